// Runs an FMU that is linked to this program, by the functions of FMI 3.0, on lists of numbers from the standard input.
//
// With STEPS == 0, each list is a time, a state, inputs and a seed for both of these, and the results are the
// derivatives of the state, the outputs, the event indicators, and the products of the partial derivatives with the
// seed, and of its first part with them. Otherwise each list is a start, inputs, and a tolerance, and the result is the
// state after these steps of co-simulation of the length H.
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef void *Fmu;
typedef uint32_t Reference;

const char *fmi3GetVersion(void);
Fmu fmi3InstantiateModelExchange(const char *, const char *, const char *, bool, bool, void *, void *);
Fmu fmi3InstantiateCoSimulation(const char *, const char *, const char *, bool, bool, bool, bool, const Reference *,
                                size_t, void *, void *, void *);
void fmi3FreeInstance(Fmu);
int fmi3Reset(Fmu);
int fmi3EnterInitializationMode(Fmu, bool, double, double, bool, double);
int fmi3ExitInitializationMode(Fmu);
int fmi3UpdateDiscreteStates(Fmu, bool *, bool *, bool *, bool *, bool *, double *);
int fmi3EnterContinuousTimeMode(Fmu);
int fmi3CompletedIntegratorStep(Fmu, bool, bool *, bool *);
int fmi3SetTime(Fmu, double);
int fmi3SetContinuousStates(Fmu, const double *, size_t);
int fmi3GetContinuousStates(Fmu, double *, size_t);
int fmi3GetContinuousStateDerivatives(Fmu, double *, size_t);
int fmi3GetEventIndicators(Fmu, double *, size_t);
int fmi3GetFloat64(Fmu, const Reference *, size_t, double *, size_t);
int fmi3SetFloat64(Fmu, const Reference *, size_t, const double *, size_t);
int fmi3GetDirectionalDerivative(Fmu, const Reference *, size_t, const Reference *, size_t, const double *, size_t,
                                 double *, size_t);
int fmi3GetAdjointDerivative(Fmu, const Reference *, size_t, const Reference *, size_t, const double *, size_t,
                             double *, size_t);
int fmi3DoStep(Fmu, double, double, bool, bool *, bool *, bool *, double *);
int fmi3GetFMUState(Fmu, void **);
int fmi3SetFMUState(Fmu, void *);
int fmi3FreeFMUState(Fmu, void **);
int fmi3SerializedFMUStateSize(Fmu, void *, size_t *);
int fmi3SerializeFMUState(Fmu, void *, uint8_t *, size_t);
int fmi3DeserializeFMUState(Fmu, const uint8_t *, size_t, void **);

enum { P = PARAMETERS, U = INPUTS, N = STATES, Y = OUTPUTS, E = EVENTS };
static double in[2 * N + 2 * U + 1], out[4 * N + 2 * Y + E + U];
static Reference known[N + U], unknown[N + Y];

static void report(void *environment, int status, const char *category, const char *message) {
    fprintf(stderr, "%s%d %s: %s\n", (const char *)environment, status, category, message);
}

#define CHECK(call) \
    do { \
        if ((call) != 0) { \
            fprintf(stderr, "%s failed\n", #call); \
            return 1; \
        } \
    } while (0)

static int evaluate(Fmu fmu) {
    const double *const state = in + 1, *const inputs = state + N, *const seed = inputs + U;
    double *values = out;
    CHECK(fmi3SetTime(fmu, in[0]));
    CHECK(fmi3SetContinuousStates(fmu, state, N));
    CHECK(fmi3SetFloat64(fmu, known + N, U, inputs, U));
    CHECK(fmi3GetContinuousStateDerivatives(fmu, values, N));
    CHECK(fmi3GetFloat64(fmu, unknown + N, Y, values + N, Y));
    CHECK(fmi3GetEventIndicators(fmu, values + N + Y, E));
    values += N + Y + E;
    CHECK(fmi3GetDirectionalDerivative(fmu, unknown, N + Y, known, N + U, seed, N + U, values, N + Y));
    // a state as an output depends on itself
    CHECK(fmi3GetDirectionalDerivative(fmu, known, N, known, N + U, seed, N + U, values + N + Y, N));
    CHECK(fmi3GetAdjointDerivative(fmu, unknown, N, known, N + U, seed, N, values + 2 * N + Y, N + U));
    return 0;
}

static int simulate(Fmu fmu) {
    bool flags[3];
    double last, ends[2][N + 1];
    void *saved = NULL, *read = NULL;
    size_t size;
    CHECK(fmi3SetFloat64(fmu, known, N + U, in, N + U));
    CHECK(fmi3EnterInitializationMode(fmu, true, in[N + U], 0.0, false, 0.0));
    CHECK(fmi3ExitInitializationMode(fmu));
    for (int way = 0; way < 2; way++) {
        for (int n = way * (STEPS / 2); n < STEPS; n++) {
            if (way == 0 && n == STEPS / 2) CHECK(fmi3GetFMUState(fmu, &saved));
            CHECK(fmi3DoStep(fmu, n * H, H, false, flags, flags + 1, flags + 2, &last));
        }
        ends[way][N] = last;
        CHECK(fmi3GetFloat64(fmu, known, N, ends[way], N));
        // once more from the middle, by way of bytes
        CHECK(fmi3SerializedFMUStateSize(fmu, saved, &size));
        uint8_t *const bytes = malloc(size);
        CHECK(fmi3SerializeFMUState(fmu, saved, bytes, size));
        CHECK(fmi3DeserializeFMUState(fmu, bytes, size, &read));
        CHECK(fmi3SetFMUState(fmu, read));
        free(bytes);
    }
    CHECK(fmi3FreeFMUState(fmu, &saved));
    CHECK(fmi3FreeFMUState(fmu, &read));
    CHECK(memcmp(ends[0], ends[1], sizeof ends[0]));
    CHECK(fmi3Reset(fmu));
    memcpy(out, ends[0], N * sizeof(double));
    return 0;
}

int main(void) {
    for (int n = 0; n < N; n++) known[n] = 1 + P + U + n, unknown[n] = 1 + P + U + N + n;
    for (int n = 0; n < U; n++) known[N + n] = 1 + P + n;
    for (int n = 0; n < Y; n++) unknown[N + n] = 1 + P + U + 2 * N + n;
    if (strcmp(fmi3GetVersion(), "3.0") != 0) return 2;
    if (fmi3InstantiateModelExchange("one", "{another}", NULL, false, false, "", report)) return 3;
    const Fmu fmu = STEPS > 0 ? fmi3InstantiateCoSimulation("one", "TOKEN", NULL, false, false, false, false, NULL, 0,
                                                            "", report, NULL)
                              : fmi3InstantiateModelExchange("one", "TOKEN", NULL, false, false, "", report);
    if (!fmu) return 4;
    bool flags[5];
    double next;
    if (STEPS == 0) {
        // a step of co-simulation is refused
        if (fmi3DoStep(fmu, 0.0, 1.0, false, flags, flags + 1, flags + 2, &next) != 3) return 5;
        CHECK(fmi3EnterInitializationMode(fmu, false, 0.0, 0.0, false, 0.0));
        CHECK(fmi3ExitInitializationMode(fmu));
        CHECK(fmi3UpdateDiscreteStates(fmu, flags, flags + 1, flags + 2, flags + 3, flags + 4, &next));
        CHECK(fmi3EnterContinuousTimeMode(fmu));
    }
    const size_t given = STEPS > 0 ? N + U + 1 : sizeof in / sizeof *in;
    const size_t got = STEPS > 0 ? N : sizeof out / sizeof *out;
    while (fread(in, sizeof *in, given, stdin) == given) {
        CHECK(STEPS > 0 ? simulate(fmu) : evaluate(fmu));
        fwrite(out, sizeof *out, got, stdout);
    }
    fmi3FreeInstance(fmu);
    return 0;
}
