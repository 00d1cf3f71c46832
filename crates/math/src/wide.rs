//! Plain loops over a few numbers, compiled twice: for every processor, and for those with AVX2.
#![allow(unsafe_code)] // One call into code for AVX2, made where it is there.

/// Work worth wide vectors: loops over arrays of eight numbers.
pub trait Wide {
    /// What it gives.
    type Output;
    /// Does it. To be `#[inline(always)]`, like all that it calls.
    fn run(self) -> Self::Output;
}

/// Does work as compiled for the widest vectors that this processor has. Nothing is fused or put in another order, so
/// that the results are the same everywhere.
#[inline]
pub fn wide<W: Wide>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") {
        // SAFETY: AVX2 is there.
        return unsafe { avx2(work) };
    }
    work.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<W: Wide>(work: W) -> W::Output {
    work.run()
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Sum([f32; 8]);

    impl Wide for Sum {
        type Output = f32;
        #[inline(always)]
        fn run(self) -> f32 {
            self.0.map(|x| x * 1.7 + 0.3).iter().sum()
        }
    }

    #[test]
    fn wide_work_gives_the_same_bits() {
        let numbers: [f32; 8] = std::array::from_fn(|i| (i as f32 + 0.1).sin());
        assert_eq!(wide(Sum(numbers)).to_bits(), Sum(numbers).run().to_bits());
    }
}
