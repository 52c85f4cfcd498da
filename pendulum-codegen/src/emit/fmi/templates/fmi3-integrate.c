// Integration for co-simulation: the pair of orders 5 and 4 of Dormand and Prince (1980), with adaptive steps.
#include <math.h>
#include <string.h>

#include "fmi3-instance.h"

#define STAGES 7
// Maximum number of steps in one call.
#define MOST_STEPS 1000000
// Share of the step size that the error estimate allows.
#define SAFETY 0.9
// Smallest and largest change of the step size, as a factor.
#define SHRINK 0.2
#define GROW 3.0
// Smallest step size, relative to the time or to 1 s.
#define SHORTEST 1e-14

static const double nodes[STAGES] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
static const double weights[STAGES][STAGES - 1] = {
    {0},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
};
// Differences of the weights of orders 5 and 4.
static const double errors[STAGES] = {
    71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40,
};

// Root mean square of values in units of the tolerance at two states.
static double norm(double tolerance, const double *values, const double *a, const double *b) {
    double sum = 0.0;
    for (int n = 0; n < STATES; n++) {
        const double scaled = values[n] / (tolerance * (1.0 + fmax(fabs(a[n]), fabs(b[n]))));
        sum += scaled * scaled;
    }
    return sqrt(sum / LENGTH(STATES));
}

// First step size: one in which Euler's method moves the state by a hundredth of its size.
static double first(const Snapshot *now, const double *rates) {
    const double size = norm(now->tolerance, now->states, now->states, now->states);
    const double speed = norm(now->tolerance, rates, now->states, now->states);
    return size < 1e-5 || !(speed > 1e-5) ? 1e-6 : 0.01 * size / speed;
}

fmi3Status instanceIntegrate(Instance *own, double end) {
    Snapshot *const now = &own->now;
    double rates[STAGES][LENGTH(STATES)], state[LENGTH(STATES)], error[LENGTH(STATES)];
    modelRhs(&now->constants, now->time, now->states, now->inputs, rates[0]);
    if (!allFinite(rates[0], STATES)) {
        return instanceReport(own, fmi3Error, "the equations of motion are not finite at t = %g s", now->time);
    }
    if (now->step <= 0.0) now->step = first(now, rates[0]);
    for (int count = 0; now->time < end; count++) {
        double h = fmin(now->step, instanceLongest(own));
        if (!(h > SHORTEST * fmax(1.0, fabs(now->time))) || count == MOST_STEPS) {
            const fmi3Status status = instanceCheckMargins(own);
            if (status != fmi3OK) return status;
            return instanceReport(own, fmi3Error,
                                  "%s at t = %g s: the motion is stiff or singular there; try model exchange "
                                  "with an implicit method, or another tolerance",
                                  count == MOST_STEPS ? "too many steps" : "the step size vanishes", now->time);
        }
        // no short rest, and no step in between that ends beside the end by rounding
        const double left = end - now->time;
        const bool is_last = h >= left * (1.0 - 1e-12);
        const bool is_cut = h > left;
        if (is_last) h = left;
        for (int stage = 1; stage < STAGES; stage++) {
            for (int n = 0; n < STATES; n++) {
                double sum = 0.0;
                for (int k = 0; k < stage; k++) sum += weights[stage][k] * rates[k][n];
                state[n] = now->states[n] + h * sum;
            }
            const double time = now->time + nodes[stage] * h;
            // the last stage is evaluated at the end of the step
            if (stage == STAGES - 1) modelProject(&now->constants, time, state);
            modelRhs(&now->constants, time, state, now->inputs, rates[stage]);
        }
        for (int n = 0; n < STATES; n++) {
            error[n] = 0.0;
            for (int k = 0; k < STAGES; k++) error[n] += h * errors[k] * rates[k][n];
        }
        const double size = norm(now->tolerance, error, now->states, state);
        const bool is_finite = isfinite(size) && allFinite(rates[STAGES - 1], STATES);
        const double factor = is_finite ? fmin(GROW, fmax(SHRINK, SAFETY * pow(size, -0.2))) : SHRINK;
        if (is_finite && size <= 1.0) {
            now->time = is_last ? end : now->time + h;
            memcpy(now->states, state, sizeof now->states);
            memcpy(rates[0], rates[STAGES - 1], sizeof rates[0]);
            // a step that was cut short says little about longer ones
            now->step = is_cut ? fmax(now->step, factor * h) : factor * h;
            const fmi3Status status = instanceCheckMargins(own);
            if (status != fmi3OK) return status;
        } else {
            now->step = fmin(factor, SAFETY) * h;
        }
    }
    return fmi3OK;
}
