/* Runge-Kutta methods of ARKODE, of SUNDIALS. */
#include "sundials.h"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

static void explicitly(int table, const Task *task, End *end, long count) {
    Objects own = make_objects(task);
    void *solver = ERKStepCreate(rhs, 0.0, own.start, own.context);
    ERKStepSetTableNum(solver, table);
    ERKStepSStolerances(solver, task->relative, task->absolute);
    ERKStepSetMaxNumSteps(solver, PATIENCE / 10);
    ERKStepSetErrFile(solver, NULL);
    for (long n = 0; n < count; n++) {
        ERKStepReInit(solver, rhs, 0.0, own.start);
        ERKStepSetStopTime(solver, task->t1);
        evolve(ERKStepEvolve, solver, ARK_NORMAL, task, &own, end);
        long evaluations = 0;
        ERKStepGetNumRhsEvals(solver, &evaluations);
        end->evaluations = evaluations;
        end->jacobians = 0;
    }
    ERKStepFree(&solver);
    free_objects(&own);
}

static void implicitly(int order, const Task *task, End *end, long count) {
    Objects own = make_objects(task);
    void *solver = ARKStepCreate(NULL, rhs, 0.0, own.start, own.context);
    ARKStepSetOrder(solver, order);
    ARKStepSStolerances(solver, task->relative, task->absolute);
    ARKStepSetMaxNumSteps(solver, PATIENCE / 10);
    ARKStepSetErrFile(solver, NULL);
    ARKStepSetLinearSolver(solver, own.linear, own.matrix);
    ARKStepSetJacFn(solver, jacobian);
    for (long n = 0; n < count; n++) {
        ARKStepReInit(solver, NULL, rhs, 0.0, own.start);
        ARKStepSetStopTime(solver, task->t1);
        evolve(ARKStepEvolve, solver, ARK_NORMAL, task, &own, end);
        long explicit_ones = 0, evaluations = 0;
        ARKStepGetNumRhsEvals(solver, &explicit_ones, &evaluations);
        end->evaluations = evaluations;
        long jacobians = 0;
        ARKStepGetNumJacEvals(solver, &jacobians);
        end->jacobians = jacobians;
    }
    ARKStepFree(&solver);
    free_objects(&own);
}

EXPORT void verner56(const Task *task, End *end, long count) {
    explicitly(ARKODE_VERNER_8_5_6, task, end, count);
}

EXPORT void fehlberg78(const Task *task, End *end, long count) {
    explicitly(ARKODE_FEHLBERG_13_7_8, task, end, count);
}

EXPORT void dirk5(const Task *task, End *end, long count) { implicitly(5, task, end, count); }
