//! Bodies and colliders in a hierarchy of entities.
//!
//! Transforms are combined as pose and scale, never as a matrix: a body without parent keeps the bits of its
//! `Transform`. Uneven scales below a rotation would shear; the shear is left out.

use crate::body::RigidBody;
use bevy::ecs::entity::Entity;
use bevy::ecs::hierarchy::ChildOf;
use bevy::ecs::query::With;
use bevy::ecs::system::{Query, SystemParam};
use bevy::math::Vec3;
use bevy::transform::components::Transform;

/// Read access to the hierarchy.
#[derive(SystemParam)]
pub(crate) struct Hierarchy<'w, 's> {
    parents: Query<'w, 's, &'static ChildOf>,
    bodies: Query<'w, 's, (), With<RigidBody>>,
}

impl Hierarchy<'_, '_> {
    /// The entity of the body to which a collider belongs: its own or the nearest ancestor's.
    pub fn body_of(&self, entity: Entity) -> Option<Entity> {
        let mut line = core::iter::once(entity).chain(self.parents.iter_ancestors(entity));
        line.find(|&entity| self.bodies.contains(entity))
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
            self.parent_transform(entity, local).mul_transform(own)
        } else {
            own
        }
    }

    /// Placement of a collider on its body: pose relative to the body, and scale relative to the world.
    pub fn placement<'a>(
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
        let line = core::iter::once(entity).chain(between);
        size.mul_transform(product(line.filter_map(|entity| local(entity).copied())))
    }
}

/// The product of the transforms from a descendant to an ancestor.
fn product(line: impl Iterator<Item = Transform>) -> Transform {
    line.fold(Transform::IDENTITY, |below, above| above.mul_transform(below))
}

/// The transform below `parent` whose world transform has the pose of `world`. Its scale is `scale`.
pub(crate) fn local_transform(parent: &Transform, world: &Transform, scale: Vec3) -> Transform {
    let turn_back = parent.rotation.inverse();
    let offset = turn_back * (world.translation - parent.translation);
    Transform { translation: offset / parent.scale, rotation: turn_back * world.rotation, scale }
}
