//! Contacts of uneven bodies: their inertias follow the bodies from substep to substep.
//!
//! Inertias of contacts are frozen during a step. A rod with the moments of inertia `A` and `C ≪ A` that
//! rotates about its middle by `θ` gets the moment `C cos² θ + A sin² θ` about its first axis. A frozen
//! contact accelerates it there, with many times the energy that the contact computes. The contacts of bodies
//! for which that counts, thin ones that rotate fast, therefore get new effective masses after the positions
//! of a substep, for its relax pass and the next solve pass. The other body of a contact keeps its inertia,
//! as in its other contacts: impacts need one inertia for each body.
//!
//! The velocities contain the effects that the warm-start impulses have with the old masses. The differences
//! from their effects with the new ones go into the velocities before any impulse, with which the next
//! substep starts.

use super::prepare::write_masses;
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide, lanes};
use crate::dim::contact::{
    ContactBlock, CoulombBlock, Frame, NormalImpulse, Pair, apply_friction, write_friction_masses,
};
use crate::dim::rotation_vector::turned_inertia;
use crate::dim::state::{BodyPose, BodyState, WideMotion};
use crate::dim::wide::{WideVector, select_symmetric};
use crate::model::contact::ContactInput;
use crate::step::solver::states::{Bodies, gather_poses};

/// The bodies while contacts follow them.
#[derive(Copy, Clone)]
pub(super) struct FollowContext<'a> {
    pub poses: &'a [BodyPose],
    pub states: &'a DisjointMut<'a, BodyState>,
    /// Velocities before any impulse of the substep.
    pub before: &'a DisjointMut<'a, BodyState>,
}

/// Gives a block the inertias that its uneven bodies have now: in the lanes with these bits, by side.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(super) unsafe fn follow<W: Wide>(
    input: &ContactInput,
    (block, mut coulomb): (&mut ContactBlock, Option<&mut CoulombBlock>),
    uneven: [u32; 2],
    FollowContext { poses, states, before }: FollowContext<'_>,
) {
    // SAFETY: the caller's promise.
    let moved = unsafe { Bodies::<W>::gather(states, &block.bodies) }.displacements;
    let mut poses =
        [gather_poses::<W>(poses, &block.bodies[0]), gather_poses::<W>(poses, &block.bodies[1])];
    for ((pose, moved), bits) in poses.iter_mut().zip(moved).zip(uneven) {
        let turned = turned_inertia(pose.inv_inertia, moved.rotation());
        pose.inv_inertia = select_symmetric(mask_of::<W>(bits), turned, pose.inv_inertia);
    }
    let (mut new, mut rows) = (block.clone(), coulomb.as_deref().cloned());
    let (frame, offset) = (Frame::load(block), WideVector::load(&block.offset));
    let pair = Pair::store(input, &mut new, frame, offset, &poses);
    write_masses(&mut new, &pair, core::array::from_fn(|k| W::load(&input.present[k])));
    write_friction_masses(&mut new, rows.as_mut(), &pair);
    let selected = uneven[0] | uneven[1];
    let effects = [effect(block, coulomb.as_deref()), effect(&new, rows.as_ref())];
    // SAFETY: the caller's promise.
    unsafe { exchange::<W>(effects, selected, block, before) };
    for lane in lanes(selected) {
        block.copy_masses(lane, &new);
        if let (Some(to), Some(from)) = (&mut coulomb, &rows) {
            to.copy_masses(lane, from);
        }
    }
}

/// Puts the difference of the old and the new effect of the impulses into the velocities before any impulse.
///
/// # Safety
/// The caller has exclusive access to the velocities of the block's bodies.
#[inline(always)]
unsafe fn exchange<W: Wide>(
    [old, new]: [[WideMotion<W>; 2]; 2],
    selected: u32,
    block: &ContactBlock,
    before: &DisjointMut<BodyState>,
) {
    let mask = mask_of::<W>(selected);
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(before, &block.bodies) };
    for (side, velocity) in bodies.velocities.iter_mut().enumerate() {
        let changed = *velocity - (new[side] - old[side]);
        *velocity = WideMotion::select(mask, changed, *velocity);
    }
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(before, &block.bodies) };
}

/// The lanes with these bits.
#[inline(always)]
fn mask_of<W: Wide>(bits: u32) -> W::Mask {
    let mut is_set = Lane::ZERO;
    lanes(bits).for_each(|lane| is_set.0[lane] = 1.0);
    W::zero().lt(W::load(&is_set))
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
