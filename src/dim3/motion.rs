//! Free motion of bodies in 3D: a record of whole registers, and its integration lane by lane.
//!
//! # Gyroscopic motion
//! Between impulses a body keeps its angular momentum `L`, not its angular velocity: its inertia rotates with
//! it, and `ω = I⁻¹ L` changes. Its free orientation after a substep is known ([`FreeRotation`]), and so is
//! the mean angular velocity that leads there, by which the solver rotates the body.
//!
//! An impulse acts at the start of the substep: joints take their moment arms and inertias from there. A
//! change `Δω` of the mean velocity is therefore one of `L` by `I Δω` with the inertia of the beginning. With
//! that of the middle, thin limbs that hang from each other gain some per cent of their energy in ten
//! seconds.
//!
//! # Impulses on gyroscopic bodies
//! The pose of a pushed body differs from its free pose with the new momentum by an angle `δ` of second
//! order. With the same momentum, its energy is different there. The difference is large for thin bodies:
//! about `δ² A / C` for a rod with the moments `A` and `C ≪ A`. (Rods 27 times as long as thick landed with
//! up to 3000 times their energy.) Energy has priority, so the momentum is adjusted:
//!
//! * The momentum of thin bodies rotates by `δ`, so that relative to the body it equals that of free motion.
//!   A rod rotates about its middle and hardly about its axis, so the rotation is invisible.
//! * The momentum of other bodies is adjusted along the gradient of the energy, `ω`, by the necessary amount.
//!   A rotation by `δ` for each impulse of their support is wrong for these. A gyroscope at 40 rad/s and 30
//!   steps a second would precess by 8 % too slowly.
//!
//! The implicit Euler step of Catto, "Numerical Methods" (GDC 2015), is as stable but dissipates. Explicit
//! Euler, `ω ← ω - h I⁻¹ (ω × I ω)`, gains energy until it explodes. The velocity at the middle of the
//! substep cannot replace the mean one. With it, the energy of thin rods at 25 rad/s changes by half from
//! step to step.

use super::gyroscopic::FreeRotation;
use super::math::{AngVector, Real, Rotation, Vector, integrate_rotation};
use super::rotation_vector::{rotation_vector, turned_frame};
use super::state::WideMotion;
use super::wide::{WideAngVector, WideRotation, WideVector};
use crate::base::wide::{Kernel, Simd, Wide, gather_adjacent, scatter_adjacent};
use parry::mass_properties::MassProperties;

/// Least relative difference of two moments of inertia that counts.
const MOMENT_DIFFERENCE_MIN: Real = 1.0e-3;
/// Least rotation angle (rad) in a substep of a body with gyroscopic motion.
const ROTATION_ANGLE_MIN: Real = 1.0e-4;
/// A rotation in a substep of up to this angle (rad) is unambiguous.
const UNAMBIGUOUS_ANGLE_MAX: Real = 1.5;
/// Largest rotation angle (rad) in a substep at which the velocity at the midpoint is sufficient for bodies
/// that are not thin.
const MIDPOINT_ANGLE_MAX: Real = 0.1;
/// A body is thin if one of its moments of inertia is so many times another: a rod 8 times as long as thick.
const INERTIA_RATIO_MAX: Real = 30.0;
/// Largest fraction of the energy by which an adjustment of the momentum may change it.
const ENERGY_CHANGE_FRACTION_MAX: Real = 0.25;
/// Largest factor by which the energy of a momentum grows that keeps its direction.
const ENERGY_RATIO_MAX: Real = 4.0;

/// A body is uneven if the product of its squared rotation (rad²) in a step and the relative difference of
/// its moments of inertia exceeds this. A rod with moments of the ratio 30 then rotates by 0.03 rad.
const UNEVEN_ROTATION_MIN: Real = 0.025;
/// Rotations (rad) in a step that are too small for any body.
const UNEVEN_ANGLE_MIN: Real = 0.01;

/// Numbers in each part of a record.
const LEN: usize = 16;
/// Offsets in the first part, besides the damping at 10 and 11: rotation at 0, acceleration at 4.
const GYROSCOPIC_FLAG: usize = 12;
const INV_MOMENTS: usize = 13;
/// Offsets in the second part.
const FRAME: usize = 0;
const PILE_FLAG: usize = 14;
const JOINT_FLAG: usize = 15;

/// Data for the integration of a body; no constraint reads it.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct FreeMotion {
    /// Data of every body.
    plain: [Real; LEN],
    /// Data of gyroscopic bodies only.
    gyroscopic: [Real; LEN],
}

impl FreeMotion {
    /// Neither accelerates nor is damped.
    pub fn at_rest(rotation: Rotation) -> Self {
        Self::new(rotation, Vector::ZERO, AngVector::ZERO, [0.0; 2], true)
    }

    /// A body with this orientation, linear and angular acceleration by gravity and the user's forces
    /// (length/s², rad/s²), and linear and angular damping (1/s).
    ///
    /// `may_be_in_pile`: whether the body may be part or support of a pile. Gravity acts on its parts.
    pub fn new(
        rotation: Rotation,
        linear: Vector,
        angular: AngVector,
        damping: [Real; 2],
        may_be_in_pile: bool,
    ) -> Self {
        let (mut plain, mut gyroscopic) = ([0.0; LEN], [0.0; LEN]);
        plain[0..4].copy_from_slice(&rotation.to_array());
        plain[4..7].copy_from_slice(&linear.to_array());
        plain[7..10].copy_from_slice(&angular.to_array());
        plain[10..12].copy_from_slice(&damping);
        gyroscopic[PILE_FLAG] = if may_be_in_pile { 1.0 } else { 0.0 };
        Self { plain, gyroscopic }
    }

    /// Enables gyroscopic motion, unless the body is round, or hardly rotates in `h` seconds.
    pub fn with_gyroscope(mut self, mass: &MassProperties, angvel: AngVector, h: Real) -> Self {
        let inv_moments = mass.inv_principal_inertia;
        let (low, high) = (inv_moments.min_element(), inv_moments.max_element());
        let is_round = low <= 0.0 || high - low < MOMENT_DIFFERENCE_MIN * high;
        if !is_round && angvel.length_squared() * h * h >= ROTATION_ANGLE_MIN * ROTATION_ANGLE_MIN {
            self.plain[GYROSCOPIC_FLAG] = 1.0;
            self.plain[INV_MOMENTS..INV_MOMENTS + 3].copy_from_slice(&inv_moments.to_array());
            let frame = mass.principal_inertia_local_frame.to_array();
            self.gyroscopic[FRAME..FRAME + 4].copy_from_slice(&frame);
        }
        self
    }

    /// The current rotation of a gyroscopic body. For others, the rotation when the step began.
    pub fn rotation(&self) -> Rotation {
        Rotation::from_xyzw(self.plain[0], self.plain[1], self.plain[2], self.plain[3])
    }

    /// The acceleration by gravity and the user's forces (length/s²).
    pub fn linear_acceleration(&self) -> Vector {
        Vector::new(self.plain[4], self.plain[5], self.plain[6])
    }

    /// Returns whether the angular velocity changes as the body rotates.
    pub fn is_gyroscopic(&self) -> bool {
        self.plain[GYROSCOPIC_FLAG] != 0.0
    }

    /// Returns whether the body may be part or support of a pile.
    pub fn may_be_in_pile(&self) -> bool {
        self.gyroscopic[PILE_FLAG] != 0.0
    }

    /// Notes that directly solved joints hold the body.
    pub fn note_joint(&mut self) {
        self.gyroscopic[JOINT_FLAG] = 1.0;
    }

    /// Rotates a gyroscopic body by this rotation vector.
    pub fn rotate(&mut self, rotvec: AngVector) {
        if self.is_gyroscopic() {
            let turned = integrate_rotation(self.rotation(), rotvec);
            self.plain[0..4].copy_from_slice(&turned.to_array());
        }
    }
}

/// Returns whether the inertia of a free body in world space changes much in a step of `step` seconds that
/// begins with this angular velocity.
pub(crate) fn is_uneven(mass: &MassProperties, angvel: AngVector, step: Real) -> bool {
    let inv_moments = mass.inv_principal_inertia;
    let (low, high) = (inv_moments.min_element(), inv_moments.max_element());
    let square = angvel.length_squared() * (step * step);
    low > 0.0
        && square > UNEVEN_ANGLE_MIN * UNEVEN_ANGLE_MIN
        && square * (high / low - 1.0) > UNEVEN_ROTATION_MIN
}

/// The velocities of up to `LANES` bodies after `h` seconds, if these are theirs and nothing holds them.
#[inline(always)]
pub(crate) fn accelerated<W: Wide>(
    bodies: &mut [FreeMotion],
    WideMotion { linear, angular }: WideMotion<W>,
    h: Real,
) -> WideMotion<W> {
    let own = gather_adjacent::<W, _, LEN>(bodies, |body| &body.plain);
    let (one, substep) = (W::splat(1.0), W::splat(h));
    let linear_acceleration = WideVector { x: own[4], y: own[5], z: own[6] };
    let angular_acceleration = WideVector { x: own[7], y: own[8], z: own[9] };
    // Damping is integrated implicitly: v' = v + h a - h c v' never overshoots zero.
    let linear = (linear + linear_acceleration * substep) * (one / (one + substep * own[10]));
    let mut angular =
        (angular + angular_acceleration * substep) * (one / (one + substep * own[11]));
    if bodies.iter().any(FreeMotion::is_gyroscopic) {
        let rotation = rotation_of(&own);
        let mut gyroscope = Gyroscope::gather(bodies, &own);
        let mean = gyroscope.free_mean_velocity(rotation, angular, substep);
        angular = WideVector::select(W::zero().lt(own[GYROSCOPIC_FLAG]), mean, angular);
        gyroscope.scatter(bodies);
    }
    WideMotion { linear, angular }
}

/// The angular velocities of up to `LANES` bodies without the torques of a substep of `h` seconds: those of
/// its `start`, except for gyroscopic bodies, which rotate with the mean of the substep.
///
/// The change of a gyroscopic body is no work of a force. Impacts that took it for one, and aimed at the
/// energy of a fall, made bars that bounce in a closed box 900 times as fast in five minutes.
#[inline(always)]
pub(crate) fn without_forces<W: Wide>(
    bodies: &[FreeMotion],
    start: WideAngVector<W>,
    free: WideAngVector<W>,
    h: Real,
) -> WideAngVector<W> {
    if !bodies.iter().any(FreeMotion::is_gyroscopic) {
        return start;
    }
    let own = gather_adjacent::<W, _, LEN>(bodies, |body| &body.plain);
    let torque = WideVector { x: own[7], y: own[8], z: own[9] };
    WideVector::select(W::zero().lt(own[GYROSCOPIC_FLAG]), free - torque * W::splat(h), start)
}

/// Rotates up to `LANES` gyroscopic bodies by `h` times their angular velocity, and updates the velocity
/// for their rotated inertia.
///
/// The velocity change is no impulse: the next substep must not start with it, nor with its rounding error.
/// Without an impulse, the velocity `before` any becomes the new one to the last bit.
#[inline(always)]
pub(crate) fn gyroscopic<W: Wide>(
    bodies: &mut [FreeMotion],
    velocity: &mut WideAngVector<W>,
    before: &mut WideAngVector<W>,
    h: Real,
) {
    let mut own = gather_adjacent::<W, _, LEN>(bodies, |body| &body.plain);
    let mut gyroscope = Gyroscope::gather(bodies, &own);
    let (w, end) = (*velocity, turned_frame(rotation_of(&own), *velocity * W::splat(h)));
    let at_end = gyroscope.velocity_at_end(end, w, W::splat(h));
    let is_gyroscopic = W::zero().lt(own[GYROSCOPIC_FLAG]);
    *velocity = WideVector::select(is_gyroscopic, at_end, w);
    *before = WideVector::select(is_gyroscopic, at_end - (w - *before), *before);
    let turned = [end.x, end.y, end.z, end.w];
    for k in 0..4 {
        own[k] = W::select(is_gyroscopic, turned[k], own[k]);
    }
    scatter_adjacent(own, bodies, |body| &mut body.plain);
    gyroscope.scatter(bodies);
}

/// The angular velocity of one body after free rotation for `h` seconds, which may be negative.
pub(crate) fn angvel_after(
    mass: &MassProperties,
    rotation: Rotation,
    angvel: AngVector,
    h: Real,
) -> AngVector {
    rotated_freely(mass, rotation, angvel, h).1
}

/// The angular velocity of one body `h` seconds before (which may be negative), rotated to `there`: the
/// body-relative velocity of free motion.
pub(crate) fn angvel_at(
    mass: &MassProperties,
    (rotation, there): (Rotation, Rotation),
    angvel: AngVector,
    h: Real,
) -> AngVector {
    let (reached, angvel) = rotated_freely(mass, rotation, angvel, h);
    there * (reached.inverse() * angvel)
}

/// The rotation of one body after free rotation for `h` seconds, and its angular velocity.
fn rotated_freely(
    mass: &MassProperties,
    rotation: Rotation,
    angvel: AngVector,
    h: Real,
) -> (Rotation, AngVector) {
    let body = FreeMotion::at_rest(rotation).with_gyroscope(mass, angvel, h);
    if body.is_gyroscopic() {
        Simd::baseline().run(RotateFreely { body, angvel, h })
    } else {
        (integrate_rotation(rotation, angvel * h), angvel)
    }
}

/// One body that rotates for some time.
struct RotateFreely {
    body: FreeMotion,
    angvel: AngVector,
    h: Real,
}

impl Kernel for RotateFreely {
    type Output = (Rotation, AngVector);

    #[inline(always)]
    fn run<W: Wide>(self) -> (Rotation, AngVector) {
        let (bodies, angular) = (&mut [self.body], WideVector::splat(self.angvel));
        let start = WideMotion { linear: WideVector::zero(), angular };
        let mut velocity = accelerated::<W>(bodies, start, self.h).angular;
        let mut before = velocity;
        gyroscopic(bodies, &mut velocity, &mut before, self.h);
        let mut lanes = WideVector::ZERO;
        velocity.store(&mut lanes);
        (bodies[0].rotation().normalize(), lanes.lane(0))
    }
}

/// Data of gyroscopic motion.
struct Gyroscope<W> {
    inv_moments: WideVector<W>,
    frame: WideRotation<W>,
    /// Orientation at the beginning of the substep, where the solver's impulses act.
    start: WideRotation<W>,
    /// The angular momentum. It is carried from substep to substep rather than computed from the velocity.
    /// The rounding error of the latter is biased, and 240 steps a second in `f32` turned it into 5 % of the
    /// energy in a minute.
    momentum: WideAngVector<W>,
    /// The angular velocity that goes with it.
    angvel: WideAngVector<W>,
    /// Whether the body may be in a pile, and whether joints hold the body.
    flags: [W; 2],
}

impl<W: Wide> Gyroscope<W> {
    #[inline(always)]
    fn gather(bodies: &[FreeMotion], own: &[W; LEN]) -> Self {
        let s = gather_adjacent::<W, _, LEN>(bodies, |body| &body.gyroscopic);
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
            flags: [s[PILE_FLAG], s[JOINT_FLAG]],
        }
    }

    #[inline(always)]
    fn scatter(self, bodies: &mut [FreeMotion]) {
        let (f, s, l, w) = (self.frame, self.start, self.momentum, self.angvel);
        let [in_pile, jointed] = self.flags;
        let numbers = [
            f.x, f.y, f.z, f.w, s.x, s.y, s.z, s.w, l.x, l.y, l.z, w.x, w.y, w.z, in_pile, jointed,
        ];
        scatter_adjacent(numbers, bodies, |body| &mut body.gyroscopic);
    }

    /// The angular velocity was changed at the orientation `rotation`.
    #[inline(always)]
    fn load(&mut self, rotation: WideRotation<W>, angvel: WideAngVector<W>) {
        let (to_world, moments) = (rotation.times(self.frame), self.inv_moments);
        let change = to_world.conjugate().rotate_unscaled(angvel - self.angvel);
        let change = WideVector {
            x: change.x / moments.x,
            y: change.y / moments.y,
            z: change.z / moments.z,
        };
        self.momentum = self.momentum + to_world.rotate_unscaled(change);
    }

    /// The mean angular velocity of a substep of `h` seconds that begins with `angvel`, if nothing holds the
    /// body. If the rotation is so large that its turns are ambiguous, the initial velocity is used.
    ///
    /// For small rotations of bodies that are not thin, the velocity of the middle is sufficient. Its
    /// orientation is the one that the initial velocity reaches by then.
    #[inline(always)]
    fn free_mean_velocity(
        &mut self,
        rotation: WideRotation<W>,
        angvel: WideAngVector<W>,
        h: W,
    ) -> WideAngVector<W> {
        self.load(rotation, angvel);
        self.start = rotation;
        let middle = turned_frame(rotation, angvel * (h * W::splat(0.5)));
        let (to_world, momentum) = self.seen_from(middle);
        self.angvel = to_world.rotate_unscaled(momentum.component_mul(self.inv_moments));
        let is_far =
            W::splat(MIDPOINT_ANGLE_MAX * MIDPOINT_ANGLE_MAX).lt(angvel.dot(angvel) * (h * h));
        let needs_mean = is_far | self.is_thin();
        if W::any(needs_mean) {
            let (to_world, momentum) = self.seen_from(rotation);
            let rotvec = rotation_vector(FreeRotation::new(self.inv_moments, momentum, h).rotation);
            let mean = to_world.rotate_unscaled(rotvec) * (W::splat(1.0) / h);
            let mean = WideVector::select(is_unambiguous(angvel, h), mean, angvel);
            self.angvel = WideVector::select(needs_mean, mean, self.angvel);
        }
        self.angvel
    }

    /// The angular velocity at the end of the substep, at the orientation `end`, if the body turned there
    /// with `angvel`.
    #[inline(always)]
    fn velocity_at_end(
        &mut self,
        end: WideRotation<W>,
        angvel: WideAngVector<W>,
        h: W,
    ) -> WideAngVector<W> {
        let (change, unambiguous) = (angvel - self.angvel, is_unambiguous(angvel, h));
        let is_free = change.dot(change).le(W::zero()) & unambiguous;
        let lag = self.work_of_lag(change);
        self.load(self.start, angvel);
        let energy = (self.energy(self.seen_from(self.start).1) + lag).max(W::zero());
        let led = self.led_to(end, unambiguous, h, energy);
        self.momentum = WideVector::select(is_free, self.momentum, led);
        let (to_world, momentum) = self.seen_from(end);
        self.angvel = to_world.rotate_unscaled(momentum.component_mul(self.inv_moments));
        self.angvel
    }

    /// The work of impulses that change the mean angular velocity `ω` of a substep is `Δω·I (ω + Δω/2)`.
    /// Constraints are solved for that. The energy of the momentum grows by as much with the velocity at
    /// the start. Returns the difference: `Δω·I (ω - ω₀)`.
    ///
    /// A joint holds the velocities at the start, on which its impulses do no work. With the difference,
    /// thrown chains of thin rods gain energy twice as often. So the difference is 0 for bodies of directly
    /// solved joints.
    #[inline(always)]
    fn work_of_lag(&self, change: WideAngVector<W>) -> W {
        let (to_world, momentum) = self.seen_from(self.start);
        let [change, mean] = [change, self.angvel].map(|v| to_world.conjugate().rotate_unscaled(v));
        let (m, lag) = (self.inv_moments, mean - momentum.component_mul(self.inv_moments));
        let work = change.x * lag.x / m.x + change.y * lag.y / m.y + change.z * lag.z / m.z;
        work * (W::splat(1.0) - self.flags[1])
    }

    /// The angular momentum with which a body that was led to the orientation `end` has this energy. For an
    /// ambiguous or too large rotation, the velocity stays constant relative to the body, but for its length.
    #[inline(always)]
    fn led_to(&self, end: WideRotation<W>, unambiguous: W::Mask, h: W, energy: W) -> WideVector<W> {
        let (_, start) = self.seen_from(self.start);
        // Subtracts the excess energy: E(m - s ω) = E(m) - s ω·ω + s² E(ω).
        let (to_world, kept) = self.seen_from(end);
        let slope = kept.component_mul(self.inv_moments);
        let (steepness, curvature) = (slope.dot(slope), self.energy(slope));
        let excess = self.energy(kept) - energy;
        let square = steepness * steepness - (curvature + curvature) * (excess + excess);
        let root = steepness + square.max(W::zero()).sqrt();
        let away = (excess + excess) / root.max(W::splat(Real::MIN_POSITIVE));
        let is_near = excess.abs().le(energy * W::splat(ENERGY_CHANGE_FRACTION_MAX));
        let follows = is_near & W::zero().le(square);
        // Other momenta keep their direction. A momentum of almost 0 has no direction, and loses this energy.
        let ratio = energy / self.energy(start).max(W::splat(Real::MIN_POSITIVE));
        let scale = ratio.min(W::splat(ENERGY_RATIO_MAX)).sqrt();
        let mut momentum = WideVector::select(follows, kept - slope * away, start * scale);
        let is_thin = self.is_thin();
        if W::any(is_thin) {
            let free = FreeRotation::new(self.inv_moments, start, h).momentum;
            momentum = WideVector::select(is_thin, free * scale, momentum);
        }
        to_world.rotate_unscaled(WideVector::select(unambiguous, momentum, start * scale))
    }

    #[inline(always)]
    fn is_thin(&self) -> W::Mask {
        let WideVector { x, y, z } = self.inv_moments;
        (x.min(y).min(z) * W::splat(INERTIA_RATIO_MAX)).lt(x.max(y).max(z))
    }

    /// The kinetic energy of rotation with an angular momentum, in the frame of the principal axes.
    #[inline(always)]
    fn energy(&self, momentum: WideVector<W>) -> W {
        momentum.dot(momentum.component_mul(self.inv_moments)) * W::splat(0.5)
    }

    /// The principal axes at the orientation `rotation`, and the angular momentum in their frame.
    #[inline(always)]
    fn seen_from(&self, rotation: WideRotation<W>) -> (WideRotation<W>, WideVector<W>) {
        let to_world = rotation.times(self.frame);
        (to_world, to_world.conjugate().rotate_unscaled(self.momentum))
    }
}

/// Returns whether the rotation in `h` seconds is small enough to be unambiguous.
#[inline(always)]
fn is_unambiguous<W: Wide>(angvel: WideAngVector<W>, h: W) -> W::Mask {
    (angvel.dot(angvel) * (h * h)).le(W::splat(UNAMBIGUOUS_ANGLE_MAX * UNAMBIGUOUS_ANGLE_MAX))
}

#[inline(always)]
fn rotation_of<W: Wide>(own: &[W; LEN]) -> WideRotation<W> {
    WideRotation { x: own[0], y: own[1], z: own[2], w: own[3] }
}
