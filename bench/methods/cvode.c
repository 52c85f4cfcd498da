/* The two methods of CVODE, of SUNDIALS. */
#include "double_pendulum.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

static int rhs(sunrealtype t, N_Vector x, N_Vector slope, void *model) {
    (void)t;
    double_pendulum_rhs(model, NV_DATA_S(x), NV_DATA_S(slope));
    return 0;
}

static int jacobian(sunrealtype t, N_Vector x, N_Vector slope, SUNMatrix matrix, void *model, N_Vector a, N_Vector b,
                    N_Vector c) {
    (void)t, (void)slope, (void)a, (void)b, (void)c;
    double_pendulum_jacobian(model, NV_DATA_S(x), SM_DATA_D(matrix));
    return 0;
}

static void integrate(int method, const Task *task, End *end, long count) {
    SUNContext context;
    SUNContext_Create(0, &context);
    void *model = double_pendulum(task->gamma);
    N_Vector start = N_VMake_Serial(4, (double *)task->x0, context), x = N_VClone(start);
    void *cvode = CVodeCreate(method, context);
    CVodeInit(cvode, rhs, 0.0, start);
    CVodeSStolerances(cvode, task->tolerance, task->tolerance);
    CVodeSetUserData(cvode, model);
    CVodeSetMaxNumSteps(cvode, PATIENCE / 10);
#if SUNDIALS_VERSION_MAJOR < 7
    CVodeSetErrFile(cvode, NULL);
#endif
    SUNMatrix matrix = NULL;
    SUNLinearSolver linear = NULL;
    SUNNonlinearSolver nonlinear = NULL;
    if (method == CV_BDF) {
        matrix = SUNDenseMatrix(4, 4, context);
        linear = SUNLinSol_Dense(x, matrix, context);
        CVodeSetLinearSolver(cvode, linear, matrix);
        CVodeSetJacFn(cvode, jacobian);
    } else {
        nonlinear = SUNNonlinSol_FixedPoint(x, 0, context);
        CVodeSetNonlinearSolver(cvode, nonlinear);
    }
    for (long n = 0; n < count; n++) {
        double t = -1.0;
        CVodeReInit(cvode, 0.0, start);
        CVodeSetStopTime(cvode, task->t1);
        int status = CVode(cvode, task->t1, x, &t, CV_NORMAL);
        long evaluations = 0;
        CVodeGetNumRhsEvals(cvode, &evaluations);
        end->t = status >= 0 ? t : -1.0;
        memcpy(end->x, NV_DATA_S(x), sizeof end->x);
        end->evaluations = evaluations;
    }
    CVodeFree(&cvode);
    if (linear) SUNLinSolFree(linear);
    if (matrix) SUNMatDestroy(matrix);
    if (nonlinear) SUNNonlinSolFree(nonlinear);
    N_VDestroy(x);
    N_VDestroy(start);
    double_pendulum_free(model);
    SUNContext_Free(&context);
}

EXPORT void adams(const Task *task, End *end, long count) { integrate(CV_ADAMS, task, end, count); }
EXPORT void bdf(const Task *task, End *end, long count) { integrate(CV_BDF, task, end, count); }
