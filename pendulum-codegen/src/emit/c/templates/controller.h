
/// Number of components of the state.
#define @NAME@_STATES @length@

/// Number of inputs.
#define @NAME@_INPUTS @inputs@

/// One step of the classical Runge-Kutta method from t to t1, with inputs that are held over it: a step of `Rk4`.
void @name@_rk4_step(const @name@_model *model, double t, double t1, const double x[@length@], const @name@_inputs *u, double out[@length@]);
