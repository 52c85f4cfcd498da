
int @name@_rounds_once(void) {
    // volatile, so that the compiler does not compute the results itself
    volatile double third = 1.0 / 3.0, one = 1.0, above = 1.0 + DBL_EPSILON, half = DBL_EPSILON / 2.0;
    // the product is 1 - 2^-54
    const int keeps_product = PENDULUM_FMA(third, 3.0, -one) == -half / 2.0;
    // the product is 1 + 2^-51 + 2^-104; rounded to an extended format first, its sum with 2^-53 would be a tie
    const int rounds_up = PENDULUM_FMA(above, above, half) == one + 3.0 * DBL_EPSILON;
    return keeps_product && rounds_up;
}
