
/// The defaults of all parameters.
extern const @name@_params @name@_defaults;
