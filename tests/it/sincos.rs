//! Sine and cosine against exact values: fixed-point arithmetic on big integers, independent of the kernel.

use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive, Zero};
use pendulum_core::Real;
use testbed::random::Random;

/// Fixed-point arithmetic in units of `2^-bits`.
struct Fixed {
    bits: usize,
    half_pi: BigInt,
}

impl Fixed {
    fn new(bits: usize) -> Self {
        // Machin: pi/4 = 4 atan(1/5) - atan(1/239), with spare bits for the rounding errors of the series
        let spare = 64;
        let atan = |inverse: u32| {
            let square = BigInt::from(inverse * inverse);
            let mut power = (BigInt::from(1) << (bits + spare)) / inverse;
            let (mut sum, mut n) = (power.clone(), 1);
            while !power.is_zero() {
                power /= -&square;
                n += 2;
                sum += &power / n;
            }
            sum
        };
        let half_pi = ((atan(5) * 4 - atan(239)) * 2) >> spare;
        Self { bits, half_pi }
    }

    /// Exact fixed-point value of an `f64`.
    fn exactly(&self, x: f64) -> BigInt {
        let bits = x.abs().to_bits();
        let (exponent, fraction) = ((bits >> 52) as i64, bits & ((1 << 52) - 1));
        let mantissa = if exponent == 0 { fraction } else { fraction | (1 << 52) };
        let shift = self.bits as i64 + exponent.max(1) - 1075;
        assert!(shift >= 0, "{x:e} asks for more than {} bits", self.bits);
        let value = BigInt::from(mantissa) << shift;
        if x.is_sign_negative() { -value } else { value }
    }

    /// Sine and cosine by their series, of the angle reduced to [-pi/4, pi/4].
    fn sin_cos(&self, x: &BigInt) -> (BigInt, BigInt) {
        let quarter: BigInt = &self.half_pi >> 1;
        let mut n = (x.abs() + quarter) / &self.half_pi;
        if x.is_negative() {
            n = -n;
        }
        let r = x - &n * &self.half_pi;
        let series = |first: BigInt, mut k: u32| {
            let (mut term, mut sum) = (first.clone(), first);
            while !term.is_zero() {
                term = (((&term * &r) >> self.bits) * &r) >> self.bits;
                term = -term / ((k + 1) * (k + 2));
                k += 2;
                sum += &term;
            }
            sum
        };
        let (sin, cos) = (series(r.clone(), 1), series(BigInt::from(1) << self.bits, 0));
        match (n % 4i32 + 4i32) % 4i32 {
            n if n.is_zero() => (sin, cos),
            n if n == BigInt::from(1) => (cos, -sin),
            n if n == BigInt::from(2) => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    /// Error of `value` in ulps of the exact number, for a mantissa of `digits` bits.
    fn ulps(&self, value: f64, exact: &BigInt, (digits, least): (i64, i64)) -> f64 {
        let exponent = (exact.bits() as i64 - digits).max(self.bits as i64 + least);
        let error = (self.exactly(value) - exact).abs();
        // to 32 bits below an ulp
        let scaled: BigInt = error >> (exponent - 32).max(0);
        scaled.to_f64().expect("finite") / 2f64.powi(32.min(exponent as i32))
    }

    /// Larger of the errors of sine and cosine.
    fn error(&self, x: f64) -> f64 {
        let (sin, cos) = Real::sin_cos(x);
        let exact = self.sin_cos(&self.exactly(x));
        let error = |value, exact| self.ulps(value, exact, (53, -1074));
        error(sin, &exact.0).max(error(cos, &exact.1))
    }

    /// Larger of the errors of sine and cosine in `f32`.
    fn error_f32(&self, x: f32) -> f64 {
        let (sin, cos) = Real::sin_cos(x);
        let exact = self.sin_cos(&self.exactly(f64::from(x)));
        let error = |value: f32, exact| self.ulps(f64::from(value), exact, (24, -149));
        error(sin, &exact.0).max(error(cos, &exact.1))
    }
}

/// Random number of either sign with a uniform logarithm of its magnitude.
fn magnitude(random: &mut Random, low: f64, high: f64) -> f64 {
    let sign = random.between(-1.0, 1.0).signum();
    sign * random.between(low.ln(), high.ln()).exp()
}

/// Maximum error, in ulps. A million random angles reach 0.80, and all of `f32` 0.84: the rounding errors of the
/// result, of the square of the reduced angle, and of its half.
const MOST: f64 = 0.85;

/// Number of random angles in each test.
const COUNT: usize = 4000;
/// Stride of the tested multiples of a quarter turn. All multiples passed once.
const STRIDE: usize = 17;

fn worst(fixed: &Fixed, angles: impl Iterator<Item = f64>) -> f64 {
    angles.map(|x| fixed.error(x)).fold(0.0, f64::max)
}

#[test]
fn angles_to_a_hundred_thousand() {
    let (fixed, mut random) = (Fixed::new(320), Random::new(1));
    let of_any_size: Vec<f64> = (0..COUNT).map(|_| magnitude(&mut random, 1e-30, 1e5)).collect();
    let of_one_turn: Vec<f64> = (0..COUNT).map(|_| random.between(-3.2, 3.2)).collect();
    let large: Vec<f64> = (0..COUNT).map(|_| random.between(-1e5, 1e5)).collect();
    for angles in [of_any_size, of_one_turn, large] {
        let worst = worst(&fixed, angles.into_iter());
        println!("{worst:.3} ulp");
        assert!(worst < MOST, "{worst} ulp");
    }
}

#[test]
fn angles_near_multiples_of_a_quarter_turn() {
    let fixed = Fixed::new(320);
    let near = (1..63_661).step_by(STRIDE).flat_map(|n| {
        let x = f64::from(n) * std::f64::consts::FRAC_PI_2;
        [
            x.next_down().next_down(),
            x.next_down(),
            x,
            x.next_up(),
            x.next_up().next_up(),
        ]
    });
    let worst = worst(&fixed, near);
    println!("{worst:.3} ulp");
    assert!(worst < MOST, "{worst} ulp");
}

#[test]
fn tiny_angles_and_zeros() {
    let (fixed, mut random) = (Fixed::new(1200), Random::new(2));
    let tiny = (0..300).map(|_| magnitude(&mut random, 5e-324, 1e-15));
    let worst = worst(&fixed, tiny.chain([5e-324, f64::MIN_POSITIVE, 1e-310]));
    assert!(worst <= 0.5, "{worst} ulp");
    for zero in [0.0_f64, -0.0] {
        let (sin, cos) = Real::sin_cos(zero);
        assert_eq!((sin.to_bits(), cos), (zero.to_bits(), 1.0));
    }
}

#[test]
fn beyond_the_range_of_the_kernel() {
    let (fixed, mut random) = (Fixed::new(1200), Random::new(3));
    let large = (0..300).map(|_| magnitude(&mut random, 1e5, 1e300));
    let worst = worst(&fixed, large.chain([1e5, 1e5_f64.next_up(), -1e5, f64::MAX]));
    assert!(worst < 1.0, "{worst} ulp");
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (sin, cos) = Real::sin_cos(x);
        assert!(sin.is_nan() && cos.is_nan());
    }
}

#[test]
fn single_precision() {
    let (fixed, mut random) = (Fixed::new(512), Random::new(4));
    let (mut within, mut beyond) = (0.0_f64, 0.0_f64);
    for n in 0..COUNT {
        let near = ((n + 1) as f64 * std::f64::consts::FRAC_PI_2) as f32;
        for x in [magnitude(&mut random, 1e-38, 1e10) as f32, near] {
            let worst = if x.abs() > MOST_F32 { &mut beyond } else { &mut within };
            *worst = worst.max(fixed.error_f32(x));
        }
    }
    println!("{within:.3} ulp, {beyond:.5} ulp");
    assert!(within < MOST, "{within} ulp");
    // a single rounding of a far more accurate value
    assert!(beyond < 0.501, "{beyond} ulp");
    for x in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let (sin, cos) = Real::sin_cos(x);
        assert!(sin.is_nan() && cos.is_nan());
    }
}

/// Largest angle that the kernel of `f32` reduces, in radians.
const MOST_F32: f32 = 6400.0;

/// Compares every `stride`-th angle of `f32` in the range of the kernel with `f64`, for both signs, in pairs.
fn assert_single_precision(stride: usize) {
    let error = |value: f32, exact: f64| {
        let ulp = 2f64.powi(exact.abs().log2().floor().max(-126.0) as i32 - 23);
        (f64::from(value) - exact).abs() / ulp
    };
    let mut worst = (0.0, 0.0);
    for bits in (0..=MOST_F32.to_bits()).step_by(stride) {
        let x = f32::from_bits(bits);
        let [(sin, cos), (sin_minus, cos_minus)] = Real::sin_cos_pair(x, -x);
        assert_eq!((sin, cos), Real::sin_cos(x), "{x}");
        assert_eq!((sin, cos), (-sin_minus, cos_minus), "{x}");
        let exact = Real::sin_cos(f64::from(x));
        let error = error(sin, exact.0).max(error(cos, exact.1));
        if error > worst.0 {
            worst = (error, x);
        }
    }
    println!("{:.4} ulp at {}", worst.0, worst.1);
    assert!(worst.0 < MOST, "{} ulp at {}", worst.0, worst.1);
}

#[test]
fn a_sample_of_single_precision() {
    assert_single_precision(1009);
}

/// Takes a minute with optimisation, and prints 0.8439 ulp at 308.64505:
///
/// `cargo test --release --package tests --test it -- --ignored all_of_single_precision`
#[cfg(not(debug_assertions))]
#[test]
#[ignore = "takes long"]
fn all_of_single_precision() {
    assert_single_precision(1);
}

/// The bits of many values, combined into one number, must be the same on every machine.
#[test]
fn the_bits_are_the_same_everywhere() {
    let mut random = Random::new(5);
    let mut sum = 0_u64;
    let mut sum_f32 = 0_u64;
    let add = |sum: &mut u64, bits: u64| *sum = sum.rotate_left(5).wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ bits;
    for n in 0..100_000 {
        // only exact operations
        let x = random.between(-1.0, 1.0) * f64::from(1 << (n % 18));
        let (sin, cos) = Real::sin_cos(x);
        let (sin_f32, cos_f32) = Real::sin_cos(x as f32);
        for (value, value_f32) in [(sin, sin_f32), (cos, cos_f32)] {
            add(&mut sum, value.to_bits());
            add(&mut sum_f32, u64::from(value_f32.to_bits()));
        }
    }
    assert_eq!(sum, 0xbee1_59e5_90c9_b40b, "{sum:#x}");
    assert_eq!(sum_f32, 0x5b06_1be3_a21c_d03a, "{sum_f32:#x}");
}
