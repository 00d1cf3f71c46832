//! `warp { repeat }`: slices of space along one axis, every second one mirrored if so wished.
use raggio_math::Vec3;
use raggio_math::turns::floor;

#[derive(Debug)]
pub(super) struct Repeat {
    axis: usize,
    width: f64,
    /// -1 on mirrored axes, else 1.
    flip: Vec3,
    offset: Vec3,
}

impl Repeat {
    /// `axis` is 0, 1 or 2; nonzero components of `flip` mirror.
    pub fn new(axis: usize, width: f32, flip: Vec3, offset: Vec3) -> Self {
        let sign = |f: f64| if f == 0.0 { 1.0 } else { -1.0 };
        let flip = Vec3::new(sign(flip.x), sign(flip.y), sign(flip.z));
        Repeat { axis: axis.min(2), width: f64::from(width), flip, offset }
    }

    pub fn apply(&self, mut p: Vec3) -> Vec3 {
        let k = self.axis;
        let slice = f64::from(floor(p[k] / self.width) as f32);
        p[k] -= slice * self.width;
        if slice as i64 & 1 != 0 {
            p *= self.flip;
            if self.flip[k] < 0.0 {
                p[k] += self.width;
            }
        }
        p + slice * self.offset
    }
}
