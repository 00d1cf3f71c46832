//! Rational spline surfaces and the curves that trim them.
use raggio_math::{Vec2, Vec3};

/// `nurbs_patch { ... }`: a tensor product of rational B-splines. What is here fits together: there are as many knots as
/// points and degree ask for, they do not fall, and weights are positive.
#[derive(Clone, Debug, PartialEq)]
pub struct Nurbs {
    /// Along u.
    pub u: Knots,
    /// Along v.
    pub v: Knots,
    /// Control points and their weights, v fastest.
    pub points: Vec<(Vec3, f64)>,
    /// Closed loops in parameters; the surface is there where it lies within an odd number of them, or everywhere if
    /// there are none.
    pub trims: Vec<Trim>,
}

/// Degree and knots of a spline.
#[derive(Clone, Debug, PartialEq)]
pub struct Knots {
    /// 1 for straight pieces, 3 for cubic ones.
    pub degree: usize,
    /// One more than the number of points and the degree together.
    pub knots: Vec<f64>,
}

impl Knots {
    /// The number of control points.
    pub fn points(&self) -> usize {
        self.knots.len() - self.degree - 1
    }

    /// The parameters where the spline begins and ends.
    pub fn domain(&self) -> (f64, f64) {
        (self.knots[self.degree], self.knots[self.points()])
    }
}

/// A rational spline in the plane of the parameters, closed by a straight line if need be.
#[derive(Clone, Debug, PartialEq)]
pub struct Trim {
    /// Along the curve.
    pub knots: Knots,
    /// Control points and their weights.
    pub points: Vec<(Vec2, f64)>,
}
