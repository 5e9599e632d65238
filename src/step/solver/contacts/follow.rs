//! Contacts of uneven bodies: their inertias follow the bodies from substep to substep.
//!
//! Inertias of contacts are frozen during a step. A rod with the moments of inertia `A` and `C ≪ A` that
//! rotates about its middle by `θ` gets the moment `C cos² θ + A sin² θ` about its first axis. A frozen
//! contact accelerates the rod there, with many times the energy that the contact computes. Uneven bodies are
//! those for which that counts: thin bodies that rotate fast. Their inertias are rotated after the positions
//! of a substep (`SolverBodies::turn_uneven`). Their contacts then get new effective masses, for the relax
//! pass of the substep and the next solve pass.
//!
//! The velocities contain the effects that the warm-start impulses have with the old masses. The differences
//! from their effects with the new ones go into the velocities before any impulse, with which the next
//! substep starts.

use super::prepare::write_masses;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::Wide;
use crate::dim::contact::{
    ContactBlock, CoulombBlock, Frame, NormalImpulse, Pair, apply_friction, write_friction_masses,
};
use crate::dim::state::{BodyPose, BodyState, READ_ONLY, WideMotion};
use crate::dim::wide::WideVector;
use crate::model::contact::ContactInput;
use crate::step::solver::states::{Bodies, gather_poses};

/// The bodies after a substep.
#[derive(Copy, Clone)]
pub(super) struct FollowContext<'a> {
    pub poses: &'a [BodyPose],
    pub uneven: &'a [bool],
    /// Velocities before any impulse of the substep.
    pub before: &'a DisjointMut<'a, BodyState>,
}

/// Gives a block the inertias of its bodies, if one of these is uneven. The other lanes get the same
/// effective masses again, to the last bit.
///
/// # Safety
/// The caller has exclusive access to the velocities of the block's bodies.
#[inline(always)]
pub(super) unsafe fn follow<W: Wide>(
    input: &ContactInput,
    (block, mut coulomb): (&mut ContactBlock, Option<&mut CoulombBlock>),
    FollowContext { poses, uneven, before }: FollowContext<'_>,
) {
    if !block.bodies.iter().flatten().any(|body| uneven[(body & !READ_ONLY) as usize]) {
        return;
    }
    let old = effect::<W>(block, coulomb.as_deref());
    let poses = block.bodies.map(|bodies| gather_poses::<W>(poses, &bodies));
    let (frame, offset) = (Frame::load(block), WideVector::load(&block.offset));
    let pair = Pair::store(input, block, frame, offset, &poses);
    write_masses(block, &pair, core::array::from_fn(|k| W::load(&input.present[k])));
    write_friction_masses(block, coulomb.as_deref_mut(), &pair);
    let new = effect::<W>(block, coulomb.as_deref());
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(before, &block.bodies) };
    for (side, velocity) in bodies.velocities.iter_mut().enumerate() {
        *velocity = *velocity - (new[side] - old[side]);
    }
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(before, &block.bodies) };
}

/// The velocity changes by the impulses of a block.
#[inline(always)]
fn effect<W: Wide>(block: &ContactBlock, coulomb: Option<&CoulombBlock>) -> [WideMotion<W>; 2] {
    let mut normal = NormalImpulse::zero();
    for point in &block.points {
        normal.add(W::load(&point.impulse), point.place());
    }
    let changes = normal.apply(block, &Frame::load(block), [WideMotion::none(); 2]);
    apply_friction(block, coulomb, changes)
}
