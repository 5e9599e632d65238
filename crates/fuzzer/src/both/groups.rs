//! Interaction groups, which separate the isolated bodies from all other colliders.

use super::rapier::prelude::*;

/// Interaction group of the isolated bodies. No other collider is in it.
pub const ISOLATED: Group = Group::GROUP_32;
/// Interaction groups of all other colliders.
pub const OTHERS: InteractionGroups =
    InteractionGroups::new(ISOLATED.complement(), ISOLATED.complement());
