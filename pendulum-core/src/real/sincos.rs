//! Sine and cosine: one kernel for scalars and for lanes.
//!
//! It uses additions, multiplications and operations on bits only, each of which IEEE 754 defines to the last bit, and no fused
//! ones. So the result is the same on every machine, and a lane is the scalar, bit for bit.
//!
//! The angle is reduced to `[-pi/4, pi/4]` by a multiple of `pi/2` in three parts (W. J. Cody, W. Waite, "Software Manual for the
//! Elementary Functions", 1980), and what the reduced angle lacks is carried along. The polynomials are minimax ones of this
//! interval, of relative error below 2^-56 with their coefficients rounded.

use super::lanes::Register;

/// What the kernel asks of a number, or of lanes of them, beside arithmetic.
pub trait Angle: Register<Scalar = f64> {
    /// Whether the absolute value of any lane is above the limit. NaN is not.
    fn any_beyond(self, limit: f64) -> bool;

    /// `(sin(x + n pi/2), cos(x + n pi/2))` from `sin x` and `cos x`, where `n` stands in the lowest bits of `self`.
    fn turn(self, sin: Self, cos: Self) -> (Self, Self);

    /// Sine and cosine where a lane is beyond [`LIMIT`].
    fn far(self) -> (Self, Self);
}

/// Up to here the angle is reduced by the kernel: products of the quotient, of 16 bits, and the first two parts of pi/2 are exact.
const LIMIT: f64 = 1e5;

/// pi/2 in parts of 37, 37 and 53 bits.
const HALF_PI: [f64; 3] = [
    1.570_796_326_792_333_3,
    2.563_344_151_583_955_8e-12,
    1.056_299_906_698_742_8e-23,
];

/// Added to a number of less than 2^51, it leaves no room for a fraction: the number is rounded to an integer, which stands in
/// the lowest bits.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// `(x - sin x) / x^3` by ascending powers of `x^2`.
const SIN: [f64; 6] = [
    0.166_666_666_666_666_3,
    -0.008_333_333_333_322_118,
    0.000_198_412_698_295_887_7,
    -2.755_731_362_109_259_4e-6,
    2.505_074_771_372_332_4e-8,
    -1.589_622_714_940_337_6e-10,
];

/// `(cos x - 1 + x^2 / 2) / x^4` by ascending powers of `x^2`.
const COS: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_305_6,
    2.480_158_728_885_065_3e-5,
    -2.755_731_417_898_857_4e-7,
    2.087_570_079_935_264_4e-9,
    -1.135_853_427_442_955_5e-11,
];

/// Sine and cosine of an angle in radians, below 1 ulp; NaN where the angle is not finite.
#[inline(always)]
pub(crate) fn sin_cos<A: Angle>(x: A) -> (A, A) {
    if x.any_beyond(LIMIT) {
        return x.far();
    }
    let shifted = x * A::splat(std::f64::consts::FRAC_2_PI) + A::splat(SHIFT);
    let n = shifted - A::splat(SHIFT);
    let near = x - n * A::splat(HALF_PI[0]);
    let low = n * A::splat(HALF_PI[1]);
    let r = near - low;
    // The reduced angle is r - excess.
    let excess = (low - (near - r)) + n * A::splat(HALF_PI[2]);

    let one = A::splat(1.0);
    let z = r * r;
    let z2 = z * z;
    let half_z = z * A::splat(0.5);
    let base = one - half_z;
    // A difference, so that the sine of -0.0 is -0.0.
    let sin = r - (r * (z * polynomial(&SIN, z, z2)) + excess * base);
    let cos = base + (((one - base) - half_z) + (z2 * polynomial(&COS, z, z2) + r * excess));
    shifted.turn(sin, cos)
}

/// Two angles in the vector register that every machine of the kind has.
#[cfg(target_arch = "x86_64")]
type Two = super::lanes::Xmm64;
#[cfg(not(target_arch = "x86_64"))]
type Two = super::lanes::Pair<f64>;

/// Sines and cosines of two angles together: the same bits as one by one.
#[inline(always)]
pub(crate) fn sin_cos_pair(angles: [f64; 2]) -> [(f64, f64); 2] {
    let (sin, cos) = sin_cos(Two::from_fn(&mut |i| angles[i]));
    [0, 1].map(|i| (sin.lane(i), cos.lane(i)))
}

/// A polynomial in `z`, by Estrin's scheme: three short chains instead of a long one.
#[inline(always)]
fn polynomial<A: Angle>(c: &[f64; 6], z: A, z2: A) -> A {
    linear(c[0], c[1], z) + z2 * (linear(c[2], c[3], z) + z2 * linear(c[4], c[5], z))
}

// Not a closure, which the compiler does not promise to inline.
#[inline(always)]
fn linear<A: Angle>(c0: f64, c1: f64, z: A) -> A {
    A::splat(c0) + z * A::splat(c1)
}

impl Angle for f64 {
    #[inline(always)]
    fn any_beyond(self, limit: f64) -> bool {
        self.abs() > limit
    }

    #[inline(always)]
    fn turn(self, sin: Self, cos: Self) -> (Self, Self) {
        let n = self.to_bits();
        let odd = (n & 1).wrapping_neg();
        let (sin, cos) = (sin.to_bits(), cos.to_bits());
        let swap = (sin ^ cos) & odd;
        let sign = |quarter: u64| (quarter & 2) << 62;
        (
            Self::from_bits((sin ^ swap) ^ sign(n)),
            Self::from_bits((cos ^ swap) ^ sign(n.wrapping_add(1))),
        )
    }

    #[cold]
    #[inline(never)]
    fn far(self) -> (Self, Self) {
        libm::sincos(self)
    }
}
