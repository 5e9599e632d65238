//! Contacts that are only seams: how a surface of many pieces feels like one.
//!
//! A body that slides over a floor of tiles sinks in a little, because contacts are soft. To the next
//! tile it then seems to come from the side: the shortest way out of that tile, or the way to it, is
//! against the motion. Each tile by itself is right; together they are a floor without any sides.
//! Bodies that catch on such seams are the oldest complaint about physics engines.
//!
//! Two rules find contacts that are not there. Let `X` be a convex body that touches the obstacles `A`
//! and `B`, with the normals `a` and `b`, which point to `X`.
//!
//! 1. **Behind.** If no point of `B` is above the plane through the contact with `A`, then `B` cannot
//!    be in the way of `X`, which is above that plane as far as it can be: the normal `a` separates `X`
//!    from `B` as well as from `A`. This holds for tiles that are flush, for those behind a gap and
//!    those that are lower. It needs no knowledge of how the obstacles hang together, so it is the same
//!    for the triangles of a mesh, for colliders, and for bodies.
//! 2. **Hidden.** If `X` meets `B` at an edge or a corner (`b` is no normal of a face of `B`), if this
//!    place lies on `A`, and if `A` rises from there above the plane of the contact, then the place is
//!    inside a valley whose one side `X` touches already: no point of `X` can come to it before coming
//!    to the side. A ball would feel the lowest line of each valley of a terrain as a bump.
//!
//! In either case `B` may still carry `X`, but with its face that looks along `a`: the contact is
//! computed anew with that face, and only if there is none it goes.
//!
//! The limits: a step that is less high than the tolerance ([`IntegrationParameters::allowed_linear_error`]
//! (crate::model::params::IntegrationParameters), 1 mm by default) is no step. And `X` must touch `A`
//! in the same step: a body that comes down flat beside an edge meets the edge.
//!
//! Others mark the edges of a mesh as convex or not (Bullet, Jolt, parry) or give segments the corners of
//! their neighbours (Box2D); that needs the neighbours to be known beforehand, and works within one
//! shape only.

use super::parts::{Part, Parts};
use crate::dim::collide::Polytope;
use crate::dim::math::{Pose, Real, Vector};
use smallvec::SmallVec;

/// A contact normal with at least this cosine to that of a face (0.8 degrees) is the face's.
const FACE: Real = 0.9999;
/// How far a hidden seam's other side rises above the contact plane, at least, as a share of the tolerance.
const RISE: Real = 0.05;
/// Normals with at least this cosine to each other (0.08 degrees) are the same.
const SAME: Real = 0.999_999;

/// A convex part of a shape, somewhere.
#[derive(Copy, Clone)]
pub(super) struct Obstacle<'a> {
    pub parts: Parts<'a>,
    pub id: u32,
    /// Pose of the shape in the common frame.
    pub pose: Pose,
}

impl Obstacle<'_> {
    fn with<T>(&self, mut f: impl FnMut(&Part<'_>, &Pose) -> Option<T>) -> Option<T> {
        let mut result = None;
        self.parts.with_part(self.id, &mut |part| {
            let pose = part.pose.map_or(self.pose, |pose| self.pose * *pose);
            result = f(&part, &pose);
        });
        result
    }

    /// How far it reaches along a direction; `None` if without limit.
    fn height(&self, direction: Vector) -> Option<Real> {
        self.with(|part, pose| {
            let local = pose.rotation.inverse() * direction;
            let highest = match Polytope::of(part.shape) {
                Some((polytope, radius)) => polytope.support(local) + local * radius,
                None => part.shape.as_support_map()?.local_support_point(local),
            };
            Some(direction.dot(*pose * highest))
        })
    }

    /// Is a point inside, or as near as `tolerance`?
    fn contains(&self, point: Vector, tolerance: Real) -> bool {
        let near = self.with(|part, pose| {
            let local = pose.inverse_transform_point(point);
            Some(part.shape.distance_to_local_point(local, true) <= tolerance)
        });
        near == Some(true)
    }

    /// Is a direction the normal of a face, or of a surface without edges?
    fn has_face(&self, normal: Vector) -> bool {
        let face = self.with(|part, pose| {
            let local = pose.rotation.inverse() * normal;
            let (polytope, _) = Polytope::of(part.shape)?;
            Some(polytope.face_toward(local).is_some_and(|face| face.normal.dot(local) > FACE))
        });
        face != Some(false)
    }
}

/// A contact of a convex part with an obstacle, in a frame that is common to all contacts of the part.
#[derive(Copy, Clone)]
pub(super) struct Facet<'a> {
    pub obstacle: Obstacle<'a>,
    /// Which part of its shape the body meets the obstacle with.
    pub on: u32,
    /// Unit normal, from the obstacle to the body.
    pub normal: Vector,
    /// The deepest point, on the obstacle.
    pub place: Vector,
    /// Distance there.
    pub dist: Real,
}

impl Facet<'_> {
    /// Does `self` meet the same part of the body in another direction?
    fn is_other(&self, facet: &Self) -> bool {
        self.on == facet.on && self.normal.dot(facet.normal) < SAME
    }

    /// First rule: is the obstacle of `self` behind the plane of `other`?
    pub fn is_behind(&self, other: &Facet<'_>, tolerance: Real) -> bool {
        let limit = other.normal.dot(other.place) + tolerance;
        // The place is part of the obstacle, and most often tells.
        other.normal.dot(self.place) <= limit
            && self.obstacle.height(other.normal).is_some_and(|height| height <= limit)
    }

    /// Second rule, for one of the points of `self`: does the obstacle of `other` hide it?
    pub fn is_hidden_at(&self, point: Vector, other: &Facet<'_>, tolerance: Real) -> bool {
        let level = self.normal.dot(point) + RISE * tolerance;
        other.dist <= self.dist + tolerance
            && other.obstacle.contains(point, tolerance)
            && other.obstacle.height(self.normal).is_none_or(|height| height > level)
    }
}

/// A contact that is only a seam.
#[derive(Copy, Clone, Debug)]
pub(super) struct Seam {
    /// Its number.
    pub index: usize,
    /// The normal along which its obstacle may still carry the body.
    pub along: Vector,
}

/// Finds the seams among the first `own` facets; the others are known to be contacts. `points` gives
/// the points of a facet, on its obstacle.
///
/// The deepest contacts are judged first, and what was found to be a seam explains no other away: so
/// at least one contact stays.
pub(super) fn find_seams(
    facets: &[Facet<'_>],
    own: usize,
    points: impl Fn(usize, &mut dyn FnMut(Vector)),
    tolerance: Real,
    seams: &mut Vec<Seam>,
) {
    let planes = distinct_planes(facets, tolerance);
    if planes.len() < 2 {
        return;
    }
    let mut order: SmallVec<[usize; 32]> = (0..own).collect();
    order.sort_by(|&a, &b| facets[a].dist.total_cmp(&facets[b].dist));
    let is_contact = |index: usize, seams: &[Seam]| seams.iter().all(|seam| seam.index != index);
    for index in order {
        let facet = &facets[index];
        let explains = |other: &usize| facets[*other].is_other(facet) && is_contact(*other, seams);
        let front = planes.iter().copied().filter(explains).find(|&other| {
            let other = &facets[other];
            facet.is_behind(other, tolerance)
                && !(facet.dist < other.dist && other.is_behind(facet, tolerance))
        });
        let found = front.or_else(|| {
            if facet.obstacle.has_face(facet.normal) {
                return None;
            }
            let mut hidden_by = None;
            let mut is_hidden = true;
            points(index, &mut |point| {
                let hides = |&other: &usize| facet.is_hidden_at(point, &facets[other], tolerance);
                let other = (0..facets.len()).filter(explains).find(hides);
                is_hidden &= other.is_some();
                hidden_by = hidden_by.or(other);
            });
            hidden_by.filter(|_| is_hidden)
        });
        if let Some(other) = found {
            seams.push(Seam { index, along: facets[other].normal });
        }
    }
}

/// One facet for each plane, the deepest.
fn distinct_planes(facets: &[Facet<'_>], tolerance: Real) -> SmallVec<[usize; 8]> {
    let mut planes = SmallVec::<[usize; 8]>::new();
    for (index, facet) in facets.iter().enumerate() {
        let same = planes.iter_mut().find(|plane| {
            let plane = &facets[**plane];
            let offset = plane.normal.dot(facet.place - plane.place);
            plane.on == facet.on && !plane.is_other(facet) && offset.abs() < tolerance
        });
        match same {
            Some(plane) if facet.dist < facets[*plane].dist => *plane = index,
            Some(_) => {}
            None => planes.push(index),
        }
    }
    planes
}
