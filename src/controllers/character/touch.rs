//! Conversion of a contact manifold into a plane.
//!
//! A manifold may extend beyond the obstacle: the plane of a face reaches a little beyond its edges. This
//! does not affect falling bodies, but a character that walks over a ridge would follow the plane into the
//! air. Contact points outside the obstacle are therefore ignored, and the closest points are used if none
//! remains.

use super::planes::Plane;
use super::resolved::ResolvedSettings;
use crate::base::guard::guarded;
use crate::collide::nearest_point;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::body::RigidBodyType;
use crate::model::collider::{Collider, ColliderHandle};
use crate::model::contact::{Contact, ContactManifold};
use parry::shape::Shape;

/// Rounds of the search for closest points. From a point beside an edge, two or three are enough.
const ROUNDS_MAX: usize = 8;

/// A collider and the character at their poses.
#[derive(Copy, Clone)]
pub(super) struct Touch<'a> {
    pub handle: ColliderHandle,
    pub collider: &'a Collider,
    pub pose: &'a Pose,
    pub shape: &'a dyn Shape,
}

impl Touch<'_> {
    /// A manifold as a plane; `None` if it has no genuine point within `reach`.
    pub fn plane(
        &self,
        manifold: &ContactManifold,
        reach: Real,
        settings: &ResolvedSettings,
    ) -> Option<Plane> {
        let is_genuine = |contact: &&Contact| self.is_genuine(contact, settings);
        let genuine: Vec<&Contact> = manifold.contacts().iter().filter(is_genuine).collect();
        if !genuine.is_empty() {
            return Some(self.of_contacts(manifold, &genuine, settings));
        }
        let start = manifold.find_deepest_contact()?;
        let Some((point, away)) = self.closest(self.collider.position() * start.local_p1, settings)
        else {
            // They overlap: the manifold is all that is known.
            let all: Vec<&Contact> = manifold.contacts().iter().collect();
            return Some(self.of_contacts(manifold, &all, settings));
        };
        let gap = away.length();
        let subshapes = [manifold.subshape1, manifold.subshape2];
        let points = core::iter::once(point);
        (gap <= reach).then(|| self.with_normal(away / gap, gap, points, subshapes, settings))
    }

    fn of_contacts(
        &self,
        manifold: &ContactManifold,
        contacts: &[&Contact],
        settings: &ResolvedSettings,
    ) -> Plane {
        let pose = self.collider.position();
        let gap = contacts.iter().map(|contact| contact.dist).fold(Real::INFINITY, Real::min);
        let points = contacts.iter().map(|contact| pose * contact.local_p1);
        let subshapes = [manifold.subshape1, manifold.subshape2];
        self.with_normal(pose.rotation * manifold.local_n1, gap, points, subshapes, settings)
    }

    fn with_normal(
        &self,
        normal: Vector,
        gap: Real,
        points: impl Iterator<Item = Vector>,
        subshapes: [u32; 2],
        settings: &ResolvedSettings,
    ) -> Plane {
        let rise = normal.dot(settings.up);
        Plane {
            collider: self.handle,
            subshapes,
            is_dynamic: self.collider.parent_type == Some(RigidBodyType::Dynamic),
            normal,
            gap,
            points: points.collect(),
            kind: Plane::kind_of(rise, settings),
            rise,
        }
    }

    /// Returns whether the two points of a contact lie on the obstacle and on the character.
    fn is_genuine(&self, contact: &Contact, settings: &ResolvedSettings) -> bool {
        let is_on = |shape: &dyn Shape, point: Vector| {
            guarded(|| nearest_point(shape, point).distance(point))
                .is_none_or(|distance| distance <= settings.tolerance)
        };
        is_on(self.collider.shape(), contact.local_p1) && is_on(self.shape, contact.local_p2)
    }

    /// The closest points, near a given one: that on the obstacle, and the vector from there to the
    /// character. `None` if they overlap.
    ///
    /// Projects to and fro between the two, which for convex parts converges to the closest points (W.
    /// Cheney, A. Goldstein 1959, "Proximity maps for convex sets").
    fn closest(&self, near: Vector, settings: &ResolvedSettings) -> Option<(Vector, Vector)> {
        let obstacle = self.collider.shape();
        let nearest = |shape: &dyn Shape, pose: &Pose, point: Vector| {
            guarded(|| *pose * nearest_point(shape, pose.inverse_transform_point(point)))
        };
        let on_obstacle = |point: Vector| nearest(obstacle, self.collider.position(), point);
        let on_character = |point: Vector| nearest(self.shape, self.pose, point);
        let (mut from, mut away) = (on_obstacle(near)?, Vector::ZERO);
        for _ in 0..ROUNDS_MAX {
            let to = on_character(from)?;
            let next = on_obstacle(to)?;
            let moved = (next - from).length();
            (from, away) = (next, to - next);
            if moved <= settings.nothing() {
                break;
            }
        }
        (away.length() > settings.nothing()).then_some((from, away))
    }
}
