//! Setters of a collider.
//!
//! Each setter sets the bit of its change in [`ColliderChanges`] for the next step. A setter refuses an
//! unusable value: it keeps the old value and logs a warning with the refused one.

use super::accept::accept_shape;
use super::check::{check_margin, check_pose};
use super::form::ShapeForm;
use super::{
    ActiveCollisionTypes, ActiveEvents, ActiveHooks, CoefficientCombineRule, Collider,
    ColliderChanges, ColliderEnabled, ColliderFlags, ColliderMassProps, InteractionGroups,
    InvalidCollider,
};
use crate::dim::mass::mass_is_valid;
use crate::dim::math::{AngVector, Pose, Real, Rotation, Vector, rotation_from_angle};
use parry::mass_properties::MassProperties;
use parry::shape::{Shape, SharedShape};

/// Logs the refused value and the reason.
fn refuse(setter: &str, reason: &InvalidCollider) {
    log::warn!("Collider::{setter} ignored: {reason}");
}

/// Returns whether the setter accepts the value. Logs a warning otherwise.
fn accepts(setter: &str, verdict: Result<(), InvalidCollider>) -> bool {
    match verdict {
        Ok(()) => true,
        Err(reason) => {
            refuse(setter, &reason);
            false
        }
    }
}

/// Pose of the collider.
impl Collider {
    /// Sets the pose (collider frame → world) of a collider without a body. An attached collider follows its
    /// body: use [`Self::set_position_wrt_parent`].
    pub fn set_position(&mut self, position: Pose) {
        if accepts("set_position", check_pose(&position)) {
            self.pose = normalized(position);
            self.changes |= ColliderChanges::POSITION;
        }
    }

    /// Sets the translation of a collider without a body. Its rotation stays.
    pub fn set_translation(&mut self, translation: Vector) {
        let pose = Pose { translation, ..self.pose };
        self.set_position(pose);
    }

    /// Sets the rotation of a collider without a body. Its translation stays.
    pub fn set_rotation(&mut self, rotation: Rotation) {
        let pose = Pose { rotation, ..self.pose };
        self.set_position(pose);
    }

    /// Sets the pose relative to its body (collider frame → body frame). No effect on a collider without a
    /// body.
    pub fn set_position_wrt_parent(&mut self, position: Pose) {
        if !accepts("set_position_wrt_parent", check_pose(&position)) {
            return;
        }
        let Some(parent) = &mut self.parent else { return };
        let body_pose = self.pose * parent.pos_wrt_parent.inverse();
        parent.pos_wrt_parent = normalized(position);
        self.pose = body_pose * parent.pos_wrt_parent;
        self.changes |= ColliderChanges::POSITION
            | ColliderChanges::PARENT
            | ColliderChanges::LOCAL_MASS_PROPERTIES;
    }

    /// Sets the translation relative to its body. Its rotation stays. No effect on a collider without a body.
    pub fn set_translation_wrt_parent(&mut self, translation: Vector) {
        if let Some(&pose) = self.position_wrt_parent() {
            self.set_position_wrt_parent(Pose { translation, ..pose });
        }
    }

    /// Sets the rotation relative to its body: an angle (2D) or a rotation vector (3D) in radians. No effect
    /// on a collider without a body.
    pub fn set_rotation_wrt_parent(&mut self, angle: AngVector) {
        if let Some(&pose) = self.position_wrt_parent() {
            let rotation = rotation_from_angle(angle);
            self.set_position_wrt_parent(Pose { rotation, ..pose });
        }
    }
}

/// Its rotation may be off unit length by rounding, and must not be: errors would add up.
pub(super) fn normalized(pose: Pose) -> Pose {
    Pose { rotation: pose.rotation.normalize(), ..pose }
}

/// Interaction settings and events.
impl Collider {
    /// Enables or disables it. A collider of a disabled body stays disabled until its body is enabled.
    pub fn set_enabled(&mut self, enabled: bool) {
        let new_state = match (enabled, self.flags.enabled) {
            (false, _) => ColliderEnabled::Disabled,
            (true, ColliderEnabled::Disabled) => ColliderEnabled::Enabled,
            (true, current) => current,
        };
        if self.flags.enabled != new_state {
            self.flags.enabled = new_state;
            self.changes |=
                ColliderChanges::ENABLED_OR_DISABLED | ColliderChanges::LOCAL_MASS_PROPERTIES;
        }
    }

    /// Sets whether it is a sensor, which reports intersections and exerts no forces.
    pub fn set_sensor(&mut self, is_sensor: bool) {
        if self.sensor != is_sensor {
            self.sensor = is_sensor;
            self.changes |= ColliderChanges::TYPE;
        }
    }

    /// Sets the groups for contacts.
    pub fn set_collision_groups(&mut self, groups: InteractionGroups) {
        if self.flags.collision_groups != groups {
            self.flags.collision_groups = groups;
            self.changes |= ColliderChanges::GROUPS;
        }
    }

    /// Sets the groups for contact forces.
    pub fn set_solver_groups(&mut self, groups: InteractionGroups) {
        if self.flags.solver_groups != groups {
            self.flags.solver_groups = groups;
            self.changes |= ColliderChanges::GROUPS;
        }
    }

    /// Sets the pairs of body types with which it collides.
    pub fn set_active_collision_types(&mut self, types: ActiveCollisionTypes) {
        if self.flags.active_collision_types != types {
            self.flags.active_collision_types = types;
            self.changes |= ColliderChanges::INTERACTIONS;
        }
    }

    /// Sets the hooks that are called for its pairs.
    pub fn set_active_hooks(&mut self, hooks: ActiveHooks) {
        if self.flags.active_hooks != hooks {
            self.flags.active_hooks = hooks;
            self.changes |= ColliderChanges::INTERACTIONS;
        }
    }

    /// Sets the events that are sent for its pairs.
    pub fn set_active_events(&mut self, events: ActiveEvents) {
        if self.flags.active_events != events {
            self.flags.active_events = events;
            self.changes |= ColliderChanges::INTERACTIONS;
        }
    }

    /// Sets the least total contact force magnitude of a pair (force units) with an event. A force of zero
    /// has none.
    pub fn set_contact_force_event_threshold(&mut self, threshold: Real) {
        if threshold >= 0.0 {
            self.contact_force_event_threshold = threshold;
        } else {
            log::warn!(
                "Collider::set_contact_force_event_threshold ignored: {threshold} is not a number of at least 0"
            );
        }
    }
}

/// Its surface.
impl Collider {
    /// Sets the largest ratio of the tangential to the normal contact force, 0 or more.
    pub fn set_friction(&mut self, friction: Real) {
        if accepts("set_friction", check_margin("friction", friction)) {
            self.material.friction = friction;
            self.changes |= ColliderChanges::MATERIAL;
        }
    }

    /// Sets the rule that combines its friction with that of another collider.
    pub fn set_friction_combine_rule(&mut self, rule: CoefficientCombineRule) {
        self.material.friction_combine_rule = rule;
        self.changes |= ColliderChanges::MATERIAL;
    }

    /// Sets the ratio of the speeds of separation and approach, 0 or more.
    pub fn set_restitution(&mut self, restitution: Real) {
        if accepts("set_restitution", check_margin("restitution", restitution)) {
            self.material.restitution = restitution;
            self.changes |= ColliderChanges::MATERIAL;
        }
    }

    /// Sets the rule that combines its restitution with that of another collider.
    pub fn set_restitution_combine_rule(&mut self, rule: CoefficientCombineRule) {
        self.material.restitution_combine_rule = rule;
        self.changes |= ColliderChanges::MATERIAL;
    }

    /// Sets the thickness (length units) of the invisible layer around the shape, 0 or more.
    pub fn set_contact_skin(&mut self, skin: Real) {
        if accepts("set_contact_skin", check_margin("contact_skin", skin)) {
            self.contact_skin = skin;
            self.changes |= ColliderChanges::SHAPE;
        }
    }
}

/// Its shape and mass.
impl Collider {
    /// Replaces the shape. Its mass follows from the new shape and the density or mass that was set.
    pub fn set_shape(&mut self, shape: SharedShape) {
        match accept_shape(&shape) {
            Ok(shape) => {
                (self.shape, self.form, self.widths) = (shape, ShapeForm::UNKNOWN, None);
                self.changes.remove(ColliderChanges::UNCHECKED_SHAPE);
                self.changes |= ColliderChanges::SHAPE | ColliderChanges::LOCAL_MASS_PROPERTIES;
            }
            Err(reason) => refuse("set_shape", &reason),
        }
    }

    /// Mutable access to the shape. A shape shared with other colliders is copied first.
    ///
    /// The next step checks the result. An invalid shape, for example with a negative radius, disables the
    /// collider, and the log contains a warning.
    pub fn shape_mut(&mut self) -> &mut dyn Shape {
        self.changes |= ColliderChanges::SHAPE
            | ColliderChanges::UNCHECKED_SHAPE
            | ColliderChanges::LOCAL_MASS_PROPERTIES;
        (self.form, self.widths) = (ShapeForm::UNKNOWN, None);
        self.shape.make_mut()
    }

    /// Checks the shape after a use of [`Self::shape_mut`]. An invalid shape is replaced by a small one, and
    /// the collider is disabled.
    pub(crate) fn replace_broken_shape(&mut self) {
        if !self.changes.contains(ColliderChanges::UNCHECKED_SHAPE) {
            return;
        }
        self.changes.remove(ColliderChanges::UNCHECKED_SHAPE);
        match accept_shape(&self.shape) {
            Ok(shape) => self.shape = shape,
            Err(reason) => {
                log::warn!(
                    "the shape of a collider became invalid, and the collider is disabled: {reason}"
                );
                self.shape = super::builder::stand_in_shape();
                self.set_enabled(false);
            }
        }
    }

    /// Sets the mass per volume (per area in 2D), 0 or more.
    pub fn set_density(&mut self, density: Real) {
        if accepts("set_density", check_margin("density", density)) {
            self.set_mass_props(ColliderMassProps::Density(density));
        }
    }

    /// Sets the mass, spread evenly over the shape, 0 or more.
    pub fn set_mass(&mut self, mass: Real) {
        if accepts("set_mass", check_margin("mass", mass)) {
            self.set_mass_props(ColliderMassProps::Mass(mass));
        }
    }

    /// Sets mass, centre of mass and angular inertia, in the collider's frame.
    pub fn set_mass_properties(&mut self, properties: MassProperties) {
        if mass_is_valid(&properties) {
            self.set_mass_props(properties.into());
        } else {
            log::warn!(
                "Collider::set_mass_properties ignored: {properties:?} are not valid mass properties"
            );
        }
    }

    fn set_mass_props(&mut self, mass_props: ColliderMassProps) {
        if self.mass_props != mass_props {
            self.mass_props = mass_props;
            self.changes |= ColliderChanges::LOCAL_MASS_PROPERTIES;
        }
    }

    /// Copies everything from `other`, including shape and user data, except the body and the pose relative
    /// to it.
    pub fn copy_from(&mut self, other: &Collider) {
        let by_parent = self.flags.enabled == ColliderEnabled::DisabledByParent;
        let enabled = match other.flags.enabled {
            ColliderEnabled::Disabled => ColliderEnabled::Disabled,
            _ if by_parent => ColliderEnabled::DisabledByParent,
            _ => ColliderEnabled::Enabled,
        };
        *self = Collider {
            pose: if self.parent.is_some() { self.pose } else { other.pose },
            parent: self.parent,
            parent_type: self.parent_type,
            proxy: self.proxy,
            flags: ColliderFlags { enabled, ..other.flags },
            changes: self.changes
                | ColliderChanges::of_everything_but_the_body()
                | (other.changes & ColliderChanges::UNCHECKED_SHAPE),
            ..other.clone()
        };
    }
}
