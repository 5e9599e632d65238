//! Platforms that are solid from one side.

use crate::geometry::SolverContact;
use crate::math::{Real, Vector};

/// Values of the user data.
mod state {
    pub const UNDECIDED: u32 = 0;
    pub const SOLID: u32 = 1;
    pub const PASSING: u32 = 2;
}

/// A manifold of a platform.
pub struct OneWay<'a> {
    /// Normal in the frame of the first collider.
    pub normal: Vector,
    /// The contacts that are solved.
    pub contacts: &'a mut Vec<SolverContact>,
    /// State of the pair.
    pub user_data: &'a mut u32,
}

impl OneWay<'_> {
    /// Removes the contacts of a body from another side, until it no longer overlaps.
    pub fn update(self, allowed_local_n1: Vector, allowed_angle: Real) {
        let from_solid_side = self.normal.dot(allowed_local_n1) >= allowed_angle.cos();
        let apart = self.contacts.iter().all(|contact| contact.dist > 0.0);
        let is_touching = !self.contacts.is_empty();
        *self.user_data = match *self.user_data {
            state::SOLID if is_touching => state::SOLID,
            state::SOLID => state::UNDECIDED,
            state::PASSING if !(from_solid_side && apart) => state::PASSING,
            _ if from_solid_side => state::SOLID,
            _ => state::PASSING,
        };
        if *self.user_data == state::PASSING {
            self.contacts.clear();
        }
    }
}
