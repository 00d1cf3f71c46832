//! Rows of rays, one a lane: the few operations that packets need, for registers of 256 and of 512 bits.
//!
//! Both modules have the same names, so that the packets' kernel is written once.
#![allow(unsafe_code)]

/// Functions on rows that are one instruction each.
macro_rules! instructions {
    ($features:literal, $($name:ident($($argument:ident: $kind:ty),*) -> $result:ty = $instruction:expr;)*) => {
        $(
            #[inline]
            #[target_feature(enable = $features)]
            pub(crate) fn $name($($argument: $kind),*) -> $result {
                $instruction
            }
        )*
    };
}

/// Eight lanes.
pub(crate) mod eight {
    use std::arch::x86_64::*;

    pub(crate) type Row = __m256;
    pub(crate) type Mask = __m256;
    pub(crate) const LANES: usize = 8;

    instructions! { "avx2,fma",
        all(value: f32) -> Row = _mm256_set1_ps(value);
        word(value: u32) -> Row = _mm256_castsi256_ps(_mm256_set1_epi32(value as i32));
        add(a: Row, b: Row) -> Row = _mm256_add_ps(a, b);
        sub(a: Row, b: Row) -> Row = _mm256_sub_ps(a, b);
        mul(a: Row, b: Row) -> Row = _mm256_mul_ps(a, b);
        div(a: Row, b: Row) -> Row = _mm256_div_ps(a, b);
        min(a: Row, b: Row) -> Row = _mm256_min_ps(a, b);
        max(a: Row, b: Row) -> Row = _mm256_max_ps(a, b);
        fmadd(a: Row, b: Row, c: Row) -> Row = _mm256_fmadd_ps(a, b, c);
        fnmadd(a: Row, b: Row, c: Row) -> Row = _mm256_fnmadd_ps(a, b, c);
        le(a: Row, b: Row) -> Mask = _mm256_cmp_ps::<_CMP_LE_OQ>(a, b);
        and(a: Mask, b: Mask) -> Mask = _mm256_and_ps(a, b);
        or(a: Mask, b: Mask) -> Mask = _mm256_or_ps(a, b);
        bits(mask: Mask) -> u16 = _mm256_movemask_ps(mask) as u16;
        select(mask: Mask, yes: Row, no: Row) -> Row = _mm256_blendv_ps(no, yes, mask);
        least(row: Row) -> f32 = {
            let half = _mm_min_ps(_mm256_castps256_ps128(row), _mm256_extractf128_ps::<1>(row));
            let pair = _mm_min_ps(half, _mm_movehl_ps(half, half));
            _mm_cvtss_f32(_mm_min_ss(pair, _mm_movehdup_ps(pair)))
        };
        most(row: Row) -> f32 = {
            let half = _mm_max_ps(_mm256_castps256_ps128(row), _mm256_extractf128_ps::<1>(row));
            let pair = _mm_max_ps(half, _mm_movehl_ps(half, half));
            _mm_cvtss_f32(_mm_max_ss(pair, _mm_movehdup_ps(pair)))
        };
        load(from: &[f32; LANES]) -> Row = {
            // SAFETY: eight floats.
            unsafe { _mm256_loadu_ps(from.as_ptr()) }
        };
        store(row: Row, to: &mut [f32; LANES]) -> () = {
            // SAFETY: eight floats.
            unsafe { _mm256_storeu_ps(to.as_mut_ptr(), row) }
        };
    }
}

/// Sixteen lanes.
pub(crate) mod sixteen {
    use std::arch::x86_64::*;

    pub(crate) type Row = __m512;
    pub(crate) type Mask = __mmask16;
    pub(crate) const LANES: usize = 16;

    instructions! { "avx512f",
        all(value: f32) -> Row = _mm512_set1_ps(value);
        word(value: u32) -> Row = _mm512_castsi512_ps(_mm512_set1_epi32(value as i32));
        add(a: Row, b: Row) -> Row = _mm512_add_ps(a, b);
        sub(a: Row, b: Row) -> Row = _mm512_sub_ps(a, b);
        mul(a: Row, b: Row) -> Row = _mm512_mul_ps(a, b);
        div(a: Row, b: Row) -> Row = _mm512_div_ps(a, b);
        min(a: Row, b: Row) -> Row = _mm512_min_ps(a, b);
        max(a: Row, b: Row) -> Row = _mm512_max_ps(a, b);
        fmadd(a: Row, b: Row, c: Row) -> Row = _mm512_fmadd_ps(a, b, c);
        fnmadd(a: Row, b: Row, c: Row) -> Row = _mm512_fnmadd_ps(a, b, c);
        le(a: Row, b: Row) -> Mask = _mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b);
        and(a: Mask, b: Mask) -> Mask = a & b;
        or(a: Mask, b: Mask) -> Mask = a | b;
        bits(mask: Mask) -> u16 = mask;
        select(mask: Mask, yes: Row, no: Row) -> Row = _mm512_mask_blend_ps(mask, no, yes);
        least(row: Row) -> f32 = _mm512_reduce_min_ps(row);
        most(row: Row) -> f32 = _mm512_reduce_max_ps(row);
        load(from: &[f32; LANES]) -> Row = {
            // SAFETY: sixteen floats.
            unsafe { _mm512_loadu_ps(from.as_ptr()) }
        };
        store(row: Row, to: &mut [f32; LANES]) -> () = {
            // SAFETY: sixteen floats.
            unsafe { _mm512_storeu_ps(to.as_mut_ptr(), row) }
        };
    }
}
