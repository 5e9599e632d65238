//! A copy of the world as it is when a step begins.

use crate::model::body::RigidBodySet;
use crate::model::collider::ColliderSet;
use crate::model::contact::NarrowPhase;
use crate::model::island::IslandManager;
use crate::model::joint::ImpulseJointSet;
use crate::model::multibody::MultibodyJointSet;
use crate::model::tree::BroadPhaseBvh;
use crate::step::world::World;

/// Everything that a step changes, and the lists of the user's edits, which the repeated step applies again.
pub(crate) struct Checkpoint {
    islands: IslandManager,
    broad_phase: BroadPhaseBvh,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    joints: ImpulseJointSet,
    multibodies: MultibodyJointSet,
}

impl Checkpoint {
    /// Copies the world. Shapes are shared.
    pub fn new(world: &World<'_>) -> Self {
        Self {
            islands: world.structure.islands.clone(),
            broad_phase: world.broad_phase.clone(),
            narrow_phase: world.structure.narrow_phase.clone(),
            bodies: world.structure.bodies.clone(),
            colliders: world.structure.colliders.clone(),
            joints: world.joints.clone(),
            multibodies: world.multibodies.clone(),
        }
    }

    /// Restores the world.
    pub fn restore(&self, world: &mut World<'_>) {
        world.structure.islands.clone_from(&self.islands);
        world.broad_phase.clone_from(&self.broad_phase);
        world.structure.narrow_phase.clone_from(&self.narrow_phase);
        world.structure.bodies.clone_from(&self.bodies);
        world.structure.colliders.clone_from(&self.colliders);
        world.joints.clone_from(&self.joints);
        world.multibodies.clone_from(&self.multibodies);
    }
}
