/* The two methods of CVODE, of SUNDIALS. */
#include "sundials.h"

#include <cvode/cvode.h>

static void integrate(int method, const Task *task, End *end, long count) {
    Objects own = make_objects(task);
    void *cvode = CVodeCreate(method, own.context);
    CVodeInit(cvode, rhs, 0.0, own.start);
    CVodeSStolerances(cvode, task->relative, task->absolute);
    CVodeSetMaxNumSteps(cvode, PATIENCE / 10);
#if SUNDIALS_VERSION_MAJOR < 7
    CVodeSetErrFile(cvode, NULL);
#endif
    if (method == CV_BDF) {
        CVodeSetLinearSolver(cvode, own.linear, own.matrix);
        CVodeSetJacFn(cvode, jacobian);
    } else {
        CVodeSetNonlinearSolver(cvode, own.nonlinear);
    }
    for (long n = 0; n < count; n++) {
        CVodeReInit(cvode, 0.0, own.start);
        CVodeSetStopTime(cvode, task->t1);
        evolve(CVode, cvode, CV_NORMAL, task, &own, end);
        long evaluations = 0;
        CVodeGetNumRhsEvals(cvode, &evaluations);
        end->evaluations = evaluations;
        long jacobians = 0;
        if (method == CV_BDF) CVodeGetNumJacEvals(cvode, &jacobians);
        end->jacobians = jacobians;
    }
    CVodeFree(&cvode);
    free_objects(&own);
}

EXPORT void adams(const Task *task, End *end, long count) { integrate(CV_ADAMS, task, end, count); }
EXPORT void bdf(const Task *task, End *end, long count) { integrate(CV_BDF, task, end, count); }
