// Integrates one trajectory per work-item, with the same steps as the Rust code. The tableau is prepended to this file.
typedef pendulum_real real;

#ifdef PENDULUM_SINGLE
#define EPSILON FLT_EPSILON
#define LEAST FLT_MIN
#else
#define EPSILON DBL_EPSILON
#define LEAST DBL_MIN
#endif

// Status of a trajectory. NOT_FINITE also encodes the component: its index times ENDS is added.
enum { AT_THE_END, NOT_FINITE, NOT_FINITE_AT_START, UNDERFLOW, TOO_MANY_STEPS, ENDS };

// Returns the index of the first component that is not finite, or -1.
static int not_finite(const real v[SCENE_LENGTH]) {
    for (int c = 0; c < SCENE_LENGTH; c++) {
        if (!isfinite(v[c])) return c;
    }
    return -1;
}

#ifdef ERROR_ORDER
static real mean_square(real rtol, real atol, const real error[SCENE_LENGTH], const real x0[SCENE_LENGTH],
                        const real x1[SCENE_LENGTH]) {
    const real half_rtol = rtol * (real)0.5;
    real sum = 0;
    for (int c = 0; c < SCENE_LENGTH; c++) {
        const real size = fabs(x0[c]) + fabs(x1[c]);
        const real ratio = error[c] / (atol + half_rtol * size);
        sum += ratio * ratio;
    }
    return sum * (real)(1.0 / SCENE_LENGTH);
}

#ifdef PENDULUM_SINGLE
#define rough_log2 log2
#define rough_exp2 exp2
#else
static double rough_log2(double x) {
    const ulong bits = as_ulong(x);
    const double m = as_double((bits & 0x000fffffffffffff) | 0x3ff0000000000000);
    const double exponent = as_double((bits >> 52) | 0x4330000000000000) - (4503599627370496.0 + 1023.0);
    const double square = m * m;
    const double low = -2.49835315 + 4.02921139 * m;
    const double high = -2.07833517 + 0.62603218 * m - 0.07844068 * square;
    return exponent + (low + square * high);
}

static double rough_exp2(double x) {
    x = fmin(fmax(x, -1022.0), 1023.0);
    const double rounded = x + 6755399441055744.0;
    const double y = x - (rounded - 6755399441055744.0);
    const double power = (0.99992456 + 0.69313673 * y) + y * y * (0.24263948 + 0.05583828 * y);
    return power * as_double((as_ulong(rounded) + 1023) << 52);
}
#endif
#endif

kernel void integrate(const uint count, const real t0, const real t1, const real h_fixed, const real rtol, const real atol,
                      const real h_min, const real h_max, const ulong max_steps, global const real *params,
                      global const real *starts, global real *ends, global int *codes) {
    const size_t id = get_global_id(0);
    if (id >= count) return;
    scene_params own;
    real *const fields = (real *)&own;
    for (int p = 0; p < SCENE_PARAMETERS; p++) {
        fields[p] = params[p * (size_t)count + id];
    }
    scene_model model;
    scene_new(&model, &own);

    real x[SCENE_LENGTH], x_new[SCENE_LENGTH], k[STAGES][SCENE_LENGTH];
    for (int c = 0; c < SCENE_LENGTH; c++) {
        x[c] = starts[c * (size_t)count + id];
    }
    const real direction = t1 < t0 ? -1 : 1;
    real t = t0;
    int code = AT_THE_END;
    real detail[2] = {0, 0};
    if (t != t1) {
        scene_rhs(&model, t, x, k[0]);
        const int bad = not_finite(k[0]);
        if (bad >= 0) code = NOT_FINITE_AT_START + ENDS * bad;
    }

#ifdef ERROR_ORDER
    real h = starts[SCENE_LENGTH * (size_t)count + id];
    real last = -13.287712379549449, most = 3;
    const real alpha = ALPHA;
    for (ulong steps = 0; t != t1 && code == AT_THE_END; steps++) {
        if (steps >= max_steps) {
            code = TOO_MANY_STEPS;
            break;
        }
        const real least = fmax(fmax(h_min, 4 * EPSILON * fabs(t)), LEAST);
        const real remaining = fabs(t1 - t);
        h = fmax(h, least);
        const real half_way = t + direction * (remaining * (real)0.5);
        const real whole = t + direction * h;
        real t_new = remaining < h + h ? half_way : whole;
        t_new = remaining <= h * (real)1.01 ? t1 : t_new;

        real error[SCENE_LENGTH];
        stages(&model, t, t_new, x, k, x_new);
        int bad = not_finite(x_new);
        real square = NAN;
        if (bad < 0) {
            scene_rhs(&model, t_new, x_new, k[STAGES - 1]);
            error_of(fabs(t_new - t), k, error);
            square = mean_square(rtol, atol, error, x, x_new);
            if (square <= 1) {
                bad = not_finite(k[STAGES - 1]);
                if (bad >= 0) square = NAN;
            }
        }
        const bool is_accepted = square <= 1;
        const real of_error = (real)0.5 * rough_log2(square);
        const real memory = is_accepted ? (real)0.04 * last : 0;
        real factor = (real)0.9 * rough_exp2(memory - alpha * of_error);
        factor = fmax(fmin(factor, most), (real)0.2);
        if (is_accepted) last = fmax(of_error, (real)-13.287712379549449);
        most = is_accepted ? 3 : 1;
        factor = isnan(square) ? (real)0.25 : factor;
        h = fabs(t_new - t) * factor;
        if (is_accepted) {
            h = fmin(h, h_max);
            t = t_new;
            for (int c = 0; c < SCENE_LENGTH; c++) {
                x[c] = x_new[c];
                k[0][c] = k[STAGES - 1][c];
            }
        } else if (h < least) {
            code = bad >= 0 ? NOT_FINITE + ENDS * bad : UNDERFLOW;
            detail[0] = bad >= 0 ? t_new - t : h;
            detail[1] = least;
        }
    }
#else
    const real slack = 8 * EPSILON * fmax(fabs(t0), fabs(t1));
    for (ulong reached = 1; t != t1 && code == AT_THE_END; reached++) {
        const real time = t0 + direction * (h_fixed * (real)reached);
        const real t_new = (t1 - time) * direction <= slack ? t1 : time;
        stages(&model, t, t_new, x, k, x_new);
        int bad = not_finite(x_new);
        if (bad < 0) {
            scene_rhs(&model, t_new, x_new, k[STAGES - 1]);
            bad = not_finite(k[STAGES - 1]);
        }
        if (bad >= 0) {
            code = NOT_FINITE + ENDS * bad;
            detail[0] = t_new - t;
            break;
        }
        t = t_new;
        for (int c = 0; c < SCENE_LENGTH; c++) {
            x[c] = x_new[c];
            k[0][c] = k[STAGES - 1][c];
        }
    }
#endif

    for (int c = 0; c < SCENE_LENGTH; c++) {
        ends[c * (size_t)count + id] = x[c];
    }
    ends[SCENE_LENGTH * (size_t)count + id] = t;
    ends[(SCENE_LENGTH + 1) * (size_t)count + id] = detail[0];
    ends[(SCENE_LENGTH + 2) * (size_t)count + id] = detail[1];
    codes[id] = code;
}
