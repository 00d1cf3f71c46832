//! Tables made by the language's linear congruential generator.
use std::sync::LazyLock;

use super::values::VALUES;
use crate::Vec3;

/// One step of the linear congruential generator, on 32 bits with wrap.
pub(super) const fn step(r: u32) -> u32 {
    r.wrapping_mul(1_812_433_253).wrapping_add(12345)
}

/// The 15 bits of a state that count.
pub(super) const fn bits15(r: u32) -> usize {
    ((r >> 16) & 0x7fff) as usize
}

/// The lattice's permutation of 0..4096. Small tables leave the cache to others.
pub(super) static HASH: [u16; 4096] = HASH_TABLE;

const HASH_TABLE: [u16; 4096] = hash_table();

const fn hash_table() -> [u16; 4096] {
    let mut h = [0u16; 4096];
    let mut i = 0;
    while i < 4096 {
        h[i] = i as u16;
        i += 1;
    }
    let mut r = 0;
    while i > 0 {
        i -= 1;
        r = step(r);
        let j = bits15(r) % 4096;
        let swapped = h[i];
        h[i] = h[j];
        h[j] = swapped;
    }
    h
}

/// Of each hash: where its corner's numbers begin in [`ROWS`].
pub(super) static HASH_ROWS: [u16; 4096] = {
    let mut rows = [0; 4096];
    let mut i = 0;
    while i < 4096 {
        rows[i] = (HASH_TABLE[i] & 255) * 4;
        i += 1;
    }
    rows
};

/// What corners read, four numbers in a row: as they lie in [`VALUES`] three rows in eight cross a cache line.
#[repr(align(64))]
pub(super) struct Rows(pub [f64; 4 * 264]);

/// Row `k + 4 m` is for corner `k` and channel `m`.
pub(super) static ROWS: Rows = {
    let mut rows = [0.0; 4 * 264];
    let mut i = 0;
    while i < rows.len() {
        rows[i] = VALUES[i / 4 + i % 4];
        i += 1;
    }
    Rows(rows)
};

/// Number of gradients, and the period of gradient noise.
pub(super) const GRADIENTS: usize = 2048;

/// What gradient noise looks up; both tables are periodic.
pub(super) struct GradientTables {
    /// Unit vectors.
    pub gradients: [[f64; 3]; GRADIENTS],
    /// A shuffle of the indices (one of them is lost to the shuffle's spare slot).
    pub permutation: [u16; GRADIENTS],
}

/// Made at first use: normalising needs a square root.
pub(super) static GRADIENT_TABLES: LazyLock<Box<GradientTables>> = LazyLock::new(gradient_tables);

fn gradient_tables() -> Box<GradientTables> {
    let mut r = 1;
    let mut component = || {
        r = step(r);
        ((bits15(r) % (2 * GRADIENTS)) as f64 - GRADIENTS as f64) / GRADIENTS as f64
    };
    let mut gradient = || loop {
        let g = Vec3::new(component(), component(), component());
        if (1e-5..=1.0).contains(&g.length_squared()) {
            return (g / g.length()).to_array();
        }
    };
    let gradients = std::array::from_fn(|_| gradient());
    let mut p: Vec<u16> = (0..GRADIENTS as u16).chain([0]).collect();
    for i in (2..=GRADIENTS).rev().step_by(2) {
        r = step(r);
        p.swap(i, bits15(r) % GRADIENTS);
    }
    Box::new(GradientTables { gradients, permutation: std::array::from_fn(|i| p[i]) })
}
