// Fig. 2 of H. Williams, "A compound double pendulum with friction" (2023), by the classical Runge-Kutta method: prints
// CSV for each friction.
//
//     cargo run --example emitted -- --c testbed/src/scenes.rs
//     cc -std=c99 -O2 -ffp-contract=off -Iout/emitted examples/emitted_c/fig2.c out/emitted/double_pendulum.c -lm -o out/emitted/fig2
#include <stdio.h>

#include "double_pendulum.h"

// x + sum of weight_i slope_i over the first `count` slopes
static void shifted(const double x[4], int count, const double weight[], double slope[][4], double out[4]) {
    for (int n = 0; n < 4; n++) {
        double sum = weight[0] * slope[0][n];
        for (int i = 1; i < count; i++) {
            sum += weight[i] * slope[i][n];
        }
        out[n] = x[n] + sum;
    }
}

// a step from t to t1
static void step(const double_pendulum_model *model, double t, double t1, double x[4]) {
    const double h = t1 - t, half = h * 0.5, sixth = h * (1.0 / 6.0), third = h * (1.0 / 3.0);
    const double weights[] = {sixth, third, third, sixth};
    double slope[4][4], y[4];
    double_pendulum_rhs(model, t, x, slope[0]);
    shifted(x, 1, &half, &slope[0], y);
    double_pendulum_rhs(model, t + half, y, slope[1]);
    shifted(x, 1, &half, &slope[1], y);
    double_pendulum_rhs(model, t + half, y, slope[2]);
    shifted(x, 1, &h, &slope[2], y);
    double_pendulum_rhs(model, t1, y, slope[3]);
    shifted(x, 4, weights, slope, x);
}

int main(void) {
    const double gammas[] = {1.0, 0.4, 0.1}, h = 0.01;
    printf("gamma,t,theta1,theta2,rate1,rate2\n");
    for (int run = 0; run < 3; run++) {
        double_pendulum_params params = double_pendulum_defaults;
        params.gamma1 = params.gamma2 = gammas[run];
        double_pendulum_model model;
        const int code = double_pendulum_new(&model, &params);
        if (code != DOUBLE_PENDULUM_OK) {
            fprintf(stderr, "%s\n", double_pendulum_error(code));
            return 1;
        }
        double x[4] = {0.0, 0.06981317007977318, 0.0, 0.0}; // 4 degrees
        for (int i = 0; i <= 2000; i++) {
            if (i > 0) {
                step(&model, (i - 1) * h, i * h, x);
            }
            printf("%g,%g,%.17g,%.17g,%.17g,%.17g\n", gammas[run], i * h, x[0], x[1], x[2], x[3]);
        }
    }
    return 0;
}
