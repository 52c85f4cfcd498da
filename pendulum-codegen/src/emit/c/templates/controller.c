
static @name@_inputs Pendulum_given(const double u[@NAME@_INPUTS]) {
    @name@_inputs given;
    @given@
    return given;
}

void @name@_rk4_step(const @name@_model *model, double t, double t1, const double x[@length@], const @name@_inputs *u, double out[@length@]) {
    const double h = t1 - t, half = h * 0.5, sixth = h * (1.0 / 6.0), third = h * (1.0 / 3.0);
    double a[@length@], b[@length@], c[@length@], d[@length@], y[@length@];
    @name@_rhs(model, t, x, u, a);
    for (int n = 0; n < @length@; n++) y[n] = x[n] + half * a[n];
    @name@_rhs(model, t + half, y, u, b);
    for (int n = 0; n < @length@; n++) y[n] = x[n] + half * b[n];
    @name@_rhs(model, t + half, y, u, c);
    for (int n = 0; n < @length@; n++) y[n] = x[n] + h * c[n];
    @name@_rhs(model, t1, y, u, d);
    for (int n = 0; n < @length@; n++) out[n] = x[n] + (sixth * a[n] + third * b[n] + third * c[n] + sixth * d[n]);
    @project@
}

// Limits of the inputs.
static const double Pendulum_low[@NAME@_INPUTS] = {@low@};
static const double Pendulum_high[@NAME@_INPUTS] = {@high@};

static void Pendulum_limit(double u[@NAME@_INPUTS], const double *low, const double *high) {
    for (int m = 0; m < @NAME@_INPUTS; m++) u[m] = Pendulum_min(Pendulum_max(u[m], low[m]), high[m]);
}
