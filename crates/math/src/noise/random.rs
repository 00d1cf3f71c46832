//! The fixed random numbers of cells, crackle, facets and black holes (textures spec, section 1.6).
use std::sync::LazyLock;

use super::tables::HASH;

const SIZE: usize = 32768;

static TABLE: LazyLock<Box<[u32; SIZE]>> = LazyLock::new(table);

/// Entry `k` (modulo 32768) of the table: uniform in 0..1, the outputs of a Mersenne twister with its default seed.
#[inline]
pub fn random(k: usize) -> f64 {
    unit(TABLE[k % SIZE])
}

/// Three entries in a row: a random point of the unit cube.
#[inline]
pub fn random3(k: usize) -> [f64; 3] {
    let table = &**TABLE;
    [unit(table[k % SIZE]), unit(table[(k + 1) % SIZE]), unit(table[(k + 2) % SIZE])]
}

/// A hash of three integers, 0..=4095; each counts modulo 4096.
#[inline]
pub fn hash3(a: i64, b: i64, c: i64) -> usize {
    let h = |i: usize| usize::from(HASH[i & 4095]);
    let low = |i: i64| (i & 4095) as usize;
    h(h(h(low(a)) ^ low(b)) ^ low(c))
}

/// The hash table of lattice noise itself, 0..=4095; the argument counts modulo 4096.
#[inline]
pub fn hash(i: i64) -> usize {
    usize::from(HASH[(i & 4095) as usize])
}

/// From 32 random bits to 0..1; exact, and the table of bits is half as large as one of numbers.
#[inline]
fn unit(bits: u32) -> f64 {
    f64::from(bits) * (1.0 / 4_294_967_296.0)
}

fn table() -> Box<[u32; SIZE]> {
    let mut twister = Mt19937::new(5489);
    Box::new(std::array::from_fn(|_| twister.next()))
}

/// The Mersenne twister of Matsumoto and Nishimura (1998), 32 bits.
struct Mt19937 {
    state: [u32; 624],
    next: usize,
}

impl Mt19937 {
    fn new(seed: u32) -> Self {
        let mut state = [seed; 624];
        for i in 1..624 {
            let previous = state[i - 1] ^ (state[i - 1] >> 30);
            state[i] = previous.wrapping_mul(1_812_433_253).wrapping_add(i as u32);
        }
        Mt19937 { state, next: 624 }
    }

    fn refill(&mut self) {
        for i in 0..624 {
            let y = (self.state[i] & 0x8000_0000) | (self.state[(i + 1) % 624] & 0x7fff_ffff);
            let twist = if y & 1 == 0 { 0 } else { 0x9908_b0df };
            self.state[i] = self.state[(i + 397) % 624] ^ (y >> 1) ^ twist;
        }
        self.next = 0;
    }

    fn next(&mut self) -> u32 {
        if self.next == 624 {
            self.refill();
        }
        let mut y = self.state[self.next];
        self.next += 1;
        y ^= y >> 11;
        y ^= (y << 7) & 0x9d2c_5680;
        y ^= (y << 15) & 0xefc6_0000;
        y ^ (y >> 18)
    }
}
