/* Methods of the GNU Scientific Library, which have no dense output. */
#include "problem.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

static long evaluations, jacobians;

static int rhs(double t, const double x[], double slope[], void *data) {
    (void)t, (void)data;
    evaluations++;
    model_rhs(x, slope);
    return GSL_SUCCESS;
}

static int jacobian(double t, const double x[], double *rows, double slope[], void *data) {
    (void)t, (void)data;
    jacobians++;
    model_jacobian_rows(x, rows);
    memset(slope, 0, LENGTH * sizeof *slope);
    return GSL_SUCCESS;
}

static void integrate(const gsl_odeiv2_step_type *type, const Task *task, End *end, long count) {
    gsl_set_error_handler_off();
    start_model();
    gsl_odeiv2_system system = {rhs, jacobian, LENGTH, NULL};
    gsl_odeiv2_driver *driver =
        gsl_odeiv2_driver_alloc_y_new(&system, type, task->h0, task->absolute, task->relative);
    gsl_odeiv2_driver_set_nmax(driver, PATIENCE / 10);
    for (long n = 0; n < count; n++) {
        double t = 0.0;
        memcpy(end->x, task[n].x0, sizeof end->x);
        evaluations = jacobians = 0;
        gsl_odeiv2_driver_reset_hstart(driver, task->h0);
        int status = gsl_odeiv2_driver_apply(driver, &t, task[n].t1, end->x);
        end->t = status == GSL_SUCCESS ? t : -1.0;
        end->evaluations = evaluations;
        end->jacobians = jacobians;
    }
    gsl_odeiv2_driver_free(driver);
}

#define METHOD(name) \
    EXPORT void name(const Task *task, End *end, long count) { \
        integrate(gsl_odeiv2_step_##name, task, end, count); \
    }

METHOD(rkck)
METHOD(rk8pd)
METHOD(msadams)
METHOD(bsimp)
METHOD(msbdf)
