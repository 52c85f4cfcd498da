#include <stdio.h>

#include "name.h"

static name_model model;
static name_ilqr ilqr;

static void put(const REAL *numbers, int length) {
    for (int n = 0; n < length; n++) {
        const double number = (double)numbers[n];
        fwrite(&number, sizeof number, 1, stdout);
    }
}

static int get(REAL *t, REAL x[NAME_STATES]) {
    double in[1 + NAME_STATES];
    if (fread(in, sizeof in, 1, stdin) != 1) return 0;
    *t = (REAL)in[0];
    for (int n = 0; n < NAME_STATES; n++) x[n] = (REAL)in[1 + n];
    return 1;
}

int main(void) {
    REAL t, x[NAME_STATES];
    name_inputs u;
    if (name_new(&model, &name_defaults) != NAME_OK || !get(&t, x)) return 1;
    name_ilqr_start(&ilqr);
    for (int sample = 0; sample < SAMPLES; sample++) {
        const REAL t1 = t + NAME_ILQR_H;
        const int code = name_ilqr_sample(&ilqr, &model, t, x, &u);
        if (code != NAME_ILQR_OK) return 1 + code;
        put((const REAL *)&u, NAME_INPUTS);
        PROJECT;
        // the state may be overwritten
        name_rk4_step(&model, t, t1, x, &u, x);
        put(x, NAME_STATES);
        put(ilqr.plan.end, NAME_STATES);
        put(ilqr.gain[3][0], NAME_INPUTS * NAME_STATES);
        // later, samples are missed
        t = sample + LATE == SAMPLES ? t1 + MISSED * NAME_ILQR_H : t1;
    }
    while (get(&t, x)) {
        name_linear_law(x, &u);
        put((const REAL *)&u, NAME_INPUTS);
        name_ilqr_command(&ilqr, 5, x, &u);
        put((const REAL *)&u, NAME_INPUTS);
        PROJECT;
        name_rk4_step(&model, t, t + NAME_ILQR_H, x, &u, x);
        put(x, NAME_STATES);
    }
    return 0;
}
