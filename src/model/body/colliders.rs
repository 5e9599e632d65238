//! The colliders of a body, and their contribution to its mass and size.

use super::{RigidBody, RigidBodyChanges};
use crate::dim::mass::{mass_is_valid, no_mass, total_mass};
use crate::dim::math::{Pose, Real};
use crate::model::check::refuse;
use crate::model::collider::{Collider, ColliderEnabled, ColliderHandle, ColliderSet, MassSpread};
use parry::mass_properties::MassProperties;
use smallvec::SmallVec;

/// The colliders of one body. Up to two, as in nearly all bodies, are stored in the body itself. The step
/// reads them together with the body, and a separate list would cost another cache miss per moving body.
pub(crate) type AttachedColliders = SmallVec<[ColliderHandle; 2]>;

/// Contribution of a collider to its body's mass, in the body's frame. Zero for a disabled collider.
fn mass_in_body(collider: &Collider) -> MassProperties {
    match &collider.parent {
        Some(parent) if collider.flags.enabled != ColliderEnabled::Disabled => {
            collider.mass_properties().transform_by(&parent.pos_wrt_parent)
        }
        _ => no_mass(),
    }
}

/// Returns whether the mass properties have neither mass nor inertia.
fn is_massless(mass: &MassProperties) -> bool {
    let nothing = no_mass();
    mass.inv_mass == 0.0 && mass.inv_principal_inertia == nothing.inv_principal_inertia
}

impl RigidBody {
    /// The colliders attached to this body.
    pub fn colliders(&self) -> &[ColliderHandle] {
        &self.colliders
    }

    /// Records that a collider is attached. [`Self::add_collider_mass`] adds its mass.
    ///
    /// A body that replaced another one may list the collider already. The next step lists its colliders
    /// anew.
    pub(crate) fn attach_collider(&mut self, handle: ColliderHandle) {
        self.colliders.push(handle);
        self.changes |= RigidBodyChanges::COLLIDERS | RigidBodyChanges::LOCAL_MASS_PROPERTIES;
    }

    /// Records that a collider is no longer attached. The next step subtracts its mass.
    pub(crate) fn detach_collider(&mut self, handle: ColliderHandle) {
        self.end_assembly();
        if let Some(position) = self.colliders.iter().position(|attached| *attached == handle) {
            self.colliders.remove(position);
            self.changes |= RigidBodyChanges::COLLIDERS | RigidBodyChanges::LOCAL_MASS_PROPERTIES;
        }
    }

    /// Adds the mass of an attached collider, so that impulses act on it before the next step sums up all
    /// masses. A known body wakes if that changes its mass.
    pub(crate) fn add_collider_mass(&mut self, collider: &Collider) {
        let before = self.mprops.local_mprops;
        self.add_mass_of(collider);
        let is_known = !self.changes.contains(RigidBodyChanges::ASSEMBLY);
        self.wake_if(is_known && self.mprops.local_mprops != before);
    }

    fn add_mass_of(&mut self, collider: &Collider) {
        let part = mass_in_body(collider);
        if is_massless(&part) {
            self.spread_over(core::iter::once(collider));
            return self.update_extent(core::iter::once(collider));
        }
        self.mprops.spread = None;
        let total = match self.mprops.from_colliders {
            nothing if nothing == no_mass() => part,
            sum => total_mass(&[sum, part]),
        };
        let center_before = self.local_center_of_mass();
        self.set_collider_mass(total);
        let shift = self.local_center_of_mass().distance(center_before);
        // An upper bound for the colliders that were there before; the next step measures all colliders.
        self.extent += shift;
        self.update_extent([collider].into_iter());
    }

    /// Recomputes mass, centre of mass, inertia and size from the current colliders and the additional mass.
    /// Every point of the body keeps its velocity. The body wakes if its mass properties change.
    ///
    /// The step does this automatically for bodies whose colliders changed.
    pub fn recompute_mass_properties_from_colliders(&mut self, colliders: &ColliderSet) {
        // The masses of a body in assembly were added up already: another sum is an edit.
        let assembly = self.changes & RigidBodyChanges::ASSEMBLY;
        self.end_assembly();
        let has_changed = self.sum_up_colliders(colliders);
        self.changes |= assembly;
        self.wake_if(has_changed && assembly.is_empty());
    }

    /// Sums up the colliders. Returns whether the mass properties changed.
    pub(crate) fn sum_up_colliders(&mut self, colliders: &ColliderSet) -> bool {
        let before = self.mprops.local_mprops;
        let attached: SmallVec<[&Collider; 4]> =
            self.colliders.iter().filter_map(|handle| colliders.get(*handle)).collect();
        let parts: SmallVec<[MassProperties; 4]> =
            attached.iter().map(|c| mass_in_body(c)).filter(|part| *part != no_mass()).collect();
        self.mprops.spread = None;
        let total = total_mass(&parts);
        // The centre of a collider without mass may be anywhere.
        self.set_collider_mass(if is_massless(&total) { no_mass() } else { total });
        self.spread_over(attached.iter().copied());
        self.warn_without_mass(&attached);
        (self.extent, self.thickness) = (0.0, Real::INFINITY);
        self.update_extent(attached.into_iter());
        self.mprops.local_mprops != before
    }

    /// Adds colliders without mass to those over which a mass is spread. Only dynamic bodies whose colliders
    /// all have no mass need that: a surface of many triangles takes long to measure.
    fn spread_over<'a>(&mut self, colliders: impl Iterator<Item = &'a Collider>) {
        if !self.is_dynamic() || self.mprops.from_colliders != no_mass() {
            return;
        }
        let enabled = colliders.filter(|c| c.flags.enabled != ColliderEnabled::Disabled);
        let known = self.mprops.spread.take().map(|spread| *spread);
        let spread = known.into_iter().chain(enabled.filter_map(MassSpread::over_collider));
        self.mprops.spread = spread.reduce(MassSpread::and).map(Box::new);
        if self.mprops.spread.is_some() {
            self.update_mass();
        }
    }

    /// Warns, when that begins, if contacts cannot move the body although it has solid colliders: their
    /// densities are zero.
    fn warn_without_mass(&mut self, attached: &[&Collider]) {
        let is_solid = |c: &&Collider| c.is_enabled() && !c.is_sensor();
        let lacks_mass = self.is_dynamic()
            && self.mprops.local_mprops.inv_mass == 0.0
            && attached.iter().any(is_solid);
        let lacked_mass = core::mem::replace(&mut self.warned_without_mass, lacks_mass);
        if lacks_mass && !lacked_mass {
            log::warn!(
                "a dynamic body has {} colliders and no mass: no force, gravity or contact moves it; a density, a \
                 mass or additional_mass is needed",
                attached.len()
            );
        }
    }

    fn set_collider_mass(&mut self, total: MassProperties) {
        if !mass_is_valid(&total) {
            return refuse("the mass properties of a rigid body's colliders", total);
        }
        self.mprops.from_colliders = total;
        self.update_mass();
    }

    /// Enlarges the extent to include these colliders, and limits the thickness to theirs.
    fn update_extent<'a>(&mut self, colliders: impl Iterator<Item = &'a Collider>) {
        let center = self.local_center_of_mass();
        for collider in colliders {
            let place = collider.parent.as_ref().map_or(Pose::IDENTITY, |p| p.pos_wrt_parent);
            let reach = collider.bounding_radius_about(place.inverse_transform_point(center));
            // Half-spaces reach to infinity, but infinity times an angular velocity of zero is NaN.
            self.extent = self.extent.max(reach).min(Real::MAX);
            self.thickness = self.thickness.min(collider.thickness());
        }
    }
}
