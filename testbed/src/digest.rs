//! Hashes of bytes that are the same on every machine and with every compiler.

/// FNV-1a hash of 64 bits.
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    pub fn add(&mut self, bytes: impl IntoIterator<Item = u8>) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    #[must_use]
    pub fn value(&self) -> u64 {
        self.0
    }
}
