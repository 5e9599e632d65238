//! The contacts of a body with other shapes than that of the current pair.

use super::internal_edges::{Facet, GhostContact, Piece, find_ghost_contacts};
use super::normals::NORMAL_DISTANCE_SQUARED_MAX;
use super::parts::Parts;
use crate::dim::math::{MAX_MANIFOLD_POINTS, Pose, Real, Vector};
use crate::model::contact::ContactManifold;
use arrayvec::ArrayVec;
use parry::shape::Shape;

/// Points of contacts may be this many times the step height beyond the edge of their piece.
const EDGE_DISTANCE_RATIO_MAX: Real = 25.0;

/// A contact of a body with a non-dynamic collider. All in the frame of the body's shape.
#[derive(Clone)]
pub(crate) struct Neighbor<'a> {
    shape: &'a dyn Shape,
    part: u32,
    pose: Pose,
    /// The body, and its touching part.
    body: &'a dyn Shape,
    on: u32,
    /// Unit normal, from the collider to the body.
    normal: Vector,
    /// The points on the collider, the deepest first.
    points: ArrayVec<Vector, MAX_MANIFOLD_POINTS>,
    /// Distance at the deepest point.
    dist: Real,
}

impl<'a> Neighbor<'a> {
    /// The contacts of a manifold with the non-dynamic collider, which is the first or second of its shapes
    /// (`side`). `pose` is that collider's, in the frame of the other. `None` if the manifold has no points.
    pub fn of(
        manifold: &ContactManifold,
        side: usize,
        shapes: [&'a dyn Shape; 2],
        pose: Pose,
    ) -> Option<Self> {
        let contacts = manifold.contacts();
        let depth = |index: &usize| contacts[*index].dist;
        let deepest = (0..contacts.len()).min_by(|a, b| depth(a).total_cmp(&depth(b)))?;
        let mut points: ArrayVec<_, MAX_MANIFOLD_POINTS> = contacts
            .iter()
            .map(|contact| pose * if side == 0 { contact.local_p1 } else { contact.local_p2 })
            .collect();
        points.swap(0, deepest);
        let parts = [manifold.subshape1, manifold.subshape2];
        let outward = [manifold.local_n1, manifold.local_n2];
        Some(Self {
            shape: shapes[side],
            part: parts[side],
            pose,
            body: shapes[1 - side],
            on: parts[1 - side],
            normal: -outward[1 - side],
            points,
            dist: contacts[deepest].dist,
        })
    }

    pub(super) fn as_facet(&self) -> Facet<'a> {
        let Self { part: id, pose, on, normal, dist, .. } = *self;
        let piece = Piece::new(Parts::of(self.shape), id, pose);
        let place = self.points.first().copied().unwrap_or(Vector::ZERO);
        Facet::new(piece, Parts::of(self.body), on, normal, place, dist)
    }
}

/// Returns whether any contact is below the plane of another, or nearly so. A ghost contact satisfies this by
/// its collider. A body among stones has contacts all around, and the full test of the stones' faces takes
/// long.
fn any_below_another(neighbors: &[Neighbor<'_>], step_height_tolerance: Real) -> bool {
    neighbors.iter().enumerate().any(|(index, one)| {
        let Some(place) = one.points.first() else { return false };
        let level = one.normal.dot(*place) + EDGE_DISTANCE_RATIO_MAX * step_height_tolerance;
        let others = neighbors.iter().enumerate().filter(|(other, _)| *other != index);
        let is_below = |point: &Vector| one.normal.dot(*point) <= level;
        others.into_iter().any(|(_, other)| {
            one.normal.distance_squared(other.normal) > NORMAL_DISTANCE_SQUARED_MAX
                && other.points.iter().any(is_below)
        })
    })
}

/// The ghost contacts among the contacts of one body; `step_height_tolerance` is the height (length units)
/// below which a step is ignored.
pub(crate) fn ghost_contacts_among(
    neighbors: &[Neighbor<'_>],
    step_height_tolerance: Real,
) -> Vec<usize> {
    if !any_below_another(neighbors, step_height_tolerance) {
        return Vec::new();
    }
    let facets: Vec<_> = neighbors.iter().map(Neighbor::as_facet).collect();
    let mut ghost_contacts = Vec::new();
    let points = |index: usize, f: &mut dyn FnMut(Vector)| {
        neighbors[index].points.iter().for_each(|point| f(*point));
    };
    find_ghost_contacts(&facets, facets.len(), &points, step_height_tolerance, &mut ghost_contacts);
    ghost_contacts.iter().map(|ghost: &GhostContact| ghost.index).collect()
}
