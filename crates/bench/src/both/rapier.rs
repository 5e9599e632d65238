//! Rapier from its published crates.
//!
//! The defaults of Rapier are its authors' recommendation and the settings of its own benchmarks. They are 4
//! solver iterations, contact recycling and clustering, friction in the relax pass only. Geometry,
//! mathematics and the numbers of the collision groups have the same types as here, so shapes are shared.

#[path = "running.rs"]
mod running;
#[path = "serialized.rs"]
mod saving;
#[path = "transcribe.rs"]
mod transcribe;

use super::peer as engine;
use super::same as numbers;
use super::template::Template;
use crate::engine::{Counts, Unsupported};
use engine::prelude::*;
use running::Running;

/// Creates the scene at its start.
pub fn start(template: &Template) -> Result<Running<'_>, Unsupported> {
    let (world, bodies) = transcribe::world(template)?;
    Ok(Running { template, world, bodies: bodies.into() })
}

/// Adds the touching pairs and their contact points.
fn count_contacts(world: &PhysicsWorld, counts: &mut Counts) {
    for pair in world.contact_pairs().filter(|pair| pair.has_any_active_contact()) {
        counts.pairs += 1;
        counts.points +=
            pair.manifolds().iter().map(|m| m.data.num_active_contacts()).sum::<usize>();
    }
}
