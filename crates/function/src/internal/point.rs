//! What the internal functions make of their arguments first.
use super::{Args, N, clipped, length, squared};

impl Args {
    /// The squares of the coordinates.
    pub(crate) fn squares(&self) -> (N, N, N) {
        (squared(self.x), squared(self.y), squared(self.z))
    }

    /// The squared distance from the origin.
    pub(crate) fn r2(&self) -> N {
        let (x2, y2, z2) = self.squares();
        x2 + y2 + z2
    }

    /// A field of strength `p[1]`, kept within -10 and 10; not-a-number gives -10.
    pub(crate) fn field(&self, e: N) -> N {
        clipped(self.p[1] * e)
    }

    /// Sweeps a plane curve around the y axis if parameter `first` says so: the two that follow are the curve's offset
    /// from the axis and its turn in degrees.
    pub(crate) fn swept(mut self, first: usize) -> Args {
        let (switch, offset, degrees) = (self.p[first], self.p[first + 1], self.p[first + 2]);
        if switch > 0.0 {
            let rho = length(self.x, self.z) - offset;
            if degrees != 0.0 {
                let (sin, cos) = degrees.to_radians().sin_cos();
                (self.x, self.y) = (rho * cos - self.y * sin, rho * sin + self.y * cos);
            } else {
                self.x = rho;
            }
        }
        self
    }
}
