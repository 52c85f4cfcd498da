// Swing-up of a pole on a cart by the controller of docs/src/recipes/controller-in-c.md, which first writes it into a folder:
//
//     cc -std=c99 -O2 -ffp-contract=off -Iout examples/emitted_c/swing_up.c out/cart_pole.c -lm -o out/swing_up
//
// Prints the time, the force and the state as CSV. On the real cart, x is measured, and the force goes to the motor, which stops where
// this program ends: at a code that is not 0, and at a force that is not a number.
#include <math.h>
#include <stdio.h>

#include "cart_pole.h"

// static, since a plan is large for a stack
static cart_pole_ilqr ilqr;

int main(void) {
    cart_pole_model model;
    cart_pole_inputs u = {0.0};
    double x[CART_POLE_STATES] = {0.0, 3.2, 0.0, 0.0};
    int is_up = 0;
    if (cart_pole_new(&model, &cart_pole_defaults) != CART_POLE_OK) return 1;
    cart_pole_ilqr_start(&ilqr);
    printf("t,push,s,theta,s_rate,theta_rate\n");
    for (int sample = 0; sample < 240; sample++) {
        const double t = sample * CART_POLE_ILQR_H;
        is_up = is_up || (fabs(x[1]) < 0.1 && fabs(x[3]) < 0.5);
        if (is_up) {
            cart_pole_linear_law(x, &u);
        } else if (cart_pole_ilqr_sample(&ilqr, &model, t, x, &u) != CART_POLE_ILQR_OK) {
            return 1;
        }
        // the linear law returns no code: its force is NaN where the state is
        if (!isfinite(u.push)) return 1;
        printf("%g,%.17g,%.17g,%.17g,%.17g,%.17g\n", t, u.push, x[0], x[1], x[2], x[3]);
        cart_pole_rk4_step(&model, t, t + CART_POLE_ILQR_H, x, &u, x);
    }
    return 0;
}
