//! This engine.

#[path = "contacts.rs"]
mod contacts;
#[path = "running.rs"]
mod running;
#[path = "snapshots.rs"]
mod saving;

use super::ours as engine;
use super::same as numbers;
use super::template::Template;
use contacts::count_contacts;
use running::Running;

/// Creates the scene at its start: built again, not transcribed.
pub fn start(template: &Template) -> Running<'_> {
    Running { template, world: template.fresh_world(), bodies: (&template.bodies).into() }
}
