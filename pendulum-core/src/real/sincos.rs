//! Sine and cosine: one kernel for both precisions, for scalars and for lanes.
//!
//! The kernel uses only additions, multiplications, their combinations (fused or not, as the type says) and bit
//! operations. IEEE 754 defines these to the last bit, so results are identical on every machine, and in lanes and
//! scalars.
//!
//! The angle is reduced to `[-pi/4, pi/4]` by subtracting a multiple of `pi/2` in parts (W. J. Cody, W. Waite,
//! "Software Manual for the Elementary Functions", 1980). The rounding error of the reduced angle is carried along. The
//! polynomials minimise the largest relative error of sine and cosine on this interval (Remez algorithm). Their
//! coefficients are rounded one at a time, highest power last, refitting the rest each time.

use super::Real;
use super::lanes::{Precision, Register};

/// Quotients have 16 bits; polynomial errors are below 2^-56.
impl Precision for f64 {
    const LIMIT: Self = 1e5;
    /// Parts of 37, 37 and 53 bits.
    const HALF_PI: (&'static [Self], [Self; 2]) = (
        &[1.570_796_326_792_333_3],
        [2.563_344_151_583_955_8e-12, 1.056_299_906_698_742_8e-23],
    );
    const SHIFT: Self = 6_755_399_441_055_744.0;
    const SIN: &'static [Self] = &[
        0.166_666_666_666_666_3,
        -0.008_333_333_333_322_118,
        0.000_198_412_698_295_887_7,
        -2.755_731_362_109_259_4e-6,
        2.505_074_771_372_332_4e-8,
        -1.589_622_714_940_337_6e-10,
    ];
    const COS: &'static [Self] = &[
        0.041_666_666_666_666_595,
        -0.001_388_888_888_887_305_6,
        2.480_158_728_885_065_3e-5,
        -2.755_731_417_898_857_4e-7,
        2.087_570_079_935_264_4e-9,
        -1.135_853_427_442_955_5e-11,
    ];

    #[inline]
    fn far(self) -> (Self, Self) {
        libm::sincos(self)
    }
}

/// Quotients have 12 bits; polynomial errors are below 2^-27.
impl Precision for f32 {
    const LIMIT: Self = 6400.0;
    /// Parts of 12 bits; rounded to 2^-24, so that differences from the angle remain exact; of 9 bits; of 24 bits.
    const HALF_PI: (&'static [Self], [Self; 2]) = (&[1.570_800_8, -4.470_348_4e-6], [1.589_069_1e-8, 2.563_344e-12]);
    const SHIFT: Self = 12_582_912.0;
    const SIN: &'static [Self] = &[0.166_666_54, -0.008_332_106, 0.000_195_078_83];
    const COS: &'static [Self] = &[0.041_666_646, -0.001_388_730_8, 2.443_210_2e-5];

    #[inline]
    fn far(self) -> (Self, Self) {
        let (sin, cos) = sin_cos(f64::from(self));
        (Self::from_f64(sin), Self::from_f64(cos))
    }
}

/// Sine and cosine of an angle in radians, with errors below 1 ulp; NaN if the angle is not finite.
#[inline(always)]
pub(crate) fn sin_cos<R: Register>(x: R) -> (R, R) {
    if x.any_beyond(R::Scalar::LIMIT) {
        return one_by_one(x);
    }
    near(x)
}

/// Sines and cosines of two angles in a register of at least two lanes, bit-identical to separate calls.
#[inline(always)]
pub(crate) fn sin_cos_pair<R: Register>(angles: [R::Scalar; 2]) -> [(R::Scalar, R::Scalar); 2] {
    let (sin, cos) = sin_cos(R::from_fn(&mut |i| angles[i % 2]));
    [0, 1].map(|i| (sin.lane(i), cos.lane(i)))
}

/// Sine and cosine of angles up to the limit of the kernel.
#[inline(always)]
fn near<R: Register>(x: R) -> (R, R) {
    let shift = R::splat(R::Scalar::SHIFT);
    let shifted = x.mul_add(constant::<R>(core::f64::consts::FRAC_2_PI), shift);
    let n = shifted - shift;
    let (first, [low, last]) = R::Scalar::HALF_PI;
    let mut near = x;
    for &part in first {
        near = n.mul_neg_add(R::splat(part), near);
    }
    let low = n * R::splat(low);
    let r = near - low;
    // The reduced angle is r - excess.
    let excess = n.mul_add(R::splat(last), low - (near - r));

    let one = constant::<R>(1.0);
    let z = r * r;
    let z2 = z * z;
    let half_z = z * constant::<R>(0.5);
    let base = one - half_z;
    // Written as a difference so that the sine of -0.0 is -0.0.
    let sin = r - r.mul_add(z * polynomial(R::Scalar::SIN, z, z2), excess * base);
    let cos = base + (((one - base) - half_z) + z2.mul_add(polynomial(R::Scalar::COS, z, z2), r * excess));
    shifted.turn(sin, cos)
}

/// Evaluates a polynomial in `z` by Estrin's scheme, which halves the length of the dependency chain.
#[inline(always)]
fn polynomial<R: Register>(c: &[R::Scalar], z: R, z2: R) -> R {
    let mut i = (c.len() - 1) / 2 * 2;
    let mut sum = pair(c, i, z);
    while i > 0 {
        i -= 2;
        sum = z2.mul_add(sum, pair(c, i, z));
    }
    sum
}

/// Term `i`, plus term `i + 1` if it exists. The compiler need not inline closures, so this is a function.
#[inline(always)]
fn pair<R: Register>(c: &[R::Scalar], i: usize, z: R) -> R {
    if i + 1 < c.len() {
        z.mul_add(R::splat(c[i + 1]), R::splat(c[i]))
    } else {
        R::splat(c[i])
    }
}

#[inline(always)]
fn constant<R: Register>(v: f64) -> R {
    R::splat(R::Scalar::from_f64(v))
}

/// Sine and cosine of each lane separately. Lanes within the range of the kernel keep its bits.
#[inline(always)]
fn one_by_one<R: Register>(x: R) -> (R, R) {
    #[cold]
    #[inline(never)]
    fn replace<R: Register>(x_sin: &mut R, cos: &mut R) {
        let alone = |x: R::Scalar| {
            if x.any_beyond(R::Scalar::LIMIT) {
                x.far()
            } else {
                near(x)
            }
        };
        let x = *x_sin;
        *x_sin = R::from_fn(&mut |i| alone(x.lane(i)).0);
        *cos = R::from_fn(&mut |i| alone(x.lane(i)).1);
    }
    // The call passes copies through memory, so that `x` itself can stay in a register.
    let (mut sin, mut cos) = (x, x);
    replace(&mut sin, &mut cos);
    (sin, cos)
}
