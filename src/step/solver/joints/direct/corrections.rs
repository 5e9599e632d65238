//! Displacements that correct large errors of joints.
//!
//! Errors are corrected by the velocities of the solve pass. The relax pass removes the rest of these
//! velocities along the locked axes. The rest along free axes is energy from nothing: a hinge whose anchor
//! was moved by two metres kept 1,400 J in 1 kg. Contacts would pass such velocities on, too. The
//! displacements of this file leave no velocity. They correct
//!
//! * errors of joints that a program made or edited, or moved a body of: those are no results of motions;
//! * the excess over limits, which is that of a load: heavy boxes jumped on ropes.
//!
//! They are a Newton step towards the poses without errors, and a step is linear: a light link that has to
//! rotate by several radians in it ends anywhere. So it ends where a body has rotated by [`ROTATION_MAX`],
//! and the next substep takes another one. Between a post and a heavy ball, the step still rotates light
//! links where it should lift the ball: a chain that hits a wall opens by half a metre, and remained open.
//! Errors by motion alone, and errors by edits of components with large mass ratios, are therefore left to
//! the velocities.

use super::driven::add_changes;
use super::jacobians::{Motion, locked_axes};
use super::joint::DirectJoint;
use super::matrix::Matrix;
use super::memory::Jacobians;
use super::pattern::Component;
use crate::dim::math::{DIM, Real, SPATIAL_DIM};

/// Largest angle (rad) by which a correction rotates a body in a substep.
const ROTATION_MAX: f64 = 0.5;

impl<const N: usize> Matrix<N> {
    /// Moves the bodies by what corrects the errors of their joints, after they moved by their velocities in
    /// a substep of this length. `displace` moves one body.
    pub fn correct_poses(
        &mut self,
        component: Component<'_>,
        memory: &Jacobians,
        substep: Real,
        displace: &mut impl FnMut(usize, [Real; SPATIAL_DIM]),
    ) {
        let is_corrected = |member: &DirectJoint| {
            memory.blocks[member.block as usize].is_corrected_apart.0[member.lane as usize] > 0.0
        };
        for (member, x) in component.members.iter().zip(&mut self.x) {
            let (from, lane) = (&memory.blocks[member.block as usize], member.lane as usize);
            *x = [0.0; N];
            let axes = locked_axes::<N>(member).filter(|_| is_corrected(member));
            for (x, axis) in x.iter_mut().zip(axes) {
                *x = -f64::from(from.corrections[axis].0[lane]);
            }
        }
        for driven in &self.driven {
            let [at, row] = driven.at;
            let is_corrected = is_corrected(&component.members[at]);
            self.x[at][row] = if is_corrected { driven.correction() } else { 0.0 };
        }
        if component.is_redundant {
            self.again.clone_from(&self.x);
            self.substitute(component);
            self.load_second_rhs(component, None);
        }
        self.substitute(component);
        self.find_velocities(component);
        let angle = self.changes.iter().map(spin).fold(0.0, f64::max) * f64::from(substep);
        let seconds = f64::from(substep) * (ROTATION_MAX / angle).min(1.0);
        for (member, numbers) in component.members.iter().zip(component.bodies) {
            for (side, body) in member.movable() {
                // A body of several joints moves once.
                let velocity = core::mem::take(&mut self.changes[numbers[side] as usize]);
                displace(body as usize, velocity.map(|value| (value * seconds) as Real));
            }
        }
    }

    /// Finds the velocities that the solution gives to the bodies.
    fn find_velocities(&mut self, component: Component<'_>) {
        self.changes.clear();
        self.changes.resize(component.body_count, [0.0; SPATIAL_DIM]);
        for (at, (rows, x)) in self.rows.iter().zip(&self.x).enumerate() {
            add_changes(component, rows, at, x, &mut self.changes);
        }
    }
}

/// The size of the angular velocity.
fn spin(velocity: &Motion) -> f64 {
    velocity[DIM..].iter().map(|value| value * value).sum::<f64>().sqrt()
}
