//! Probes: tests of the boxes of a node.
//!
//! No test misses a box that it should find: where a rounding error could decide, it decides for the box.

use super::node::Planes;
use crate::base::wide::Wide;
use parry::bounding_volume::Aabb;
use parry::math::{DIM, Real, Vector};

/// Tests all boxes of a node at once.
pub trait Probe: Copy {
    /// Lower bounds of the distance for each box, and the boxes with anything within `reach`.
    ///
    /// Must be `#[inline(always)]`, see [`Kernel`](crate::base::wide::Kernel).
    fn test<W: Wide>(&self, planes: &Planes, reach: Real) -> (W, W::Mask);
}

/// A box: finds overlapping boxes. Touching counts. It has no distances: all are zero.
#[derive(Copy, Clone, Debug)]
pub struct BoxProbe(pub Aabb);

impl Probe for BoxProbe {
    #[inline(always)]
    fn test<W: Wide>(&self, planes: &Planes, _reach: Real) -> (W, W::Mask) {
        let mut mask = W::zero().le(W::zero());
        for axis in 0..DIM {
            let (mins, maxs) = (W::load(&planes[axis]), W::load(&planes[DIM + axis]));
            mask = mask & mins.le(W::splat(self.0.maxs[axis]));
            mask = mask & W::splat(self.0.mins[axis]).le(maxs);
        }
        (W::splat(Real::MIN), mask)
    }
}

/// A point: finds near boxes.
#[derive(Copy, Clone, Debug)]
pub struct PointProbe(pub Vector);

impl Probe for PointProbe {
    #[inline(always)]
    fn test<W: Wide>(&self, planes: &Planes, reach: Real) -> (W, W::Mask) {
        let mut squared = W::zero();
        for axis in 0..DIM {
            let (mins, maxs) = (W::load(&planes[axis]), W::load(&planes[DIM + axis]));
            let place = W::splat(self.0[axis]);
            let outside = (mins - place).max(place - maxs).max(W::zero());
            squared = squared + outside * outside;
        }
        // Rounding must not make the distance of an equal box larger.
        let distance = squared.sqrt() * W::splat(1.0 - 4.0 * Real::EPSILON);
        (distance, distance.le(W::splat(reach)))
    }
}

/// A ray or a swept box, with the time at which it enters another box.
///
/// A swept box is a ray from its middle against boxes that are larger by its half extents. With one addition
/// less it is two rays: from its front for the entry planes, and from its back for the exit planes.
#[derive(Copy, Clone, Debug)]
pub struct SlabProbe {
    front: Vector,
    back: Vector,
    inv_dir: Vector,
    /// The first planes of a node per axis, and the last ones.
    near: [usize; DIM],
    far: [usize; DIM],
}

impl SlabProbe {
    /// A box around `origin` (or, of no size, a point), that moves along `dir` for ever.
    pub fn new(origin: Vector, dir: Vector, half_extents: Vector) -> Self {
        let (mut front, mut back, mut inv_dir) = (origin, origin, dir);
        let (mut near, mut far) = ([0; DIM], [0; DIM]);
        for axis in 0..DIM {
            // The inverse of a zero component is the largest finite number, so that its product with zero is
            // zero.
            let length = dir[axis];
            inv_dir[axis] = if length.abs() > 1.0 / Real::MAX { 1.0 / length } else { Real::MAX };
            let forth = inv_dir[axis] > 0.0;
            (near[axis], far[axis]) = if forth { (axis, DIM + axis) } else { (DIM + axis, axis) };
            let half = if forth { half_extents[axis] } else { -half_extents[axis] };
            front[axis] += half;
            back[axis] -= half;
        }
        Self { front, back, inv_dir, near, far }
    }

    /// The time interval in a box, limited to the earliest and the latest time. A box that is never entered
    /// has an exit before the entry, or at time zero.
    pub fn span(&self, aabb: &Aabb) -> [Real; 2] {
        let (mut start, mut end) = (0.0, Real::INFINITY);
        for axis in 0..DIM {
            let forth = self.inv_dir[axis] > 0.0;
            let (near, far) = if forth { (aabb.mins, aabb.maxs) } else { (aabb.maxs, aabb.mins) };
            start = ((near[axis] - self.front[axis]) * self.inv_dir[axis]).max(start);
            end = ((far[axis] - self.back[axis]) * self.inv_dir[axis]).min(end);
        }
        [start * (1.0 - 4.0 * Real::EPSILON), (end * (1.0 + 4.0 * Real::EPSILON)).max(0.0)]
    }
}

impl Probe for SlabProbe {
    /// The exit is later by the rounding errors of entry and exit, so a ray along a face does not miss the
    /// box. (Ize, "Robust BVH Ray Traversal", JCGT 2013.)
    #[inline(always)]
    fn test<W: Wide>(&self, planes: &Planes, reach: Real) -> (W, W::Mask) {
        let (mut start, mut end) = (W::zero(), W::splat(Real::INFINITY));
        for axis in 0..DIM {
            let inv_dir = W::splat(self.inv_dir[axis]);
            let (near, far) = (W::load(&planes[self.near[axis]]), W::load(&planes[self.far[axis]]));
            // If one operand is NaN, `max` and `min` return the second one.
            start = ((near - W::splat(self.front[axis])) * inv_dir).max(start);
            end = ((far - W::splat(self.back[axis])) * inv_dir).min(end);
        }
        let end = end * W::splat(1.0 + 4.0 * Real::EPSILON);
        (start, start.le(end) & start.le(W::splat(reach)))
    }
}
