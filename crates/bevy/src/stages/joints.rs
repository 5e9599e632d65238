//! New and edited joints.

use crate::invalid::refuse;
use crate::joint::Joint;
use crate::world::PhysicsWorld;
use bevy::ecs::entity::Entity;
use bevy::ecs::query::Changed;
use bevy::ecs::system::{Commands, Query, ResMut};
use rapier::prelude::{InvalidJoint, RigidBodyHandle};

/// Inserts new joints and edits changed ones. A joint remains pending until both entities have a body.
pub(crate) fn sync_joints(
    mut world: ResMut<PhysicsWorld>,
    joints: Query<&Joint>,
    edited: Query<Entity, Changed<Joint>>,
    mut commands: Commands,
) {
    world.pending.joints.extend_sorted(edited);
    for entity in world.pending.joints.take() {
        let Ok(joint) = joints.get(entity) else {
            continue;
        };
        let (Some(body1), Some(body2)) =
            (world.body_handle(joint.body1), world.body_handle(joint.body2))
        else {
            // An old joint connects other bodies than the component.
            world.remove_joint(entity);
            world.pending.joints.push(entity);
            continue;
        };
        if let Err(reason) = world.upsert_joint(entity, joint, [body1, body2]) {
            refuse(&mut commands, entity, reason);
        }
    }
}

impl PhysicsWorld {
    /// Inserts the joint of an entity, or edits it.
    fn upsert_joint(
        &mut self,
        entity: Entity,
        joint: &Joint,
        [body1, body2]: [RigidBodyHandle; 2],
    ) -> Result<(), InvalidJoint> {
        let mut data = joint.data;
        data.user_data = u128::from(entity.to_bits());
        data.validate()?;
        let old = self.joint(entity);
        let is_same_pair = old.is_some_and(|old| old.body1() == body1 && old.body2() == body2);
        if is_same_pair {
            let handle = self.joint_handle(entity);
            if let Some(old) = handle.and_then(|h| self.engine.impulse_joints.get_mut(h)) {
                old.data = data;
            }
            return Ok(());
        }
        // A refused joint leaves the old one in place.
        let handle = self.engine.try_insert_impulse_joint(body1, body2, data)?;
        self.remove_joint(entity);
        self.joints.insert(entity, handle);
        Ok(())
    }
}
