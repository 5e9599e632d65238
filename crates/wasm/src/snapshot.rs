//! Snapshots of worlds.

use crate::fault::{Fault, Kind};
use crate::memory;
use crate::rapier::pipeline::PhysicsWorld;
use crate::registry::{insert_world, read};

#[cold]
fn refused(error: impl core::fmt::Display) -> Fault {
    Fault::new(Kind::InvalidSnapshot, error.to_string())
}

exports! {
    /// Saves a world. The bytes hold the snapshot. Returns their number.
    fn world_save(world: u32) -> u32 {
        memory::put_bytes(read(world)?.to_snapshot().map_err(refused)?)
    }

    /// Restores a world from the bytes. Returns its number.
    fn world_restore() -> u32 {
        insert_world(PhysicsWorld::from_snapshot(&memory::bytes()).map_err(refused)?)
    }

    /// Copies a world. Returns the number of the copy.
    fn world_copy(world: u32) -> u32 {
        insert_world(read(world)?.clone())
    }

    /// Writes the gravity of a world.
    fn world_gravity(world: u32) {
        memory::put_vector(0, read(world)?.gravity);
    }
}
