
// The sums left_j right_(k - j) over j = 1 .. k - 1 of all products of series; row j - 1 holds the coefficients of order j.
static void Pendulum_sums(size_t k, size_t products, const double *left, const double *right, double *sums) {
    for (size_t m = 0; m < products; m++) {
        // in two parts, so that an addition need not wait for the one before; the newest coefficients come last
        double even = 0.0, odd = 0.0;
        for (size_t j = 2; j + 1 < k; j++) {
            const double term = left[(j - 1) * products + m] * right[(k - j - 1) * products + m];
            if (j % 2 == 0) {
                even += term;
            } else {
                odd += term;
            }
        }
        sums[m] = even + odd;
        if (k > 1) {
            const size_t newest = (k - 2) * products + m;
            sums[m] += left[m] * right[newest] + left[newest] * (k > 2 ? right[m] : 0.0);
        }
    }
}

int @name@_series(const @name@_model *model, double t, double series[][@length@], size_t order, @name@_work *work@forces@) {
    double sums[@products@], kept[@kept@];
    if (order > @NAME@_MAX_ORDER) return 1;
    if (order == 0) return 0;
    {
        const double *const x = series[0];
        @start@
    }
    for (size_t k = 1; k < order; k++) {
        const double over_next = 1.0 / (double)(k + 1);
        double *const left = work->left + (k - 1) * @products@, *const right = work->right + (k - 1) * @products@;
        Pendulum_sums(k, @products@, work->left, work->right, sums);
        @order@
    }
    return 0;
}
