/* The generated model, and what every integration takes and gives. */
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

/* Each function integrates `count` tasks in a row. They are equal, so that its solver is made once, and only started anew. */
typedef struct {
    double tolerance, gamma, t1, h0, x0[4];
} Task;

typedef struct {
    /* Not the end of the task where the integration failed. */
    double t, x[4], evaluations;
} End;

#define EXPORT __attribute__((visibility("default")))

/* Evaluations after which an integration is given up. */
#define PATIENCE 3000000
