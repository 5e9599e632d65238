//! Mass of a body: its record, and the solver's view.

use super::RigidBodyType;
use crate::base::measure::is_point;
use crate::dim::axes::{LockedAxes, inv_mass_per_axis, lock_rotations};
use crate::dim::mass::{mass_is_valid, no_mass, total_mass};
use crate::dim::math::{
    AngularInertia, Pose, Real, Vector, ang_is_finite, mul_inertia, zero_inertia,
};
use crate::dim::spatial::ANG_AXES;
use crate::model::check::refuse;
use crate::model::collider::MassSpread;
use parry::mass_properties::MassProperties;

/// Returns whether a body can have this mass. Zero is no mass. For any other value, the inverse and its
/// inverse must be finite.
pub(super) fn mass_is_usable(mass: Real) -> bool {
    let inv_mass = 1.0 / mass;
    mass == 0.0 || (mass > 0.0 && inv_mass.is_finite() && (1.0 / inv_mass).is_finite())
}

/// Mass that a body has beyond that of its colliders.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub enum RigidBodyAdditionalMassProps {
    /// Additional mass, distributed like the mass of the colliders. The centre of mass stays, and the angular
    /// inertia grows in proportion. If the colliders have no mass, it is distributed evenly over their
    /// volume, surface or length, in this order of preference. Without colliders it is a point mass at the
    /// body's origin, without angular inertia.
    Mass(Real),
    /// Mass, centre of mass and principal inertia of one more part, in the body's frame.
    MassProps(MassProperties),
}

/// The mass, centre of mass and inertia of a body.
///
/// The fields that each step reads and writes come first (`repr(C)`), next to the hot fields of
/// [`RigidBody`](super::RigidBody).
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[repr(C)]
pub struct RigidBodyMassProps {
    /// The centre of mass in world space.
    pub world_com: Vector,
    /// Inverse mass along each world axis; zero where locked, and unless the body is dynamic.
    pub(crate) inv_mass: Vector,
    /// World-space inverse inertia about the centre of mass; zero where locked, and unless dynamic.
    pub(crate) inv_inertia: AngularInertia,
    /// Colliders and additional mass together, in the body's frame.
    pub local_mprops: MassProperties,
    /// Locks of the body's degrees of freedom.
    pub(crate) locked_axes: LockedAxes,
    /// The colliders' part of [`Self::local_mprops`].
    pub(crate) from_colliders: MassProperties,
    /// Distribution of a mass over colliders without mass. `None` if [`Self::from_colliders`] has one. Boxed
    /// because few bodies have it.
    pub(crate) spread: Option<Box<MassSpread>>,
    /// Boxed because few bodies have an additional mass.
    pub(crate) additional: Option<Box<RigidBodyAdditionalMassProps>>,
    /// Inverse mass along each world axis: a field in Rapier.
    #[cfg(feature = "upstream-signatures")]
    pub effective_inv_mass: Vector,
    /// World-space inverse inertia about the centre of mass: a field in Rapier.
    #[cfg(feature = "upstream-signatures")]
    pub effective_world_inv_inertia: AngularInertia,
}

impl Default for RigidBodyMassProps {
    fn default() -> Self {
        Self {
            world_com: Vector::ZERO,
            inv_mass: Vector::ZERO,
            inv_inertia: zero_inertia(),
            local_mprops: no_mass(),
            locked_axes: LockedAxes::empty(),
            from_colliders: no_mass(),
            spread: None,
            additional: None,
            #[cfg(feature = "upstream-signatures")]
            effective_inv_mass: Vector::ZERO,
            #[cfg(feature = "upstream-signatures")]
            effective_world_inv_inertia: zero_inertia(),
        }
    }
}

impl RigidBodyMassProps {
    /// Returns whether all numbers are usable.
    pub(super) fn is_valid(&self) -> bool {
        let parts = [&self.local_mprops, &self.from_colliders];
        let spread = self.spread.as_deref().is_none_or(MassSpread::is_valid);
        let additional = match self.additional.as_deref() {
            None => true,
            Some(RigidBodyAdditionalMassProps::Mass(mass)) => mass_is_usable(*mass),
            Some(RigidBodyAdditionalMassProps::MassProps(part)) => mass_is_valid(part),
        };
        additional
            && spread
            && parts.into_iter().all(mass_is_valid)
            && is_point(self.world_com)
            && self.inv_mass.is_finite()
            && self.inv_mass.min_element() >= 0.0
            && ANG_AXES.iter().all(|axis| ang_is_finite(mul_inertia(&self.inv_inertia, *axis)))
    }

    /// Mass, centre of mass and principal inertia of the body with all its colliders, in its frame.
    pub fn local_mprops(&self) -> &MassProperties {
        &self.local_mprops
    }

    /// The additional mass of the body itself; `None` if it was not set.
    pub fn additional_local_mprops(&self) -> Option<&RigidBodyAdditionalMassProps> {
        self.additional.as_deref()
    }

    /// The world axes along and about which forces and impulses have no effect.
    pub fn flags(&self) -> LockedAxes {
        self.locked_axes
    }

    /// Returns whether the body may rotate about every axis. If so its inertia turns with it. With locked
    /// axes of the world it does not.
    pub(crate) fn rotates_freely(&self) -> bool {
        !self.locked_axes.intersects(LockedAxes::ROTATION_LOCKED)
    }

    /// The mass of the colliders plus the additional mass, also for a fixed body.
    pub fn mass(&self) -> Real {
        self.local_mprops.mass()
    }

    /// The centre of mass in world space.
    pub fn world_com(&self) -> Vector {
        self.world_com
    }

    /// The effective inverse mass along each world axis (1/mass). Zero along locked axes, and along all axes
    /// unless the body is dynamic.
    pub fn effective_inv_mass(&self) -> Vector {
        self.inv_mass
    }

    /// The effective inverse inertia about the centre of mass in world space (1/(mass·length²)). Zero about
    /// locked axes, and about all axes unless the body is dynamic.
    pub fn effective_world_inv_inertia(&self) -> &AngularInertia {
        &self.inv_inertia
    }

    /// The effective mass along each world axis. Zero represents an infinite mass: along locked axes, and
    /// along all axes unless the body is dynamic.
    pub fn effective_mass(&self) -> Vector {
        self.inv_mass.map(|inv_mass| if inv_mass > 0.0 { 1.0 / inv_mass } else { 0.0 })
    }

    /// Sums up the colliders and the additional mass. [`Self::update_world`] must follow.
    pub(crate) fn update_local(&mut self) {
        let from_colliders = self.mass_of_colliders();
        let total = match self.additional.as_deref() {
            None => from_colliders,
            Some(RigidBodyAdditionalMassProps::Mass(mass)) => match self.spread.as_deref() {
                Some(spread) => spread.scaled_to(from_colliders.mass() + mass),
                None => {
                    let mut total = from_colliders;
                    total.set_mass(total.mass() + mass, true);
                    total
                }
            },
            Some(RigidBodyAdditionalMassProps::MassProps(part)) => match from_colliders {
                none if none == no_mass() => *part,
                colliders => total_mass(&[colliders, *part]),
            },
        };
        if mass_is_valid(&total) {
            self.local_mprops = total;
        } else {
            refuse("the mass properties of a rigid body", total);
        }
    }

    /// The mass of the colliders' volumes, or if these have none, of their surfaces or lengths.
    fn mass_of_colliders(&self) -> MassProperties {
        let from_density = self.spread.as_deref().and_then(MassSpread::density_mass);
        from_density.unwrap_or(self.from_colliders)
    }

    /// Transforms the body's own mass properties to world space.
    pub(crate) fn update_world(&mut self, pose: &Pose, body_type: RigidBodyType) {
        self.world_com = pose * self.local_mprops.local_com;
        if body_type.is_dynamic() {
            let inv_inertia = self.local_mprops.world_inv_inertia(&pose.rotation);
            self.inv_mass = inv_mass_per_axis(self.locked_axes, self.local_mprops.inv_mass);
            self.inv_inertia = lock_rotations(self.locked_axes, inv_inertia);
        } else {
            self.inv_mass = Vector::ZERO;
            self.inv_inertia = zero_inertia();
        }
        #[cfg(feature = "upstream-signatures")]
        {
            (self.effective_inv_mass, self.effective_world_inv_inertia) =
                (self.inv_mass, self.inv_inertia);
        }
    }
}
