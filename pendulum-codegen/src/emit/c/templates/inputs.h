
/// Inputs, given at each evaluation.
typedef struct {
    @fields@
} @name@_inputs;
