//! `ripples` and `waves`: sines of the distances to the scene's wave sources, four sources at a time.
use raggio_math::Vec3;
use raggio_math::noise::wave_sources;
use raggio_math::turns::sin_turns;
use raggio_scene as scene;

/// Sources that are worked out together.
const LANES: usize = 4;

/// What `ripples` and `waves` are computed from, as patterns and as normals.
#[derive(Clone, Debug)]
pub(crate) struct Waves {
    groups: Box<[Sources]>,
    /// `phase`
    phase: f64,
}

/// Points that waves spread from.
#[derive(Clone, Copy, Debug, Default)]
struct Sources {
    x: [f64; LANES],
    y: [f64; LANES],
    z: [f64; LANES],
    /// Waves per unit.
    frequency: [f64; LANES],
    /// The share in the mean height; 0 where there is no source.
    share: [f64; LANES],
}

/// The ways from sources to a point, their lengths, where 0 counts as 1, and the waves' heights there by share.
struct Heights {
    ways: [[f64; 3]; LANES],
    lengths: [f64; LANES],
    heights: [f64; LANES],
}

impl Waves {
    /// Waves of one frequency from all sources.
    pub fn of_one_frequency(pattern: &scene::Pattern, count: u32) -> Self {
        Waves::new(pattern, count, |_| 1.0)
    }

    /// Each source has its own frequency; quicker waves are lower.
    pub fn of_own_frequencies(pattern: &scene::Pattern, count: u32) -> Self {
        Waves::new(pattern, count, |own| own)
    }

    fn new(pattern: &scene::Pattern, count: u32, quickness: impl Fn(f64) -> f64) -> Self {
        let all = wave_sources(count);
        let groups = all.chunks(LANES).map(|chunk| {
            let mut group = Sources::default();
            for (i, source) in chunk.iter().enumerate() {
                let quickness = quickness(source.frequency);
                [group.x[i], group.y[i], group.z[i]] = source.center.to_array();
                group.frequency[i] = f64::from(pattern.frequency) * quickness;
                group.share[i] = 1.0 / (quickness * all.len() as f64);
            }
            group
        });
        Waves { groups: groups.collect(), phase: f64::from(pattern.phase) }
    }

    /// The mean height of all waves.
    fn mean(&self, p: Vec3) -> f64 {
        self.groups.iter().map(|group| group.at(p, self.phase).heights.iter().sum::<f64>()).sum()
    }

    pub(super) fn ripples_value(&self, p: Vec3) -> f64 {
        0.5 * (1.0 + self.mean(p))
    }

    pub(super) fn waves_value(&self, p: Vec3) -> f64 {
        0.2 * (2.5 + self.mean(p))
    }

    /// How far a normal is bent: away from the sources, by the heights.
    pub fn bend(&self, p: Vec3, amount: f64) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for group in &self.groups {
            let Heights { ways, lengths, heights } = group.at(p, self.phase);
            for i in 0..LANES {
                sum += Vec3::from(ways[i]) * (amount * heights[i] / lengths[i]);
            }
        }
        sum
    }
}

impl Sources {
    #[inline]
    fn at(&self, p: Vec3, phase: f64) -> Heights {
        let mut out = Heights { ways: [[0.0; 3]; LANES], lengths: [0.0; LANES], heights: [0.0; LANES] };
        for i in 0..LANES {
            let (x, y, z) = (p.x - self.x[i], p.y - self.y[i], p.z - self.z[i]);
            let l = (x * x + y * y + z * z).sqrt();
            let l = if l == 0.0 { 1.0 } else { l };
            out.ways[i] = [x, y, z];
            out.lengths[i] = l;
            out.heights[i] = sin_turns(l * self.frequency[i] + phase) * self.share[i];
        }
        out
    }
}
