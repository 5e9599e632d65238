//! A world with the vehicles that drive in it.

use super::rapier::pipeline::{
    EventHandler, PhysicsHooks, PhysicsWorld, Replay, ReplayError, Replayed,
};
use super::space::Vehicles;

/// A world and its vehicles: the data that a copy contains.
#[derive(Default)]
pub struct Simulation {
    pub world: PhysicsWorld,
    pub vehicles: Vehicles,
}

impl Simulation {
    /// A world without vehicles.
    pub fn of(world: PhysicsWorld) -> Self {
        Self { world, vehicles: Vehicles::default() }
    }

    /// The world, whose colliders follow bodies that were moved since the last step. The next step does
    /// the same.
    pub fn current(&mut self) -> &mut PhysicsWorld {
        self.world.bodies.propagate_modified_body_positions_to_colliders(&mut self.world.colliders);
        &mut self.world
    }

    /// The hash of the current world, before and after queries.
    pub fn hash(&mut self) -> u64 {
        self.current().hash()
    }

    /// One step.
    pub fn step(&mut self, hooks: &dyn PhysicsHooks, events: &dyn EventHandler) {
        self.vehicles.update(&mut self.world);
        self.world.step_with_events(hooks, events);
    }
}

/// The world after the last step of a recording, if every step has the recorded hash.
pub fn replay(recording: &[u8]) -> Result<PhysicsWorld, ReplayError> {
    let mut replay = Replay::new(recording)?;
    while replay.step()? == Replayed::Step {}
    Ok(replay.world().clone())
}

impl Clone for Simulation {
    fn clone(&self) -> Self {
        Self { world: self.world.clone(), vehicles: self.vehicles.clone() }
    }

    /// Reuses the memory of the target.
    fn clone_from(&mut self, source: &Self) {
        self.world.clone_from(&source.world);
        self.vehicles.clone_from(&source.vehicles);
    }
}
