//! Splines taken apart into Bezier pieces, and nets of Bezier control points.
use raggio_function::Range;
use raggio_math::{Vec2, Vec3, Vec4};
use raggio_scene::Knots;
use smallvec::SmallVec;

/// A row of control points.
pub(super) type Row = SmallVec<[Vec4; 8]>;

/// A piece of a spline between two knots.
pub(super) struct Span<'a> {
    knots: &'a Knots,
    /// The number of the knot where it begins.
    index: usize,
    pub(super) from: f64,
    pub(super) to: f64,
}

/// The pieces of a spline; knots that coincide have none between them.
pub(super) fn spans(knots: &Knots) -> impl Iterator<Item = Span<'_>> {
    (knots.degree..knots.points()).filter_map(move |index| {
        let (from, to) = (knots.knots[index], knots.knots[index + 1]);
        (from < to).then_some(Span { knots, index, from, to })
    })
}

impl Span<'_> {
    /// The Bezier control points of the piece: values of its polar form at the ends (Ramshaw, "Blossoming", 1987).
    pub(super) fn bezier(&self, points: &[Vec4]) -> Row {
        let degree = self.knots.degree;
        let row = |ends: usize| {
            let at = |round: usize| if round <= degree - ends { self.from } else { self.to };
            self.polar(points, at)
        };
        (0..=degree).map(row).collect()
    }

    /// The polar form, by de Boor's scheme with an argument for each round, counted from 1.
    fn polar(&self, points: &[Vec4], at: impl Fn(usize) -> f64) -> Vec4 {
        let (degree, knots) = (self.knots.degree, &self.knots.knots);
        let first = self.index - degree;
        let mut row: Row = points[first..=self.index].iter().copied().collect();
        for round in 1..=degree {
            for i in (round..=degree).rev() {
                let (a, b) = (knots[first + i], knots[first + i + degree + 1 - round]);
                row[i] = row[i - 1].lerp(row[i], (at(round) - a) / (b - a));
            }
        }
        row[degree]
    }
}

/// A net of homogeneous control points, v fastest.
pub(super) struct Grid {
    rows: usize,
    points: Vec<Vec4>,
}

impl Grid {
    /// `rows` along u.
    pub(super) fn new(rows: usize, points: Vec<Vec4>) -> Self {
        Grid { rows, points }
    }

    pub(super) fn points(&self) -> &[Vec4] {
        &self.points
    }

    fn columns(&self) -> usize {
        self.points.len() / self.rows
    }

    /// Another net, from each column of this one.
    pub(super) fn along_u(&self, f: impl Fn(&[Vec4]) -> Row) -> Grid {
        let columns = self.columns();
        let new: Vec<Row> = (0..columns)
            .map(|j| f(&(0..self.rows).map(|i| self.points[i * columns + j]).collect::<Row>()))
            .collect();
        let rows = new.first().map_or(0, |column| column.len());
        Grid { rows, points: (0..rows * columns).map(|k| new[k % columns][k / columns]).collect() }
    }

    /// Another net, from each row of this one.
    pub(super) fn along_v(&self, f: impl Fn(&[Vec4]) -> Row) -> Grid {
        Grid { rows: self.rows, points: self.points.chunks(self.columns()).flat_map(f).collect() }
    }

    /// The homogeneous point.
    #[inline]
    pub(super) fn at(&self, at: Vec2) -> Vec4 {
        let across: Row = self.points.chunks(self.columns()).map(|row| bernstein(row, at.y)).collect();
        bernstein(&across, at.x)
    }

    /// The homogeneous point and its derivatives.
    pub(super) fn with_slopes(&self, at: Vec2) -> (Vec4, Vec4, Vec4) {
        let rows = || self.points.chunks(self.columns());
        let across: Row = rows().map(|row| bernstein(row, at.y)).collect();
        let rising: Row = rows().map(|row| slope(row, at.y)).collect();
        (bernstein(&across, at.x), slope(&across, at.x), bernstein(&rising, at.x))
    }

    /// The control points of a part.
    pub(super) fn part(&self, lo: Vec2, hi: Vec2) -> Grid {
        self.along_u(|column| part(column, lo.x, hi.x)).along_v(|row| part(row, lo.y, hi.y))
    }

    /// Moves the surface.
    pub(super) fn move_by(&mut self, d: Vec3) {
        for p in &mut self.points {
            *p += (d * p.w).extend(0.0);
        }
    }

    /// Where the weights lie.
    pub(super) fn weights(&self) -> Range {
        hull(self.points.iter().copied())[3]
    }

    /// Where the homogeneous derivatives lie if the net reaches over parameters of this size.
    pub(super) fn slope_ranges(&self, size: Vec2) -> ([Range; 4], [Range; 4]) {
        let columns = self.columns();
        let (u, v) = ((self.rows - 1) as f64 / size.x, (columns - 1) as f64 / size.y);
        let across = (columns..self.points.len()).map(|k| (self.points[k] - self.points[k - columns]) * u);
        let along = self.points.chunks(columns).flat_map(|row| row.windows(2).map(|w| (w[1] - w[0]) * v));
        (hull(across), hull(along))
    }
}

/// The ranges of four coordinates.
fn hull(points: impl Iterator<Item = Vec4>) -> [Range; 4] {
    let (lo, hi) = points.fold((Vec4::INFINITY, Vec4::NEG_INFINITY), |(lo, hi), p| (lo.min(p), hi.max(p)));
    [0, 1, 2, 3].map(|k| Range::new(lo[k], hi[k]))
}

/// A point of a Bezier curve, by Horner's scheme in Bernstein's basis.
#[inline]
fn bernstein(points: &[Vec4], t: f64) -> Vec4 {
    let degree = points.len() - 1;
    let s = 1.0 - t;
    let (mut power, mut choose) = (1.0, 1.0);
    let mut sum = points[0] * s;
    for (i, p) in points.iter().enumerate().take(degree).skip(1) {
        power *= t;
        choose *= (degree - i + 1) as f64 / i as f64;
        sum = (sum + *p * (power * choose)) * s;
    }
    sum + points[degree] * (power * t)
}

fn slope(points: &[Vec4], t: f64) -> Vec4 {
    let differences: Row = points.windows(2).map(|w| w[1] - w[0]).collect();
    let degree = differences.len() as f64;
    match differences.len() {
        1 => differences[0],
        _ => bernstein(&differences, t) * degree,
    }
}

/// The control points of a part of a Bezier curve (de Casteljau).
pub(super) fn part(points: &[Vec4], from: f64, to: f64) -> Row {
    let mut row: Row = points.iter().copied().collect();
    let last = row.len() - 1;
    if to < 1.0 {
        // From the end, each point becomes the last of the shorter curves so far.
        for round in 1..=last {
            for i in (round..=last).rev() {
                row[i] = row[i - 1].lerp(row[i], to);
            }
        }
    }
    if from > 0.0 {
        for round in 1..=last {
            for i in 0..=last - round {
                row[i] = row[i].lerp(row[i + 1], from / to.min(1.0));
            }
        }
    }
    row
}
