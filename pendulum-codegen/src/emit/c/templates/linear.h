
/// The inputs u0 - K (x - x0), within their limits: those of `LinearLaw`.
void @name@_linear_law(const double x[@length@], @name@_inputs *u);
