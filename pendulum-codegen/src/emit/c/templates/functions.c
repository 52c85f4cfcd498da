// Functions that generated code may call. Each section starts with the name of one; for a function of the platform, it also gives the default.
// Names of helpers begin with a capital and go on in small letters, so that they cannot clash with names from a scene, whose prefix
// is in snake_case.

//! PENDULUM_ATAN2: atan2
#ifndef PENDULUM_ATAN2
#define PENDULUM_ATAN2 atan2
#endif
extern double PENDULUM_ATAN2(double, double);

//! PENDULUM_COS: cos, called for angles beyond 1e5 rad only
#ifndef PENDULUM_COS
#define PENDULUM_COS cos
#endif
extern double PENDULUM_COS(double);

//! PENDULUM_EXP: exp
#ifndef PENDULUM_EXP
#define PENDULUM_EXP exp
#endif
extern double PENDULUM_EXP(double);

//! PENDULUM_FMA: fma
#ifndef PENDULUM_FMA
#define PENDULUM_FMA fma
#endif
extern double PENDULUM_FMA(double, double, double);

//! PENDULUM_LN: log
#ifndef PENDULUM_LN
#define PENDULUM_LN log
#endif
extern double PENDULUM_LN(double);

//! PENDULUM_POW: pow
#ifndef PENDULUM_POW
#define PENDULUM_POW pow
#endif
extern double PENDULUM_POW(double, double);

//! PENDULUM_SIN: sin, called for angles beyond 1e5 rad only
#ifndef PENDULUM_SIN
#define PENDULUM_SIN sin
#endif
extern double PENDULUM_SIN(double);

//! PENDULUM_SQRT: sqrt
#ifndef PENDULUM_SQRT
#define PENDULUM_SQRT sqrt
#endif
extern double PENDULUM_SQRT(double);

//! PENDULUM_TAN: tan
#ifndef PENDULUM_TAN
#define PENDULUM_TAN tan
#endif
extern double PENDULUM_TAN(double);

//! PENDULUM_TANH: tanh
#ifndef PENDULUM_TANH
#define PENDULUM_TANH tanh
#endif
extern double PENDULUM_TANH(double);

//! Pendulum_abs
// The absolute value; +0.0 of both zeros.
static inline double Pendulum_abs(double x) {
    return x > 0.0 ? x : 0.0 - x;
}

//! Pendulum_is_finite
static inline int Pendulum_is_finite(double x) {
    return x >= -DBL_MAX && x <= DBL_MAX;
}

//! Pendulum_max
// The larger of two; the left one if they are equal, or if it is NaN.
static inline double Pendulum_max(double a, double b) {
    return a < b ? b : a;
}

//! Pendulum_min
// The smaller of two; the left one if they are equal, or if it is NaN.
static inline double Pendulum_min(double a, double b) {
    return a > b ? b : a;
}

//! Pendulum_signum
// The sign: -1, 0 or 1. Zeros and NaN are returned as they are.
static inline double Pendulum_signum(double x) {
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}

//! Pendulum_pair
typedef struct {
    double sin, cos;
} Pendulum_pair;

typedef union {
    double number;
    uint64_t bits;
} Pendulum_bits;

//! Pendulum_sincos
// Sine and cosine of an angle in radians, to less than 1 ulp.
//
// The angle is reduced to [-pi/4, pi/4] by a multiple of pi/2 in parts of 37, 37 and 53 bits (Cody and Waite), and the rounding error
// of the reduced angle is carried along. The polynomials are minimax ones, evaluated by Estrin's scheme.
static inline Pendulum_pair Pendulum_sincos(double x) {
    Pendulum_bits turned, sine, cosine;
    Pendulum_pair pair;
    uint64_t swap;
    if (x > 1e5 || x < -1e5) {
        pair.sin = PENDULUM_SIN(x);
        pair.cos = PENDULUM_COS(x);
        return pair;
    }
    // 1.5 * 2^52 leaves no room for a fraction: the sum is rounded to an integer, which stands in its lowest bits
    turned.number = x * 0.6366197723675814 + 6755399441055744.0;
    const double n = turned.number - 6755399441055744.0;
    const double near = x - n * 1.5707963267923333;
    const double low = n * 2.5633441515839558e-12;
    const double r = near - low;
    // the reduced angle is r - excess
    const double excess = (low - (near - r)) + n * 1.0562999066987428e-23;

    const double z = r * r;
    const double z2 = z * z;
    const double half_z = z * 0.5;
    const double base = 1.0 - half_z;
    const double s = (0.1666666666666663 + z * -0.008333333333322118)
        + z2 * ((0.0001984126982958877 + z * -2.7557313621092594e-6)
        + z2 * (2.5050747713723324e-8 + z * -1.5896227149403376e-10));
    const double c = (0.041666666666666595 + z * -0.0013888888888873056)
        + z2 * ((2.4801587288850653e-5 + z * -2.7557314178988574e-7)
        + z2 * (2.0875700799352644e-9 + z * -1.1358534274429555e-11));
    // a difference, so that the sine of -0.0 is -0.0
    sine.number = r - (r * (z * s) + excess * base);
    cosine.number = base + (((1.0 - base) - half_z) + (z2 * c + r * excess));

    // quarter turns, without a branch
    swap = (sine.bits ^ cosine.bits) & (0 - (turned.bits & 1));
    sine.bits ^= swap ^ ((turned.bits & 2) << 62);
    cosine.bits ^= swap ^ (((turned.bits + 1) & 2) << 62);
    pair.sin = sine.number;
    pair.cos = cosine.number;
    return pair;
}

//! Pendulum_pairf
typedef struct {
    float sin, cos;
} Pendulum_pairf;

typedef union {
    float number;
    uint32_t bits;
} Pendulum_bitsf;

//! Pendulum_sincosf
// Sine and cosine of an angle in radians, to less than 1 ulp of single precision, in the steps of Pendulum_sincos: multiples of pi/2 in
// parts of 12, 12, 9 and 24 bits.
static inline Pendulum_pairf Pendulum_sincosf(float x) {
    Pendulum_bitsf turned, sine, cosine;
    Pendulum_pairf pair;
    uint32_t swap;
    if (x > 6400.0f || x < -6400.0f) {
        pair.sin = PENDULUM_SINF(x);
        pair.cos = PENDULUM_COSF(x);
        return pair;
    }
    turned.number = x * 0.63661975f + 12582912.0f;
    const float n = turned.number - 12582912.0f;
    const float near = (x - n * 1.5708008f) - n * -4.4703484e-6f;
    const float low = n * 1.5890691e-8f;
    const float r = near - low;
    const float excess = (low - (near - r)) + n * 2.563344e-12f;

    const float z = r * r;
    const float z2 = z * z;
    const float half_z = z * 0.5f;
    const float base = 1.0f - half_z;
    const float s = (0.16666654f + z * -0.008332106f) + z2 * 0.00019507883f;
    const float c = (0.041666646f + z * -0.0013887308f) + z2 * 2.4432102e-5f;
    sine.number = r - (r * (z * s) + excess * base);
    cosine.number = base + (((1.0f - base) - half_z) + (z2 * c + r * excess));

    swap = (sine.bits ^ cosine.bits) & (0 - (turned.bits & 1));
    sine.bits ^= swap ^ ((turned.bits & 2) << 30);
    cosine.bits ^= swap ^ (((turned.bits + 1) & 2) << 30);
    pair.sin = sine.number;
    pair.cos = cosine.number;
    return pair;
}

//! Pendulum_sincos_fused
// Sine and cosine of an angle in radians, to less than 1 ulp, in fused arithmetic.
//
// The angle is reduced to [-pi/4, pi/4] by a multiple of pi/2 in parts of 37, 37 and 53 bits (Cody and Waite), and the rounding error
// of the reduced angle is carried along. The polynomials are minimax ones, evaluated by Estrin's scheme.
static inline Pendulum_pair Pendulum_sincos_fused(double x) {
    Pendulum_bits turned, sine, cosine;
    Pendulum_pair pair;
    uint64_t swap;
    if (x > 1e5 || x < -1e5) {
        pair.sin = PENDULUM_SIN(x);
        pair.cos = PENDULUM_COS(x);
        return pair;
    }
    // 1.5 * 2^52 leaves no room for a fraction: the sum is rounded to an integer, which stands in its lowest bits
    turned.number = PENDULUM_FMA(x, 0.6366197723675814, 6755399441055744.0);
    const double n = turned.number - 6755399441055744.0;
    const double near = PENDULUM_FMA(-n, 1.5707963267923333, x);
    const double low = n * 2.5633441515839558e-12;
    const double r = near - low;
    // the reduced angle is r - excess
    const double excess = PENDULUM_FMA(n, 1.0562999066987428e-23, low - (near - r));

    const double z = r * r;
    const double z2 = z * z;
    const double half_z = z * 0.5;
    const double base = 1.0 - half_z;
    const double s = PENDULUM_FMA(z2, PENDULUM_FMA(z2,
        PENDULUM_FMA(z, -1.5896227149403376e-10, 2.5050747713723324e-8),
        PENDULUM_FMA(z, -2.7557313621092594e-6, 0.0001984126982958877)),
        PENDULUM_FMA(z, -0.008333333333322118, 0.1666666666666663));
    const double c = PENDULUM_FMA(z2, PENDULUM_FMA(z2,
        PENDULUM_FMA(z, -1.1358534274429555e-11, 2.0875700799352644e-9),
        PENDULUM_FMA(z, -2.7557314178988574e-7, 2.4801587288850653e-5)),
        PENDULUM_FMA(z, -0.0013888888888873056, 0.041666666666666595));
    // a difference, so that the sine of -0.0 is -0.0
    sine.number = r - PENDULUM_FMA(r, z * s, excess * base);
    cosine.number = base + (((1.0 - base) - half_z) + PENDULUM_FMA(z2, c, r * excess));

    // quarter turns, without a branch
    swap = (sine.bits ^ cosine.bits) & (0 - (turned.bits & 1));
    sine.bits ^= swap ^ ((turned.bits & 2) << 62);
    cosine.bits ^= swap ^ (((turned.bits + 1) & 2) << 62);
    pair.sin = sine.number;
    pair.cos = cosine.number;
    return pair;
}
