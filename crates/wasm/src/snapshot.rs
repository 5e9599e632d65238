//! Snapshots of worlds.

use crate::fault::{Fault, Kind};
use crate::memory;
use crate::rapier::pipeline::PhysicsWorld;
use crate::registry::{insert_world, moved, read};

#[cold]
fn refused(error: impl core::fmt::Display) -> Fault {
    Fault::new(Kind::InvalidSnapshot, error.to_string())
}

exports! {
    /// Saves a world. The scratch block holds the gravity. The bytes hold the snapshot. Returns their number.
    fn world_save(world: u32) -> u32 {
        let (gravity, saved) = (memory::vector(0, "gravity")?, moved(world)?);
        let snapshot = if saved.gravity == gravity {
            saved.to_snapshot()
        } else {
            // A query may be reading the world, so the gravity goes into a copy.
            let mut copy = saved.clone();
            copy.gravity = gravity;
            copy.to_snapshot()
        };
        memory::put_bytes(snapshot.map_err(refused)?)
    }

    /// Restores a world from the bytes. Returns its number.
    fn world_restore() -> u32 {
        insert_world(PhysicsWorld::from_snapshot(&memory::bytes()).map_err(refused)?)
    }

    /// Copies a world. The scratch block holds the gravity. Returns the number of the copy.
    fn world_copy(world: u32) -> u32 {
        let gravity = memory::vector(0, "gravity")?;
        let mut copy = moved(world)?.clone();
        copy.gravity = gravity;
        insert_world(copy)
    }

    /// Writes the gravity of a world.
    fn world_gravity(world: u32) {
        memory::put_vector(0, read(world)?.gravity);
    }
}
