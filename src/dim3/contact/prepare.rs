//! From manifolds to constraints: once per step.

use super::block::{COUPLINGS, ContactBlock, ContactInput, FrictionRow, PointRow};
use super::friction::{self, WideFriction};
use crate::base::disjoint::DisjointMut;
use crate::base::wide::{LANES, Lane, Wide};
use crate::dim3::math::{MAX_MANIFOLD_POINTS, Real};
use crate::dim3::state::{
    BodyPose, BodyState, WideMotion, WidePose, gather_motions, gather_poses, gather_states,
    scatter_velocities,
};
use crate::dim3::wide::{WideSymmetric, WideVector, mul_inertia};

/// The axes of the contact frame in world space.
#[derive(Copy, Clone)]
pub(super) struct Frame<W> {
    pub t1: WideVector<W>,
    pub t2: WideVector<W>,
    pub n: WideVector<W>,
}

impl<W: Wide> Frame<W> {
    /// A right-handed frame about a unit normal (Duff et al. 2017, see
    /// [`tangents`](crate::dim3::math::tangents)).
    #[inline(always)]
    fn about(n: WideVector<W>) -> Self {
        let one = W::splat(1.0);
        let sign = W::select(n.z.lt(W::zero()), -one, one);
        let a = -one / (sign + n.z);
        let t1 = WideVector {
            x: one + sign * n.x * n.x * a,
            y: sign * (n.x * n.y * a),
            z: -(sign * n.x),
        };
        Self { t1, t2: cross(n, t1), n }
    }

    /// The frame that a block remembers two axes of.
    #[inline(always)]
    pub fn load(block: &ContactBlock) -> Self {
        let n = WideVector::load(&block.normal);
        let t1 = WideVector::load(&block.tangent);
        Self { t1, t2: cross(n, t1), n }
    }

    /// World to contact frame.
    #[inline(always)]
    pub fn local(&self, v: WideVector<W>) -> WideVector<W> {
        WideVector { x: self.t1.dot(v), y: self.t2.dot(v), z: self.n.dot(v) }
    }

    /// Contact frame to world.
    #[inline(always)]
    pub fn world(&self, v: WideVector<W>) -> WideVector<W> {
        self.t1 * v.x + self.t2 * v.y + self.n * v.z
    }

    /// A symmetric matrix, world to contact frame: `Rᵀ M R`.
    #[inline(always)]
    fn local_symmetric(&self, m: WideSymmetric<W>) -> WideSymmetric<W> {
        let (m1, m2, mn) =
            (mul_inertia(m, self.t1), mul_inertia(m, self.t2), mul_inertia(m, self.n));
        WideSymmetric {
            m11: self.t1.dot(m1),
            m12: self.t1.dot(m2),
            m13: self.t1.dot(mn),
            m22: self.t2.dot(m2),
            m23: self.t2.dot(mn),
            m33: self.n.dot(mn),
        }
    }
}

#[inline(always)]
fn cross<W: Wide>(a: WideVector<W>, b: WideVector<W>) -> WideVector<W> {
    crate::dim3::wide::cross(a, b)
}

/// `1 / value` where the value is positive, zero elsewhere.
#[inline(always)]
pub(super) fn invert<W: Wide>(value: W) -> W {
    let positive = W::zero().lt(value);
    let one = W::splat(1.0);
    W::select(positive, one / W::select(positive, value, one), W::zero())
}

/// One contact point on its way from a manifold to a row.
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
    /// Inverse inertias in the contact frame.
    pub inv_inertia: [WideSymmetric<W>; 2],
}

/// Fills a block from its manifolds and gives its bodies the impulses with which the step starts.
///
/// `before` holds the velocities before any such impulse; `prediction` is how far apart points may be.
///
/// # Safety
/// Nobody else may touch the states of the block's bodies meanwhile.
#[inline(always)]
pub(crate) unsafe fn prepare<W: Wide>(
    input: &mut ContactInput,
    block: &mut ContactBlock,
    poses: &[BodyPose],
    states: &DisjointMut<BodyState>,
    before: &[BodyState],
    prediction: Real,
) {
    let (pair, points) = read_geometry::<W>(input, poses);
    write_pair(block, input, &pair);
    write_points(block, &pair, &points);
    let friction = friction::prepare(input, &pair, &points, W::splat(prediction));
    friction.store(&mut block.friction);
    write_approach(block, &pair, &points, before);
    // SAFETY: the caller's promise.
    unsafe { warm_start(block, &pair, &points, &friction, states) };
}

/// Where the points are in the world and in the contact frame, as the bodies stand now.
#[inline(always)]
fn read_geometry<W: Wide>(
    input: &mut ContactInput,
    poses: &[BodyPose],
) -> (Pair<W>, [Point<W>; MAX_MANIFOLD_POINTS]) {
    let poses = [
        gather_poses::<W>(poses, &input.bodies[0]),
        gather_poses::<W>(poses, &input.bodies[1]),
    ];
    let n = poses[0].rotation.rotate(WideVector::load(&input.normal));
    n.store(&mut input.world_normal);
    let frame = Frame::about(n);
    let poses = [scaled(poses[0], input, 0), scaled(poses[1], input, 1)];

    // The world has no centre of mass. The other body's makes all levers as short as they can be.
    let half = W::splat(0.5);
    let is_world = [half.lt(W::load(&input.is_world[0])), half.lt(W::load(&input.is_world[1]))];
    let (x1, x2) = (poses[0].center_of_mass, poses[1].center_of_mass);
    let origin1 = WideVector::select(is_world[0], x2, x1);
    let origin2 = WideVector::select(is_world[1], x1, x2);

    let zero = Point {
        local: WideVector::zero(),
        separation: W::zero(),
        present: W::zero(),
        impulse: W::zero(),
    };
    let mut points = [zero; MAX_MANIFOLD_POINTS];
    for k in 0..MAX_MANIFOLD_POINTS {
        let p1 = x1 + poses[0].rotation.rotate(WideVector::load(&input.anchors[0][k]));
        let p2 = x2 + poses[1].rotation.rotate(WideVector::load(&input.anchors[1][k]));
        let middle = (p1 + p2) * half;
        middle.store(&mut input.points[k]);
        let separation = (p2 - p1).dot(n);
        separation.store(&mut input.separations[k]);
        points[k] = Point {
            local: frame.local(middle - origin1),
            separation,
            present: W::load(&input.present[k]),
            impulse: W::load(&input.impulses[k]),
        };
    }
    let inv_inertia = [
        frame.local_symmetric(poses[0].inv_inertia),
        frame.local_symmetric(poses[1].inv_inertia),
    ];
    let offset = frame.local(origin1 - origin2);
    (Pair { frame, poses, offset, inv_inertia }, points)
}

/// The pose with its inverse masses scaled: a dominated body cannot move a dominant one.
#[inline(always)]
fn scaled<W: Wide>(mut pose: WidePose<W>, input: &ContactInput, side: usize) -> WidePose<W> {
    let factor = W::load(&input.mass_factors[side]);
    pose.inv_mass = pose.inv_mass * factor;
    let i = pose.inv_inertia;
    pose.inv_inertia = WideSymmetric {
        m11: i.m11 * factor,
        m12: i.m12 * factor,
        m13: i.m13 * factor,
        m22: i.m22 * factor,
        m23: i.m23 * factor,
        m33: i.m33 * factor,
    };
    pose
}

#[inline(always)]
fn write_pair<W: Wide>(block: &mut ContactBlock, input: &ContactInput, pair: &Pair<W>) {
    block.bodies = input.bodies;
    pair.frame.n.store(&mut block.normal);
    pair.frame.t1.store(&mut block.tangent);
    pair.offset.store(&mut block.offset);
    for side in 0..2 {
        pair.poses[side].inv_mass.store(&mut block.inv_mass[side]);
        store_symmetric(pair.inv_inertia[side], &mut block.inv_inertia[side]);
    }
    block.restitution = input.restitution;
    block.totals = [Lane::ZERO; MAX_MANIFOLD_POINTS];
    for lane in 0..LANES {
        let fixed = |side: usize| block.inv_mass[side].lane(lane).length_squared() == 0.0;
        block.is_static.0[lane] = if fixed(0) || fixed(1) { 1.0 } else { 0.0 };
    }
}

#[inline(always)]
fn store_symmetric<W: Wide>(m: WideSymmetric<W>, to: &mut WideSymmetric<Lane>) {
    m.m11.store(&mut to.m11);
    m.m12.store(&mut to.m12);
    m.m13.store(&mut to.m13);
    m.m22.store(&mut to.m22);
    m.m23.store(&mut to.m23);
    m.m33.store(&mut to.m33);
}

/// The rows of the points, and how they act on each other: `K_ij = J_i M⁻¹ J_jᵀ`.
#[inline(always)]
fn write_points<W: Wide>(
    block: &mut ContactBlock,
    pair: &Pair<W>,
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
) {
    let n = pair.frame.n;
    let inv_mass = pair.poses[0].inv_mass + pair.poses[1].inv_mass;
    let linear = n.dot(n.component_mul(inv_mass));
    let mut pairs = 0;
    for i in 0..MAX_MANIFOLD_POINTS {
        let point = &points[i];
        let mass = invert(effective(pair, linear, point, point)) * point.present;
        point.local.x.store(&mut block.points[i].x);
        point.local.y.store(&mut block.points[i].y);
        point.separation.store(&mut block.points[i].separation);
        mass.store(&mut block.points[i].mass);
        point.impulse.store(&mut block.points[i].impulse);
        for other in &points[i + 1..] {
            effective(pair, linear, point, other).store(&mut block.coupling[pairs]);
            pairs += 1;
        }
    }
    debug_assert_eq!(pairs, COUPLINGS);
}

/// `J_i M⁻¹ J_jᵀ`, with the angular part `ρ × n = (ρ₂, -ρ₁, 0)`.
#[inline(always)]
fn effective<W: Wide>(pair: &Pair<W>, linear: W, i: &Point<W>, j: &Point<W>) -> W {
    let (a, b, c) = (i.local, j.local, pair.offset);
    linear
        + lever_product(pair.inv_inertia[0], [a.x, a.y], [b.x, b.y])
        + lever_product(
            pair.inv_inertia[1],
            [a.x + c.x, a.y + c.y],
            [b.x + c.x, b.y + c.y],
        )
}

/// `(a₂, -a₁, 0) I⁻¹ (b₂, -b₁, 0)ᵀ`.
#[inline(always)]
fn lever_product<W: Wide>(inv_inertia: WideSymmetric<W>, a: [W; 2], b: [W; 2]) -> W {
    inv_inertia.m11 * a[1] * b[1] - inv_inertia.m12 * (a[1] * b[0] + a[0] * b[1])
        + inv_inertia.m22 * a[0] * b[0]
}

/// Relative normal velocities before anything acts: what restitution will reverse.
#[inline(always)]
fn write_approach<W: Wide>(
    block: &mut ContactBlock,
    pair: &Pair<W>,
    points: &[Point<W>; MAX_MANIFOLD_POINTS],
    before: &[BodyState],
) {
    if block.restitution == Lane::ZERO {
        return;
    }
    let motions =
        [gather_motions::<W>(before, &block.bodies[0]), gather_motions::<W>(before, &block.bodies[1])];
    let row = NormalRow::new(&pair.frame, pair.offset, motions);
    for (point, approach) in points.iter().zip(&mut block.approach) {
        row.at(point.local.x, point.local.y).store(approach);
    }
}

/// The normal component of a relative motion, as a function of the point in the contact plane.
#[derive(Copy, Clone)]
pub(super) struct NormalRow<W> {
    base: W,
    slope_x: W,
    slope_y: W,
}

impl<W: Wide> NormalRow<W> {
    /// The row of two bodies' velocities, or of their displacements.
    #[inline(always)]
    pub fn new(frame: &Frame<W>, c: WideVector<W>, motions: [WideMotion<W>; 2]) -> Self {
        let [m1, m2] = motions;
        let w1 = [frame.t1.dot(m1.angular), frame.t2.dot(m1.angular)];
        let w2 = [frame.t1.dot(m2.angular), frame.t2.dot(m2.angular)];
        Self::of_local(frame.n.dot(m2.linear - m1.linear), w1, w2, c)
    }

    /// The row of the relative linear motion along the normal and the first two components of the
    /// angular motions, in the contact frame.
    #[inline(always)]
    pub fn of_local(linear: W, w1: [W; 2], w2: [W; 2], c: WideVector<W>) -> Self {
        Self {
            base: linear + c.y * w2[0] - c.x * w2[1],
            slope_x: w1[1] - w2[1],
            slope_y: w2[0] - w1[0],
        }
    }

    /// Its value at a point.
    #[inline(always)]
    pub fn at(&self, x: W, y: W) -> W {
        self.base + self.slope_x * x + self.slope_y * y
    }
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
    let c = pair.offset;
    let mut impulse = PairImpulse::of_friction(friction, c);
    for point in points {
        impulse.add_normal(point.impulse, point.local.x, point.local.y, c);
    }
    // SAFETY: the caller's promise.
    unsafe {
        let [m1, _] = gather_states::<W>(states, &block.bodies[0]);
        let [m2, _] = gather_states::<W>(states, &block.bodies[1]);
        let (m1, m2) = impulse.apply(block, &pair.frame, m1, m2);
        scatter_velocities(states, &block.bodies[0], m1);
        scatter_velocities(states, &block.bodies[1], m2);
    }
}

/// The sum of the impulses of a block: linear on the second body (the first gets the opposite), and
/// angular on each, all in the contact frame.
#[derive(Copy, Clone)]
pub(super) struct PairImpulse<W> {
    pub linear: WideVector<W>,
    pub angular1: WideVector<W>,
    pub angular2: WideVector<W>,
}

impl<W: Wide> PairImpulse<W> {
    #[inline(always)]
    pub fn zero() -> Self {
        let zero = WideVector::zero();
        Self { linear: zero, angular1: zero, angular2: zero }
    }

    /// Tangential and twist impulses at the friction centre.
    #[inline(always)]
    pub fn of_friction(friction: &WideFriction<W>, c: WideVector<W>) -> Self {
        let mut sum = Self::zero();
        sum.add_tangential(friction.impulse, friction.center, c);
        sum.angular1.z = sum.angular1.z + friction.twist_impulse;
        sum.angular2.z = sum.angular2.z + friction.twist_impulse;
        sum
    }

    /// An impulse in the contact plane at the point `ρ`: `ρ × P` with `P₃ = 0`.
    #[inline(always)]
    pub fn add_tangential(&mut self, p: [W; 2], rho: WideVector<W>, c: WideVector<W>) {
        self.linear.x = self.linear.x + p[0];
        self.linear.y = self.linear.y + p[1];
        self.angular1 = self.angular1 + tangential_moment(rho, p);
        self.angular2 = self.angular2 + tangential_moment(rho + c, p);
    }

    /// An impulse along the normal at the point with the coordinates `(x, y)`.
    #[inline(always)]
    pub fn add_normal(&mut self, p: W, x: W, y: W, c: WideVector<W>) {
        self.linear.z = self.linear.z + p;
        self.angular1.x = self.angular1.x + p * y;
        self.angular1.y = self.angular1.y - p * x;
        self.angular2.x = self.angular2.x + p * (y + c.y);
        self.angular2.y = self.angular2.y - p * (x + c.x);
    }

    /// The velocities after the impulses have acted.
    #[inline(always)]
    pub fn apply(
        &self,
        block: &ContactBlock,
        frame: &Frame<W>,
        mut m1: WideMotion<W>,
        mut m2: WideMotion<W>,
    ) -> (WideMotion<W>, WideMotion<W>) {
        let p = frame.world(self.linear);
        m1.linear = m1.linear - p.component_mul(WideVector::load(&block.inv_mass[0]));
        m2.linear = m2.linear + p.component_mul(WideVector::load(&block.inv_mass[1]));
        let [i1, i2] = [
            crate::dim3::wide::load_symmetric(&block.inv_inertia[0]),
            crate::dim3::wide::load_symmetric(&block.inv_inertia[1]),
        ];
        m1.angular = m1.angular - frame.world(mul_inertia(i1, self.angular1));
        m2.angular = m2.angular + frame.world(mul_inertia(i2, self.angular2));
        (m1, m2)
    }
}

/// `ρ × P` with `P₃ = 0`.
#[inline(always)]
fn tangential_moment<W: Wide>(rho: WideVector<W>, p: [W; 2]) -> WideVector<W> {
    WideVector { x: -(rho.z * p[1]), y: rho.z * p[0], z: rho.x * p[1] - rho.y * p[0] }
}
