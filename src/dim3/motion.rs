//! How bodies move while nothing holds them, in 3D: a record of whole registers, and what integrates it lane by lane.
//!
//! # Tumbling
//! Between impulses a body keeps its angular momentum `L`, not its angular velocity: as it turns, its inertia turns with
//! it, and `ω = I⁻¹ L` changes. How a body turns that nothing holds stands in `spin.rs`: with `L` constant to rounding
//! and an energy that is off by a fraction of a per cent and does not drift, however fast it turns.
//!
//! Through the solver we take the *mean* velocity of a substep: the rotation vector of the free turn, divided by the
//! time. A body that nothing holds arrives by it exactly where it goes, and constraints that look ahead along their bodies'
//! velocities look there.
//!
//! An impulse acts where the substep begins: that is where joints take their levers and inertias from. A change `Δω`
//! of the mean velocity is therefore one of `L` by `I Δω` with the inertia of the beginning. With that of the
//! middle, thin limbs that hang from each other gain some per cent of their energy in ten seconds.
//!
//! With the new `L` the body turns freely once more, and that is where it goes: by `h Δω` further but for the second
//! order in the angle of a substep. Turned by `h (ω + Δω)` instead, as the velocity says, its energy would be anybody's
//! guess where a blow made it turn by radians about an axis that is not one of its own: `I⁻¹ L` has any energy between those of
//! `L` about the longest and about the thinnest axis. (A thin bar that hit a wall at 100 m/s got a hundred thousand
//! times its energy.)

use super::math::{AngVector, Real, Rotation, Vector, integrate_rotation};
use super::spin::free_turn;
use super::state::WideMotion;
use super::turn::rotation_vector;
use super::wide::{WideAngVector, WideRotation, WideVector};
use crate::base::wide::{Kernel, LANES, Simd, Wide, gather, scatter};
use parry::mass_properties::MassProperties;

/// Moments that differ by less than this share make no visible difference.
const ISOTROPY: Real = 1.0e-3;
/// A body that turns by less than this (rad) in a substep does not tumble.
const TURN_MIN: Real = 1.0e-4;
/// Rad: further than this, the shorter way is the other one.
const HALF_TURN: Real = core::f64::consts::PI as Real;

/// Numbers that every body needs; as many are for those that tumble alone.
const PLAIN_LEN: usize = 16;
const RECORD_LEN: usize = 2 * PLAIN_LEN;
/// Where what stands, but for the damping at 10 and 11: rotation (of a body that tumbles: that of its principal axes) at
/// 0, acceleration at 4.
const TUMBLES: usize = 12;
const INV_MOMENTS: usize = 13;
const FRAME: usize = 16;
const BEARS_WEIGHT: usize = 30;

/// What integrates a body; no constraint reads it.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct FreeMotion([Real; RECORD_LEN]);

impl FreeMotion {
    /// Neither accelerates nor is damped.
    pub fn at_rest(rotation: Rotation) -> Self {
        Self::new(rotation, (Vector::ZERO, AngVector::ZERO), [0.0; 2], true)
    }

    /// A body with this orientation, linear and angular acceleration by gravity and the user's forces (length/s²,
    /// rad/s²), and linear and angular damping (1/s).
    ///
    /// Does gravity pull it, so that it may be part of a pile? What holds piles up `bears_weight`, too.
    pub fn new(
        rotation: Rotation,
        (linear, angular): (Vector, AngVector),
        damping: [Real; 2],
        bears_weight: bool,
    ) -> Self {
        let mut record = [0.0; RECORD_LEN];
        record[0..4].copy_from_slice(&rotation.to_array());
        record[4..7].copy_from_slice(&linear.to_array());
        record[7..10].copy_from_slice(&angular.to_array());
        record[10..12].copy_from_slice(&damping);
        record[BEARS_WEIGHT] = if bears_weight { 1.0 } else { 0.0 };
        Self(record)
    }

    /// Lets the body tumble, unless it need not: if it is round, or hardly turns in `h` seconds.
    pub fn with_gyroscope(mut self, mass: &MassProperties, angvel: AngVector, h: Real) -> Self {
        let inv_moments = mass.inv_principal_inertia;
        let (low, high) = (inv_moments.min_element(), inv_moments.max_element());
        let is_round = low <= 0.0 || high - low < ISOTROPY * high;
        if !is_round && angvel.length_squared() * h * h >= TURN_MIN * TURN_MIN {
            let (order, inv_moments) = middle_second(inv_moments);
            let frame = mass.principal_inertia_local_frame * order;
            let axes = self.rotation() * frame;
            self.0[0..4].copy_from_slice(&axes.to_array());
            self.0[TUMBLES] = 1.0;
            self.0[INV_MOMENTS..INV_MOMENTS + 3].copy_from_slice(&inv_moments.to_array());
            self.0[FRAME..FRAME + 4].copy_from_slice(&frame.to_array());
        }
        self
    }

    /// Of a body that tumbles: how it is turned now. Of others: how it was when the step began.
    pub fn rotation(&self) -> Rotation {
        let quaternion = |at: usize| {
            Rotation::from_xyzw(self.0[at], self.0[at + 1], self.0[at + 2], self.0[at + 3])
        };
        if self.tumbles() { quaternion(0) * quaternion(FRAME).conjugate() } else { quaternion(0) }
    }

    /// The acceleration by gravity and the user's forces (length/s²).
    pub fn linear_acceleration(&self) -> Vector {
        Vector::new(self.0[4], self.0[5], self.0[6])
    }

    /// Does the angular velocity change as the body turns?
    pub fn tumbles(&self) -> bool {
        self.0[TUMBLES] != 0.0
    }

    /// May it be part of a pile?
    pub fn bears_weight(&self) -> bool {
        self.0[BEARS_WEIGHT] != 0.0
    }

    /// Turns a tumbling body by this rotation vector.
    pub fn turn(&mut self, turn: AngVector) {
        if self.tumbles() {
            let axes = Rotation::from_xyzw(self.0[0], self.0[1], self.0[2], self.0[3]);
            let turned = integrate_rotation(axes, turn);
            self.0[0..4].copy_from_slice(&turned.to_array());
        }
    }
}

/// The velocities of up to [`LANES`] bodies after `h` seconds, if these are theirs and nothing holds them.
#[inline(always)]
pub(crate) fn accelerated<W: Wide>(
    bodies: &mut [FreeMotion],
    WideMotion { linear, angular }: WideMotion<W>,
    h: Real,
) -> WideMotion<W> {
    let own = gather::<W, PLAIN_LEN>(rows(bodies, |record| &record[..PLAIN_LEN]));
    let (one, substep) = (W::splat(1.0), W::splat(h));
    let linear_acceleration = WideVector { x: own[4], y: own[5], z: own[6] };
    let angular_acceleration = WideVector { x: own[7], y: own[8], z: own[9] };
    // Damping is integrated implicitly: v' = v + h a - h c v' never overshoots zero.
    let linear = (linear + linear_acceleration * substep) * (one / (one + substep * own[10]));
    let mut angular =
        (angular + angular_acceleration * substep) * (one / (one + substep * own[11]));
    if bodies.iter().any(FreeMotion::tumbles) {
        let mut gyroscope = Gyroscope::gather(bodies, &own);
        let mean = gyroscope.mean_velocity(axes_of(&own), angular, h);
        angular = WideVector::select(W::zero().lt(own[TUMBLES]), mean, angular);
        gyroscope.scatter(bodies);
    }
    WideMotion { linear, angular }
}

/// Turns up to [`LANES`] bodies, if they tumble, for `h` seconds, and their angular velocities as their inertia turns. Returns the
/// turn of each.
///
/// What turns the velocity is no impulse: the next substep must not start with it, nor with the rounding of it. Where
/// there was no impulse, the velocity `before` any becomes the new one to the last bit.
#[inline(always)]
pub(crate) fn tumble<W: Wide>(
    bodies: &mut [FreeMotion],
    velocity: &mut WideAngVector<W>,
    before: &mut WideAngVector<W>,
    h: Real,
) -> WideAngVector<W> {
    let mut own = gather::<W, PLAIN_LEN>(rows(bodies, |record| &record[..PLAIN_LEN]));
    let mut gyroscope = Gyroscope::gather(bodies, &own);
    let w = *velocity;
    let (end, turn, at_end) = gyroscope.turn_under(axes_of(&own), w, h);
    let tumbles = W::zero().lt(own[TUMBLES]);
    *velocity = WideVector::select(tumbles, at_end, w);
    *before = WideVector::select(tumbles, at_end - (w - *before), *before);
    let turned = [end.x, end.y, end.z, end.w];
    for k in 0..4 {
        own[k] = W::select(tumbles, turned[k], own[k]);
    }
    scatter(own, rows_mut(bodies, |record| &mut record[..PLAIN_LEN]));
    gyroscope.scatter(bodies);
    WideVector::select(tumbles, turn, w * W::splat(h))
}

/// The angular velocity of one body after it has turned freely for `h` seconds.
pub(crate) fn angvel_after(
    mass: &MassProperties,
    rotation: Rotation,
    angvel: AngVector,
    h: Real,
) -> AngVector {
    let body = FreeMotion::at_rest(rotation).with_gyroscope(mass, angvel, h);
    if body.tumbles() { Simd::baseline().run(TurnFreely { body, angvel, h }) } else { angvel }
}

/// One body that turns for a while.
struct TurnFreely {
    body: FreeMotion,
    angvel: AngVector,
    h: Real,
}

impl Kernel for TurnFreely {
    type Output = AngVector;

    #[inline(always)]
    fn run<W: Wide>(self) -> AngVector {
        let (bodies, angular) = (&mut [self.body], WideVector::splat(self.angvel));
        let start = WideMotion { linear: WideVector::zero(), angular };
        let mut velocity = accelerated::<W>(bodies, start, self.h).angular;
        let mut before = velocity;
        tumble(bodies, &mut velocity, &mut before, self.h);
        let mut lanes = WideVector::ZERO;
        velocity.store(&mut lanes);
        lanes.lane(0)
    }
}

/// What lets bodies tumble.
struct Gyroscope<W> {
    inv_moments: WideVector<W>,
    /// How the principal axes stood at the beginning of the substep, where the solver's impulses act.
    start: WideRotation<W>,
    /// The angular momentum. It is carried from substep to substep rather than computed from the
    /// velocity each time: what rounding does to it on average goes in one direction, and 240 steps a
    /// second in `f32` made of it 5 % of the energy in a minute.
    momentum: WideAngVector<W>,
    /// The angular velocity that goes with it: through the solver the mean one, then that at the end.
    angvel: WideAngVector<W>,
    /// Not ours, but in the same registers.
    others: [W; 6],
}

impl<W: Wide> Gyroscope<W> {
    #[inline(always)]
    fn gather(bodies: &[FreeMotion], own: &[W; PLAIN_LEN]) -> Self {
        let s = gather::<W, PLAIN_LEN>(rows(bodies, |record| &record[PLAIN_LEN..]));
        Self {
            inv_moments: WideVector {
                x: own[INV_MOMENTS],
                y: own[INV_MOMENTS + 1],
                z: own[INV_MOMENTS + 2],
            },
            start: WideRotation { x: s[4], y: s[5], z: s[6], w: s[7] },
            momentum: WideVector { x: s[8], y: s[9], z: s[10] },
            angvel: WideVector { x: s[11], y: s[12], z: s[13] },
            others: [s[0], s[1], s[2], s[3], s[14], s[15]],
        }
    }

    #[inline(always)]
    fn scatter(self, bodies: &mut [FreeMotion]) {
        let (s, l, w) = (self.start, self.momentum, self.angvel);
        let [a, b, c, d, first, second] = self.others;
        let numbers = [a, b, c, d, s.x, s.y, s.z, s.w, l.x, l.y, l.z, w.x, w.y, w.z, first, second];
        scatter(numbers, rows_mut(bodies, |record| &mut record[PLAIN_LEN..]));
    }

    /// Somebody changed the angular velocity while the principal axes stood so.
    #[inline(always)]
    fn take_in(&mut self, axes: WideRotation<W>, angvel: WideAngVector<W>) {
        let moments = self.inv_moments;
        let change = axes.conjugate().rotate_unscaled(angvel - self.angvel);
        let change = WideVector {
            x: change.x / moments.x,
            y: change.y / moments.y,
            z: change.z / moments.z,
        };
        self.momentum = self.momentum + axes.rotate_unscaled(change);
    }

    /// The principal axes after a free turn of `h` seconds, and its rotation vector. By more than half a turn there are several of
    /// these; then it is the one that goes with the angular velocity `angvel`.
    #[inline(always)]
    fn turn(
        &self,
        axes: WideRotation<W>,
        angvel: WideAngVector<W>,
        h: Real,
    ) -> (WideRotation<W>, WideAngVector<W>) {
        let momentum = axes.conjugate().rotate_unscaled(self.momentum);
        let by = free_turn(self.inv_moments, momentum, h);
        let straight = angvel * W::splat(h);
        let is_near = straight.dot(straight).lt(W::splat(HALF_TURN * HALF_TURN));
        let is_near = is_near & W::zero().lt(by.w);
        let vector = axes.rotate_unscaled(rotation_vector(by));
        (axes.times(by), WideVector::select(is_near, vector, straight))
    }

    /// The mean angular velocity in a substep of `h` seconds that begins with `angvel`.
    #[inline(always)]
    fn mean_velocity(
        &mut self,
        axes: WideRotation<W>,
        angvel: WideAngVector<W>,
        h: Real,
    ) -> WideAngVector<W> {
        self.take_in(axes, angvel);
        self.start = axes;
        let (_, turn) = self.turn(axes, angvel, h);
        self.angvel = turn * W::splat(1.0 / h);
        self.angvel
    }

    /// Turns the principal axes for `h` seconds. The mean velocity has become `angvel`, by what acted at the start. Returns
    /// how they stand then, the turn, and the angular velocity at its end.
    #[inline(always)]
    fn turn_under(
        &mut self,
        axes: WideRotation<W>,
        angvel: WideAngVector<W>,
        h: Real,
    ) -> (WideRotation<W>, WideAngVector<W>, WideAngVector<W>) {
        self.take_in(self.start, angvel);
        let (end, turn) = self.turn(axes, angvel, h);
        let end = end.normalized();
        let momentum = end.conjugate().rotate_unscaled(self.momentum);
        self.angvel = end.rotate_unscaled(momentum.component_mul(self.inv_moments));
        (end, turn, self.angvel)
    }
}

/// Names the principal axes anew, in the same sense, such that the second has the middle moment: how the new ones stand among the old
/// ones, and their moments (or the inverse of these).
fn middle_second(moments: Vector) -> (Rotation, Vector) {
    let Vector { x, y, z } = moments;
    let is_between = |a: Real, b: Real, c: Real| (a - b) * (b - c) >= 0.0;
    if is_between(x, y, z) {
        (Rotation::IDENTITY, moments)
    } else if is_between(y, z, x) {
        (Rotation::from_xyzw(0.5, 0.5, 0.5, 0.5), Vector::new(y, z, x))
    } else {
        (Rotation::from_xyzw(-0.5, -0.5, -0.5, 0.5), Vector::new(z, x, y))
    }
}

#[inline(always)]
fn axes_of<W: Wide>(own: &[W; PLAIN_LEN]) -> WideRotation<W> {
    WideRotation { x: own[0], y: own[1], z: own[2], w: own[3] }
}

/// Half of the record of each body; no lane beyond them is looked at later.
#[expect(clippy::expect_used, reason = "half a record is so long")]
#[inline(always)]
fn rows(
    bodies: &[FreeMotion],
    half: impl Fn(&[Real; RECORD_LEN]) -> &[Real],
) -> [&[Real; PLAIN_LEN]; LANES] {
    let mut rows = [const { &[0.0; PLAIN_LEN] }; LANES];
    for (row, body) in rows.iter_mut().zip(bodies) {
        *row = half(&body.0).first_chunk().expect("half a record");
    }
    rows
}

#[inline(always)]
fn rows_mut(
    bodies: &mut [FreeMotion],
    half: impl Fn(&mut [Real; RECORD_LEN]) -> &mut [Real],
) -> [Option<&mut [Real; PLAIN_LEN]>; LANES] {
    let mut rows = [const { None }; LANES];
    for (row, body) in rows.iter_mut().zip(bodies) {
        *row = half(&mut body.0).first_chunk_mut();
    }
    rows
}
