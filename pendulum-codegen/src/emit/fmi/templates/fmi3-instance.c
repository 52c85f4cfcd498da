// Functions that several other sources call.
#include "fmi3-instance.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

fmi3Status instanceReport(Instance *own, fmi3Status status, const char *format, ...) {
    char text[512];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    if (own->log)
        own->log(own->environment, status, status == fmi3Discard ? "logStatusDiscard" : "logStatusError", text);
    return status;
}

bool allFinite(const double *values, size_t count) {
    for (size_t n = 0; n < count; n++) {
        if (!isfinite(values[n])) return false;
    }
    return true;
}
