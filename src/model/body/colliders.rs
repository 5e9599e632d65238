//! The colliders of a body: which they are, and the mass and size that they give it.

use super::{RigidBody, RigidBodyChanges};
use crate::dim::mass::{mass_is_valid, no_mass, total_mass};
use crate::dim::math::{Pose, Real};
use crate::model::check::refuse;
use crate::model::collider::{Collider, ColliderEnabled, ColliderHandle, ColliderSet};
use parry::mass_properties::MassProperties;
use smallvec::SmallVec;

/// The colliders of one body. One or two, as nearly all bodies have, stand in the body itself: the step asks for them when it has
/// the body at hand, and a list elsewhere would be one more wait for memory for every body that moves.
pub(crate) type AttachedColliders = SmallVec<[ColliderHandle; 2]>;

/// What a collider adds to its body's mass, in the body's frame. Nothing if the user disabled it.
fn mass_in_body(collider: &Collider) -> MassProperties {
    match &collider.parent {
        Some(parent) if collider.flags.enabled != ColliderEnabled::Disabled => {
            collider.mass_properties().transform_by(&parent.pos_wrt_parent)
        }
        _ => no_mass(),
    }
}

impl RigidBody {
    /// The colliders attached to this body.
    pub fn colliders(&self) -> &[ColliderHandle] {
        &self.colliders
    }

    /// Notes that a collider is attached. Its mass comes by [`Self::add_collider_mass`].
    ///
    /// A body that was put in the place of another may list it already. The next step lists its colliders anew.
    pub(crate) fn attach_collider(&mut self, handle: ColliderHandle) {
        self.colliders.push(handle);
        self.changes |= RigidBodyChanges::COLLIDERS | RigidBodyChanges::LOCAL_MASS_PROPERTIES;
    }

    /// Notes that a collider is no longer attached. The next step takes its mass off.
    pub(crate) fn detach_collider(&mut self, handle: ColliderHandle) {
        if let Some(position) = self.colliders.iter().position(|attached| *attached == handle) {
            self.colliders.remove(position);
            self.changes |= RigidBodyChanges::COLLIDERS | RigidBodyChanges::LOCAL_MASS_PROPERTIES;
        }
    }

    /// Adds the mass of a collider that was just attached, so that the body can be pushed before the
    /// next step sums all of them up.
    pub(crate) fn add_collider_mass(&mut self, collider: &Collider) {
        let part = mass_in_body(collider);
        if part.inv_mass == 0.0 && part == no_mass() {
            return self.update_extent([collider].into_iter());
        }
        let total = match self.mprops.from_colliders {
            nothing if nothing == no_mass() => part,
            sum => total_mass(&[sum, part]),
        };
        let center_before = self.local_center_of_mass();
        self.set_collider_mass(total);
        let shift = self.local_center_of_mass().distance(center_before);
        // An upper bound for the colliders that were there before; the next step measures them.
        self.extent += shift;
        self.update_extent([collider].into_iter());
    }

    /// Sums up mass, centre of mass, inertia and size from the colliders as they are now, and adds the
    /// additional mass. The step does so by itself for bodies whose colliders changed.
    pub fn recompute_mass_properties_from_colliders(&mut self, colliders: &ColliderSet) {
        let attached: SmallVec<[&Collider; 4]> =
            self.colliders.iter().filter_map(|handle| colliders.get(*handle)).collect();
        let parts: SmallVec<[MassProperties; 4]> =
            attached.iter().map(|c| mass_in_body(c)).filter(|part| *part != no_mass()).collect();
        self.set_collider_mass(total_mass(&parts));
        (self.extent, self.thickness) = (0.0, Real::INFINITY);
        self.update_extent(attached.into_iter());
    }

    fn set_collider_mass(&mut self, total: MassProperties) {
        if !mass_is_valid(&total) {
            return refuse("the mass properties of a rigid body's colliders", total);
        }
        self.mprops.from_colliders = total;
        self.update_mass();
    }

    /// Lets the extent reach around these colliders, too, and the thickness be no more than theirs.
    fn update_extent<'a>(&mut self, colliders: impl Iterator<Item = &'a Collider>) {
        let center = self.local_center_of_mass();
        for collider in colliders {
            let place = collider.parent.as_ref().map_or(Pose::IDENTITY, |p| p.pos_wrt_parent);
            let reach = collider.bounding_radius_about(place.inverse_transform_point(center));
            // Half-spaces reach to infinity, but infinity times an angular velocity of zero is no number.
            self.extent = self.extent.max(reach).min(Real::MAX);
            self.thickness = self.thickness.min(collider.thickness());
        }
    }
}
