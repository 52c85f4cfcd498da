// Types of FMI 3.0, and an instance of the model.
#ifndef fmi3InstanceHeader
#define fmi3InstanceHeader

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "fmi3-model.h"

// A prefix of all functions, for programs that link several FMUs: -DFMI3_FUNCTION_PREFIX=name_
#ifndef FMI3_FUNCTION_PREFIX
#define FMI3_FUNCTION_PREFIX
#endif
#define FMI3_JOINED(prefix, name) prefix##name
#define FMI3_WITH(prefix, name) FMI3_JOINED(prefix, name)
#define FMI3(name) FMI3_WITH(FMI3_FUNCTION_PREFIX, fmi3##name)

#if defined(_WIN32)
#define FMI3_EXPORT __declspec(dllexport)
#define FMI3_HIDDEN
#elif defined(__GNUC__)
#define FMI3_EXPORT __attribute__((visibility("default")))
#define FMI3_HIDDEN __attribute__((visibility("hidden")))
#else
#define FMI3_EXPORT
#define FMI3_HIDDEN
#endif

typedef void *fmi3Instance;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef const char *fmi3String;
typedef const uint8_t *fmi3Binary;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef void (*fmi3LogMessageCallback)(void *environment, fmi3Status status, fmi3String category, fmi3String message);

// Modes of an instance, one bit each.
enum { INSTANTIATED = 1, INITIALIZATION = 2, EVENT = 4, CONTINUOUS_TIME = 8, STEP = 16, TERMINATED = 32, ANY = 63 };

// Everything that fmi3GetFMUState saves.
typedef struct {
    Model constants;
    double parameters[LENGTH(PARAMETERS)], inputs[LENGTH(INPUTS)], states[LENGTH(STATES)];
    double time;
    // Relative tolerance, and absolute one in SI units, of the steps of co-simulation.
    double tolerance;
    // Length in s of the next step of co-simulation; 0 before the first one.
    double step;
    int32_t mode;
    // True if the constants are those of the parameters.
    bool is_built;
} Snapshot;

typedef struct {
    Snapshot now;
    bool is_co_simulation;
    void *environment;
    fmi3LogMessageCallback log;
} Instance;

// Logs a message, and returns the status.
FMI3_HIDDEN fmi3Status instanceReport(Instance *own, fmi3Status status, const char *format, ...);

// Computes the constants of the model if parameters have changed, after a check of these.
FMI3_HIDDEN fmi3Status instanceBuild(Instance *own);

// Computes the constants, normalises the quaternions of the start, and assembles its loops.
FMI3_HIDDEN fmi3Status instanceAssemble(Instance *own);

// Reports loops that have come to a singularity.
FMI3_HIDDEN fmi3Status instanceCheckMargins(Instance *own);

// Longest step, in s, in which no loop comes to its singularity at the present rate.
FMI3_HIDDEN double instanceLongest(const Instance *own);

// Integrates up to a time.
FMI3_HIDDEN fmi3Status instanceIntegrate(Instance *own, double end);

// True if all numbers are finite.
FMI3_HIDDEN bool allFinite(const double *values, size_t count);

#endif
