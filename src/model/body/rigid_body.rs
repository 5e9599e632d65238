//! The record of one rigid body: its fields, getters and setters.
//!
//! `motion.rs` contains pose and velocity, `forces.rs` forces and impulses, `settings.rs` the settings of the
//! simulation, `colliders.rs` the colliders.

use super::mass::mass_is_usable;
use super::{
    AttachedColliders, EnergyError, QuarantineCause, RestPose, RigidBodyActivation,
    RigidBodyAdditionalMassProps, RigidBodyBuilder, RigidBodyChanges, RigidBodyMassProps,
    RigidBodyType, RigidBodyVelocity,
};
use crate::base::fault::{Fault, ensure};
use crate::base::in_place::clone_in_place;
use crate::base::loading::{Loaded, check_when_loaded};
use crate::dim::mass::{largest_inverse_moment, mass_is_valid, no_mass};
use crate::dim::math::{ANG_ZERO, AngVector, Pose, Real, Vector, ang_is_finite, cross};
use crate::model::check::{is_non_negative, is_saved_pose, refuse};
use crate::model::edit_mark::EditMark;
use crate::model::island::BodyLink;
use crate::model::params::ITERATIONS_MAX;
use parry::mass_properties::MassProperties;

/// A rigid body: a pose, a velocity and a mass, and the colliders that move with it.
///
/// [`RigidBodyBuilder`] makes it, and a [`RigidBodySet`](super::RigidBodySet) owns it.
///
/// Setters with a `wake_up` argument wake a sleeping body if it is `true`. Setters refuse values that are not
/// finite or outside their range: the old value stays, and `log` gets a warning with the refused value.
//
// The order of the fields is fixed (`repr(C)`). The fields that each step reads and writes are at the front,
// in five cache lines (3D, `f32`). They end with the first fields of `mprops`. Rarely used fields come last.
#[derive(Debug)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde-serialize", serde(remote = "Self"))]
#[repr(C)]
pub struct RigidBody {
    /// The body's frame in world space.
    pub(crate) pose: Pose,
    /// Its velocity in world space.
    pub(crate) vels: RigidBodyVelocity,
    /// The user's force on the centre of mass (mass·length/s²); stays until it is reset.
    pub(crate) force: Vector,
    /// The user's torque (mass·length²/s²); stays until it is reset.
    pub(crate) torque: AngVector,
    /// Fraction of the linear velocity lost per second, to first order (1/s).
    pub(crate) linear_damping: Real,
    /// Fraction of the angular velocity lost per second, to first order (1/s).
    pub(crate) angular_damping: Real,
    /// Factor on gravity for the body.
    pub(crate) gravity_scale: Real,
    /// Largest distance from the centre of mass to any point of the colliders: bounds the displacement of
    /// surface points by a rotation.
    pub(crate) extent: Real,
    /// Thickness of the thinnest collider; infinite without any.
    pub(crate) thickness: Real,
    pub(crate) soft_ccd_prediction: Real,
    /// Length (s) of the substeps that computed the impulses of its contacts and joints; 0 without impulses.
    pub(crate) substep: Real,
    /// The length of substeps for which its contacts store their impulses, over that ([`StepPace`]).
    pub(crate) reference_ratio: Real,
    /// The energy that impulses have added to its island.
    pub(crate) energy_error: EnergyError,
    pub(crate) activation: RigidBodyActivation,
    pub(crate) changes: RigidBodyChanges,
    /// Positions of the body in the step's lists.
    pub(crate) link: BodyLink,
    pub(crate) body_type: RigidBodyType,
    pub(crate) dominance: i8,
    pub(crate) enabled: bool,
    pub(crate) ccd_enabled: bool,
    pub(crate) ccd_active: bool,
    /// Whether the body penetrates a non-dynamic collider by more than a quarter of its thickness. CCD then
    /// searches its path at any length.
    pub(crate) deeply_penetrating: bool,
    pub(crate) gyroscopic_forces_enabled: bool,
    /// Whether [`Self::push`] is not zero.
    pub(super) pushed: bool,
    pub(crate) colliders: AttachedColliders,
    pub(crate) mprops: RigidBodyMassProps,
    // From here on: cold.
    /// The pose from which drift is measured, while the body rests.
    pub(crate) rest: RestPose,
    /// Target of a position-based kinematic body after the next step. It is undefined for others: see
    /// [`RigidBody::next_position`].
    pub(crate) next_pose: Pose,
    pub(crate) additional_solver_iterations: usize,
    /// Force and torque on the centre of mass in the next step alone.
    pub(crate) push: (Vector, AngVector),
    /// Mark of a pending edit.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(super) edit: EditMark,
    /// The cause for which a step disabled the body. Not saved: it may contain NaN.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(super) quarantine: Option<Box<QuarantineCause>>,
    /// Whether the log contains the warning that the body has solid colliders and no mass. A loaded world
    /// warns again.
    #[cfg_attr(feature = "serde-serialize", serde(skip))]
    pub(super) warned_without_mass: bool,
    /// User data. The engine never reads it.
    pub user_data: u128,
}

clone_in_place!(RigidBody {
    pose,
    vels,
    force,
    torque,
    linear_damping,
    angular_damping,
    gravity_scale,
    extent,
    thickness,
    soft_ccd_prediction,
    substep,
    reference_ratio,
    energy_error,
    activation,
    changes,
    link,
    body_type,
    dominance,
    enabled,
    ccd_enabled,
    ccd_active,
    deeply_penetrating,
    gyroscopic_forces_enabled,
    pushed,
    colliders,
    mprops,
    rest,
    next_pose,
    additional_solver_iterations,
    push,
    edit,
    quarantine,
    warned_without_mass,
    user_data
});

check_when_loaded!(RigidBody);

/// All numbers are usable. (Large ones may exceed the range of positions: see [`Self::quarantine`].)
impl Loaded for RigidBody {
    fn check_loaded(&self) -> Result<(), Fault> {
        for pose in [self.pose, self.next_pose] {
            ensure!(is_saved_pose(&pose), "a body is at {pose:?}, or goes there");
        }
        let velocity = self.vels;
        ensure!(velocity.is_finite(), "a body moves at {velocity:?}");
        let pushes = [(self.force, self.torque), self.push];
        let are_numbers =
            |&(force, torque): &(Vector, _)| force.is_finite() && ang_is_finite(torque);
        ensure!(pushes.iter().all(are_numbers), "a body is pushed by {pushes:?}");
        let numbers = [self.gravity_scale, self.linear_damping, self.angular_damping];
        let are_right = numbers[0].is_finite() && numbers[1..].iter().all(|&n| is_non_negative(n));
        ensure!(are_right, "gravity scale and damping of a body: {numbers:?}");
        let iterations = self.additional_solver_iterations;
        ensure!(iterations <= ITERATIONS_MAX, "a body has {iterations} additional iterations");
        let energy_error = self.energy_error.added;
        ensure!(energy_error.is_finite(), "an energy error of {energy_error} J");
        let lengths = [self.extent, self.soft_ccd_prediction, self.substep, self.reference_ratio];
        let are_lengths = lengths.iter().all(|length| length.is_finite() && *length >= 0.0);
        ensure!(
            are_lengths,
            "extent, soft-CCD prediction, substep and ratio to its reference: {lengths:?}"
        );
        ensure!(self.thickness >= 0.0, "a body has the thickness {}", self.thickness);
        ensure!(self.rest.is_sound(), "a body has drifted from {:?}", self.rest);
        ensure!(self.mprops.is_valid(), "a body has the mass {:?}", self.mprops);
        Ok(())
    }
}

impl Default for RigidBody {
    fn default() -> Self {
        Self::new()
    }
}

impl From<RigidBodyBuilder> for RigidBody {
    fn from(builder: RigidBodyBuilder) -> Self {
        builder.build()
    }
}

impl RigidBody {
    /// A dynamic body at the origin, at rest, without colliders.
    pub(super) fn new() -> Self {
        Self {
            pose: Pose::IDENTITY,
            vels: RigidBodyVelocity::zero(),
            force: Vector::ZERO,
            torque: ANG_ZERO,
            linear_damping: 0.0,
            angular_damping: 0.0,
            gravity_scale: 1.0,
            extent: 0.0,
            thickness: Real::INFINITY,
            activation: RigidBodyActivation::active(),
            changes: RigidBodyChanges::everything(),
            link: BodyLink::default(),
            body_type: RigidBodyType::Dynamic,
            dominance: 0,
            enabled: true,
            ccd_enabled: false,
            ccd_active: false,
            deeply_penetrating: false,
            gyroscopic_forces_enabled: true,
            pushed: false,
            mprops: RigidBodyMassProps::default(),
            rest: RestPose::ORIGIN,
            next_pose: Pose::IDENTITY,
            soft_ccd_prediction: 0.0,
            additional_solver_iterations: 0,
            substep: 0.0,
            reference_ratio: 1.0,
            energy_error: EnergyError::NONE,
            colliders: AttachedColliders::new(),
            push: (Vector::ZERO, ANG_ZERO),
            edit: EditMark::default(),
            quarantine: None,
            warned_without_mass: false,
            user_data: 0,
        }
    }

    /// Copies everything from `other` except its colliders and their mass.
    pub fn copy_from(&mut self, other: &RigidBody) {
        let colliders = core::mem::take(&mut self.colliders);
        let (from_colliders, extent) = (self.mprops.from_colliders, self.extent);
        let spread = self.mprops.spread.take();
        let thickness = self.thickness;
        let differences = self.differences(other);
        let (link, changes, edit) = (self.link, self.changes, self.edit);
        *self = Self { colliders, link, extent, thickness, edit, ..other.clone() };
        self.mprops.from_colliders = from_colliders;
        self.mprops.spread = spread;
        self.changes = changes | differences;
        self.sum_up_mass();
    }

    /// The changes that would give this body the state of another.
    fn differences(&self, other: &RigidBody) -> RigidBodyChanges {
        let (mass, others_mass) = (&self.mprops, &other.mprops);
        let has_other_mass = self.body_type != other.body_type
            || mass.additional != others_mass.additional
            || mass.locked_axes != others_mass.locked_axes;
        let is_elsewhere = self.pose != other.pose || self.next_position() != other.next_position();
        let mut changes = RigidBodyChanges::empty();
        if self.enabled != other.enabled {
            changes = RigidBodyChanges::of_switch(other.enabled);
        }
        let mut mark = |differs: bool, change| {
            changes.insert(if differs { change } else { RigidBodyChanges::empty() })
        };
        mark(self.body_type != other.body_type, RigidBodyChanges::TYPE);
        mark(self.dominance != other.dominance, RigidBodyChanges::DOMINANCE);
        mark(self.is_sleeping() != other.is_sleeping(), RigidBodyChanges::SLEEP);
        mark(has_other_mass, RigidBodyChanges::LOCAL_MASS_PROPERTIES);
        mark(is_elsewhere, RigidBodyChanges::POSITION);
        changes
    }

    /// Resets all references to the set that contained the body.
    pub(super) fn detach_from_set(&mut self) -> (AttachedColliders, BodyLink) {
        self.changes = RigidBodyChanges::everything();
        let colliders = core::mem::take(&mut self.colliders);
        if !colliders.is_empty() {
            self.mprops.from_colliders = no_mass();
            self.mprops.spread = None;
            (self.extent, self.thickness) = (0.0, Real::INFINITY);
            self.sum_up_mass();
        }
        (colliders, core::mem::take(&mut self.link))
    }

    /// Type of the body: the cause of its motion.
    pub fn body_type(&self) -> RigidBodyType {
        self.body_type
    }

    /// Sets the type of the body. A body that becomes fixed loses its velocity. Otherwise every point of the
    /// body keeps its velocity, except along axes that are locked for a body that becomes dynamic.
    pub fn set_body_type(&mut self, body_type: RigidBodyType, wake_up: bool) {
        if body_type == self.body_type {
            return;
        }
        self.body_type = body_type;
        self.next_pose = self.pose;
        if body_type.is_fixed() {
            self.halt();
        }
        // Colliders without mass are measured only where that mass matters.
        self.changes.insert(RigidBodyChanges::TYPE | RigidBodyChanges::LOCAL_MASS_PROPERTIES);
        self.end_assembly();
        self.update_mass();
        self.wake_if(wake_up);
    }

    /// Returns whether forces, gravity and contacts move the body.
    pub fn is_dynamic(&self) -> bool {
        self.body_type.is_dynamic()
    }

    /// Returns whether the user alone moves the body.
    pub fn is_kinematic(&self) -> bool {
        self.body_type.is_kinematic()
    }

    /// Returns whether the body never moves.
    pub fn is_fixed(&self) -> bool {
        self.body_type.is_fixed()
    }

    /// Returns whether the body can move.
    pub fn is_dynamic_or_kinematic(&self) -> bool {
        self.body_type.is_dynamic_or_kinematic()
    }

    /// Returns whether the body takes part in the simulation.
    pub fn is_enabled(&self) -> bool {
        self.enabled
    }

    /// Sets whether the body and its colliders take part in the simulation. The next step wakes a body that
    /// was disabled before. All other state stays, but the cause of the [quarantine](Self::quarantine) is
    /// cleared.
    pub fn set_enabled(&mut self, enabled: bool) {
        if enabled != self.enabled {
            self.enabled = enabled;
            self.quarantine = None;
            self.changes |= RigidBodyChanges::of_switch(enabled);
        }
    }

    /// The user data. The engine never reads it.
    pub fn user_data(&self) -> u128 {
        self.user_data
    }

    // ---- Sleep ----

    /// The sleep state of the body, and its thresholds of sleep.
    pub fn activation(&self) -> &RigidBodyActivation {
        &self.activation
    }

    /// Mutable access to the sleep state and the thresholds.
    pub fn activation_mut(&mut self) -> &mut RigidBodyActivation {
        self.changes.insert(RigidBodyChanges::SLEEP);
        &mut self.activation
    }

    /// Returns whether the body sleeps.
    pub fn is_sleeping(&self) -> bool {
        self.activation.sleeping
    }

    /// Puts the body to sleep: its velocity becomes zero until it wakes.
    ///
    /// The next step wakes it again if a touching body does not sleep.
    pub fn sleep(&mut self) {
        if self.is_fixed() {
            return;
        }
        self.activation.sleep();
        self.halt();
        self.changes.insert(RigidBodyChanges::SLEEP);
    }

    /// Wakes the body. A `strong` wake-up also restarts the time until it may sleep.
    ///
    /// The next step wakes the island of a body that slept. It also restarts the time of all bodies of the
    /// island, after a weak wake-up too. A weak wake-up of an awake body has no effect.
    pub fn wake_up(&mut self, strong: bool) {
        if self.activation.sleeping {
            self.changes.insert(RigidBodyChanges::SLEEP);
        }
        self.activation.wake_up(strong);
    }

    pub(super) fn wake_if(&mut self, wake_up: bool) {
        if wake_up && !self.is_fixed() {
            self.wake_up(true);
        }
    }

    // ---- Mass ----

    /// The mass of the colliders plus the additional mass. Zero for a fixed body.
    pub fn mass(&self) -> Real {
        if self.is_fixed() { 0.0 } else { self.mprops.mass() }
    }

    /// Mass, centre of mass and inertia.
    pub fn mass_properties(&self) -> &RigidBodyMassProps {
        &self.mprops
    }

    /// The centre of mass in world space.
    pub fn center_of_mass(&self) -> Vector {
        self.mprops.world_com
    }

    /// The centre of mass in the body's frame.
    pub fn local_center_of_mass(&self) -> Vector {
        self.mprops.local_mprops.local_com
    }

    /// Sets the mass beyond that of the colliders (at least 0). It replaces any additional mass or mass
    /// properties set before. See [`RigidBodyAdditionalMassProps::Mass`].
    pub fn set_additional_mass(&mut self, additional_mass: Real, wake_up: bool) {
        if !mass_is_usable(additional_mass) {
            return refuse("the additional mass of a rigid body", additional_mass);
        }
        let additional = RigidBodyAdditionalMassProps::Mass(additional_mass);
        self.set_additional((additional_mass > 0.0).then_some(additional), wake_up);
    }

    /// Sets mass, centre of mass and inertia beyond those of the colliders, in the body's frame. They replace
    /// any additional mass or mass properties set before.
    pub fn set_additional_mass_properties(&mut self, props: MassProperties, wake_up: bool) {
        if !mass_is_valid(&props) {
            return refuse("the additional mass properties of a rigid body", props);
        }
        self.set_additional(Some(RigidBodyAdditionalMassProps::MassProps(props)), wake_up);
    }

    fn set_additional(&mut self, additional: Option<RigidBodyAdditionalMassProps>, wake_up: bool) {
        if self.mprops.additional.as_deref() != additional.as_ref() {
            self.end_assembly();
            self.mprops.additional = additional.map(Box::new);
            self.changes.insert(RigidBodyChanges::LOCAL_MASS_PROPERTIES);
            self.update_mass();
            self.wake_if(wake_up);
        }
    }

    /// Sums up the masses again, after one of them changed. The centre of mass may move, but every point of
    /// the body keeps its velocity, so that its momentum and its joints do.
    ///
    /// A body in assembly is the exception. Its velocity is that of the final centre of mass, as described by
    /// the builder.
    pub(super) fn update_mass(&mut self) {
        let before = self.mprops.local_mprops;
        self.sum_up_mass();
        self.lower_impulses(&before);
        let shift = self.pose.rotation * (self.local_center_of_mass() - before.local_com);
        let RigidBodyVelocity { linvel, angvel } = self.vels;
        let moved = RigidBodyVelocity::new(linvel + cross(angvel, shift), angvel);
        let is_kept = shift == Vector::ZERO
            || self.changes.contains(RigidBodyChanges::ASSEMBLY)
            || !moved.is_usable();
        self.set_velocity(if is_kept { self.vels } else { moved });
    }

    /// Sums up the masses again. The velocity stays, so the new centre of mass has that of the old centre.
    pub(super) fn sum_up_mass(&mut self) {
        self.mprops.update_local();
        self.update_world_mass_properties();
    }

    /// Lowers the impulses with which the next step starts, in the same proportion as the mass or the
    /// inertia. With those of a heavier body, a resting one would jump. The solver scales impulses by the
    /// length of the substeps that computed them.
    fn lower_impulses(&mut self, before: &MassProperties) {
        let ratio = |now: Real, before: Real| if before > 0.0 { now / before } else { 1.0 };
        let now = &self.mprops.local_mprops;
        let linear = ratio(now.inv_mass, before.inv_mass);
        let angular = ratio(largest_inverse_moment(now), largest_inverse_moment(before));
        self.substep = (self.substep * linear.max(angular).max(1.0)).min(Real::MAX);
    }

    /// Ends the assembly of a body that has a mass, at its first edit other than an attachment.
    pub(crate) fn end_assembly(&mut self) {
        if self.mprops.mass() > 0.0 {
            self.changes.remove(RigidBodyChanges::ASSEMBLY);
        }
    }

    /// Transforms the mass properties to world space, after the pose, the type or the locks changed.
    pub(crate) fn update_world_mass_properties(&mut self) {
        self.mprops.update_world(&self.pose, self.body_type);
    }
}

impl RigidBody {
    /// Bytes at the front of a body that are all that a step reads of every awake body.
    pub(super) const FRONT: usize = core::mem::offset_of!(Self, mprops)
        + core::mem::offset_of!(RigidBodyMassProps, locked_axes);
}

// Five cache lines in single precision, twice that in double.
const _: () = assert!(RigidBody::FRONT <= 5 * 64 * size_of::<Real>() / size_of::<f32>());
