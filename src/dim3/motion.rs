//! How bodies move while nothing holds them, in 3D: a record of whole registers, and what integrates it lane by lane.
//!
//! # Tumbling
//! Between impulses a body keeps its angular momentum `L`, not its angular velocity: as it turns, its
//! inertia turns with it, and `ω = I⁻¹ L` changes. We take the velocity of the middle of the substep
//! (from the orientation that the old velocity reaches by then) through the solver and turn the body
//! by it. So `L` is constant to rounding and the energy error is of second order and bounded.
//!
//! An impulse acts where the substep begins: that is where joints take their levers and inertias from. A change `Δω`
//! of the middle's velocity is therefore one of `L` by `I Δω` with the inertia of the beginning. With that of the
//! middle, thin limbs that hang from each other gain some per cent of their energy in ten seconds.
//!
//! Where a body turns by radians within a substep, about an axis that is not one of its own, the middle says nothing of the
//! way: `ω = I⁻¹ L` may have many times the energy. Such a body keeps its angular velocity for that substep. (A thin bar
//! that hit a wall at 100 m/s got a hundred thousand times its energy.)
//!
//! The implicit Euler step of Catto, "Numerical Methods" (GDC 2015), is as stable but dissipates;
//! explicit Euler, `ω ← ω - h I⁻¹ (ω × I ω)`, gains energy until it explodes.

use super::math::{AngVector, Real, Rotation, Vector, integrate_rotation};
use super::state::WideMotion;
use super::turn::turned_frame;
use super::wide::{WideAngVector, WideRotation, WideVector};
use crate::base::wide::{Kernel, LANES, Simd, Wide, gather, scatter};
use parry::mass_properties::MassProperties;

/// Moments that differ by less than this share make no visible difference.
const ISOTROPY: Real = 1.0e-3;
/// A body that turns by less than this (rad) in a substep does not tumble.
const TURN_MIN: Real = 1.0e-4;
/// Tumbling that makes the energy so many times what it was is not followed.
const JUMP: Real = 1.5;
/// The same for a body that turns by more than this in a substep (rad): no more than rounding.
const JUMP_FAR: Real = 1.001;
const FAR_TURN: Real = 0.5;

/// Numbers that every body needs; as many are for those that tumble alone.
const PLAIN_LEN: usize = 16;
const RECORD_LEN: usize = 2 * PLAIN_LEN;
/// Where what stands, but for the damping at 10 and 11: rotation at 0, acceleration at 4.
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
            self.0[TUMBLES] = 1.0;
            self.0[INV_MOMENTS..INV_MOMENTS + 3].copy_from_slice(&inv_moments.to_array());
            let frame = mass.principal_inertia_local_frame.to_array();
            self.0[FRAME..FRAME + 4].copy_from_slice(&frame);
        }
        self
    }

    /// Of a body that tumbles: how it is turned now. Of others: how it was when the step began.
    pub fn rotation(&self) -> Rotation {
        Rotation::from_xyzw(self.0[0], self.0[1], self.0[2], self.0[3])
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
            let turned = integrate_rotation(self.rotation(), turn);
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
        let rotation = rotation_of(&own);
        let mut gyroscope = Gyroscope::gather(bodies, &own);
        let at_middle = gyroscope.velocity_at_middle(rotation, angular, substep);
        angular = WideVector::select(W::zero().lt(own[TUMBLES]), at_middle, angular);
        gyroscope.scatter(bodies);
    }
    WideMotion { linear, angular }
}

/// Turns up to [`LANES`] bodies, if they tumble, by `h` times their angular velocity, and it as their inertia turns.
///
/// What turns the velocity is no impulse: the next substep must not start with it, nor with the rounding of it. Where
/// there was no impulse, the velocity `before` any becomes the new one to the last bit.
#[inline(always)]
pub(crate) fn tumble<W: Wide>(
    bodies: &mut [FreeMotion],
    velocity: &mut WideAngVector<W>,
    before: &mut WideAngVector<W>,
    h: Real,
) {
    let mut own = gather::<W, PLAIN_LEN>(rows(bodies, |record| &record[..PLAIN_LEN]));
    let mut gyroscope = Gyroscope::gather(bodies, &own);
    let (w, end) = (*velocity, turned_frame(rotation_of(&own), *velocity * W::splat(h)));
    let at_end = gyroscope.velocity_at_end(end, w, W::splat(h));
    let tumbles = W::zero().lt(own[TUMBLES]);
    *velocity = WideVector::select(tumbles, at_end, w);
    *before = WideVector::select(tumbles, at_end - (w - *before), *before);
    let turned = [end.x, end.y, end.z, end.w];
    for k in 0..4 {
        own[k] = W::select(tumbles, turned[k], own[k]);
    }
    scatter(own, rows_mut(bodies, |record| &mut record[..PLAIN_LEN]));
    gyroscope.scatter(bodies);
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
    frame: WideRotation<W>,
    /// Orientation at the beginning of the substep, where the solver's impulses act.
    start: WideRotation<W>,
    /// The angular momentum. It is carried from substep to substep rather than computed from the
    /// velocity each time: what rounding does to it on average goes in one direction, and 240 steps a
    /// second in `f32` made of it 5 % of the energy in a minute.
    momentum: WideAngVector<W>,
    /// The angular velocity that goes with it.
    angvel: WideAngVector<W>,
    /// Not ours, but in the same registers.
    others: [W; 2],
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
            frame: WideRotation { x: s[0], y: s[1], z: s[2], w: s[3] },
            start: WideRotation { x: s[4], y: s[5], z: s[6], w: s[7] },
            momentum: WideVector { x: s[8], y: s[9], z: s[10] },
            angvel: WideVector { x: s[11], y: s[12], z: s[13] },
            others: [s[14], s[15]],
        }
    }

    #[inline(always)]
    fn scatter(self, bodies: &mut [FreeMotion]) {
        let (f, s, l, w) = (self.frame, self.start, self.momentum, self.angvel);
        let [first, second] = self.others;
        let numbers =
            [f.x, f.y, f.z, f.w, s.x, s.y, s.z, s.w, l.x, l.y, l.z, w.x, w.y, w.z, first, second];
        scatter(numbers, rows_mut(bodies, |record| &mut record[PLAIN_LEN..]));
    }

    /// Somebody changed the angular velocity at the orientation `rotation`.
    #[inline(always)]
    fn take_in(&mut self, rotation: WideRotation<W>, angvel: WideAngVector<W>) {
        let (to_world, moments) = (rotation.times(self.frame), self.inv_moments);
        let change = to_world.conjugate().rotate_unscaled(angvel - self.angvel);
        let change = WideVector {
            x: change.x / moments.x,
            y: change.y / moments.y,
            z: change.z / moments.z,
        };
        self.momentum = self.momentum + to_world.rotate_unscaled(change);
    }

    /// The angular velocity at the orientation `rotation`.
    #[inline(always)]
    fn turn_to(&mut self, rotation: WideRotation<W>) -> WideAngVector<W> {
        let to_world = rotation.times(self.frame);
        let momentum = to_world.conjugate().rotate_unscaled(self.momentum);
        self.angvel = to_world.rotate_unscaled(momentum.component_mul(self.inv_moments));
        self.angvel
    }

    /// The angular velocity in the middle of a substep of `h` seconds that begins with `angvel`.
    #[inline(always)]
    fn velocity_at_middle(
        &mut self,
        rotation: WideRotation<W>,
        angvel: WideAngVector<W>,
        h: W,
    ) -> WideAngVector<W> {
        self.take_in(rotation, angvel);
        self.start = rotation;
        let middle = turned_frame(rotation, angvel * (h * W::splat(0.5)));
        self.turn_soundly(middle, angvel, h)
    }

    /// The angular velocity at the end of the substep, at the orientation `end`, if it is `angvel` in
    /// the middle.
    #[inline(always)]
    fn velocity_at_end(
        &mut self,
        end: WideRotation<W>,
        angvel: WideAngVector<W>,
        h: W,
    ) -> WideAngVector<W> {
        self.take_in(self.start, angvel);
        self.turn_soundly(end, angvel, h)
    }

    /// As [`Self::turn_to`], unless the angular velocity `before` would get much energy by that: then it stays, and the
    /// momentum is begun anew.
    #[inline(always)]
    fn turn_soundly(
        &mut self,
        rotation: WideRotation<W>,
        before: WideAngVector<W>,
        h: W,
    ) -> WideAngVector<W> {
        let turns_far = W::splat(FAR_TURN * FAR_TURN).lt(before.dot(before) * (h * h));
        let jump = W::select(turns_far, W::splat(JUMP_FAR), W::splat(JUMP));
        let most = self.momentum.dot(before) * jump;
        let turned = self.turn_to(rotation);
        let is_sound = self.momentum.dot(turned).le(most);
        self.momentum = WideVector::select(is_sound, self.momentum, WideVector::zero());
        self.angvel = WideVector::select(is_sound, turned, WideVector::zero());
        WideVector::select(is_sound, turned, before)
    }
}

#[inline(always)]
fn rotation_of<W: Wide>(own: &[W; PLAIN_LEN]) -> WideRotation<W> {
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
