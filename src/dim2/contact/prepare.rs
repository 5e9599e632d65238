//! From manifolds to constraints: once per step.

use super::block::{COUPLINGS, ContactBlock};
use super::coulomb::CoulombBlock;
use super::friction::{self, WideFriction};
use super::rows::{Frame, NormalImpulse, invert};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide};
use crate::dim2::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim2::state::{
    BodyPose, BodyState, WidePose, gather_poses, gather_states, scatter_states,
};
use crate::dim2::wide::WideVector;
use crate::model::contact::{ContactInput, MotionSince};

/// One contact point between manifold and row.
#[derive(Copy, Clone)]
pub(super) struct Point<W> {
    /// In the contact frame, from the first centre of mass.
    pub local: WideVector<W>,
    pub separation: W,
    pub present: W,
    pub impulse: W,
}

/// The bodies of a block and the frame of its contacts.
pub(super) struct Pair<W> {
    pub frame: Frame<W>,
    pub poses: [WidePose<W>; 2],
    /// `c = x1 - x2` in the contact frame.
    pub offset: WideVector<W>,
}

/// The bodies as constraints are prepared.
#[derive(Copy, Clone)]
pub(crate) struct PrepareContext<'a> {
    pub poses: &'a [BodyPose],
    pub states: &'a DisjointMut<'a, BodyState>,
}

/// Fills a block from its manifolds and gives its bodies the impulses with which the step starts.
///
/// `prediction` is how far apart points may be.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(crate) unsafe fn prepare<W: Wide>(
    input: &ContactInput,
    block: &mut ContactBlock,
    _coulomb: Option<&mut CoulombBlock>,
    PrepareContext { poses, states }: PrepareContext<'_>,
    prediction: Real,
) {
    let (pair, points) = read_geometry::<W>(input, block, poses);
    write_pair(block, input, &pair);
    write_points(block, &pair, &points);
    let friction = friction::prepare(input, &pair, &points, W::splat(prediction));
    friction.store(&mut block.friction);
    // SAFETY: the caller's promise.
    unsafe { warm_start(block, &pair, &points, &friction, states) };
}

/// The points in the world and in the contact frame, at the bodies' current poses: the frame, `c` and the
/// points in it.
///
/// [Frozen](crate::model::contact::AnchorFrame) contacts keep the frame, the moment arms and `c` of their
/// last transformation. World positions are subtracted from each other before anything small is added: far
/// from the origin they have few fractional digits, and their differences keep all of them.
#[inline(always)]
fn read_geometry<W: Wide>(
    input: &ContactInput,
    block: &mut ContactBlock,
    poses: &[BodyPose],
) -> (Pair<W>, [Point<W>; MAX_MANIFOLD_POINTS]) {
    let poses = [
        scaled(gather_poses::<W>(poses, &input.bodies[0]), &input.mass_factors[0]),
        scaled(gather_poses::<W>(poses, &input.bodies[1]), &input.mass_factors[1]),
    ];
    let motion = MotionSince::new(&input.anchor_frame, &input.is_world, &poses);
    let (n, c) = (motion.normal, motion.offset());
    let frame = Frame::about(n);

    let zero = W::zero();
    let absent =
        Point { local: WideVector::zero(), separation: zero, present: zero, impulse: zero };
    let mut points = [absent; MAX_MANIFOLD_POINTS];
    for k in 0..MAX_MANIFOLD_POINTS {
        let placed = WideVector::load(&input.arms[k]);
        let (arm, moved) = motion.at(placed);
        let separation = W::load(&input.placed_separations[k]) + n.dot(moved);
        (motion.origin + arm).store(&mut block.places[k]);
        points[k] = Point {
            local: frame.local(WideVector::select(motion.is_frozen, placed, arm)),
            separation,
            present: W::load(&input.present[k]),
            impulse: W::load(&input.impulses[k]),
        };
    }
    (Pair { frame, poses, offset: frame.local(c) }, points)
}

/// The pose with its inverse masses scaled: a dominated body cannot move a dominant one.
#[inline(always)]
fn scaled<W: Wide>(mut pose: WidePose<W>, factor: &Lane) -> WidePose<W> {
    let factor = W::load(factor);
    pose.inv_mass = pose.inv_mass * factor;
    pose.inv_inertia = pose.inv_inertia * factor;
    pose
}

#[inline(always)]
fn write_pair<W: Wide>(block: &mut ContactBlock, input: &ContactInput, pair: &Pair<W>) {
    block.bodies = input.bodies;
    pair.frame.n.store(&mut block.normal);
    pair.offset.store(&mut block.offset);
    for side in 0..2 {
        pair.poses[side].inv_mass.store(&mut block.inv_mass[side]);
        pair.poses[side].inv_inertia.store(&mut block.inv_inertia[side]);
    }
    block.totals = [Lane::ZERO; MAX_MANIFOLD_POINTS];
}

/// The rows of the points, and how they act on each other: `K_ij = J_i M⁻¹ J_jᵀ`.
#[inline(always)]
fn write_points<W: Wide>(
    block: &mut ContactBlock,
    pair: &Pair<W>,
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
) {
    let n = pair.frame.n;
    let linear = n.dot(n.component_mul(pair.poses[0].inv_mass + pair.poses[1].inv_mass));
    let mut pairs = 0;
    for i in 0..MAX_MANIFOLD_POINTS {
        let point = &points[i];
        let mass = invert(linear + angular_part(pair, point, point)) * point.present;
        point.local.x.store(&mut block.points[i].x);
        point.separation.store(&mut block.points[i].separation);
        mass.store(&mut block.points[i].mass);
        point.impulse.store(&mut block.points[i].impulse);
        for other in &points[i + 1..] {
            (linear + angular_part(pair, point, other)).store(&mut block.coupling[pairs]);
            pairs += 1;
        }
    }
    debug_assert_eq!(pairs, COUPLINGS);
}

/// The angular part of `J_i M⁻¹ J_jᵀ`, with `ρ × n = ρₜ`.
#[inline(always)]
fn angular_part<W: Wide>(pair: &Pair<W>, i: &Point<W>, j: &Point<W>) -> W {
    let (a, b, c) = (i.local.x, j.local.x, pair.offset.x);
    pair.poses[0].inv_inertia * a * b + pair.poses[1].inv_inertia * (a + c) * (b + c)
}

/// Applies the impulses that the last step ended with.
///
/// # Safety
/// As [`gather_states`] and [`scatter_velocities`], for the bodies of the block.
#[inline(always)]
unsafe fn warm_start<W: Wide>(
    block: &ContactBlock,
    pair: &Pair<W>,
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
    friction: &WideFriction<W>,
    states: &DisjointMut<BodyState>,
) {
    let mut impulse = NormalImpulse::zero();
    for point in points {
        impulse.add(point.impulse, [point.local.x]);
    }
    // SAFETY: the caller's promise.
    unsafe {
        let (v1, d1) = gather_states::<W>(states, &block.bodies[0]);
        let (v2, d2) = gather_states::<W>(states, &block.bodies[1]);
        let velocities = friction.apply(friction.impulse, block, &pair.frame, [v1, v2]);
        let [v1, v2] = impulse.apply(block, &pair.frame, velocities);
        scatter_states(states, &block.bodies[0], (v1, d1));
        scatter_states(states, &block.bodies[1], (v2, d2));
    }
}
