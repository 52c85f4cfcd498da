
// Iterative LQR with limits of the inputs: Y. Tassa, T. Erez, E. Todorov, IROS (2012) 4906; Y. Tassa, N. Mansard, E. Todorov, ICRA
// (2014) 1168. All operations have the order of the Rust code. Matrices are stored column by column.
enum { N = @NAME@_STATES, M = @NAME@_INPUTS, K = @NAME@_ILQR_STEPS };

// Weights of the state, of the inputs and of the final state, and the goal.
static const double Pendulum_q[N * N] = {
    @q@
};
static const double Pendulum_r[M * M] = {
    @r@
};
static const double Pendulum_end[N * N] = {
    @end@
};
static const double Pendulum_goal[N] = {@goal@};
static const double Pendulum_rest[M] = {@rest@};

// sum += a b, where a is a matrix of rows x inner entries, and b one of inner x columns entries.
static inline void Pendulum_add_product(int rows, int inner, int columns, double *sum, const double *a, const double *b) {
    for (int j = 0; j < columns; j++) {
        for (int k = 0; k < inner; k++) {
            const double factor = b[k + inner * j];
            for (int i = 0; i < rows; i++) sum[i + rows * j] += a[i + rows * k] * factor;
        }
    }
}

// sum += a^T b, where a is a matrix of inner x rows entries.
static inline void Pendulum_add_transposed(int rows, int inner, int columns, double *sum, const double *a, const double *b) {
    for (int j = 0; j < columns; j++) {
        for (int i = 0; i < rows; i++) {
            double entry = sum[i + rows * j];
            for (int k = 0; k < inner; k++) entry += a[k + inner * i] * b[k + inner * j];
            sum[i + rows * j] = entry;
        }
    }
}

// result = factor matrix
static inline void Pendulum_scale(int length, double factor, const double *matrix, double *result) {
    for (int n = 0; n < length; n++) result[n] = factor * matrix[n];
}

static inline void Pendulum_clear(int length, double *matrix) {
    for (int n = 0; n < length; n++) matrix[n] = 0.0;
}

static inline void Pendulum_copy(int length, const double *from, double *to) {
    for (int n = 0; n < length; n++) to[n] = from[n];
}

static inline double Pendulum_dot(int length, const double *a, const double *b) {
    double sum = 0.0;
    for (int n = 0; n < length; n++) sum = a[n] * b[n] + sum;
    return sum;
}

static int Pendulum_all_finite(int length, const double *numbers) {
    for (int n = 0; n < length; n++) {
        if (!Pendulum_is_finite(numbers[n])) return 0;
    }
    return 1;
}

// One step of the motion, by the explicit midpoint rule.
static void Pendulum_step(const @name@_model *model, double t, const double x[N], const double inputs[M], double end[N]) {
    const double h = @NAME@_ILQR_H, half = 0.5 * h;
    const @name@_inputs given = Pendulum_given(inputs), *const u = &given;
    double rate[N], middle[N];
    @name@_rhs(model, t, x, u, rate);
    for (int n = 0; n < N; n++) middle[n] = half * rate[n] + x[n];
    @name@_rhs(model, t + half, middle, u, rate);
    double *const out = end;
    for (int n = 0; n < N; n++) out[n] = h * rate[n] + x[n];
    @project@
}
@normalise@

// Derivatives of a step with respect to the state and to the inputs, by the chain rule through both evaluations.
static void Pendulum_step_derivatives(const @name@_model *model, double t, const double x[N], const double inputs[M], double a[N * N], double b[N * M]) {
    const double h = @NAME@_ILQR_H, half = 0.5 * h;
    const @name@_inputs given = Pendulum_given(inputs), *const u = &given;
    double rate[N], middle[N], by_state[N * N], by_inputs[N * M], middle_by_state[N * N];
    @name@_rhs_and_jacobian(model, t, x, u, rate, by_state);
    @name@_input_jacobian(model, t, x, u, by_inputs);
    for (int n = 0; n < N; n++) middle[n] = half * rate[n] + x[n];
    @name@_rhs_and_jacobian(model, t + half, middle, u, rate, middle_by_state);
    @name@_input_jacobian(model, t + half, middle, u, b);
    Pendulum_scale(N * N, half, by_state, by_state);
    Pendulum_scale(N * M, half, by_inputs, by_inputs);
    Pendulum_copy(N * N, middle_by_state, a);
    Pendulum_add_product(N, N, N, a, middle_by_state, by_state);
    Pendulum_add_product(N, N, M, b, middle_by_state, by_inputs);
    Pendulum_scale(N * N, h, a, a);
    Pendulum_scale(N * M, h, b, b);
    for (int n = 0; n < N; n++) a[n + N * n] += 1.0;
    @normalised@
}

// Cholesky factor of the rows and columns of a matrix that are free; in all others it is the identity. The diagonal holds reciprocals.
typedef struct {
    int is_free[M];
    double rows[M][M];
} Pendulum_factor;

// Returns 0 unless the matrix is positive definite in the free rows.
static int Pendulum_factorize(const double matrix[M * M], const int is_free[M], Pendulum_factor *factor) {
    for (int i = 0; i < M; i++) {
        factor->is_free[i] = is_free[i];
        for (int j = 0; j <= i; j++) {
            double entry = is_free[i] && is_free[j] ? matrix[i + M * j] : i == j ? 1.0 : 0.0;
            for (int k = 0; k < j; k++) entry -= factor->rows[i][k] * factor->rows[j][k];
            if (i != j) {
                factor->rows[i][j] = entry * factor->rows[j][j];
                continue;
            }
            // false for NaN as well
            if (!(entry > DBL_MIN && entry <= DBL_MAX)) return 0;
            factor->rows[i][j] = 1.0 / PENDULUM_SQRT(entry);
        }
    }
    return 1;
}

// Solves for the rows of a matrix of rows x M entries, with a minus sign; columns that are not free become 0.
static void Pendulum_solve_minus(int rows, const Pendulum_factor *factor, const double *of, double *result) {
    for (int i = 0; i < M; i++) {
        const double sign = factor->is_free[i] ? -1.0 : 0.0;
        double *const column = result + rows * i;
        Pendulum_scale(rows, sign, of + rows * i, column);
        for (int j = 0; j < i; j++) {
            for (int n = 0; n < rows; n++) column[n] -= factor->rows[i][j] * result[n + rows * j];
        }
        Pendulum_scale(rows, factor->rows[i][i], column, column);
    }
    for (int i = M - 1; i >= 0; i--) {
        double *const column = result + rows * i;
        for (int j = i + 1; j < M; j++) {
            for (int n = 0; n < rows; n++) column[n] -= factor->rows[j][i] * result[n + rows * j];
        }
        Pendulum_scale(rows, factor->rows[i][i], column, column);
    }
}

// Minimizes at . matrix at / 2 + slope . at within limits, beginning near `at`, by projected Newton steps (D. P. Bertsekas, SIAM J.
// Control Optim. 20 (1982) 221). Returns 0 unless the matrix is positive definite in the free inputs.
static int Pendulum_minimize(const double matrix[M * M], const double slope[M], const double low[M], const double high[M], double at[M], Pendulum_factor *factor) {
    int is_known = 0;
    Pendulum_limit(at, low, high);
    for (int step = 0; step < M + 20; step++) {
        double gradient[M], sizes[M], newton[M], next[M], length = 1.0;
        int is_free[M], is_level = 1, is_same = is_known, is_stuck = 1, is_at_rest = 1;
        for (int i = 0; i < M; i++) {
            gradient[i] = slope[i];
            sizes[i] = Pendulum_abs(slope[i]);
            for (int j = 0; j < M; j++) {
                const double term = matrix[i + M * j] * at[j];
                gradient[i] += term;
                sizes[i] += Pendulum_abs(term);
            }
            const int is_held = (at[i] <= low[i] && gradient[i] >= 0.0) || (at[i] >= high[i] && gradient[i] <= 0.0);
            is_free[i] = !is_held;
            // a gradient of a few ulps of its terms is put down to rounding
            is_level &= is_held || Pendulum_abs(gradient[i]) <= 16.0 * DBL_EPSILON * sizes[i];
            is_same = is_same && factor->is_free[i] == is_free[i];
        }
        if (!is_same && !Pendulum_factorize(matrix, is_free, factor)) return 0;
        is_known = 1;
        if (is_level) break;
        Pendulum_solve_minus(1, factor, gradient, newton);
        Pendulum_copy(M, at, next);
        for (int halving = 0; halving < 20; halving++) {
            double reached[M], promised = 0.0, change = 0.0;
            for (int i = 0; i < M; i++) reached[i] = at[i] + length * newton[i];
            Pendulum_limit(reached, low, high);
            for (int i = 0; i < M; i++) {
                const double moved = reached[i] - at[i];
                double bent = 0.0;
                for (int j = 0; j < M; j++) bent += matrix[i + M * j] * (reached[j] - at[j]);
                promised += gradient[i] * moved;
                change += moved * (gradient[i] + 0.5 * bent);
            }
            if (change <= 0.1 * promised) {
                Pendulum_copy(M, reached, next);
                break;
            }
            length *= 0.5;
        }
        for (int i = 0; i < M; i++) is_stuck = is_stuck && next[i] == at[i];
        for (int i = 0; i < M && is_stuck; i++) {
            // a step of any length crosses a limit that is all but reached: that input is held from now on
            const double reached = at[i] + length * newton[i];
            if (reached > high[i] && gradient[i] < 0.0) next[i] = high[i];
            else if (reached < low[i] && gradient[i] > 0.0) next[i] = low[i];
        }
        for (int i = 0; i < M; i++) {
            is_at_rest = is_at_rest && next[i] == at[i];
            at[i] = next[i];
        }
        if (is_at_rest) break;
    }
    return 1;
}

// The cost d . weights d of a deviation.
static double Pendulum_cost(int length, const double *weights, const double *deviation) {
    double product[N > M ? N : M];
    Pendulum_clear(length, product);
    Pendulum_add_product(length, length, 1, product, weights, deviation);
    return Pendulum_dot(length, deviation, product);
}

// Second derivatives of such a cost, and its gradient.
static void Pendulum_cost_derivatives(int length, const double *weights, const double *deviation, double *second, double *gradient) {
    Pendulum_scale(length * length, 2.0, weights, second);
    Pendulum_clear(length, gradient);
    Pendulum_add_product(length, length, 1, gradient, second, deviation);
}

static void Pendulum_deviation(int length, const double *from, const double *at, double *deviation) {
    for (int n = 0; n < length; n++) deviation[n] = at[n] - from[n];
}

// The law of a step with a share of the change of its inputs.
static void Pendulum_law(const @name@_ilqr *ilqr, int k, double share, const double x[N], double inputs[M]) {
    for (int m = 0; m < M; m++) {
        double feedback = 0.0;
        for (int n = 0; n < N; n++) feedback = ilqr->gain[k][m][n] * (x[n] - ilqr->plan.x[k][n]) + feedback;
        inputs[m] = (ilqr->plan.u[k][m] + share * ilqr->change[k][m]) + feedback;
    }
    Pendulum_limit(inputs, Pendulum_low, Pendulum_high);
}

static double Pendulum_time(double t0, int k) {
    return t0 + (double)k * @NAME@_ILQR_H;
}

// The motion under the changed inputs, into the trial. Returns 0 if it or its cost is not finite.
static int Pendulum_forward(@name@_ilqr *ilqr, const @name@_model *model, double t0, const double x0[N], double share, double *cost) {
    double x[N], dx[N], du[M];
    Pendulum_copy(N, x0, x);
    *cost = 0.0;
    for (int k = 0; k < K; k++) {
        double *const u = ilqr->trial.u[k];
        Pendulum_law(ilqr, k, share, x, u);
        Pendulum_copy(N, x, ilqr->trial.x[k]);
        Pendulum_deviation(N, Pendulum_goal, x, dx);
        Pendulum_deviation(M, Pendulum_rest, u, du);
        *cost += @NAME@_ILQR_H * (Pendulum_cost(N, Pendulum_q, dx) + Pendulum_cost(M, Pendulum_r, du));
        Pendulum_step(model, Pendulum_time(t0, k), ilqr->trial.x[k], u, x);
        if (!Pendulum_all_finite(N, x)) return 0;
    }
    Pendulum_copy(N, x, ilqr->trial.end);
    Pendulum_deviation(N, Pendulum_goal, x, dx);
    *cost += Pendulum_cost(N, Pendulum_end, dx);
    return Pendulum_is_finite(*cost);
}

// The backward pass along the trial: the best change of each input, as a law of the change of the state. The cost decreases by
// -(s slope + s^2 bend) for a share s of the change. Returns 0 if the cost is not convex in the inputs.
static int Pendulum_backward(@name@_ilqr *ilqr, const @name@_model *model, double t0, double *slope, double *bend) {
    const double h = @NAME@_ILQR_H;
    const int all[M] = {@ones@};
    double gradient[N], hessian[N * N], dx[N], guess[M];
    Pendulum_factor factor;
    Pendulum_deviation(N, Pendulum_goal, ilqr->trial.end, dx);
    Pendulum_cost_derivatives(N, Pendulum_end, dx, hessian, gradient);
    Pendulum_clear(M, guess);
    *slope = *bend = 0.0;
    for (int k = K - 1; k >= 0; k--) {
        double a[N * N], b[N * M], by_x[N], by_u[M], xx[N * N], xu[N * M], uu[M * M], du[M];
        double to_x[N * N], by_b[N * M], low[M], high[M], damped[M * M], bent[M], half[N * M], change[M], gain[N * M];
        double damping = ilqr->damping;
        Pendulum_step_derivatives(model, Pendulum_time(t0, k), ilqr->trial.x[k], ilqr->trial.u[k], a, b);
        Pendulum_deviation(N, Pendulum_goal, ilqr->trial.x[k], dx);
        Pendulum_deviation(M, Pendulum_rest, ilqr->trial.u[k], du);
        Pendulum_cost_derivatives(N, Pendulum_q, dx, xx, by_x);
        Pendulum_cost_derivatives(M, Pendulum_r, du, uu, by_u);
        // damping would hide it, and the search run away
        if (!Pendulum_factorize(uu, all, &factor)) return 0;

        Pendulum_clear(N * M, by_b);
        Pendulum_add_product(N, N, M, by_b, hessian, b);
        Pendulum_clear(N * N, to_x);
        Pendulum_add_product(N, N, N, to_x, hessian, a);
        Pendulum_scale(N, h, by_x, by_x);
        Pendulum_add_transposed(N, N, 1, by_x, a, gradient);
        Pendulum_scale(M, h, by_u, by_u);
        Pendulum_add_transposed(M, N, 1, by_u, b, gradient);
        Pendulum_scale(N * N, h, xx, xx);
        Pendulum_add_transposed(N, N, N, xx, a, to_x);
        Pendulum_clear(N * M, xu);
        Pendulum_add_transposed(N, N, M, xu, a, by_b);
        Pendulum_scale(M * M, h, uu, uu);
        Pendulum_add_transposed(M, N, M, uu, b, by_b);

        Pendulum_deviation(M, ilqr->trial.u[k], Pendulum_low, low);
        Pendulum_deviation(M, ilqr->trial.u[k], Pendulum_high, high);
        for (;;) {
            Pendulum_copy(M * M, uu, damped);
            for (int m = 0; m < M; m++) damped[m + M * m] += damping * Pendulum_abs(uu[m + M * m]);
            Pendulum_copy(M, guess, change);
            if (Pendulum_minimize(damped, by_u, low, high, change, &factor)) break;
            damping = Pendulum_max(1e-6, 10.0 * damping);
            // false for NaN as well
            if (!(damping < 1e10)) return 0;
        }
        Pendulum_copy(M, change, guess);
        Pendulum_solve_minus(N, &factor, xu, gain);

        // the minimum of the quadratic model of the cost to go with these inputs, which damping moves
        Pendulum_clear(M, bent);
        Pendulum_add_product(M, M, 1, bent, uu, change);
        *slope += Pendulum_dot(M, by_u, change);
        *bend += 0.5 * Pendulum_dot(M, change, bent);
        Pendulum_copy(N, by_x, gradient);
        for (int m = 0; m < M; m++) bent[m] = by_u[m] + bent[m];
        Pendulum_add_product(N, M, 1, gradient, gain, bent);
        Pendulum_add_product(N, M, 1, gradient, xu, change);
        // derivatives by the state alone that are not finite, as at a kink, reach the gains and not the minimum
        if (!Pendulum_all_finite(N, gradient)) return 0;
        Pendulum_copy(N * M, xu, half);
        Pendulum_scale(M * M, 0.5, uu, uu);
        Pendulum_add_product(N, M, M, half, gain, uu);
        for (int j = 0; j < N; j++) {
            for (int i = 0; i < N; i++) {
                double part = 0.0;
                for (int m = 0; m < M; m++) part += gain[i + N * m] * half[j + N * m];
                to_x[i + N * j] = 0.5 * xx[i + N * j] + part;
            }
        }
        for (int j = 0; j < N; j++) {
            for (int i = 0; i < N; i++) hessian[i + N * j] = to_x[i + N * j] + to_x[j + N * i];
        }
        Pendulum_copy(M, change, ilqr->change[k]);
        Pendulum_copy(N * M, gain, ilqr->gain[k][0]);
    }
    return 1;
}

void @name@_ilqr_start(@name@_ilqr *ilqr) {
    static const double start[K][M] = {
        @start@
    };
    for (int k = 0; k < K; k++) {
        Pendulum_copy(M, start[k], ilqr->plan.u[k]);
        Pendulum_clear(N, ilqr->plan.x[k]);
        Pendulum_clear(M, ilqr->change[k]);
        Pendulum_clear(M * N, ilqr->gain[k][0]);
    }
    Pendulum_clear(N, ilqr->plan.end);
    ilqr->damping = 0.0;
    ilqr->factor = 1.0;
    ilqr->cost = ilqr->cost_before = ilqr->share = ilqr->t = 0.0;
    ilqr->is_sampled = 0;
}

int @name@_ilqr_pass(@name@_ilqr *ilqr, const @name@_model *model, double t0, const double x0[@length@]) {
    double cost, slope, bend, share = 1.0;
    if (!(Pendulum_is_finite(t0) && Pendulum_all_finite(N, x0))) return @NAME@_ILQR_NOT_FINITE;
    if (!Pendulum_forward(ilqr, model, t0, x0, 0.0, &cost)) return @NAME@_ILQR_DIVERGED;
    if (!Pendulum_backward(ilqr, model, t0, &slope, &bend)) return @NAME@_ILQR_NOT_CONVEX;
    ilqr->plan = ilqr->trial;
    ilqr->cost = ilqr->cost_before = cost;
    ilqr->share = 0.0;
    const int is_level = -share * (slope + share * bend) <= 64.0 * DBL_EPSILON * Pendulum_abs(cost);
    for (int halving = 0; halving <= 8 && !is_level; halving++) {
        const double promised = -share * (slope + share * bend);
        if (Pendulum_forward(ilqr, model, t0, x0, share, &cost) && promised > 0.0 && ilqr->cost_before - cost >= 1e-2 * promised) {
            ilqr->plan = ilqr->trial;
            Pendulum_clear(K * M, ilqr->change[0]);
            ilqr->cost = cost;
            ilqr->share = share;
            break;
        }
        share *= 0.5;
    }
    if (is_level || ilqr->share > 0.0) {
        ilqr->factor = Pendulum_min(0.5, ilqr->factor * 0.5);
        ilqr->damping *= ilqr->factor;
        if (ilqr->damping < 1e-6) ilqr->damping = 0.0;
    } else {
        ilqr->factor = Pendulum_max(2.0, ilqr->factor * 2.0);
        ilqr->damping = Pendulum_max(1e-6, ilqr->damping * ilqr->factor);
    }
    return @NAME@_ILQR_OK;
}

void @name@_ilqr_shift(@name@_ilqr *ilqr) {
    for (int k = 0; k + 1 < K; k++) {
        Pendulum_copy(N, ilqr->plan.x[k + 1], ilqr->plan.x[k]);
        Pendulum_copy(M, ilqr->plan.u[k + 1], ilqr->plan.u[k]);
        Pendulum_copy(M * N, ilqr->gain[k + 1][0], ilqr->gain[k][0]);
    }
    Pendulum_copy(N, ilqr->plan.end, ilqr->plan.x[K - 1]);
}

void @name@_ilqr_command(const @name@_ilqr *ilqr, int step, const double x[@length@], @name@_inputs *u) {
    double inputs[M];
    Pendulum_law(ilqr, step, 0.0, x, inputs);
    *u = Pendulum_given(inputs);
}

int @name@_ilqr_sample(@name@_ilqr *ilqr, const @name@_model *model, double t, const double x[@length@], @name@_inputs *u) {
    // before the plan moves on: a time that is not finite would spoil its clock
    if (!(Pendulum_is_finite(t) && Pendulum_all_finite(N, x))) return @NAME@_ILQR_NOT_FINITE;
    const double h = @NAME@_ILQR_H;
    double start = ilqr->is_sampled ? ilqr->t : t;
    // at most one plan: what follows its end repeats its last inputs
    for (int k = 0; k < K && !(t - start < 0.5 * h); k++) {
        @name@_ilqr_shift(ilqr);
        start += h;
    }
    if (t - start >= h) start = t;
    ilqr->t = start;
    ilqr->is_sampled = 1;
    const int code = @name@_ilqr_pass(ilqr, model, t, x);
    if (code == @NAME@_ILQR_OK) *u = Pendulum_given(ilqr->plan.u[0]);
    return code;
}
