//! The systems of a fixed step, in the order of execution, and the observers between the steps.

mod edits;
mod lifecycle;
mod pose_parts;
mod required;
mod bodies;
mod colliders;
mod joints;
mod step;
mod write_back;
mod nested;
mod interpolation;

pub(crate) use bodies::{apply_impulses, edit_bodies, insert_bodies};
pub(crate) use colliders::{describe_colliders, move_colliders};
pub(crate) use interpolation::{interpolate_transforms, restore_transforms};
pub(crate) use joints::sync_joints;
pub(crate) use lifecycle::{observe_lifecycle, queue_existing_entities};
pub(crate) use nested::{carry_nested_bodies, write_nested_transforms};
pub(crate) use required::observe_required;
pub(crate) use step::{send_events, step};
pub(crate) use write_back::write_transforms;
