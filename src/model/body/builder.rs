//! The builder of rigid bodies.

use super::mass::mass_is_usable;
use super::{
    RigidBody, RigidBodyActivation, RigidBodyAdditionalMassProps, RigidBodyType, RigidBodyVelocity,
};
use crate::dim::axes::LockedAxes;
use crate::dim::mass::mass_is_valid;
use crate::dim::math::{ANG_ZERO, AngVector, Pose, Real, Vector, rotation_from_angle};
use crate::model::check::{checked_pose, is_non_negative};
use crate::model::params::ITERATIONS_MAX;
use core::fmt::Debug;
use parry::mass_properties::MassProperties;

/// Error of [`RigidBodyBuilder::try_build`]: a value is not finite or outside its range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the {field} of a rigid body is {value}, which is invalid")]
pub struct InvalidRigidBody {
    /// The builder's field.
    pub field: &'static str,
    /// The refused value, as text.
    pub value: String,
}

/// Description of a rigid body: its type, pose, velocity, locked axes and further settings.
///
/// Every property has a default, and each method changes one property. [`Self::build`] makes the body.
/// `RigidBodySet::insert` also accepts the builder itself.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
#[must_use = "a builder does nothing until its body is built or inserted"]
pub struct RigidBodyBuilder {
    /// The pose of the body's frame in world space. Default: the identity.
    pub position: Pose,
    /// World-space velocity of the centre of mass (length/s). Default: zero.
    pub linvel: Vector,
    /// World-space angular velocity (rad/s). Default: zero.
    pub angvel: AngVector,
    /// Factor on gravity for the body. Default: 1.
    pub gravity_scale: Real,
    /// Fraction of the linear velocity lost per second, to first order (1/s). Default: 0.
    pub linear_damping: Real,
    /// Fraction of the angular velocity lost per second, to first order (1/s). Default: 0.
    pub angular_damping: Real,
    /// Type of the body: the cause of its motion.
    pub body_type: RigidBodyType,
    /// The world axes along and about which a dynamic body does not move. Default: none.
    pub locked_axes: LockedAxes,
    /// Mass beyond that of the colliders. Default: none.
    pub additional_mass_properties: Option<RigidBodyAdditionalMassProps>,
    /// Whether the body may fall asleep. Default: yes.
    pub can_sleep: bool,
    /// Whether the body starts asleep. Default: no.
    pub sleeping: bool,
    /// Whether continuous collision detection also stops the body at other dynamic bodies. Default: no.
    pub ccd_enabled: bool,
    /// Prediction distance of the body's contacts (length units). Default: 0, off.
    pub soft_ccd_prediction: Real,
    /// The dominance group: in a contact, a body of a higher group acts as if its mass were infinite.
    /// Default: 0.
    pub dominance_group: i8,
    /// Whether the body takes part in the simulation. Default: yes.
    pub enabled: bool,
    /// Substeps of the solver beyond those of the integration parameters. Default: 0.
    pub additional_solver_iterations: usize,
    /// Whether gyroscopic forces act on the body. Default: yes. No effect in 2D.
    pub gyroscopic_forces_enabled: bool,
    /// User data. Default: 0.
    pub user_data: u128,
}

impl Default for RigidBodyBuilder {
    fn default() -> Self {
        Self::dynamic()
    }
}

impl RigidBodyBuilder {
    /// A body of this type at the origin, at rest.
    pub fn new(body_type: RigidBodyType) -> Self {
        Self {
            position: Pose::IDENTITY,
            linvel: Vector::ZERO,
            angvel: ANG_ZERO,
            gravity_scale: 1.0,
            linear_damping: 0.0,
            angular_damping: 0.0,
            body_type,
            locked_axes: LockedAxes::empty(),
            additional_mass_properties: None,
            can_sleep: true,
            sleeping: false,
            ccd_enabled: false,
            soft_ccd_prediction: 0.0,
            dominance_group: 0,
            enabled: true,
            additional_solver_iterations: 0,
            gyroscopic_forces_enabled: true,
            user_data: 0,
        }
    }

    /// A body moved by forces, gravity, contacts and joints.
    pub fn dynamic() -> Self {
        Self::new(RigidBodyType::Dynamic)
    }

    /// A body that never moves.
    pub fn fixed() -> Self {
        Self::new(RigidBodyType::Fixed)
    }

    /// A body whose velocity the user sets.
    pub fn kinematic_velocity_based() -> Self {
        Self::new(RigidBodyType::KinematicVelocityBased)
    }

    /// A body whose next pose the user sets.
    pub fn kinematic_position_based() -> Self {
        Self::new(RigidBodyType::KinematicPositionBased)
    }

    /// [`Self::fixed`].
    #[deprecated(note = "use `RigidBodyBuilder::fixed()`")]
    pub fn new_static() -> Self {
        Self::fixed()
    }

    /// [`Self::kinematic_velocity_based`].
    #[deprecated(note = "use `RigidBodyBuilder::kinematic_velocity_based()`")]
    pub fn new_kinematic_velocity_based() -> Self {
        Self::kinematic_velocity_based()
    }

    /// [`Self::kinematic_position_based`].
    #[deprecated(note = "use `RigidBodyBuilder::kinematic_position_based()`")]
    pub fn new_kinematic_position_based() -> Self {
        Self::kinematic_position_based()
    }

    /// Sets the pose of the body's frame in world space.
    pub fn pose(mut self, pose: Pose) -> Self {
        self.position = pose;
        self
    }

    /// [`Self::pose`].
    #[deprecated(note = "use `RigidBodyBuilder::pose()`")]
    pub fn position(self, pose: Pose) -> Self {
        self.pose(pose)
    }

    /// Sets the origin of the body's frame in world space.
    pub fn translation(mut self, translation: Vector) -> Self {
        self.position.translation = translation;
        self
    }

    /// Sets the orientation of the body's frame, in radians: the angle (in 2D), or a rotation vector (in 3D).
    pub fn rotation(mut self, angle: AngVector) -> Self {
        self.position.rotation = rotation_from_angle(angle);
        self
    }

    /// Sets the world-space velocity of the centre of mass (length/s). The centre is that of all colliders
    /// that are attached before the first step.
    pub fn linvel(mut self, linvel: Vector) -> Self {
        self.linvel = linvel;
        self
    }

    /// Sets the world-space angular velocity (rad/s).
    pub fn angvel(mut self, angvel: AngVector) -> Self {
        self.angvel = angvel;
        self
    }

    /// Sets the factor on gravity for the body (1: full gravity, 0: none).
    pub fn gravity_scale(mut self, scale: Real) -> Self {
        self.gravity_scale = scale;
        self
    }

    /// Sets the fraction of the linear velocity lost per second, to first order (1/s, at least 0).
    pub fn linear_damping(mut self, factor: Real) -> Self {
        self.linear_damping = factor;
        self
    }

    /// Sets the fraction of the angular velocity lost per second, to first order (1/s, at least 0).
    pub fn angular_damping(mut self, factor: Real) -> Self {
        self.angular_damping = factor;
        self
    }

    /// Sets the dominance group: in a contact, a body of a higher group acts as if its mass were infinite.
    pub fn dominance_group(mut self, group: i8) -> Self {
        self.dominance_group = group;
        self
    }

    /// Adds mass beyond that of the colliders (at least 0), in place of any other additional mass.
    /// See [`RigidBodyAdditionalMassProps::Mass`].
    pub fn additional_mass(mut self, mass: Real) -> Self {
        self.additional_mass_properties = Some(RigidBodyAdditionalMassProps::Mass(mass));
        self
    }

    /// Adds mass, centre of mass and inertia beyond those of the colliders, in the body's frame, in
    /// place of any other additional mass.
    pub fn additional_mass_properties(mut self, props: MassProperties) -> Self {
        self.additional_mass_properties = Some(RigidBodyAdditionalMassProps::MassProps(props));
        self
    }

    /// Sets the world axes along and about which a dynamic body does not move. Its velocity along and about
    /// them is zero.
    pub fn locked_axes(mut self, locked_axes: LockedAxes) -> Self {
        self.locked_axes = locked_axes;
        self
    }

    /// Locks the translation along every axis.
    pub fn lock_translations(self) -> Self {
        self.set_locked(LockedAxes::TRANSLATION_LOCKED, true)
    }

    /// Locks the rotation about every axis.
    pub fn lock_rotations(self) -> Self {
        self.set_locked(LockedAxes::ROTATION_LOCKED, true)
    }

    pub(crate) fn set_locked(mut self, axes: LockedAxes, locked: bool) -> Self {
        self.locked_axes.set(axes, locked);
        self
    }

    /// Sets whether the body may fall asleep.
    pub fn can_sleep(mut self, can_sleep: bool) -> Self {
        self.can_sleep = can_sleep;
        self
    }

    /// Sets whether the body starts asleep.
    pub fn sleeping(mut self, sleeping: bool) -> Self {
        self.sleeping = sleeping;
        self
    }

    /// Sets whether continuous collision detection also stops the body at other dynamic bodies: see
    /// [`RigidBody::enable_ccd`].
    pub fn ccd_enabled(mut self, enabled: bool) -> Self {
        self.ccd_enabled = enabled;
        self
    }

    /// Sets the prediction distance of the body's contacts (length units; 0 is off): see
    /// [`RigidBody::set_soft_ccd_prediction`].
    pub fn soft_ccd_prediction(mut self, distance: Real) -> Self {
        self.soft_ccd_prediction = distance;
        self
    }

    /// Sets whether the body takes part in the simulation.
    pub fn enabled(mut self, enabled: bool) -> Self {
        self.enabled = enabled;
        self
    }

    /// Sets the number of additional substeps of the solver for the island of this body (at most 1000). The
    /// island consists of all dynamic bodies that contacts or joints connect to it, directly or through other
    /// dynamic bodies.
    pub fn additional_solver_iterations(mut self, iterations: usize) -> Self {
        self.additional_solver_iterations = iterations;
        self
    }

    /// Sets the user data. The engine never reads it.
    pub fn user_data(mut self, data: u128) -> Self {
        self.user_data = data;
        self
    }

    /// Makes the body.
    ///
    /// A value that is not finite or not possible is replaced by its default, and `log` gets a warning
    /// that names it. [`Self::try_build`] returns the error instead.
    pub fn build(&self) -> RigidBody {
        let mut mended = self.clone();
        for error in mended.mend() {
            log::warn!("{error}; the default is used");
        }
        mended.build_valid()
    }

    /// Makes the body.
    ///
    /// # Errors
    /// If a value is not finite or not possible; the error names the first such value.
    pub fn try_build(&self) -> Result<RigidBody, InvalidRigidBody> {
        let mut mended = self.clone();
        match mended.mend().into_iter().next() {
            Some(error) => Err(error),
            None => Ok(mended.build_valid()),
        }
    }

    /// Replaces every impossible value by its default, and returns an error for each.
    fn mend(&mut self) -> Vec<InvalidRigidBody> {
        let default = Self::new(self.body_type);
        let mut errors = Vec::new();
        let pose = checked_pose(self.position);
        keep_if(pose.is_some(), "position", &mut self.position, default.position, &mut errors);
        self.position = pose.unwrap_or(default.position);

        let mut keep = |valid, field, value: &mut Real, default| {
            keep_if(valid, field, value, default, &mut errors);
        };
        let (scale, soft_ccd) = (self.gravity_scale, self.soft_ccd_prediction);
        let (linear, angular) = (self.linear_damping, self.angular_damping);
        keep(scale.is_finite(), "gravity_scale", &mut self.gravity_scale, 1.0);
        keep(is_non_negative(linear), "linear_damping", &mut self.linear_damping, 0.0);
        keep(is_non_negative(angular), "angular_damping", &mut self.angular_damping, 0.0);
        keep(is_non_negative(soft_ccd), "soft_ccd_prediction", &mut self.soft_ccd_prediction, 0.0);

        let (linvel, angvel) = (self.linvel, self.angvel);
        let usable = |linvel, angvel| RigidBodyVelocity::new(linvel, angvel).is_usable();
        keep_if(usable(linvel, ANG_ZERO), "linvel", &mut self.linvel, default.linvel, &mut errors);
        keep_if(
            usable(Vector::ZERO, angvel),
            "angvel",
            &mut self.angvel,
            default.angvel,
            &mut errors,
        );
        let (field, valid) = match &self.additional_mass_properties {
            None => ("", true),
            Some(RigidBodyAdditionalMassProps::Mass(mass)) => {
                ("additional_mass", mass_is_usable(*mass))
            }
            Some(RigidBodyAdditionalMassProps::MassProps(props)) => {
                ("additional_mass_properties", mass_is_valid(props))
            }
        };
        keep_if(valid, field, &mut self.additional_mass_properties, None, &mut errors);
        let iterations = self.additional_solver_iterations;
        keep_if(
            iterations <= ITERATIONS_MAX,
            "additional_solver_iterations",
            &mut self.additional_solver_iterations,
            0,
            &mut errors,
        );
        errors
    }

    /// Makes the body out of values that are all possible.
    fn build_valid(self) -> RigidBody {
        let mut body = RigidBody::new();
        body.body_type = self.body_type;
        (body.pose, body.next_pose) = (self.position, self.position);
        body.mprops.locked_axes = self.locked_axes;
        if !self.body_type.is_fixed() {
            body.set_velocity(RigidBodyVelocity::new(self.linvel, self.angvel));
        }
        body.gravity_scale = self.gravity_scale;
        (body.linear_damping, body.angular_damping) = (self.linear_damping, self.angular_damping);
        body.mprops.additional = self.additional_mass_properties.map(Box::new);
        body.ccd_enabled = self.ccd_enabled;
        body.soft_ccd_prediction = self.soft_ccd_prediction;
        body.dominance = self.dominance_group;
        body.enabled = self.enabled;
        body.additional_solver_iterations = self.additional_solver_iterations;
        body.gyroscopic_forces_enabled = self.gyroscopic_forces_enabled;
        body.user_data = self.user_data;
        if !self.can_sleep {
            body.activation = RigidBodyActivation::cannot_sleep();
        }
        if self.sleeping {
            body.sleep();
        }
        body.update_mass();
        body
    }
}

/// Records an error for an impossible value, and replaces the value by its default.
fn keep_if<T: Debug>(
    valid: bool,
    field: &'static str,
    value: &mut T,
    default: T,
    errors: &mut Vec<InvalidRigidBody>,
) {
    if !valid {
        errors.push(InvalidRigidBody { field, value: format!("{value:?}") });
        *value = default;
    }
}
