//! Bodies and colliders in a hierarchy of entities.
//!
//! Transforms are combined as pose and scale, never as a matrix: a body without parent keeps the bits of its
//! `Transform`. Uneven scales below a rotation would shear; the shear is left out. Ancestors without a
//! `Transform` count as the identity, while Bevy's propagation ends there.

use crate::body::RigidBody;
use bevy::ecs::entity::Entity;
use bevy::ecs::entity_disabling::Disabled;
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::Allow;
use bevy::ecs::system::{Query, SystemParam};
use bevy::math::{Quat, Vec3};
use bevy::transform::components::Transform;

/// Local transforms, those of disabled ancestors included.
pub(crate) type Locals<'w, 's> = Query<'w, 's, &'static Transform, Allow<Disabled>>;

/// Read access to the hierarchy, disabled entities included.
#[derive(SystemParam)]
pub(crate) struct Hierarchy<'w, 's> {
    parents: Query<'w, 's, &'static ChildOf, Allow<Disabled>>,
    bodies: Query<'w, 's, &'static RigidBody, Allow<Disabled>>,
}

/// The motion of a nested body by its ancestors, as far as it is not the step's: up to the nearest ancestor
/// of type `KinematicPosition`. That one moves during the step, and carries other bodies by friction.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
pub(crate) struct Carrier {
    /// The ancestor of type `KinematicPosition`.
    pub body: Option<Entity>,
    /// Transform of the parent entity, relative to that ancestor or to the world.
    pub parent: Transform,
}

impl Carrier {
    /// Returns whether two carriers are equal, also if their numbers are invalid.
    pub fn is_same(&self, other: &Self) -> bool {
        self.body == other.body && is_same(&self.parent, &other.parent)
    }
}

impl Hierarchy<'_, '_> {
    /// The entity of the body to which a collider belongs: its own or the nearest ancestor's.
    pub fn body_of(&self, entity: Entity) -> Option<Entity> {
        let mut chain = core::iter::once(entity).chain(self.parents.iter_ancestors(entity));
        chain.find(|&entity| self.bodies.contains(entity))
    }

    /// The carrier of a nested body.
    pub fn carrier<'a>(
        &self,
        entity: Entity,
        local: impl Fn(Entity) -> Option<&'a Transform>,
    ) -> Carrier {
        let is_moved_by_step =
            |&entity: &Entity| self.bodies.get(entity) == Ok(&RigidBody::KinematicPosition);
        let ancestors = || self.parents.iter_ancestors(entity);
        let below = ancestors().take_while(|ancestor| !is_moved_by_step(ancestor));
        Carrier {
            body: ancestors().find(is_moved_by_step),
            parent: product(below.filter_map(|entity| local(entity).copied())),
        }
    }

    /// Number of ancestors.
    pub fn depth(&self, entity: Entity) -> usize {
        self.parents.iter_ancestors(entity).count()
    }

    /// World transform of an entity's parent; the identity without a parent.
    pub fn parent_transform<'a>(
        &self,
        entity: Entity,
        local: impl Fn(Entity) -> Option<&'a Transform>,
    ) -> Transform {
        let ancestors = self.parents.iter_ancestors(entity);
        product(ancestors.filter_map(|entity| local(entity).copied()))
    }

    /// World transform of an entity.
    pub fn world_transform<'a>(
        &self,
        entity: Entity,
        local: impl Fn(Entity) -> Option<&'a Transform>,
    ) -> Transform {
        let own = local(entity).copied().unwrap_or_default();
        if self.parents.contains(entity) {
            combine(&self.parent_transform(entity, local), &own)
        } else {
            own
        }
    }

    /// Pose of a collider relative to its body, and scale relative to the world.
    pub fn relative_transform<'a>(
        &self,
        entity: Entity,
        body: Option<Entity>,
        local: impl Fn(Entity) -> Option<&'a Transform> + Copy,
    ) -> Transform {
        let Some(body) = body else {
            return self.world_transform(entity, local);
        };
        let size = Transform::from_scale(self.world_transform(body, local).scale);
        if body == entity {
            return size;
        }
        let between = self.parents.iter_ancestors(entity).take_while(|&ancestor| ancestor != body);
        let chain = core::iter::once(entity).chain(between);
        combine(&size, &product(chain.filter_map(|entity| local(entity).copied())))
    }
}

/// The product of the transforms from a descendant to an ancestor.
fn product(chain: impl Iterator<Item = Transform>) -> Transform {
    chain.fold(Transform::IDENTITY, |below, above| combine(&above, &below))
}

/// The transform of `below` in the space of `above`. Negative factors of a scale mirror rotations, too.
fn combine(above: &Transform, below: &Transform) -> Transform {
    let rotation = above.rotation * mirrored(below.rotation, above.scale);
    Transform { rotation, ..above.mul_transform(*below) }
}

/// The rotation in a space that `scale` mirrors.
fn mirrored(rotation: Quat, scale: Vec3) -> Quat {
    if scale.cmpge(Vec3::ZERO).all() {
        return rotation;
    }
    let signs = scale.signum();
    let axis = rotation.xyz() * signs * signs.element_product();
    Quat::from_xyzw(axis.x, axis.y, axis.z, rotation.w)
}

/// Returns whether two transforms have equal bits. Invalid numbers equal themselves.
pub(crate) fn is_same(transform: &Transform, other: &Transform) -> bool {
    let bits = |transform: &Transform| {
        let Transform { translation, rotation, scale } = transform;
        let vectors = [*translation, *scale].map(|vector| vector.to_array().map(f32::to_bits));
        (vectors, rotation.to_array().map(f32::to_bits))
    };
    transform == other || bits(transform) == bits(other)
}

/// The transform below `parent` whose world transform has the pose of `world`.
///
/// The parts of `old` remain that no world pose determines: the scale, coordinates along which the parent has
/// size 0, and all of them below an invalid parent.
pub(crate) fn local_transform(parent: &Transform, world: &Transform, old: &Transform) -> Transform {
    if !parent.is_finite() {
        return *old;
    }
    let inverse = parent.rotation.inverse();
    let offset = inverse * (world.translation - parent.translation);
    let is_flat = parent.scale.cmpeq(Vec3::ZERO);
    Transform {
        translation: Vec3::select(is_flat, old.translation, offset / parent.scale),
        rotation: mirrored(inverse * world.rotation, parent.scale),
        scale: old.scale,
    }
}
