
void @name@_linear_law(const double x[@length@], @name@_inputs *u) {
    // one row for each component of the state
    static const double gain[@length@][@NAME@_INPUTS] = {
        @gain@
    };
    static const double x0[@length@] = {@x0@};
    double inputs[@NAME@_INPUTS] = {@u0@};
    for (int n = 0; n < @length@; n++) {
        const double deviation = x[n] - x0[n];
        for (int m = 0; m < @NAME@_INPUTS; m++) inputs[m] -= gain[n][m] * deviation;
    }
    Pendulum_limit(inputs, Pendulum_low, Pendulum_high);
    *u = Pendulum_given(inputs);
}
