// The functions of FMI 3.0, for model exchange and co-simulation.
#include "fmi3-instance.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

// Tolerance if the importer gives none, and the limits of those that it gives.
#define TOLERANCE 1e-8
#define LEAST_TOLERANCE 1e-13
#define MOST_TOLERANCE 1e-2

// Kinds of variables, in the order of their value references.
typedef enum { TIME, PARAMETER, INPUT, STATE, DERIVATIVE, OUTPUT, EVENT_FUNCTION, KINDS } kind;
static const size_t counts[KINDS] = {1, PARAMETERS, INPUTS, STATES, STATES, OUTPUTS, EVENTS};

typedef struct {
    kind kind;
    size_t index;
} variable;

// Returns the kind KINDS for an unknown reference.
static variable find(fmi3ValueReference reference) {
    variable found = {TIME, reference};
    while (found.kind < KINDS && found.index >= counts[found.kind]) {
        found.index -= counts[found.kind];
        found.kind++;
    }
    return found;
}

static fmi3Status unknown(Instance *own, fmi3ValueReference reference) {
    return instanceReport(own, fmi3Error, "%u is no value reference of this FMU that this function takes",
                          (unsigned)reference);
}

#define RETURN_UNLESS_OK(call) \
    do { \
        const fmi3Status status_ = (call); \
        if (status_ != fmi3OK) return status_; \
    } while (0)
// Takes the instance, and refuses calls in other modes.
#define TAKE(modes) \
    Instance *const own = (Instance *)object; \
    if (!own) return fmi3Error; \
    if (!(own->now.mode & (modes))) return instanceReport(own, fmi3Error, "%s is not allowed in this mode", __func__); \
    Snapshot *const now = &own->now; \
    (void)now
#define REQUIRE(holds) \
    if (!(holds)) return instanceReport(own, fmi3Error, "%s: wrong number of values: " #holds, __func__)

// Instances

static void setStart(Instance *own) {
    Snapshot *const now = &own->now;
    memset(now, 0, sizeof *now);
    memcpy(now->parameters, modelStart, PARAMETERS * sizeof(double));
    memcpy(now->states, modelStart + PARAMETERS, STATES * sizeof(double));
    now->tolerance = TOLERANCE;
    now->mode = INSTANTIATED;
}

static fmi3Instance instantiate(fmi3String token, void *environment, fmi3LogMessageCallback log,
                                bool is_co_simulation) {
    Instance *const own = calloc(1, sizeof *own);
    if (!own) return NULL;
    own->is_co_simulation = is_co_simulation;
    own->environment = environment;
    own->log = log;
    if (!token || strcmp(token, MODEL_TOKEN) != 0) {
        instanceReport(own, fmi3Error,
                       "the instantiation token is not %s: the model description is that of another FMU", MODEL_TOKEN);
        free(own);
        return NULL;
    }
    setStart(own);
    return own;
}

FMI3_EXPORT const char *FMI3(GetVersion)(void) { return "3.0"; }

FMI3_EXPORT fmi3Instance FMI3(InstantiateModelExchange)(fmi3String name, fmi3String token, fmi3String resources,
                                                        bool visible, bool logs, void *environment,
                                                        fmi3LogMessageCallback log) {
    (void)name, (void)resources, (void)visible, (void)logs;
    return instantiate(token, environment, log, false);
}

FMI3_EXPORT fmi3Instance FMI3(InstantiateCoSimulation)(fmi3String name, fmi3String token, fmi3String resources,
                                                       bool visible, bool logs, bool uses_events, bool may_return,
                                                       const fmi3ValueReference intermediate[], size_t count,
                                                       void *environment, fmi3LogMessageCallback log, void *update) {
    (void)name, (void)resources, (void)visible, (void)logs, (void)uses_events, (void)may_return, (void)intermediate,
        (void)count;
    (void)update;
    return instantiate(token, environment, log, true);
}

FMI3_EXPORT void FMI3(FreeInstance)(fmi3Instance object) { free(object); }

FMI3_EXPORT fmi3Status FMI3(SetDebugLogging)(fmi3Instance object, bool on, size_t count,
                                             const fmi3String categories[]) {
    (void)object, (void)on, (void)count, (void)categories;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(Reset)(fmi3Instance object) {
    TAKE(ANY);
    setStart(own);
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(Terminate)(fmi3Instance object) {
    TAKE(EVENT | CONTINUOUS_TIME | STEP);
    now->mode = TERMINATED;
    return fmi3OK;
}

// Modes

FMI3_EXPORT fmi3Status FMI3(EnterInitializationMode)(fmi3Instance object, bool has_tolerance, double tolerance,
                                                     double start, bool has_stop, double stop) {
    TAKE(INSTANTIATED);
    (void)has_stop, (void)stop;
    if (has_tolerance) now->tolerance = fmin(MOST_TOLERANCE, fmax(LEAST_TOLERANCE, tolerance));
    now->time = start;
    now->mode = INITIALIZATION;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(ExitInitializationMode)(fmi3Instance object) {
    TAKE(INITIALIZATION);
    RETURN_UNLESS_OK(instanceAssemble(own));
    now->mode = own->is_co_simulation ? STEP : EVENT;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(EnterEventMode)(fmi3Instance object) {
    TAKE(CONTINUOUS_TIME);
    now->mode = EVENT;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(EnterContinuousTimeMode)(fmi3Instance object) {
    TAKE(EVENT);
    now->mode = CONTINUOUS_TIME;
    return fmi3OK;
}

// Distance of the state from unit quaternions and closed loops, after which it is on them if `moves`.
static double project(Snapshot *now, bool moves) {
    double state[LENGTH(STATES)], distance = 0.0;
    memcpy(state, now->states, sizeof state);
    modelProject(&now->constants, now->time, state);
    for (int n = 0; n < STATES; n++) distance = fmax(distance, fabs(state[n] - now->states[n]));
    if (moves) memcpy(now->states, state, sizeof state);
    return distance;
}

// Nothing changes at an event but a state that has left its invariants. Kinks of the equations are events too, so that
// no step of an integrator crosses them.
FMI3_EXPORT fmi3Status FMI3(UpdateDiscreteStates)(fmi3Instance object, bool *needs_update, bool *terminates,
                                                  bool *new_nominals, bool *new_states, bool *has_next, double *next) {
    TAKE(EVENT);
    (void)next;
    *needs_update = *terminates = *new_nominals = *has_next = false;
    *new_states = project(now, true) > 0.0;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(EvaluateDiscreteStates)(fmi3Instance object) {
    TAKE(INITIALIZATION | EVENT);
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(CompletedIntegratorStep)(fmi3Instance object, bool is_final, bool *enters_event_mode,
                                                     bool *terminates) {
    TAKE(CONTINUOUS_TIME);
    (void)is_final;
    *enters_event_mode = project(now, false) > now->tolerance;
    *terminates = false;
    return instanceCheckMargins(own);
}

// Variables

// Values of a kind of variable, computed into `room` if they are not stored.
static fmi3Status evaluate(Instance *own, kind kind, double *room, const double **values) {
    const Snapshot *const now = &own->now;
    const double *const stored[] = {&now->time, now->parameters, now->inputs, now->states};
    // importers may read what follows from the start values
    if (kind >= STATE && now->mode == INITIALIZATION) RETURN_UNLESS_OK(instanceAssemble(own));
    if (kind < DERIVATIVE) {
        *values = stored[kind];
        return fmi3OK;
    }
    RETURN_UNLESS_OK(instanceBuild(own));
    *values = room;
    switch (kind) {
    case DERIVATIVE: modelRhs(&now->constants, now->time, now->states, now->inputs, room); break;
    case OUTPUT: modelOutputs(&now->constants, now->time, now->states, room); break;
    default: modelEvents(&now->constants, now->time, now->states, room);
    }
    if (allFinite(room, counts[kind])) return fmi3OK;
    return instanceReport(own, fmi3Discard, "the equations are not finite at t = %g s", now->time);
}

FMI3_EXPORT fmi3Status FMI3(GetFloat64)(fmi3Instance object, const fmi3ValueReference references[], size_t count,
                                        double values[], size_t room) {
    TAKE(ANY);
    REQUIRE(count == room);
    double computed[KINDS][LENGTH(MOST)];
    const double *known[KINDS] = {NULL};
    for (size_t n = 0; n < count; n++) {
        const variable at = find(references[n]);
        if (at.kind == KINDS) return unknown(own, references[n]);
        if (!known[at.kind]) RETURN_UNLESS_OK(evaluate(own, at.kind, computed[at.kind], &known[at.kind]));
        values[n] = known[at.kind][at.index];
    }
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(SetFloat64)(fmi3Instance object, const fmi3ValueReference references[], size_t count,
                                        const double values[], size_t given) {
    TAKE(ANY & ~TERMINATED);
    REQUIRE(count == given);
    for (size_t n = 0; n < count; n++) {
        const variable at = find(references[n]);
        if (at.kind == INPUT) {
            now->inputs[at.index] = values[n];
            continue;
        }
        if (at.kind != PARAMETER && at.kind != STATE) return unknown(own, references[n]);
        if (!(now->mode & (INSTANTIATED | INITIALIZATION))) {
            return instanceReport(own, fmi3Error, "parameters and start values are fixed after the initialization");
        }
        *(at.kind == STATE ? &now->states[at.index] : &now->parameters[at.index]) = values[n];
        if (at.kind == PARAMETER) now->is_built = false;
    }
    return fmi3OK;
}

// Model exchange

FMI3_EXPORT fmi3Status FMI3(SetTime)(fmi3Instance object, double time) {
    TAKE(CONTINUOUS_TIME);
    now->time = time;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(SetContinuousStates)(fmi3Instance object, const double states[], size_t count) {
    TAKE(CONTINUOUS_TIME);
    REQUIRE(count == STATES);
    memcpy(now->states, states, count * sizeof(double));
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(GetContinuousStates)(fmi3Instance object, double states[], size_t count) {
    TAKE(ANY);
    REQUIRE(count == STATES);
    const double *values;
    RETURN_UNLESS_OK(evaluate(own, STATE, NULL, &values));
    memcpy(states, values, count * sizeof(double));
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(GetContinuousStateDerivatives)(fmi3Instance object, double derivatives[], size_t count) {
    TAKE(ANY);
    REQUIRE(count == STATES);
    const double *values;
    return evaluate(own, DERIVATIVE, derivatives, &values);
}

FMI3_EXPORT fmi3Status FMI3(GetEventIndicators)(fmi3Instance object, double indicators[], size_t count) {
    TAKE(ANY);
    REQUIRE(count == EVENTS);
    const double *values;
    return evaluate(own, EVENT_FUNCTION, indicators, &values);
}

FMI3_EXPORT fmi3Status FMI3(GetNominalsOfContinuousStates)(fmi3Instance object, double nominals[], size_t count) {
    TAKE(ANY);
    REQUIRE(count == STATES);
    for (size_t n = 0; n < count; n++) nominals[n] = 1.0;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(GetNumberOfEventIndicators)(fmi3Instance object, size_t *count) {
    TAKE(ANY);
    *count = EVENTS;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(GetNumberOfContinuousStates)(fmi3Instance object, size_t *count) {
    TAKE(ANY);
    *count = STATES;
    return fmi3OK;
}

// Co-simulation

FMI3_EXPORT fmi3Status FMI3(DoStep)(fmi3Instance object, double start, double length, bool is_final, bool *needs_events,
                                    bool *terminates, bool *returned_early, double *last) {
    TAKE(STEP);
    (void)is_final;
    *needs_events = *terminates = *returned_early = false;
    *last = now->time;
    if (!(length > 0.0))
        return instanceReport(own, fmi3Error, "the communication step size is %g s, not positive", length);
    // importers round the time in their own way
    if (!(fabs(start - now->time) <= 1e-6 * length)) {
        return instanceReport(own, fmi3Error, "the step starts at %g s, not at %g s", start, now->time);
    }
    now->time = start;
    const fmi3Status status = instanceIntegrate(own, start + length);
    *last = now->time;
    return status;
}

// Partial derivatives

// Derivatives of rates and outputs with respect to states and inputs; entry (i, j) is at i + rows * j.
typedef struct {
    double of_rates[LENGTH(STATES) * LENGTH(STATES)], of_inputs[LENGTH(STATES) * LENGTH(INPUTS)];
    double of_outputs[LENGTH(OUTPUTS) * LENGTH(STATES)];
} derivatives;

static double entry(const derivatives *all, variable unknown, variable known) {
    const size_t i = unknown.index, j = known.index;
    switch (unknown.kind) {
    case STATE: return known.kind == STATE && i == j;
    case DERIVATIVE: return known.kind == STATE ? all->of_rates[i + STATES * j] : all->of_inputs[i + STATES * j];
    default: return known.kind == STATE ? all->of_outputs[i + OUTPUTS * j] : 0.0;
    }
}

// Adds the product of the derivatives of `unknowns` with respect to `knowns`, or of its transpose, with `seed`.
static fmi3Status multiply(Instance *own, const fmi3ValueReference unknowns[], size_t rows,
                           const fmi3ValueReference knowns[], size_t columns, const double seed[], double result[],
                           bool is_transposed) {
    const Snapshot *const now = &own->now;
    if (!HAS_JACOBIAN) {
        return instanceReport(own, fmi3Error, "this FMU has no derivatives: declare `generate: [rhs, jacobian, ..]`");
    }
    RETURN_UNLESS_OK(instanceBuild(own));
    derivatives *const all = calloc(1, sizeof *all);
    if (!all) return instanceReport(own, fmi3Error, "out of memory");
    modelDerivatives(&now->constants, now->time, now->states, now->inputs, all->of_rates, all->of_inputs,
                     all->of_outputs);
    memset(result, 0, (is_transposed ? columns : rows) * sizeof(double));
    fmi3Status status = fmi3OK;
    for (size_t i = 0; i < rows && status == fmi3OK; i++) {
        const variable row = find(unknowns[i]);
        if (row.kind != STATE && row.kind != DERIVATIVE && row.kind != OUTPUT) status = unknown(own, unknowns[i]);
        for (size_t j = 0; j < columns && status == fmi3OK; j++) {
            const variable column = find(knowns[j]);
            if (column.kind != STATE && column.kind != INPUT) {
                status = unknown(own, knowns[j]);
            } else if (is_transposed) {
                result[j] += entry(all, row, column) * seed[i];
            } else {
                result[i] += entry(all, row, column) * seed[j];
            }
        }
    }
    free(all);
    return status;
}

FMI3_EXPORT fmi3Status FMI3(GetDirectionalDerivative)(fmi3Instance object, const fmi3ValueReference unknowns[],
                                                      size_t rows, const fmi3ValueReference knowns[], size_t columns,
                                                      const double seed[], size_t seeds, double sensitivity[],
                                                      size_t room) {
    TAKE(INITIALIZATION | EVENT | CONTINUOUS_TIME | STEP | TERMINATED);
    REQUIRE(seeds == columns);
    REQUIRE(room == rows);
    return multiply(own, unknowns, rows, knowns, columns, seed, sensitivity, false);
}

FMI3_EXPORT fmi3Status FMI3(GetAdjointDerivative)(fmi3Instance object, const fmi3ValueReference unknowns[], size_t rows,
                                                  const fmi3ValueReference knowns[], size_t columns,
                                                  const double seed[], size_t seeds, double sensitivity[],
                                                  size_t room) {
    TAKE(INITIALIZATION | EVENT | CONTINUOUS_TIME | STEP | TERMINATED);
    REQUIRE(seeds == rows);
    REQUIRE(room == columns);
    return multiply(own, unknowns, rows, knowns, columns, seed, sensitivity, true);
}

// Saved states: copies of a snapshot

FMI3_EXPORT fmi3Status FMI3(GetFMUState)(fmi3Instance object, fmi3FMUState *saved) {
    TAKE(ANY);
    if (!*saved) *saved = malloc(sizeof *now);
    if (!*saved) return instanceReport(own, fmi3Error, "out of memory");
    memcpy(*saved, now, sizeof *now);
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(SetFMUState)(fmi3Instance object, fmi3FMUState saved) {
    TAKE(ANY);
    memcpy(now, saved, sizeof *now);
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(FreeFMUState)(fmi3Instance object, fmi3FMUState *saved) {
    (void)object;
    free(*saved);
    *saved = NULL;
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(SerializedFMUStateSize)(fmi3Instance object, fmi3FMUState saved, size_t *size) {
    (void)object, (void)saved;
    *size = sizeof(Snapshot);
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(SerializeFMUState)(fmi3Instance object, fmi3FMUState saved, uint8_t bytes[], size_t size) {
    TAKE(ANY);
    REQUIRE(size == sizeof *now);
    memcpy(bytes, saved, size);
    return fmi3OK;
}

FMI3_EXPORT fmi3Status FMI3(DeserializeFMUState)(fmi3Instance object, const uint8_t bytes[], size_t size,
                                                 fmi3FMUState *saved) {
    TAKE(ANY);
    REQUIRE(size == sizeof *now);
    if (!*saved) *saved = malloc(size);
    if (!*saved) return instanceReport(own, fmi3Error, "out of memory");
    memcpy(*saved, bytes, size);
    return fmi3OK;
}
