//! Planes among the members of the world, which all rays are asked about: in a row, without a call for each.
use raggio_math::{Ray, Vec3};

use crate::index::Index;
use crate::leaf::{Leaves, Prim};
use crate::shapes::Plane;
use crate::tree::{Group, Node};
use crate::{Hit, Surface};

/// The planes of a group, and where its other members are.
pub(crate) struct Borders {
    planes: Vec<Border>,
    pub(crate) others: Index,
}

/// A member that is a plane.
struct Border {
    plane: Plane,
    leaf: u32,
    inverted: bool,
    /// Classes of rays that do not see it.
    skip: u8,
}

impl Borders {
    /// Sorts the members of a group.
    pub(crate) fn of(group: &Group, leaves: &Leaves) -> Borders {
        let (mut planes, mut numbers) = (Vec::new(), Vec::new());
        for (number, member) in (0..).zip(&group.members) {
            let Node::Leaf(index) = member.node.node() else { continue };
            let leaf = &leaves.leaves[index as usize];
            if let Prim::Plane(plane) = leaf.prim {
                planes.push(Border { plane, leaf: index, inverted: leaf.inverted, skip: member.skip });
                numbers.push(number);
            }
        }
        Borders { planes, others: group.surfaces.without(&numbers) }
    }

    /// How many planes there are.
    pub(crate) fn len(&self) -> usize {
        self.planes.len()
    }

    /// The normals and distances of all planes.
    pub(crate) fn sides(&self) -> impl Iterator<Item = (Vec3, f64)> + '_ {
        self.planes.iter().map(|border| border.plane.side())
    }

    /// Puts the nearest hit of the planes, for rays of the class whose bit is `class`, where it is wanted, and says
    /// whether there is one.
    #[inline]
    pub(crate) fn closest(&self, ray: &Ray, range: (f64, f64), class: u8, best: &mut Hit) -> bool {
        let (mut far, mut nearest) = (range.1, None);
        for border in self.planes.iter().filter(|border| border.skip & class == 0) {
            if let Some(local) = border.plane.closest(ray, (range.0, far)) {
                far = local.t;
                nearest = Some((border, local));
            }
        }
        let Some((border, local)) = nearest else { return false };
        *best = Hit { t: local.t, leaf: border.leaf, inverted: border.inverted, local };
        true
    }
}
