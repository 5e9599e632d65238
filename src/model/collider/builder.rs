//! The builder of colliders: a description that is validated when the collider is built.

use super::accept::accept_shape;
use super::check::{check_margin, check_pose};
use super::form::ShapeForm;
use super::setters::normalized;
use super::{
    ActiveCollisionTypes, ActiveEvents, ActiveHooks, CoefficientCombineRule, Collider,
    ColliderChanges, ColliderEnabled, ColliderFlags, ColliderMassProps, ColliderMaterial,
    InteractionGroups, InvalidCollider,
};
use crate::dim::mass::mass_is_valid;
use crate::dim::math::{AngVector, Pose, Real, Vector, rotation_from_angle};
use crate::model::edit_mark::EditMark;
use crate::model::tree::ColliderProxy;
use parry::mass_properties::MassProperties;
use parry::shape::SharedShape;

/// Description of a collider. A program starts with a shape's constructor and chains the properties that
/// differ from the defaults. It then calls [`build`](Self::build), or inserts the builder itself into the
/// collider set.
///
/// Constructors accept any numbers. [`Self::try_build`] returns an error for invalid ones (a negative radius,
/// a NaN, an empty mesh). [`Self::build`] logs the error and makes a disabled collider, so one invalid value
/// from a level file does not stop the program.
#[derive(Clone, Debug)]
#[must_use = "a builder does nothing until it is built"]
pub struct ColliderBuilder {
    /// The shape.
    pub shape: SharedShape,
    /// The source of its mass. Density 1 by default.
    pub mass_properties: ColliderMassProps,
    /// Largest ratio of the tangential to the normal contact force. 0.5 by default.
    pub friction: Real,
    /// The rule that combines its friction with that of another collider.
    pub friction_combine_rule: CoefficientCombineRule,
    /// Ratio of the speeds of separation and approach. 0 by default.
    pub restitution: Real,
    /// The rule that combines its restitution with that of another collider.
    pub restitution_combine_rule: CoefficientCombineRule,
    /// Collider frame → body frame if it will be attached to a body, → world otherwise.
    pub position: Pose,
    /// Whether it is a sensor, which reports intersections and exerts no forces.
    pub is_sensor: bool,
    /// The types of bodies between which it collides.
    pub active_collision_types: ActiveCollisionTypes,
    /// The hooks that are called for its pairs.
    pub active_hooks: ActiveHooks,
    /// The events that are sent for its pairs.
    pub active_events: ActiveEvents,
    /// A number for the user. The engine does not read it.
    pub user_data: u128,
    /// The groups with which it has contacts.
    pub collision_groups: InteractionGroups,
    /// The groups with which its contacts exert forces.
    pub solver_groups: InteractionGroups,
    /// Whether the collider takes part in the simulation. True by default.
    pub enabled: bool,
    /// Thickness (length units) of an invisible layer around the shape. 0 by default.
    pub contact_skin: Real,
    /// Least total contact force magnitude of a pair (force units) with an event. A force of zero has none. 0
    /// by default.
    pub contact_force_event_threshold: Real,
    /// The error of the shape's constructor, if it failed; `shape` is then a placeholder.
    impossible: Option<InvalidCollider>,
}

/// A small ball in place of an invalid shape.
pub(super) fn stand_in_shape() -> SharedShape {
    SharedShape::ball(0.5)
}

impl Default for ColliderBuilder {
    /// A ball of radius 0.5.
    fn default() -> Self {
        Self::ball(0.5)
    }
}

/// Beginning and end.
impl ColliderBuilder {
    /// A collider of the given shape.
    pub fn new(shape: SharedShape) -> Self {
        let material = ColliderMaterial::default();
        let flags = ColliderFlags::default();
        Self {
            shape,
            mass_properties: ColliderMassProps::default(),
            friction: material.friction,
            friction_combine_rule: material.friction_combine_rule,
            restitution: material.restitution,
            restitution_combine_rule: material.restitution_combine_rule,
            position: Pose::IDENTITY,
            is_sensor: false,
            active_collision_types: flags.active_collision_types,
            active_hooks: flags.active_hooks,
            active_events: flags.active_events,
            user_data: 0,
            collision_groups: flags.collision_groups,
            solver_groups: flags.solver_groups,
            enabled: true,
            contact_skin: 0.0,
            contact_force_event_threshold: 0.0,
            impossible: None,
        }
    }

    /// A collider of the given shape, or one whose `try_build` returns this error.
    pub(crate) fn of(shape: Result<SharedShape, InvalidCollider>) -> Self {
        match shape {
            Ok(shape) => Self::new(shape),
            Err(reason) => Self { impossible: Some(reason), ..Self::new(stand_in_shape()) },
        }
    }

    /// Makes the collider.
    ///
    /// For an invalid value (see [`Self::try_build`]) the log contains a warning. The result is then a
    /// disabled ball without mass, with the same user data, and with the same pose if that is valid.
    pub fn build(&self) -> Collider {
        self.try_build().unwrap_or_else(|reason| {
            log::warn!("an invalid collider is built as a disabled ball: {reason}");
            let mut collider = self.to_collider();
            collider.shape = stand_in_shape();
            collider.mass_props = ColliderMassProps::Density(0.0);
            collider.material = ColliderMaterial::default();
            collider.flags.enabled = ColliderEnabled::Disabled;
            collider.contact_skin = 0.0;
            collider.contact_force_event_threshold = 0.0;
            if check_pose(&self.position).is_err() {
                collider.pose = Pose::IDENTITY;
            }
            collider
        })
    }

    /// Makes the collider, or returns the reason why it is invalid.
    ///
    /// # Errors
    /// If the shape has sizes that are negative or not finite, coordinates that are not finite, indices out
    /// of range or no elements. If a convex shape cannot collide. If the position is not finite. If friction,
    /// restitution, contact skin, density, mass or the force threshold is negative or not finite; the
    /// threshold may be infinite.
    pub fn try_build(&self) -> Result<Collider, InvalidCollider> {
        let shape = self.try_shape()?;
        check_pose(&self.position)?;
        check_margin("friction", self.friction)?;
        check_margin("restitution", self.restitution)?;
        check_margin("contact_skin", self.contact_skin)?;
        self.check_mass()?;
        let threshold = self.contact_force_event_threshold;
        if threshold.is_nan() || threshold < 0.0 {
            return Err(InvalidCollider::Number {
                parameter: "contact_force_event_threshold",
                value: threshold,
                expected: "at least 0",
            });
        }
        Ok(Collider { shape, ..self.to_collider() })
    }

    /// The shape, checked as by [`Self::try_build`]: for compounds and for queries.
    ///
    /// A mirrored or unevenly scaled hull, mesh or height field is replaced by a consistent copy.
    ///
    /// The constructors of [`SharedShape`] belong to parry. Some of them panic on sizes that are not
    /// positive, on indices out of range and on empty lists. `ColliderBuilder::cylinder(h, r).try_shape()` is
    /// `SharedShape::cylinder(h, r)` without the panic.
    ///
    /// # Errors
    /// If the shape has sizes that are negative or not finite, coordinates that are not finite, indices out
    /// of range or no elements.
    pub fn try_shape(&self) -> Result<SharedShape, InvalidCollider> {
        if let Some(reason) = &self.impossible {
            return Err(reason.clone());
        }
        accept_shape(&self.shape)
    }

    fn check_mass(&self) -> Result<(), InvalidCollider> {
        match &self.mass_properties {
            ColliderMassProps::Density(density) => check_margin("density", *density),
            ColliderMassProps::Mass(mass) => check_margin("mass", *mass),
            ColliderMassProps::MassProperties(properties) if mass_is_valid(properties) => Ok(()),
            ColliderMassProps::MassProperties(properties) => Err(InvalidCollider::Number {
                parameter: "inverse mass of mass_properties",
                value: properties.inv_mass,
                expected: "finite and at least 0, like its inverse inertia and centre of mass",
            }),
        }
    }

    fn to_collider(&self) -> Collider {
        let enabled =
            if self.enabled { ColliderEnabled::Enabled } else { ColliderEnabled::Disabled };
        Collider {
            shape: self.shape.clone(),
            form: ShapeForm::UNKNOWN,
            widths: None,
            pose: normalized(self.position),
            parent: None,
            parent_type: None,
            material: ColliderMaterial {
                friction: self.friction,
                restitution: self.restitution,
                friction_combine_rule: self.friction_combine_rule,
                restitution_combine_rule: self.restitution_combine_rule,
            },
            mass_props: self.mass_properties.clone(),
            flags: ColliderFlags {
                active_collision_types: self.active_collision_types,
                collision_groups: self.collision_groups,
                solver_groups: self.solver_groups,
                active_hooks: self.active_hooks,
                active_events: self.active_events,
                enabled,
            },
            sensor: self.is_sensor,
            contact_skin: self.contact_skin,
            proxy: ColliderProxy::default(),
            contact_force_event_threshold: self.contact_force_event_threshold,
            changes: ColliderChanges::everything(),
            edit: EditMark::default(),
            user_data: self.user_data,
        }
    }

    /// The default friction: 0.5.
    pub fn default_friction() -> Real {
        ColliderMaterial::default().friction
    }

    /// The default density: 1.
    pub fn default_density() -> Real {
        1.0
    }
}

impl From<ColliderBuilder> for Collider {
    fn from(builder: ColliderBuilder) -> Self {
        builder.build()
    }
}

/// Properties that differ from the defaults.
impl ColliderBuilder {
    /// Sets the user data.
    pub fn user_data(mut self, data: u128) -> Self {
        self.user_data = data;
        self
    }

    /// Sets the groups with which it has contacts.
    pub fn collision_groups(mut self, groups: InteractionGroups) -> Self {
        self.collision_groups = groups;
        self
    }

    /// Sets the groups with which its contacts exert forces.
    pub fn solver_groups(mut self, groups: InteractionGroups) -> Self {
        self.solver_groups = groups;
        self
    }

    /// Sets whether it is a sensor, which reports intersections and exerts no forces.
    pub fn sensor(mut self, is_sensor: bool) -> Self {
        self.is_sensor = is_sensor;
        self
    }

    /// Sets the hooks that are called for its pairs.
    pub fn active_hooks(mut self, hooks: ActiveHooks) -> Self {
        self.active_hooks = hooks;
        self
    }

    /// Sets the events that are sent for its pairs.
    pub fn active_events(mut self, events: ActiveEvents) -> Self {
        self.active_events = events;
        self
    }

    /// Sets the types of bodies between which it collides.
    pub fn active_collision_types(mut self, types: ActiveCollisionTypes) -> Self {
        self.active_collision_types = types;
        self
    }

    /// Sets the largest ratio of the tangential to the normal contact force, 0 or more.
    pub fn friction(mut self, friction: Real) -> Self {
        self.friction = friction;
        self
    }

    /// Sets the rule that combines its friction with that of another collider.
    pub fn friction_combine_rule(mut self, rule: CoefficientCombineRule) -> Self {
        self.friction_combine_rule = rule;
        self
    }

    /// Sets the ratio of the speeds of separation and approach, 0 or more.
    pub fn restitution(mut self, restitution: Real) -> Self {
        self.restitution = restitution;
        self
    }

    /// Sets the rule that combines its restitution with that of another collider.
    pub fn restitution_combine_rule(mut self, rule: CoefficientCombineRule) -> Self {
        self.restitution_combine_rule = rule;
        self
    }

    /// Sets the mass per volume (per area in 2D), 0 or more. Replaces a mass set before.
    pub fn density(mut self, density: Real) -> Self {
        self.mass_properties = ColliderMassProps::Density(density);
        self
    }

    /// Sets the mass, spread evenly over the shape, 0 or more. Replaces a density set before.
    pub fn mass(mut self, mass: Real) -> Self {
        self.mass_properties = ColliderMassProps::Mass(mass);
        self
    }

    /// Sets mass, centre of mass and angular inertia, in the collider's frame. Replaces a density or
    /// mass set before.
    pub fn mass_properties(mut self, properties: MassProperties) -> Self {
        self.mass_properties = properties.into();
        self
    }

    /// Sets the least total contact force magnitude of a pair (force units) with an event. A force of zero
    /// has none.
    pub fn contact_force_event_threshold(mut self, threshold: Real) -> Self {
        self.contact_force_event_threshold = threshold;
        self
    }

    /// Sets its position: on its body if it will be attached to one, in the world otherwise.
    pub fn translation(mut self, translation: Vector) -> Self {
        self.position.translation = translation;
        self
    }

    /// Sets its orientation on its body or in the world: an angle (2D) or a rotation vector (3D), in
    /// radians.
    pub fn rotation(mut self, angle: AngVector) -> Self {
        self.position.rotation = rotation_from_angle(angle);
        self
    }

    /// Sets its position and orientation: on its body if it will be attached to one, in the world
    /// otherwise.
    pub fn position(mut self, position: Pose) -> Self {
        self.position = position;
        self
    }

    /// Sets the thickness (length units) of an invisible layer around the shape, 0 or more.
    pub fn contact_skin(mut self, skin: Real) -> Self {
        self.contact_skin = skin;
        self
    }

    /// Sets whether the collider takes part in the simulation.
    pub fn enabled(mut self, enabled: bool) -> Self {
        self.enabled = enabled;
        self
    }
}
