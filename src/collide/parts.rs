//! The convex parts of a shape, between which contacts are computed.
//!
//! A mesh has triangles, a compound has children, a height field has cells; any other shape is its own only
//! part. Parts far from the other shape are never visited.

use super::part::Part;
use super::voxels::{for_each_voxel, with_voxel};
use crate::base::bvh::SlabProbe;
use crate::dim::collide::{
    Flat, FlatShape, as_flat, as_flat_mesh, cell_count, flat_of, for_each_cell, for_each_free_cell,
    has_free_cells, with_cell,
};
use crate::dim::math::{Pose, Real, Vector};
use parry::bounding_volume::{Aabb, BoundingVolume};
use parry::partitioning::BvhNode;
use parry::shape::{CompositeShape, HeightField, Shape, Voxels};

/// A shape by the search method for its parts.
#[derive(Copy, Clone)]
pub(super) enum Parts<'a> {
    /// Convex: one part.
    Convex(&'a dyn Shape),
    /// Parts in a tree.
    Tree(&'a dyn Shape, &'a dyn CompositeShape),
    /// Parts in a grid.
    Grid(&'a dyn Shape, &'a HeightField),
    /// Boxes of equal size.
    Voxels(&'a dyn Shape, &'a Voxels),
}

impl<'a> Parts<'a> {
    /// Finds out how the parts of a shape are stored.
    pub fn of(shape: &'a dyn Shape) -> Self {
        if let Some(composite) = shape.as_composite_shape() {
            Self::Tree(shape, composite)
        } else if let Some(field) = shape.as_heightfield() {
            Self::Grid(shape, field)
        } else if let Some(voxels) = shape.as_voxels() {
            Self::Voxels(shape, voxels)
        } else {
            Self::Convex(shape)
        }
    }

    /// The shape.
    pub fn shape(&self) -> &'a dyn Shape {
        match *self {
            Self::Convex(shape) => shape,
            Self::Tree(shape, _) | Self::Grid(shape, _) | Self::Voxels(shape, _) => shape,
        }
    }

    /// Number of parts, or a bound of it.
    pub fn len(&self) -> usize {
        match *self {
            Self::Convex(_) => 1,
            Self::Tree(_, composite) => composite.bvh().leaf_count() as usize,
            Self::Grid(_, field) => cell_count(field),
            Self::Voxels(..) => usize::MAX,
        }
    }

    /// Returns whether the shape is one convex part.
    pub fn is_convex(&self) -> bool {
        matches!(self, Self::Convex(_))
    }

    /// Calls `f` with the part of a number, without constraints. No effect if there is no such part.
    pub fn with_part(&self, id: u32, f: &mut dyn FnMut(Part<'_>)) {
        let constraints = None;
        match *self {
            Self::Convex(shape) => f(Part::whole(shape)),
            Self::Tree(_, composite) => {
                composite.map_part_at(id, &mut |pose, shape, _| {
                    f(Part { id, pose, shape, constraints });
                });
            }
            Self::Grid(_, field) => {
                with_cell(field, id, &mut |shape| f(Part { id, pose: None, shape, constraints }));
            }
            Self::Voxels(_, voxels) => with_voxel(voxels, id, f),
        }
    }

    /// The part of a number, if it is a flat piece of a surface.
    pub fn flat(&self, id: u32) -> Option<Flat> {
        let mut found = None;
        self.with_part(id, &mut |part| {
            let flat = as_flat(part.shape).and_then(Flat::new);
            found = flat.map(|flat| part.pose.map_or(flat, |pose| flat.at(pose)));
        });
        found
    }

    /// Returns whether the shape is a two-sided surface of flat parts.
    pub fn is_surface(&self) -> bool {
        match *self {
            Self::Tree(shape, _) => as_flat_mesh(shape).is_some(),
            Self::Grid(_, field) => has_free_cells(field),
            _ => false,
        }
    }

    /// Calls `f` with every part of a surface that may reach into a box, always in the same order.
    pub fn for_each_flat(&self, region: &Aabb, mut f: impl FnMut(u32, &FlatShape)) {
        let near = Near::Inside(*region);
        match *self {
            Self::Tree(shape, _) => {
                let Some(mesh) = as_flat_mesh(shape) else { return };
                for id in mesh.bvh().leaves(|node| near.touches(node)) {
                    f(id, &flat_of(mesh, id));
                }
            }
            Self::Grid(_, field) => {
                let Some(region) = near.clipped(field.local_aabb()) else { return };
                for_each_free_cell(field, &region, f);
            }
            _ => {}
        }
    }

    /// Calls `f` with every part that may reach into `near`, always in the same order; where something moves
    /// along a line, perhaps more than once.
    pub fn for_each_part(&self, near: &Near, f: &mut dyn FnMut(Part<'_>)) {
        match *self {
            Self::Convex(shape) => f(Part::whole(shape)),
            Self::Tree(_, composite) => {
                for id in composite.bvh().leaves(|node| near.touches(node)) {
                    composite.map_part_at(id, &mut |pose, shape, constraints| {
                        f(Part { id, pose, shape, constraints });
                    });
                }
            }
            Self::Grid(_, field) => near.for_each_piece(field.local_aabb(), |region| {
                for_each_cell(field, region, &mut |id, shape, constraints| {
                    f(Part { id, pose: None, shape, constraints });
                });
            }),
            Self::Voxels(_, voxels) => near.for_each_piece(voxels.local_aabb(), |region| {
                for_each_voxel(voxels, region, f);
            }),
        }
    }
}

/// The region, in the frame of one shape, in which the other shape can be touched.
pub(super) enum Near {
    /// Inside a box.
    Inside(Aabb),
    /// Tests against a swept line.
    Along(Line),
    /// Below a plane: where `normal · x ≤ offset`.
    Below {
        /// Unit normal of the plane.
        normal: Vector,
        /// Its distance from the origin.
        offset: Real,
    },
}

impl Near {
    /// The points that are within `prediction` of `other` at `pose`.
    pub fn of(other: &dyn Shape, pose: &Pose, prediction: Real) -> Self {
        match other.as_halfspace() {
            Some(half_space) => {
                let normal = pose.rotation * half_space.normal;
                Self::Below { normal, offset: normal.dot(pose.translation) + prediction }
            }
            None => Self::Inside(other.compute_aabb(pose).loosened(prediction)),
        }
    }

    /// The region, if it is a box of finite size.
    pub fn bounds(&self) -> Option<Aabb> {
        match self {
            Self::Inside(region) => Some(*region).filter(|region| region.extents().is_finite()),
            Self::Along(line) => Some(line.region),
            Self::Below { .. } => None,
        }
    }

    /// Returns whether anything in `node` may lie in the region.
    #[inline]
    fn touches(&self, node: &BvhNode) -> bool {
        match self {
            Self::Inside(region) => overlaps(node, region),
            Self::Along(line) => {
                overlaps(node, &line.region) && {
                    let [start, end] = line.probe.span(&Aabb::new(node.mins(), node.maxs()));
                    start <= end.min(1.0)
                }
            }
            Self::Below { normal, offset } => {
                let (mins, maxs) = (node.mins(), node.maxs());
                let center = mins.midpoint(maxs);
                let lowest = normal.dot(center) - normal.abs().dot(maxs - center);
                lowest <= *offset
            }
        }
    }

    /// A box that covers the part of `bounds` in the region; `None` if they do not overlap.
    fn clipped(&self, bounds: Aabb) -> Option<Aabb> {
        match self {
            Self::Inside(region) | Self::Along(Line { region, .. }) => bounds.intersection(region),
            Self::Below { .. } => Some(bounds),
        }
    }

    /// Calls `f` with boxes that cover the part of `bounds` in the region.
    fn for_each_piece(&self, bounds: Aabb, mut f: impl FnMut(&Aabb)) {
        let Some(whole) = self.clipped(bounds) else { return };
        let Self::Along(line) = self else { return f(&whole) };
        let [start, end] = line.probe.span(&whole);
        let (start, end) = (start.min(1.0), end.min(1.0));
        let length = (end - start) * line.displacement.length();
        let count = (length / (2.0 * line.radius)).ceil().clamp(1.0, PIECES_MAX);
        let at = |k: Real| line.start + line.displacement * (start + (end - start) * (k / count));
        for k in 0..count as usize {
            let (from, to) = (at(k as Real), at(k as Real + 1.0));
            let piece = Aabb::new(from.min(to), from.max(to)).loosened(line.radius);
            whole.intersection(&piece).iter().for_each(&mut f);
        }
    }
}

#[inline]
fn overlaps(node: &BvhNode, region: &Aabb) -> bool {
    // parry has this test in lanes; but not where it could be inlined, and a call costs more.
    node.mins().cmple(region.maxs).all() && node.maxs().cmpge(region.mins).all()
}

/// Largest number of boxes of a line.
const PIECES_MAX: Real = 64.0;

/// The swept region of a point set that moves along a line, independent of its rotation.
///
/// The box of a long diagonal path contains nearly everything: all triangles of a terrain, of which the line
/// crosses some hundred.
pub(super) struct Line {
    start: Vector,
    displacement: Vector,
    radius: Real,
    probe: SlabProbe,
    region: Aabb,
}

impl Line {
    /// The swept region of all points within `radius` of `start`; all of it lies in `region`. `None` if it
    /// has no end, or is no longer than wide, so that the region is sufficient.
    pub fn new(start: Vector, displacement: Vector, radius: Real, region: Aabb) -> Option<Self> {
        let length = displacement.length();
        let is_long = radius > 0.0 && length > 2.0 * radius;
        (is_long && length.is_finite() && start.is_finite()).then(|| {
            let probe = SlabProbe::new(start, displacement, Vector::splat(radius));
            Self { start, displacement, radius, probe, region }
        })
    }
}
