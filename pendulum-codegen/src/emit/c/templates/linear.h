
/// The inputs u0 - K (x - x0), within their limits: those of `LinearLaw`.
///
/// All inputs are NaN if a component of x is NaN: check before they act.
void @name@_linear_law(const double x[@length@], @name@_inputs *u);
