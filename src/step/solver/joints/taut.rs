//! Taut joints: forces that hold light bodies stiffly.
//!
//! A force `F` that pulls at the lever `r` of a body of mass `m` and inertia `I` holds the body's direction like
//! a spring: turned aside, the body swings about its anchor with `ω² = F r / (I + m r²)`. A method that keeps the
//! direction of the force through a substep, as the symplectic one does, is stable only for `h ω < 2`, and near
//! that it turns its small errors into vibrations of what is light. The links of a chain under a weight a thousand
//! times as heavy are beyond that.
//!
//! So where `(h ω)²`, summed over the two bodies of a joint, is above [`TAUT`], its whole component is solved by a
//! method that loses energy instead (Müller et al., "Detailed rigid body simulation with extended position based
//! dynamics", 2020; with all joints at once: Deul et al., "Direct position-based solver for stiff rods", 2018):
//! starting without impulses, the bodies are led to where they would go freely, and from there projected on what
//! the joints allow, along the rows *there*. A projection never adds energy, however stiff.

use super::block::JointBlock;
use super::direct::Member;
use crate::dim::joint::inertia_about;
use crate::dim::math::{AngularInertia, Real, zero_inertia};
use crate::model::params::JointPass;

/// The `(h ω)²` above which a joint is taut.
const TAUT: Real = 0.003;

/// The bodies that joints hold: by solver index.
#[derive(Default)]
pub(super) struct Tautness {
    inv_inertias: Vec<AngularInertia>,
}

impl Tautness {
    /// Forgets all bodies.
    pub fn clear(&mut self, body_count: usize) {
        self.inv_inertias.clear();
        self.inv_inertias.resize(body_count, zero_inertia());
    }

    /// Notes the inertia of a body that a joint holds.
    pub fn note(&mut self, body: u32, inv_inertia: &AngularInertia) {
        self.inv_inertias[body as usize] = *inv_inertia;
    }

    /// Did the joint pull so hard in the last substep that it is taut?
    pub fn is_taut(&self, block: &JointBlock, member: &Member, pass: &JointPass) -> bool {
        let lane = member.lane as usize;
        let pull = block.applied.linear.lane(lane).length() * pass.substep;
        let swings = member.movable().map(|(side, body)| {
            let lever = block.levers[side].lane(lane).length();
            let inv_mass = block.inv_mass[side].lane(lane).max_element();
            match inertia_about(&self.inv_inertias[body as usize]) {
                Some(inertia) if inv_mass > 0.0 => {
                    pull * lever / (inertia + lever * lever / inv_mass)
                }
                _ => 0.0,
            }
        });
        swings.sum::<Real>() > TAUT
    }
}
