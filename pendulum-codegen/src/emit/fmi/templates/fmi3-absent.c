// Functions of FMI 3.0 for what the model does not have: other types of variables, clocks, scheduled execution and
// configuration. All must exist.
#include "fmi3-instance.h"

typedef const fmi3ValueReference *references;

// Nothing is left to do for no variable.
static fmi3Status none(size_t count) { return count == 0 ? fmi3OK : fmi3Error; }

#define GET_AND_SET(Name, type) \
    FMI3_EXPORT fmi3Status FMI3(Get##Name)(fmi3Instance own, references of, size_t count, type values[], \
                                           size_t room) { \
        (void)own, (void)of, (void)values, (void)room; \
        return none(count); \
    } \
    FMI3_EXPORT fmi3Status FMI3(Set##Name)(fmi3Instance own, references of, size_t count, const type values[], \
                                           size_t given) { \
        (void)own, (void)of, (void)values, (void)given; \
        return none(count); \
    }

GET_AND_SET(Float32, float)
GET_AND_SET(Int8, int8_t)
GET_AND_SET(UInt8, uint8_t)
GET_AND_SET(Int16, int16_t)
GET_AND_SET(UInt16, uint16_t)
GET_AND_SET(Int32, int32_t)
GET_AND_SET(UInt32, uint32_t)
GET_AND_SET(Int64, int64_t)
GET_AND_SET(UInt64, uint64_t)
GET_AND_SET(Boolean, bool)
GET_AND_SET(String, fmi3String)

// A function of an instance, of variables, and of arrays of values.
#define OF_VARIABLES(Name, ...) \
    FMI3_EXPORT fmi3Status FMI3(Name)(fmi3Instance own, references of, size_t count, __VA_ARGS__) { \
        (void)own, (void)of, (void)a, (void)b, (void)c; \
        return none(count); \
    }

OF_VARIABLES(GetBinary, size_t *a, fmi3Binary *b, size_t c)
OF_VARIABLES(SetBinary, const size_t *a, const fmi3Binary *b, size_t c)
OF_VARIABLES(GetIntervalFraction, uint64_t *a, uint64_t *b, int *c)
OF_VARIABLES(GetOutputDerivatives, const int32_t *a, double *b, size_t c)

#define OF_CLOCKS(Name, First, Second) \
    FMI3_EXPORT fmi3Status FMI3(Name)(fmi3Instance own, references of, size_t count, First a, Second b) { \
        (void)own, (void)of, (void)a, (void)b; \
        return none(count); \
    }

OF_CLOCKS(GetIntervalDecimal, double *, int *)
OF_CLOCKS(GetShiftFraction, uint64_t *, uint64_t *)
OF_CLOCKS(SetIntervalFraction, const uint64_t *, const uint64_t *)
OF_CLOCKS(SetShiftFraction, const uint64_t *, const uint64_t *)

#define OF_CLOCK_VALUES(Name, type) \
    FMI3_EXPORT fmi3Status FMI3(Name)(fmi3Instance own, references of, size_t count, type values) { \
        (void)own, (void)of, (void)values; \
        return none(count); \
    }

OF_CLOCK_VALUES(GetClock, bool *)
OF_CLOCK_VALUES(SetClock, const bool *)
OF_CLOCK_VALUES(GetShiftDecimal, double *)
OF_CLOCK_VALUES(SetIntervalDecimal, const double *)
OF_CLOCK_VALUES(SetShiftDecimal, const double *)

#define REFUSED(Name) \
    FMI3_EXPORT fmi3Status FMI3(Name)(fmi3Instance own) { \
        (void)own; \
        return fmi3Error; \
    }

REFUSED(EnterConfigurationMode)
REFUSED(ExitConfigurationMode)
REFUSED(EnterStepMode)

FMI3_EXPORT fmi3Status FMI3(GetNumberOfVariableDependencies)(fmi3Instance own, fmi3ValueReference of, size_t *count) {
    (void)own, (void)of, (void)count;
    return fmi3Error;
}

FMI3_EXPORT fmi3Status FMI3(GetVariableDependencies)(fmi3Instance own, fmi3ValueReference of, size_t *elements,
                                                     fmi3ValueReference *independents, size_t *their_elements,
                                                     int *kinds, size_t count) {
    (void)own, (void)of, (void)elements, (void)independents, (void)their_elements, (void)kinds, (void)count;
    return fmi3Error;
}

FMI3_EXPORT fmi3Instance FMI3(InstantiateScheduledExecution)(fmi3String name, fmi3String token, fmi3String resources,
                                                             bool visible, bool logs, void *environment,
                                                             fmi3LogMessageCallback log, void *update, void *lock,
                                                             void *unlock) {
    (void)name, (void)token, (void)resources, (void)visible, (void)logs, (void)environment, (void)update, (void)lock,
        (void)unlock;
    (void)log;
    return NULL;
}

FMI3_EXPORT fmi3Status FMI3(ActivateModelPartition)(fmi3Instance own, fmi3ValueReference clock, double time) {
    (void)own, (void)clock, (void)time;
    return fmi3Error;
}
