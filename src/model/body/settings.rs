//! Settings of a body's simulation: damping, gravity, dominance, locked axes, CCD and solver substeps.

use super::{RigidBody, RigidBodyChanges};
use crate::dim::axes::LockedAxes;
use crate::dim::math::Real;
use crate::model::check::{is_non_negative, refuse};
use crate::model::params::ITERATIONS_MAX;

impl RigidBody {
    /// Fraction of the linear velocity lost per second, to first order (1/s).
    pub fn linear_damping(&self) -> Real {
        self.linear_damping
    }

    /// Sets the fraction of the linear velocity lost per second, to first order (1/s, at least 0).
    pub fn set_linear_damping(&mut self, damping: Real) {
        if !is_non_negative(damping) {
            return refuse("the linear damping of a rigid body", damping);
        }
        self.linear_damping = damping;
    }

    /// Fraction of the angular velocity lost per second, to first order (1/s).
    pub fn angular_damping(&self) -> Real {
        self.angular_damping
    }

    /// Sets the fraction of the angular velocity lost per second, to first order (1/s, at least 0).
    pub fn set_angular_damping(&mut self, damping: Real) {
        if !is_non_negative(damping) {
            return refuse("the angular damping of a rigid body", damping);
        }
        self.angular_damping = damping;
    }

    /// The factor on gravity for the body.
    pub fn gravity_scale(&self) -> Real {
        self.gravity_scale
    }

    /// Sets the factor on gravity for the body (1: full gravity, 0: none, -1: upwards).
    pub fn set_gravity_scale(&mut self, scale: Real, wake_up: bool) {
        if !scale.is_finite() {
            return refuse("the gravity scale of a rigid body", scale);
        }
        if scale != self.gravity_scale {
            self.gravity_scale = scale;
            self.wake_if(wake_up);
        }
    }

    /// The dominance group.
    pub fn dominance_group(&self) -> i8 {
        self.dominance
    }

    /// Sets the dominance group. In a contact of two dynamic bodies, the body of the higher group acts as if
    /// its mass were infinite. A change wakes the body.
    pub fn set_dominance_group(&mut self, dominance: i8) {
        if dominance != self.dominance {
            self.dominance = dominance;
            self.changes.insert(RigidBodyChanges::DOMINANCE);
            self.wake_if(true);
        }
    }

    /// The dominance in contacts: the dominance group of a dynamic body, and more than any group for all
    /// others.
    pub fn effective_dominance_group(&self) -> i16 {
        if self.is_dynamic() { i16::from(self.dominance) } else { i16::from(i8::MAX) + 1 }
    }

    /// [`Self::effective_dominance_group`] of a collider's body. A collider without a body has the dominance
    /// of a fixed body.
    pub(crate) fn dominance_of(body: Option<&Self>) -> i16 {
        body.map_or(i16::from(i8::MAX) + 1, Self::effective_dominance_group)
    }

    /// The world axes along and about which a dynamic body does not move.
    pub fn locked_axes(&self) -> LockedAxes {
        self.mprops.locked_axes
    }

    /// Sets the world axes along and about which a dynamic body does not move. It loses its velocity along
    /// and about them. Kinematic bodies ignore locks.
    pub fn set_locked_axes(&mut self, locked_axes: LockedAxes, wake_up: bool) {
        if locked_axes != self.mprops.locked_axes {
            self.mprops.locked_axes = locked_axes;
            self.changes.insert(RigidBodyChanges::LOCAL_MASS_PROPERTIES);
            self.update_world_mass_properties();
            self.set_velocity(self.vels);
            self.wake_if(wake_up);
        }
    }

    /// Returns whether the translation is locked along every axis.
    pub fn is_translation_locked(&self) -> bool {
        self.mprops.locked_axes.contains(LockedAxes::TRANSLATION_LOCKED)
    }

    /// Sets whether the translation is locked along every axis.
    pub fn lock_translations(&mut self, locked: bool, wake_up: bool) {
        self.set_axes_locked(LockedAxes::TRANSLATION_LOCKED, locked, wake_up);
    }

    /// Sets whether the rotation is locked about every axis.
    pub fn lock_rotations(&mut self, locked: bool, wake_up: bool) {
        self.set_axes_locked(LockedAxes::ROTATION_LOCKED, locked, wake_up);
    }

    fn set_axes_locked(&mut self, axes: LockedAxes, locked: bool, wake_up: bool) {
        let mut locked_axes = self.mprops.locked_axes;
        locked_axes.set(axes, locked);
        self.set_locked_axes(locked_axes, wake_up);
    }

    /// Returns whether continuous collision detection against dynamic bodies is on.
    pub fn is_ccd_enabled(&self) -> bool {
        self.ccd_enabled
    }

    /// Sets whether continuous collision detection also stops the body at dynamic bodies that it would
    /// otherwise pass through within a step. Fixed and kinematic colliders stop every dynamic body,
    /// independent of this setting.
    pub fn enable_ccd(&mut self, enabled: bool) {
        self.ccd_enabled = enabled;
    }

    /// Returns whether the last step searched the body's path. A path is searched if the body moves by more
    /// than half its thickness. Any motion is searched while the body penetrates a wall by a quarter of its
    /// thickness. [`Self::is_ccd_enabled`] only selects the colliders of the search.
    pub fn is_ccd_active(&self) -> bool {
        self.ccd_active && self.is_dynamic()
    }

    /// The prediction distance of the body's contacts (length units).
    pub fn soft_ccd_prediction(&self) -> Real {
        self.soft_ccd_prediction
    }

    /// Sets the prediction distance of the body's contacts (length units, at least 0; 0 switches soft
    /// continuous collision detection off). It is cheaper and softer than [`Self::enable_ccd`] for fast
    /// bodies that must not pass through each other.
    pub fn set_soft_ccd_prediction(&mut self, prediction_distance: Real) {
        if !is_non_negative(prediction_distance) {
            return refuse("the soft CCD prediction of a rigid body", prediction_distance);
        }
        self.soft_ccd_prediction = prediction_distance;
    }

    /// Number of substeps beyond those of the integration parameters.
    pub fn additional_solver_iterations(&self) -> usize {
        self.additional_solver_iterations
    }

    /// Sets the number of additional substeps for this body while it is awake, and for its whole island; at
    /// most 1000. The solver adds substeps itself where light bodies carry heavy ones.
    pub fn set_additional_solver_iterations(&mut self, additional_iterations: usize) {
        if additional_iterations > ITERATIONS_MAX {
            let what = "the number of additional solver iterations of a rigid body";
            return refuse(what, additional_iterations);
        }
        self.additional_solver_iterations = additional_iterations;
    }
}
