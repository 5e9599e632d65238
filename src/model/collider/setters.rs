//! Setters of a collider.
//!
//! Each setter stores its value by [`Collider::store`], which sets the bit of the change in
//! [`ColliderChanges`] for the next step. A value that is there already is no change. A setter refuses an
//! unusable value: it keeps the old value and logs a warning with the refused value.

use super::accept::accept_shape;
use super::check::{check_margin, check_pose, is_same_shape};
use super::form::ShapeForm;
use super::{
    ActiveCollisionTypes, ActiveEvents, ActiveHooks, CoefficientCombineRule, Collider,
    ColliderChanges, ColliderEnabled, ColliderMassProps, InteractionGroups, InvalidCollider,
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

impl Collider {
    /// Stores a value in a field. Marks the change for the next step if the value differs from the old value.
    fn store<T: PartialEq>(
        &mut self,
        field: impl FnOnce(&mut Self) -> &mut T,
        value: T,
        change: ColliderChanges,
    ) {
        let stored = field(self);
        if *stored != value {
            *stored = value;
            self.changes |= change;
        }
    }
}

/// Pose of the collider.
impl Collider {
    /// Sets the pose (collider frame → world) of a collider without a body. An attached collider follows its
    /// body: use [`Self::set_position_wrt_parent`].
    pub fn set_position(&mut self, position: Pose) {
        if accepts("set_position", check_pose(&position)) && position != self.pose {
            self.store(|it| &mut it.pose, normalized(position), ColliderChanges::POSITION);
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

    /// Sets the pose relative to its body (collider frame → body frame). The collider keeps its contacts. No
    /// effect on a collider without a body.
    pub fn set_position_wrt_parent(&mut self, position: Pose) {
        if !accepts("set_position_wrt_parent", check_pose(&position)) {
            return;
        }
        let Some(parent) = &mut self.parent else { return };
        let (old, new) = (parent.pos_wrt_parent, normalized(position));
        if [position, new].contains(&old) {
            return;
        }
        parent.pos_wrt_parent = new;
        self.pose = self.pose * old.inverse() * new;
        self.changes |= ColliderChanges::POSITION | ColliderChanges::LOCAL_MASS_PROPERTIES;
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
        let change = ColliderChanges::ENABLED_OR_DISABLED | ColliderChanges::LOCAL_MASS_PROPERTIES;
        self.store(|it| &mut it.flags.enabled, new_state, change);
    }

    /// Sets whether it is a sensor, which reports intersections and exerts no forces.
    pub fn set_sensor(&mut self, is_sensor: bool) {
        self.store(|it| &mut it.sensor, is_sensor, ColliderChanges::TYPE);
    }

    /// Sets the groups for contacts.
    pub fn set_collision_groups(&mut self, groups: InteractionGroups) {
        self.store(|it| &mut it.flags.collision_groups, groups, ColliderChanges::GROUPS);
    }

    /// Sets the groups for contact forces.
    pub fn set_solver_groups(&mut self, groups: InteractionGroups) {
        self.store(|it| &mut it.flags.solver_groups, groups, ColliderChanges::GROUPS);
    }

    /// Sets the pairs of body types with which it collides.
    pub fn set_active_collision_types(&mut self, types: ActiveCollisionTypes) {
        let change = ColliderChanges::INTERACTIONS;
        self.store(|it| &mut it.flags.active_collision_types, types, change);
    }

    /// Sets the hooks that are called for its pairs.
    pub fn set_active_hooks(&mut self, hooks: ActiveHooks) {
        self.store(|it| &mut it.flags.active_hooks, hooks, ColliderChanges::HOOKS);
    }

    /// Sets the events that are sent for its pairs.
    pub fn set_active_events(&mut self, events: ActiveEvents) {
        self.store(|it| &mut it.flags.active_events, events, ColliderChanges::EVENTS);
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
            self.store(|it| &mut it.material.friction, friction, ColliderChanges::MATERIAL);
        }
    }

    /// Sets the rule that combines its friction with that of another collider.
    pub fn set_friction_combine_rule(&mut self, rule: CoefficientCombineRule) {
        self.store(|it| &mut it.material.friction_combine_rule, rule, ColliderChanges::MATERIAL);
    }

    /// Sets the ratio of the speeds of separation and approach, 0 or more.
    pub fn set_restitution(&mut self, restitution: Real) {
        if accepts("set_restitution", check_margin("restitution", restitution)) {
            self.store(|it| &mut it.material.restitution, restitution, ColliderChanges::MATERIAL);
        }
    }

    /// Sets the rule that combines its restitution with that of another collider.
    pub fn set_restitution_combine_rule(&mut self, rule: CoefficientCombineRule) {
        self.store(|it| &mut it.material.restitution_combine_rule, rule, ColliderChanges::MATERIAL);
    }

    /// Sets the thickness (length units) of the invisible layer around the shape, 0 or more.
    pub fn set_contact_skin(&mut self, skin: Real) {
        if accepts("set_contact_skin", check_margin("contact_skin", skin)) {
            self.store(|it| &mut it.contact_skin, skin, ColliderChanges::SHAPE);
        }
    }
}

/// Its shape and mass.
impl Collider {
    /// Replaces the shape. Its mass follows from the new shape and the density or mass that was set.
    ///
    /// The same shared shape, or a primitive with the same numbers, changes nothing. Meshes, hulls and other
    /// shapes with lists of points are new shapes unless they are shared.
    pub fn set_shape(&mut self, shape: SharedShape) {
        match accept_shape(&shape) {
            Ok(shape) => {
                self.store_shape(shape);
                self.changes.remove(ColliderChanges::UNCHECKED_SHAPE);
            }
            Err(reason) => refuse("set_shape", &reason),
        }
    }

    fn store_shape(&mut self, shape: SharedShape) {
        if !is_same_shape(&self.shape, &shape) {
            (self.shape, self.form, self.widths) = (shape, ShapeForm::UNKNOWN, None);
            self.changes |= ColliderChanges::SHAPE | ColliderChanges::LOCAL_MASS_PROPERTIES;
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
        let change = ColliderChanges::LOCAL_MASS_PROPERTIES;
        self.store(|it| &mut it.mass_props, mass_props, change);
    }

    /// Copies everything from `other`, including shape and user data, except the body and the pose relative
    /// to it. Only differences count as changes.
    pub fn copy_from(&mut self, other: &Collider) {
        self.store_shape(other.shape.clone());
        self.changes |= other.changes & ColliderChanges::UNCHECKED_SHAPE;
        self.store(|it| &mut it.contact_skin, other.contact_skin, ColliderChanges::SHAPE);
        self.store(|it| &mut it.material, other.material, ColliderChanges::MATERIAL);
        self.set_mass_props(other.mass_props.clone());
        if self.parent.is_none() {
            self.store(|it| &mut it.pose, other.pose, ColliderChanges::POSITION);
        }
        self.set_enabled(other.flags.enabled != ColliderEnabled::Disabled);
        self.set_sensor(other.sensor);
        self.set_collision_groups(other.flags.collision_groups);
        self.set_solver_groups(other.flags.solver_groups);
        self.set_active_collision_types(other.flags.active_collision_types);
        self.set_active_hooks(other.flags.active_hooks);
        self.set_active_events(other.flags.active_events);
        self.contact_force_event_threshold = other.contact_force_event_threshold;
        self.user_data = other.user_data;
    }
}
