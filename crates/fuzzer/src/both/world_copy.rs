//! Copies of the sets of a world.

use super::rapier::prelude::*;

/// Complete state of a world.
pub struct WorldCopy {
    pub islands: IslandManager,
    pub broad_phase: BroadPhaseBvh,
    pub narrow_phase: NarrowPhase,
    pub bodies: RigidBodySet,
    pub colliders: ColliderSet,
    pub impulse_joints: ImpulseJointSet,
    pub multibody_joints: MultibodyJointSet,
}

impl WorldCopy {
    pub fn of(world: &PhysicsWorld) -> Self {
        Self {
            islands: world.islands.clone(),
            broad_phase: world.broad_phase.clone(),
            narrow_phase: world.narrow_phase.clone(),
            bodies: world.bodies.clone(),
            colliders: world.colliders.clone(),
            impulse_joints: world.impulse_joints.clone(),
            multibody_joints: world.multibody_joints.clone(),
        }
    }

    /// Exchanges this state and the world's.
    pub fn exchange(&mut self, world: &mut PhysicsWorld) {
        (0..7).for_each(|position| self.exchange_one(world, position));
    }

    /// Exchanges the set at a position and the world's.
    pub fn exchange_one(&mut self, world: &mut PhysicsWorld, position: usize) {
        match position {
            0 => core::mem::swap(&mut self.islands, &mut world.islands),
            1 => core::mem::swap(&mut self.broad_phase, &mut world.broad_phase),
            2 => core::mem::swap(&mut self.narrow_phase, &mut world.narrow_phase),
            3 => core::mem::swap(&mut self.bodies, &mut world.bodies),
            4 => core::mem::swap(&mut self.colliders, &mut world.colliders),
            5 => core::mem::swap(&mut self.impulse_joints, &mut world.impulse_joints),
            _ => core::mem::swap(&mut self.multibody_joints, &mut world.multibody_joints),
        }
    }
}
