//! Random numbers. Those of `testbed` would make it a dependency of all examples, which then build for twice as long.

/// Generator of random numbers (SplitMix64, Steele et al. 2014).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns a normal number of mean 0 and standard deviation 1 (Box and Muller 1958).
    pub(crate) fn normal(&mut self) -> f64 {
        let [radius, angle] = [
            f64::MIN_POSITIVE + (1.0 - f64::MIN_POSITIVE) * self.unit(),
            std::f64::consts::TAU * self.unit(),
        ];
        (-2.0 * radius.ln()).sqrt() * angle.cos()
    }

    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}
