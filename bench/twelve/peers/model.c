/* The model for Python, and for the comparison with that in Rust. */
#include "problem.h"

EXPORT void rhs(const double *x, double *slopes, long count) {
    start_model();
    for (long n = 0; n < count; n++) model_rhs(x + n * LENGTH, slopes);
}

EXPORT void jacobian(const double *x, double *columns, long count) {
    start_model();
    for (long n = 0; n < count; n++) model_jacobian(x + n * LENGTH, columns);
}
