//! Noise as a function of counters.

use core::f64::consts::TAU;

use crate::real::Real;

/// Increment of SplitMix64.
const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

/// Source of the noise of one trajectory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Noise(u64);

impl Noise {
    /// Noise of the member `member` of the ensembles with a seed.
    pub(super) fn new(seed: u64, member: u64) -> Self {
        Self(mixed(
            mixed(seed.wrapping_add(GOLDEN))
                .wrapping_add(member)
                .wrapping_add(GOLDEN),
        ))
    }

    /// A number of the standard normal distribution for each sample and channel (G. E. P. Box, M. E. Muller, Ann. Math.
    /// Stat. 29 (1958) 610).
    pub(super) fn normal(self, sample: usize, channel: usize) -> f64 {
        let of_sample = mixed(self.0.wrapping_add(GOLDEN.wrapping_mul(1 + sample as u64)));
        let of_channel = |part: usize| {
            let z = mixed(of_sample.wrapping_add(GOLDEN.wrapping_mul((1 + 2 * channel + part) as u64)));
            (z >> 11) as f64
        };
        let scale = 1.0 / (1_u64 << 53) as f64;
        // the first one is never 0, whose logarithm is infinite
        let [radius, angle] = [(of_channel(0) + 0.5) * scale, of_channel(1) * scale * TAU];
        Real::sqrt(-2.0 * Real::ln(radius)) * Real::sin_cos(angle).1
    }
}

/// Finalizer of SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014, 453).
const fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::Noise;

    #[test]
    fn numbers_have_the_moments_of_a_normal_distribution() {
        let count = 200_000;
        let noise = Noise::new(7, 3);
        let moments = |number: &dyn Fn(usize) -> f64| {
            let mut sums = [0.0; 4];
            for k in 0..count {
                let powers = core::iter::successors(Some(number(k)), |z| Some(z * number(k)));
                for (sum, power) in sums.iter_mut().zip(powers) {
                    *sum += power / f64::from(count as u32);
                }
            }
            sums
        };
        // standard errors of the moments: sqrt of 1, 2, 15 and 96 over the count
        let standard = |[m1, m2, m3, m4]: [f64; 4]| {
            let size = f64::from(count as u32).sqrt();
            [
                m1,
                (m2 - 1.0) / 2_f64.sqrt(),
                m3 / 15_f64.sqrt(),
                (m4 - 3.0) / 96_f64.sqrt(),
            ]
            .map(|z| z * size)
        };
        let along = standard(moments(&|k| noise.normal(k, 0)));
        assert!(along.iter().all(|z| z.abs() < 4.0), "{along:?}");
        let across = standard(moments(&|k| Noise::new(7, k as u64).normal(5, 1)));
        assert!(across.iter().all(|z| z.abs() < 4.0), "{across:?}");
    }

    #[test]
    fn samples_channels_members_and_seeds_are_independent() {
        let count = 100_000;
        let noise = Noise::new(1, 0);
        let others: [&dyn Fn(usize) -> f64; 5] = [
            &|k| noise.normal(k + 1, 0),
            &|k| noise.normal(k, 1),
            &|k| noise.normal(k, 2),
            &|k| Noise::new(1, 1).normal(k, 0),
            &|k| Noise::new(2, 0).normal(k, 0),
        ];
        for (which, other) in others.iter().enumerate() {
            let covariance = (0..count).map(|k| noise.normal(k, 0) * other(k)).sum::<f64>() / f64::from(count as u32);
            assert!(
                covariance.abs() < 4.0 / f64::from(count as u32).sqrt(),
                "{which}: {covariance}"
            );
        }
    }

    #[test]
    fn a_number_has_the_same_bits_everywhere() {
        assert_eq!(Noise::new(0, 0).normal(0, 0).to_bits(), 0x3FFE_C38D_5964_33F5);
    }
}
