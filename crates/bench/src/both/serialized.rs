//! Saved worlds of Rapier: its sets, serialised by bincode as in its JavaScript packages and its
//! documentation.

use super::engine::prelude::*;

/// The complete state of a world.
type Sets<'a> = (
    &'a Vector,
    &'a IntegrationParameters,
    &'a IslandManager,
    &'a BroadPhaseBvh,
    &'a NarrowPhase,
    &'a RigidBodySet,
    &'a ColliderSet,
    &'a ImpulseJointSet,
    &'a MultibodyJointSet,
);

/// The same state, restored.
type OwnedSets = (
    Vector,
    IntegrationParameters,
    IslandManager,
    BroadPhaseBvh,
    NarrowPhase,
    RigidBodySet,
    ColliderSet,
    ImpulseJointSet,
    MultibodyJointSet,
);

pub fn save(world: &PhysicsWorld) -> Option<Vec<u8>> {
    let sets: Sets<'_> = (
        &world.gravity,
        &world.integration_parameters,
        &world.islands,
        &world.broad_phase,
        &world.narrow_phase,
        &world.bodies,
        &world.colliders,
        &world.impulse_joints,
        &world.multibody_joints,
    );
    bincode::serialize(&sets).ok()
}

pub fn load(bytes: &[u8]) -> bool {
    bincode::deserialize::<OwnedSets>(bytes).is_ok()
}

/// Returns `None`: Rapier cannot return a world to an earlier copy in place.
pub fn save_and_return(_: &mut PhysicsWorld) -> Option<f64> {
    None
}
