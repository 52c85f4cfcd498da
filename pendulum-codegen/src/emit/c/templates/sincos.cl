typedef struct {
    double sin, cos;
} Pendulum_pair;

// Sine and cosine of an angle in radians, to less than 1 ulp: the steps of the Rust code, in both precisions.
static inline Pendulum_pair Pendulum_sincos(double x) {
    Pendulum_pair pair;
#ifdef PENDULUM_SINGLE
    if (x > 6400.0f || x < -6400.0f) {
        pair.sin = sincos(x, &pair.cos);
        return pair;
    }
    const double shifted = x * 0.63661975f + 12582912.0f;
    const double n = shifted - 12582912.0f;
    const double near = (x - n * 1.5708008f) - n * -4.4703484e-6f;
    const double low = n * 1.5890691e-8f;
    const double last = n * 2.563344e-12f;
    const pendulum_word turns = as_uint(shifted);
#else
    if (x > 1e5 || x < -1e5) {
        pair.sin = sincos(x, &pair.cos);
        return pair;
    }
    const double shifted = x * 0.6366197723675814 + 6755399441055744.0;
    const double n = shifted - 6755399441055744.0;
    const double near = x - n * 1.5707963267923333;
    const double low = n * 2.5633441515839558e-12;
    const double last = n * 1.0562999066987428e-23;
    const pendulum_word turns = as_ulong(shifted);
#endif
    const double r = near - low;
    const double excess = (low - (near - r)) + last;

    const double z = r * r;
    const double z2 = z * z;
    const double half_z = z * 0.5;
    const double base = 1.0 - half_z;
#ifdef PENDULUM_SINGLE
    const double s = (0.16666654f + z * -0.008332106f) + z2 * 0.00019507883f;
    const double c = (0.041666646f + z * -0.0013887308f) + z2 * 2.4432102e-5f;
#else
    const double s = (0.1666666666666663 + z * -0.008333333333322118)
        + z2 * ((0.0001984126982958877 + z * -2.7557313621092594e-6)
        + z2 * (2.5050747713723324e-8 + z * -1.5896227149403376e-10));
    const double c = (0.041666666666666595 + z * -0.0013888888888873056)
        + z2 * ((2.4801587288850653e-5 + z * -2.7557314178988574e-7)
        + z2 * (2.0875700799352644e-9 + z * -1.1358534274429555e-11));
#endif
    const double sine = r - (r * (z * s) + excess * base);
    const double cosine = base + (((1.0 - base) - half_z) + (z2 * c + r * excess));

    const double a = turns & 1 ? cosine : sine;
    const double b = turns & 1 ? sine : cosine;
    pair.sin = turns & 2 ? -a : a;
    pair.cos = (turns + 1) & 2 ? -b : b;
    return pair;
}
