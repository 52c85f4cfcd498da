const @name@_params @name@_defaults = {
    @values@
};
