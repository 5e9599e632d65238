//! Contact counts of this engine, in either precision.

use super::engine::prelude::*;
use crate::engine::Counts;

/// Adds the touching pairs and their contact points.
pub fn count_contacts(world: &PhysicsWorld, counts: &mut Counts) {
    let pairs = world.contact_pairs().map(|(_, _, pair)| pair);
    for pair in pairs.filter(|pair| pair.has_any_active_contact) {
        counts.pairs += 1;
        counts.points += pair.manifolds.iter().map(|m| m.data.num_active_contacts()).sum::<usize>();
    }
}
