/* Methods of the GNU Scientific Library. */
#include "double_pendulum.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <string.h>

typedef struct {
    void *model;
    long evaluations;
} Pendulum;

static int rhs(double t, const double x[], double slope[], void *data) {
    (void)t;
    Pendulum *pendulum = data;
    pendulum->evaluations++;
    double_pendulum_rhs(pendulum->model, x, slope);
    return GSL_SUCCESS;
}

static int jacobian(double t, const double x[], double *rows, double slope[], void *data) {
    (void)t;
    Pendulum *pendulum = data;
    double columns[16];
    double_pendulum_jacobian(pendulum->model, x, columns);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) rows[4 * i + j] = columns[4 * j + i];
        slope[i] = 0.0;
    }
    return GSL_SUCCESS;
}

static void integrate(const gsl_odeiv2_step_type *type, const Task *task, End *end, long count) {
    gsl_set_error_handler_off();
    Pendulum pendulum = {double_pendulum(task->gamma), 0};
    gsl_odeiv2_system system = {rhs, jacobian, 4, &pendulum};
    gsl_odeiv2_driver *driver =
        gsl_odeiv2_driver_alloc_y_new(&system, type, task->h0, task->tolerance, task->tolerance);
    gsl_odeiv2_driver_set_nmax(driver, PATIENCE / 10);
    for (long n = 0; n < count; n++) {
        double t = 0.0, x[4];
        memcpy(x, task[n].x0, sizeof x);
        pendulum.evaluations = 0;
        gsl_odeiv2_driver_reset_hstart(driver, task->h0);
        int status = gsl_odeiv2_driver_apply(driver, &t, task[n].t1, x);
        end->t = status == GSL_SUCCESS ? t : -1.0;
        memcpy(end->x, x, sizeof x);
        end->evaluations = pendulum.evaluations;
    }
    gsl_odeiv2_driver_free(driver);
    double_pendulum_free(pendulum.model);
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
