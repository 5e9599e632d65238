//! From manifolds to constraints: once per step.

use super::block::{COUPLINGS, ContactBlock};
use super::coulomb::CoulombBlock;
use super::friction;
use super::rows::{Frame, NormalImpulse, invert};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide};
use crate::dim3::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim3::state::{
    BodyPose, BodyState, WideMotion, WidePose, gather_poses, gather_states, scatter_velocities,
};
use crate::dim3::wide::{WideSymmetric, WideVector};
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
    /// `c = x1 - x2` in the contact frame.
    pub offset: WideVector<W>,
    /// Inverse masses along the axes of the world.
    pub inv_mass: [WideVector<W>; 2],
    /// Inverse inertias in the contact frame.
    pub inv_inertia: [WideSymmetric<W>; 2],
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
/// Friction is at each point if there is a place for its rows in `coulomb`.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub(crate) unsafe fn prepare<W: Wide>(
    input: &ContactInput,
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    PrepareContext { poses, states }: PrepareContext<'_>,
    prediction: Real,
) {
    let poses =
        [gather_poses::<W>(poses, &input.bodies[0]), gather_poses::<W>(poses, &input.bodies[1])];
    let (frame, offset, points) = read_geometry(input, block, &poses);
    let pair = write_pair(block, input, frame, offset, &poses);
    write_points(block, &pair, &points);
    let friction = friction::prepare(input, &pair, &points, W::splat(prediction));
    friction.store(&mut block.friction);
    // SAFETY: the caller's promise.
    let mut velocities = unsafe { gather_both(states, block) };
    velocities = match coulomb {
        None => friction.apply(friction.impulse, block, &pair.frame, velocities),
        Some(rows) => {
            rows.prepare(input, block, &pair, &points);
            rows.warm_start(block, &pair.frame, velocities)
        }
    };
    velocities = warm_start(block, &pair, &points, velocities);
    // SAFETY: the caller's promise.
    unsafe { scatter_both(states, block, velocities) };
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
    poses: &[WidePose<W>; 2],
) -> (Frame<W>, WideVector<W>, [Point<W>; MAX_MANIFOLD_POINTS]) {
    let motion = MotionSince::new(&input.anchor_frame, &input.is_world, poses);
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
    (frame, frame.local(c), points)
}

/// Data of its bodies that a block stores.
#[inline(always)]
fn write_pair<W: Wide>(
    block: &mut ContactBlock,
    input: &ContactInput,
    frame: Frame<W>,
    offset: WideVector<W>,
    poses: &[WidePose<W>; 2],
) -> Pair<W> {
    block.bodies = input.bodies;
    block.totals = [Lane::ZERO; MAX_MANIFOLD_POINTS];
    frame.n.store(&mut block.normal);
    frame.t1.store(&mut block.tangent);
    offset.store(&mut block.offset);
    let mut inv_mass = [WideVector::zero(); 2];
    let mut columns = [[WideVector::zero(); 3]; 2];
    for side in 0..2 {
        // A dominated body cannot move a dominant one.
        let factor = W::load(&input.mass_factors[side]);
        inv_mass[side] = poses[side].inv_mass * factor;
        inv_mass[side].store(&mut block.inv_mass[side]);
        let world = frame.columns(poses[side].inv_inertia);
        for axis in 0..3 {
            columns[side][axis] = world[axis] * factor;
            columns[side][axis].store(&mut block.inv_inertia[axis][side]);
        }
    }
    let inv_inertia = [frame.local_symmetric(columns[0]), frame.local_symmetric(columns[1])];
    Pair { frame, offset, inv_mass, inv_inertia }
}

/// The rows of the points, and how they act on each other: `K_ij = J_i M⁻¹ J_jᵀ`.
#[inline(always)]
fn write_points<W: Wide>(
    block: &mut ContactBlock,
    pair: &Pair<W>,
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
) {
    let n = pair.frame.n;
    let linear = n.dot(n.component_mul(pair.inv_mass[0] + pair.inv_mass[1]));
    let mut pairs = 0;
    for i in 0..MAX_MANIFOLD_POINTS {
        let point = &points[i];
        let mass = invert(linear + angular_part(pair, point, point)) * point.present;
        point.local.x.store(&mut block.points[i].x);
        point.local.y.store(&mut block.points[i].y);
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

/// The angular part of `J_i M⁻¹ J_jᵀ`, with `ρ × n = (ρ₂, -ρ₁, 0)`.
#[inline(always)]
fn angular_part<W: Wide>(pair: &Pair<W>, i: &Point<W>, j: &Point<W>) -> W {
    let (a, b, c) = (i.local, j.local, pair.offset);
    let [i1, i2] = pair.inv_inertia;
    arm_product(i1, [a.x, a.y], [b.x, b.y])
        + arm_product(i2, [a.x + c.x, a.y + c.y], [b.x + c.x, b.y + c.y])
}

/// `(a₂, -a₁, 0) I⁻¹ (b₂, -b₁, 0)ᵀ`.
#[inline(always)]
fn arm_product<W: Wide>(inv_inertia: WideSymmetric<W>, a: [W; 2], b: [W; 2]) -> W {
    inv_inertia.m11 * a[1] * b[1] - inv_inertia.m12 * (a[1] * b[0] + a[0] * b[1])
        + inv_inertia.m22 * a[0] * b[0]
}

/// Applies the normal impulses that the last step ended with.
#[inline(always)]
fn warm_start<W: Wide>(
    block: &ContactBlock,
    pair: &Pair<W>,
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
    velocities: [WideMotion<W>; 2],
) -> [WideMotion<W>; 2] {
    let mut impulse = NormalImpulse::zero();
    for point in points {
        impulse.add(point.impulse, [point.local.x, point.local.y]);
    }
    impulse.apply(block, &pair.frame, velocities)
}

/// # Safety
/// As [`gather_states`], for both bodies.
#[inline(always)]
unsafe fn gather_both<W: Wide>(
    states: &DisjointMut<BodyState>,
    block: &ContactBlock,
) -> [WideMotion<W>; 2] {
    // SAFETY: the caller's promise.
    unsafe {
        let (v1, _) = gather_states(states, &block.bodies[0]);
        let (v2, _) = gather_states(states, &block.bodies[1]);
        [v1, v2]
    }
}

/// # Safety
/// As [`scatter_velocities`], for both bodies.
#[inline(always)]
unsafe fn scatter_both<W: Wide>(
    states: &DisjointMut<BodyState>,
    block: &ContactBlock,
    [v1, v2]: [WideMotion<W>; 2],
) {
    // SAFETY: the caller's promise.
    unsafe {
        scatter_velocities(states, &block.bodies[0], v1);
        scatter_velocities(states, &block.bodies[1], v2);
    }
}
