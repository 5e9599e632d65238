//! This engine in double precision.

#[path = "contacts.rs"]
mod contacts;
#[path = "running.rs"]
mod running;
#[path = "snapshots.rs"]
mod saving;
#[path = "transcribe.rs"]
mod transcribe;

use super::double_engine as engine;
use super::template::Template;
use super::wide as numbers;
use crate::engine::Unsupported;
use contacts::count_contacts;
use running::Running;

/// Creates the scene at its start, in this engine's crate for double precision.
pub fn start(template: &Template) -> Result<Running<'_>, Unsupported> {
    let (world, bodies) = transcribe::world(template)?;
    Ok(Running { template, world, bodies: bodies.into() })
}
