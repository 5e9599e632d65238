//! From manifolds to rows, when a step begins, and the impulses of the last one.

use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide, invert};
use crate::dim::contact::{
    ContactBlock, CoulombBlock, Frame, NormalImpulse, Pair, prepare_friction,
};
use crate::dim::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim::state::{BodyPose, BodyState, WideMotion};
use crate::dim::wide::WideVector;
use crate::model::contact::{ContactInput, MotionSince, Turning, WidePoint};
use crate::step::solver::states::{Bodies, gather_poses};

/// The bodies as constraints are prepared.
#[derive(Copy, Clone)]
pub(in crate::step::solver) struct PrepareContext<'a> {
    pub poses: &'a [BodyPose],
    pub states: &'a DisjointMut<'a, BodyState>,
    /// Distance up to which points may be apart.
    pub prediction: Real,
    /// Half the length of the step (s).
    pub half_step: Real,
}

/// Fills a block from its manifolds and gives its bodies the impulses with which the step starts.
///
/// Friction is at each point if there is a place for its rows in `coulomb`.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(in crate::step::solver) unsafe fn prepare<W: Wide>(
    input: &ContactInput,
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    context: PrepareContext<'_>,
) {
    let PrepareContext { poses, states, prediction, half_step } = context;
    block.bodies = input.bodies;
    block.totals = [Lane::ZERO; MAX_MANIFOLD_POINTS];
    let poses =
        [gather_poses::<W>(poses, &input.bodies[0]), gather_poses::<W>(poses, &input.bodies[1])];
    let motion = MotionSince::new(&input.anchor_frame, &input.is_world, &poses);
    let frame = Frame::about(motion.normal);
    let points = read_points(input, block, &motion, &frame);
    let pair = Pair::store(input, block, frame, frame.local(motion.offset()), &poses);
    write_points(block, &pair, &points);
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    let half_step = W::splat(half_step);
    let turning = Turning { angvels: bodies.velocities.map(|motion| motion.angular), half_step };
    let friction = prepare_friction(input, &pair, &points, W::splat(prediction), turning);
    bodies.velocities = friction.begin(input, block, coulomb, &pair, &points, bodies.velocities);
    bodies.velocities = warm_start(block, &frame, &points, bodies.velocities);
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
}

/// The points in the world and in the contact frame, at the bodies' current poses.
///
/// [Frozen](crate::model::contact::AnchorFrame) contacts keep the frame, the moment arms and `c` of their
/// last transformation. World positions are subtracted from each other before anything small is added. Far
/// from the origin they have few fractional digits, and their differences keep all of them.
#[inline(always)]
fn read_points<W: Wide>(
    input: &ContactInput,
    block: &mut ContactBlock,
    motion: &MotionSince<W>,
    frame: &Frame<W>,
) -> [WidePoint<W>; MAX_MANIFOLD_POINTS] {
    let mut points = [WidePoint::absent(); MAX_MANIFOLD_POINTS];
    for k in 0..MAX_MANIFOLD_POINTS {
        let anchor_arm = WideVector::load(&input.arms[k]);
        let (arm, moved) = motion.at(anchor_arm);
        let separation = W::load(&input.anchor_separations[k]) + motion.normal.dot(moved);
        (motion.origin + arm).store(&mut block.places[k]);
        points[k] = WidePoint {
            local: frame.local(WideVector::select(motion.is_frozen, anchor_arm, arm)),
            separation,
            present: W::load(&input.present[k]),
            impulse: W::load(&input.impulses[k]),
        };
    }
    points
}

/// The rows of the points.
#[inline(always)]
fn write_points<W: Wide>(
    block: &mut ContactBlock,
    pair: &Pair<W>,
    points: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
) {
    for (point, row) in points.iter().zip(&mut block.points) {
        row.store_place(point.local);
        point.separation.store(&mut row.separation);
        point.impulse.store(&mut row.impulse);
    }
    write_masses(block, pair, points.map(|point| point.present));
}

/// The effective masses of the present points (1, absent: 0), and how points act on each other: `K_ij =
/// J_i M⁻¹ J_jᵀ`.
#[inline(always)]
pub(super) fn write_masses<W: Wide>(
    block: &mut ContactBlock,
    pair: &Pair<W>,
    present: [W; MAX_MANIFOLD_POINTS],
) {
    let n = pair.frame.n;
    let linear = n.dot(n.component_mul(pair.inv_mass[0] + pair.inv_mass[1]));
    let mut pairs = 0;
    for i in 0..MAX_MANIFOLD_POINTS {
        let place = block.points[i].place();
        let mass = invert(linear + pair.angular_part(place, place)) * present[i];
        mass.store(&mut block.points[i].mass);
        for j in i + 1..MAX_MANIFOLD_POINTS {
            let coupling = linear + pair.angular_part(place, block.points[j].place());
            coupling.store(&mut block.coupling[pairs]);
            pairs += 1;
        }
    }
    debug_assert_eq!(pairs, block.coupling.len());
}

/// Applies the normal impulses that the last step ended with.
#[inline(always)]
fn warm_start<W: Wide>(
    block: &ContactBlock,
    frame: &Frame<W>,
    points: &[WidePoint<W>; MAX_MANIFOLD_POINTS],
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let mut impulse = NormalImpulse::zero();
    for (point, row) in points.iter().zip(&block.points) {
        impulse.add(point.impulse, row.place());
    }
    impulse.apply(block, frame, velocities)
}
