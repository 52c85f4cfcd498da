
/// The highest order of a series.
#define @NAME@_MAX_ORDER 24

/// The workspace of a series.
typedef struct {
    double left[(@NAME@_MAX_ORDER - 1) * @products@], right[(@NAME@_MAX_ORDER - 1) * @products@];
} @name@_work;

/// The power series of the motion@constant@: from series[0], the state at t, to series[order]. The state at tau is the sum of
/// series[k] * (tau - t)^k.
///
/// Returns 0; or 1, without a result, if the order is above @NAME@_MAX_ORDER.
int @name@_series(const @name@_model *model, double t, double series[][@length@], size_t order, @name@_work *work@forces@);
