/* A problem, and the input and output of every integration.
 *
 * The model is the emitted C, with `LENGTH` components, `start_model`, `model_rhs` and `model_jacobian`, which writes
 * column by column. */
#pragma once

// before the model, which declares functions of them as C
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif
#include "model.h"
#ifdef __cplusplus
}
#endif

/* Each function integrates `count` equal tasks in a row, so its solver is created once and only restarted. */
typedef struct {
    /* Relative and absolute tolerance, end, first step, number of output times, start. */
    double relative, absolute, t1, h0, outputs, x0[LENGTH];
} Task;

typedef struct {
    /* Time reached; less than the end of the task if the integration failed. */
    double t, x[LENGTH], evaluations, jacobians;
    /* Number of states at output times, by dense output; 0 if the method has none. */
    double outputs, along[][LENGTH];
} End;

/* Output time, the first with n = 0. */
static inline double output_time(const Task *task, long n) { return (n + 1) * (task->t1 / (task->outputs + 1)); }

#define EXPORT __attribute__((visibility("default")))

/* Maximum number of evaluations of an integration. */
#define PATIENCE 3000000

/* Jacobian row by row. */
static inline void model_jacobian_rows(const double *x, double *rows) {
    double columns[LENGTH * LENGTH];
    model_jacobian(x, columns);
    for (int i = 0; i < LENGTH; i++) {
        for (int j = 0; j < LENGTH; j++) rows[LENGTH * i + j] = columns[LENGTH * j + i];
    }
}
