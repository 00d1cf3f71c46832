//! A tree of boxes in the plane over pieces of curves in their order: neighbours along a curve lie side by side.
use raggio_math::Vec2;

/// Boxes are grown by this share of their extent and place, so that rounding loses nothing.
const MARGIN: f64 = 1e-9;

/// The tree, parents before their children.
#[derive(Clone, Debug)]
pub(crate) struct PlaneTree {
    nodes: Vec<Node>,
}

/// A box of one or more pieces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    pub(crate) min: Vec2,
    pub(crate) max: Vec2,
    /// The node to go on with when nothing in here is wanted.
    skip: u32,
    /// The piece, of a node with only one.
    piece: Option<u32>,
}

impl PlaneTree {
    /// A tree over the boxes (least and greatest corner) of pieces.
    pub(crate) fn new(boxes: &[(Vec2, Vec2)]) -> Self {
        let mut tree = PlaneTree { nodes: Vec::with_capacity(2 * boxes.len()) };
        if !boxes.is_empty() {
            tree.build(boxes, 0);
        }
        tree
    }

    fn build(&mut self, boxes: &[(Vec2, Vec2)], first: usize) {
        let (min, max) = boxes.iter().fold(boxes[0], |sum, b| (sum.0.min(b.0), sum.1.max(b.1)));
        let margin = MARGIN * (1.0 + min.abs().max(max.abs()).max_element());
        let piece = (boxes.len() == 1).then_some(first as u32);
        let at = self.nodes.len();
        self.nodes.push(Node {
            min: min - Vec2::splat(margin),
            max: max + Vec2::splat(margin),
            skip: 0,
            piece,
        });
        if piece.is_none() {
            let (left, right) = boxes.split_at(boxes.len() / 2);
            self.build(left, first);
            self.build(right, first + left.len());
        }
        self.nodes[at].skip = self.nodes.len() as u32;
    }

    /// Calls `each` in order with the pieces of which no box that holds them is `rejected`, and with their own box.
    #[inline(always)]
    pub(crate) fn visit(&self, rejected: impl Fn(&Node) -> bool, mut each: impl FnMut(usize, &Node)) {
        let mut i = 0;
        while let Some(node) = self.nodes.get(i) {
            if rejected(node) {
                i = node.skip as usize;
                continue;
            }
            if let Some(piece) = node.piece {
                each(piece as usize, node);
            }
            i += 1;
        }
    }
}

/// A line `normal . p + offset = 0` in the plane, and the box around the part of it that matters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(crate) normal: Vec2,
    pub(crate) offset: f64,
    min: Vec2,
    max: Vec2,
}

impl Line {
    /// The whole line.
    #[inline]
    pub(crate) fn new(normal: Vec2, offset: f64) -> Self {
        Line { normal, offset, min: Vec2::NEG_INFINITY, max: Vec2::INFINITY }
    }

    /// The line where it is between two of its points; points that are no numbers bound nothing.
    #[inline]
    pub(crate) fn between(self, a: Vec2, b: Vec2) -> Self {
        if a.is_nan() || b.is_nan() {
            return self;
        }
        Line { min: a.min(b), max: a.max(b), ..self }
    }

    /// The signed distance of a point, times the length of the normal.
    #[inline(always)]
    pub(crate) fn side(&self, p: Vec2) -> f64 {
        self.normal.x * p.x + self.normal.y * p.y + self.offset
    }

    /// Does the line surely pass the box by?
    #[inline(always)]
    pub(crate) fn misses(&self, node: &Node) -> bool {
        if node.max.x < self.min.x
            || node.max.y < self.min.y
            || node.min.x > self.max.x
            || node.min.y > self.max.y
        {
            return true;
        }
        let (middle, half) = ((node.min + node.max) * 0.5, (node.max - node.min) * 0.5);
        self.side(middle).abs() > self.normal.x.abs() * half.x + self.normal.y.abs() * half.y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ring of small boxes.
    fn ring() -> Vec<(Vec2, Vec2)> {
        let at = |k: i32| Vec2::from_angle(f64::from(k) * 0.37) * 3.0;
        (0..17).map(|k| (at(k).min(at(k + 1)), at(k).max(at(k + 1)))).collect()
    }

    fn visited(line: &Line) -> Vec<usize> {
        let mut seen = Vec::new();
        PlaneTree::new(&ring()).visit(|node| line.misses(node), |i, _| seen.push(i));
        seen
    }

    #[test]
    fn the_pieces_on_a_line_are_visited_in_order() {
        for k in 0..40 {
            let line = Line::new(Vec2::from_angle(f64::from(k)), f64::from(k % 7) - 3.0);
            let touched = |(min, max): &(Vec2, Vec2)| {
                let sides =
                    [*min, *max, Vec2::new(min.x, max.y), Vec2::new(max.x, min.y)].map(|p| line.side(p));
                sides.iter().any(|s| *s <= 0.0) && sides.iter().any(|s| *s >= 0.0)
            };
            let wanted: Vec<usize> = (0..17).filter(|&i| touched(&ring()[i])).collect();
            assert_eq!(visited(&line), wanted);
        }
    }

    #[test]
    fn only_the_part_between_two_points_counts_if_they_are_numbers() {
        let line = Line::new(Vec2::Y, 0.0);
        let all = visited(&line);
        let half = visited(&line.between(Vec2::ZERO, Vec2::new(f64::INFINITY, 0.0)));
        assert!(!half.is_empty() && half.len() < all.len());
        assert_eq!(visited(&line.between(Vec2::ZERO, Vec2::NAN)), all);
        assert!(visited(&line.between(Vec2::ZERO, Vec2::X)).is_empty());
    }

    #[test]
    fn nothing_to_visit_in_an_empty_tree() {
        PlaneTree::new(&[]).visit(|_| false, |_, _| unreachable!());
    }
}
