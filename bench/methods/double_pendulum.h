/* The generated model, and the input and output of every integration. */
#pragma once

#ifdef __cplusplus
extern "C" {
#endif
void *double_pendulum(double gamma);
void double_pendulum_free(void *model);
void double_pendulum_rhs(const void *model, const double x[4], double slope[4]);
/* Column by column. */
void double_pendulum_jacobian(const void *model, const double x[4], double columns[16]);
#ifdef __cplusplus
}
#endif

/* Each function integrates `count` equal tasks in a row, so its solver is created once and only restarted. */
typedef struct {
    double tolerance, gamma, t1, h0, x0[4];
} Task;

typedef struct {
    /* Time reached; less than the end of the task if the integration failed. */
    double t, x[4], evaluations;
} End;

#define EXPORT __attribute__((visibility("default")))

/* Maximum number of evaluations of an integration. */
#define PATIENCE 3000000
