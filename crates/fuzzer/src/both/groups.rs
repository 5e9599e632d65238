//! Interaction groups, which separate the bystanders from all other colliders.

use super::rapier::prelude::*;

/// Interaction group of the bystanders. No other collider is in it.
pub const BYSTANDERS: Group = Group::GROUP_32;
/// Interaction groups of all other colliders.
pub const OTHERS: InteractionGroups =
    InteractionGroups::new(BYSTANDERS.complement(), BYSTANDERS.complement());
