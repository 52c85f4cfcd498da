
/// Returns 1 if sums with a product are rounded once on this machine, as the results require, and 0 if its fma rounds the product or
/// an intermediate result.
int @name@_rounds_once(void);
