#include <math.h>
#include <string.h>

#include "name.h"

static name_model model;
static name_ilqr ilqr, before;

/// True if a sample is refused, and nothing has changed.
static int is_refused(REAL t, const REAL x[NAME_STATES]) {
    name_inputs u = {(REAL)0.25};
    return name_ilqr_sample(&ilqr, &model, t, x, &u) == NAME_ILQR_NOT_FINITE && u.motor == (REAL)0.25 &&
           memcmp(&ilqr, &before, sizeof ilqr) == 0;
}

int main(void) {
    const REAL start[NAME_STATES] = {1, 0}, kink[NAME_STATES] = {0, 0}, crossed[NAME_STATES] = {0, 1}, unknown[NAME_STATES] = {0, (REAL)NAN};
    name_inputs u;
    if (name_new(&model, &name_defaults) != NAME_OK) return 1;
    name_ilqr_start(&ilqr);
    if (name_ilqr_sample(&ilqr, &model, NAME_ILQR_H, start, &u) != NAME_ILQR_OK) return 2;
    memcpy(&before, &ilqr, sizeof ilqr);
    if (!is_refused((REAL)NAN, start) || !is_refused((REAL)INFINITY, start) || !is_refused(NAME_ILQR_H, unknown)) return 3;
    // derivatives are NaN where the motion starts, at the last node of the backward pass
    if (name_ilqr_pass(&ilqr, &model, 0, kink) != NAME_ILQR_NOT_CONVEX) return 4;
    if (memcmp(&ilqr.plan, &before.plan, sizeof ilqr.plan) != 0) return 5;
    if (name_ilqr_pass(&ilqr, &model, 0, start) != NAME_ILQR_OK) return 6;
    // with a rate, only those by the state are
    memcpy(&before, &ilqr, sizeof ilqr);
    if (name_ilqr_pass(&ilqr, &model, 0, crossed) != NAME_ILQR_NOT_CONVEX) return 9;
    if (memcmp(&ilqr.plan, &before.plan, sizeof ilqr.plan) != 0 || memcmp(ilqr.gain[0], before.gain[0], sizeof ilqr.gain[0]) != 0) return 10;
    name_linear_law(unknown, &u);
    if (!isnan(u.motor)) return 7;
    name_ilqr_command(&ilqr, NAME_ILQR_STEPS - 1, unknown, &u);
    if (!isnan(u.motor)) return 8;
    return 0;
}
