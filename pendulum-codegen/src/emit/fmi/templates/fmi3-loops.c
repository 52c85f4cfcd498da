// Parameters, and invariants of the state: unit quaternions and closed loops.
#include <math.h>
#include <string.h>

#include "fmi3-instance.h"

// Maximum number of Newton corrections in an assembly.
#define MOST_CORRECTIONS 100
// Maximum correction, in rad or m. Longer ones could switch to another assembly mode.
#define LONGEST 0.3
// Size of the correction at convergence, in rad or m: the next one is of the size of rounding errors.
#define LEAST 1.5e-8
// Largest gap of a closed loop, in rad or relative to its size.
#define CLOSED 1e-11
// Largest deviation of a quaternion's length from 1 at the start.
#define FAR 1e-3
// Least margin of a loop from its singularity.
#define NEAR 1e-4

fmi3Status instanceBuild(Instance *own) {
    Snapshot *const now = &own->now;
    if (now->is_built) return fmi3OK;
    const int code = modelNew(&now->constants, now->parameters);
    if (code != 0) return instanceReport(own, fmi3Error, "%s", modelError(code));
    now->is_built = true;
    return fmi3OK;
}

static double longestGap(const Snapshot *now) {
    double gaps[3 * LENGTH(GAPS)], worst = 0.0;
    modelGaps(&now->constants, now->time, now->states, gaps);
    for (int n = 0; n < GAPS; n++) {
        const double distance = gaps[n] / gaps[2 * GAPS + n];
        worst = fmax(worst, fmax(distance, gaps[GAPS + n]));
    }
    return worst;
}

fmi3Status instanceAssemble(Instance *own) {
    Snapshot *const now = &own->now;
    double corrections[LENGTH(DEPENDENTS)] = {0.0};
    const fmi3Status built = instanceBuild(own);
    if (built != fmi3OK) return built;
    if (!allFinite(now->states, STATES)) return instanceReport(own, fmi3Error, "a start value is not finite");
    for (int n = 0; n < QUATERNIONS; n++) {
        const double *const q = now->states + modelQuaternions[n];
        const double norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        if (!(fabs(norm - 1.0) <= FAR)) {
            return instanceReport(own, fmi3Error, "a start quaternion has the length %g; it must be 1, to three digits",
                                  norm);
        }
    }
    double size = 0.0;
    for (int k = 0; k < MOST_CORRECTIONS && DEPENDENTS > 0; k++) {
        modelCorrections(&now->constants, now->time, now->states, corrections);
        size = 0.0;
        for (int n = 0; n < DEPENDENTS; n++) size = fmax(size, fabs(corrections[n]));
        if (!allFinite(corrections, DEPENDENTS)) break;
        const double share = size > LONGEST ? LONGEST / size : 1.0;
        for (int n = 0; n < DEPENDENTS; n++) now->states[modelDependents[n]] += share * corrections[n];
        if (size < LEAST) break;
    }
    const double gap = DEPENDENTS > 0 ? longestGap(now) : 0.0;
    if (!allFinite(corrections, DEPENDENTS) || !(gap <= CLOSED)) {
        return instanceReport(own, fmi3Error,
                              "the loops do not close near the start: give better guesses of the dependent "
                              "coordinates, or other values of the independent ones");
    }
    modelProject(&now->constants, now->time, now->states);
    return instanceCheckMargins(own);
}

fmi3Status instanceCheckMargins(Instance *own) {
    const Snapshot *const now = &own->now;
    double margins[2 * LENGTH(MARGINS)];
    modelMargins(&now->constants, now->time, now->states, margins);
    for (int n = 0; n < MARGINS; n++) {
        if (!isfinite(margins[n])) {
            return instanceReport(own, fmi3Error, "%s at t = %g s: it cannot close", modelMarginNames[n], now->time);
        }
        if (margins[n] < NEAR) {
            return instanceReport(own, fmi3Error, "%s at t = %g s: it comes to its singularity (toggle)",
                                  modelMarginNames[n], now->time);
        }
    }
    return fmi3OK;
}

double instanceLongest(const Instance *own) {
    const Snapshot *const now = &own->now;
    double margins[2 * LENGTH(MARGINS)], longest = INFINITY;
    modelMargins(&now->constants, now->time, now->states, margins);
    for (int n = 0; n < MARGINS; n++) {
        // half of the way
        if (margins[MARGINS + n] < 0.0) longest = fmin(longest, -0.5 * margins[n] / margins[MARGINS + n]);
    }
    return longest;
}
