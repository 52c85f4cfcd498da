/* Right-hand side and Jacobian for SUNDIALS, and the objects that its solvers need. */
#pragma once

#include "problem.h"

#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

static int rhs(sunrealtype t, N_Vector x, N_Vector slope, void *data) {
    (void)t, (void)data;
    model_rhs(NV_DATA_S(x), NV_DATA_S(slope));
    return 0;
}

static int jacobian(sunrealtype t, N_Vector x, N_Vector slope, SUNMatrix matrix, void *data, N_Vector a, N_Vector b,
                    N_Vector c) {
    (void)t, (void)slope, (void)data, (void)a, (void)b, (void)c;
    model_jacobian(NV_DATA_S(x), SM_DATA_D(matrix));
    return 0;
}

typedef struct {
    SUNContext context;
    N_Vector start, x;
    SUNMatrix matrix;
    SUNLinearSolver linear;
    SUNNonlinearSolver nonlinear;
} Objects;

static Objects make_objects(const Task *task) {
    Objects own;
    start_model();
    SUNContext_Create(0, &own.context);
    own.start = N_VMake_Serial(LENGTH, (double *)task->x0, own.context);
    own.x = N_VClone(own.start);
    own.matrix = SUNDenseMatrix(LENGTH, LENGTH, own.context);
    own.linear = SUNLinSol_Dense(own.x, own.matrix, own.context);
    own.nonlinear = SUNNonlinSol_FixedPoint(own.x, 0, own.context);
    return own;
}

static void free_objects(Objects *own) {
    SUNNonlinSolFree(own->nonlinear);
    SUNLinSolFree(own->linear);
    SUNMatDestroy(own->matrix);
    N_VDestroy(own->x);
    N_VDestroy(own->start);
    SUNContext_Free(&own->context);
}

/* `CVode` and its like, with their numbers for the task of reaching a time. */
typedef int Evolve(void *solver, sunrealtype to, N_Vector x, sunrealtype *t, int normal);

/* Integrates to the end by way of the output times, at which the solver interpolates. */
static void evolve(Evolve *solve, void *solver, int normal, const Task *task, Objects *own, End *end) {
    double t = -1.0;
    int status = 0;
    end->outputs = 0;
    for (long n = 0; n < task->outputs && status >= 0; n++) {
        status = solve(solver, output_time(task, n), own->x, &t, normal);
        memcpy(end->along[n], NV_DATA_S(own->x), sizeof end->x);
        end->outputs += status >= 0;
    }
    if (status >= 0) status = solve(solver, task->t1, own->x, &t, normal);
    end->t = status >= 0 ? t : -1.0;
    memcpy(end->x, NV_DATA_S(own->x), sizeof end->x);
}
