//! How a body turns that nothing holds, lane by lane: only in 3D is there anything to it.
//!
//! # Equation
//! In the axes of the body, along its principal axes, the angular momentum `m` obeys Euler's equations `ṁ = m × D m`, with `D`
//! the inverse moments `d₁, d₂, d₃`, and the body turns at `ω = D m`. They conserve the energy `½ m·Dm`, and the momentum
//! in the axes of the world.
//!
//! # Method
//! The energy is split into parts whose motions are turns about a fixed axis, known exactly:
//!
//! ```text
//! ½ m·Dm = ½ d₂ |m|² + ½ a m₁² + ½ b m₃²        a = d₁ - d₂,  b = d₃ - d₂
//! ```
//!
//! The first turns the body at the rate `d₂ |m|` about its angular momentum, and commutes with the others: that turn is
//! made once, as a whole. The second turns it about its own first axis by the angle `a m₁ t`, the third about its own third axis by
//! `b m₃ t`. Half of the second, the third, and the other half of the second are a substep. Each of these turns leaves
//! the angular momentum where it is in the world, whatever its angle. The method is of second order, reversible
//! and symplectic, so what is missing of the energy goes up and down and does not grow. Of a symmetric body it is exact.
//!
//! Which axis is the second is free: with the middle moment of inertia `a b`, to which the error is in proportion, is smallest.
//!
//! # Pieces
//! The error is of second order in
//!
//! ```text
//! ρ² t² = (a² m₁² + b² m₃² + |ab| m₂² + |ab| |m|²) t²
//! ```
//!
//! The first three terms are the sum of the squares of the largest angles by which the body can turn about its two axes on its
//! way (they follow from energy and momentum); the last is what stability asks for: the faster of two turns is one of the
//! other's axis. All are constant on the way. In 4000 random bodies, from nearly round to boards and rods a hundred
//! times as long as thin, the energy went up and down by 0.6 % at most for `ρ t = ½`, 0.1 % on average, and by a quarter of that for half
//! of it; from 1.5 on there are resonances. So a substep in which `ρ t` is more than ½ rad is
//! cut in two, four or eight pieces. Bodies turn by 0.8 rad in such a piece, on average. Who is too fast for eight is turned by eight
//! that are too short, halved until they are small enough: its energy and its momentum are right, and by what angle a body is turned
//! that turns by radians from one look at it to the next nobody sees. (Pieces as long as the `ρ` of the moment allows would be
//! longer or shorter as the energy goes up and down; then it drifts.)
//!
//! # Alternatives
//! Explicit midpoint steps of the angular velocity keep `L` as well, but beyond a tenth of a radian their energy may be
//! many times the true one. The implicit Euler step of Catto, "Numerical Methods" (GDC 2015), is stable but dissipates. The exact solution
//! (van Zon & Schofield, "Numerical implementation of the exact dynamics of free rigid bodies", 2007) needs elliptic functions and
//! their inverses, whose series converge the more slowly the nearer a body is to turning about its middle axis.
//!
//! Sources: McLachlan, "Explicit Lie-Poisson integration and the Euler equations" (1993); Touma & Wisdom, "Lie-Poisson integrators for
//! rigid body dynamics in the solar system" (1994); Fassò, "Comparison of splitting algorithms for the rigid body" (2003), who
//! compares the ways to split.

use super::math::Real;
use super::turn::quaternion;
use super::wide::{WideAngVector, WideRotation, WideVector};
use crate::base::turning::wide_cosine_and_sine;
use crate::base::wide::Wide;

/// The largest `ρ t` of a piece (rad).
const PIECE: Real = 0.5;
/// How many pieces a substep has at most.
const PIECES: Real = 8.0;

/// How the principal axes of a body turn in `h` seconds, as seen from where they stood before: `momentum` is given along
/// these, and the second is the one with the middle moment.
#[inline(always)]
pub(crate) fn free_turn<W: Wide>(
    inv_moments: WideVector<W>,
    momentum: WideAngVector<W>,
    h: Real,
) -> WideRotation<W> {
    let [a, b] = [inv_moments.x - inv_moments.y, inv_moments.z - inv_moments.y];
    let (time, count) = pieces([a, b], momentum, h);
    let (real, u) = quaternion(momentum * (inv_moments.y * (time * count)));
    let turned = WideRotation { x: u.x, y: u.y, z: u.z, w: real };
    let angles = [a * (time * W::splat(0.5)), b * time];
    let (mut m, mut turned) = piece(angles, momentum, turned);
    let mut done = W::splat(1.0);
    while W::any(done.lt(count)) {
        let (next, further) = piece(angles, m, turned);
        // Whoever has arrived stays, to the last bit.
        let goes_on = done.lt(count);
        m = WideVector::select(goes_on, next, m);
        turned = WideRotation::select(goes_on, further, turned);
        done = done + W::splat(1.0);
    }
    turned
}

/// How long a piece takes, and how many a substep has.
#[inline(always)]
fn pieces<W: Wide>([a, b]: [W; 2], m: WideAngVector<W>, h: Real) -> (W, W) {
    // No product of these is negative: `a` and `b` have different signs.
    let about_second = a * b * (m.y * m.y);
    let rate_squared = (a - b) * (a * (m.x * m.x) - b * (m.z * m.z)) - about_second - about_second;
    let (mut time, mut count) = (W::splat(h), W::splat(1.0));
    let is_long = |time: W| W::splat(PIECE * PIECE).lt(rate_squared * (time * time));
    while W::any(is_long(time)) {
        let halved = is_long(time);
        let doubled = (count + count).min(W::splat(PIECES));
        time = W::select(halved, time * W::splat(0.5), time);
        count = W::select(halved, doubled, count);
    }
    (time, count)
}

/// The angular momentum along the body's axes and how these are turned, after a further piece. It takes the angles by which the body turns
/// about its first axis in half a piece, and about its third in a whole one, per momentum about them.
#[inline(always)]
fn piece<W: Wide>(
    [first, third]: [W; 2],
    m: WideAngVector<W>,
    turned: WideRotation<W>,
) -> (WideAngVector<W>, WideRotation<W>) {
    let (m, turned) = about_first(first * m.x, m, turned);
    let (m, turned) = about_third(third * m.z, m, turned);
    about_first(first * m.x, m, turned)
}

#[inline(always)]
fn about_first<W: Wide>(
    angle: W,
    m: WideAngVector<W>,
    q: WideRotation<W>,
) -> (WideAngVector<W>, WideRotation<W>) {
    let (c, s) = half_angle(angle);
    let (y, z) = turned_back([c, s], [m.y, m.z]);
    let turned = WideRotation {
        x: q.x * c + q.w * s,
        y: q.y * c + q.z * s,
        z: q.z * c - q.y * s,
        w: q.w * c - q.x * s,
    };
    (WideVector { x: m.x, y, z }, turned)
}

#[inline(always)]
fn about_third<W: Wide>(
    angle: W,
    m: WideAngVector<W>,
    q: WideRotation<W>,
) -> (WideAngVector<W>, WideRotation<W>) {
    let (c, s) = half_angle(angle);
    let (x, y) = turned_back([c, s], [m.x, m.y]);
    let turned = WideRotation {
        x: q.x * c + q.y * s,
        y: q.y * c - q.x * s,
        z: q.z * c + q.w * s,
        w: q.w * c - q.z * s,
    };
    (WideVector { x, y, z: m.z }, turned)
}

/// Cosine and sine of half an angle of up to about [`PIECE`], which is an eighth of four times that.
#[inline(always)]
fn half_angle<W: Wide>(angle: W) -> (W, W) {
    let four_times = angle * W::splat(4.0);
    let (cosine, sine) = wide_cosine_and_sine::<W, 0>(four_times * four_times);
    (cosine, sine * four_times)
}

/// Two components of what stands still, seen from axes that turn by an angle with this cosine and sine of its half.
#[inline(always)]
fn turned_back<W: Wide>([c, s]: [W; 2], [first, second]: [W; 2]) -> (W, W) {
    let (cosine, half_sine) = (c * c - s * s, c * s);
    let sine = half_sine + half_sine;
    (first * cosine + second * sine, second * cosine - first * sine)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::random::Random;
    use crate::base::wide::{Kernel, LANES, Lane, Simd};
    use crate::dim3::math::{Rotation, Vector};

    /// A body per lane, turned `times` in succession.
    struct Turning {
        inv_moments: WideVector<Lane>,
        momentum: WideVector<Lane>,
        axes: WideRotation<Lane>,
        h: Real,
        times: usize,
    }

    impl Kernel for &mut Turning {
        type Output = ();
        #[inline(always)]
        fn run<W: Wide>(self) {
            let momentum = WideVector::<W>::load(&self.momentum);
            let inv_moments = WideVector::load(&self.inv_moments);
            let mut axes = WideRotation::<W>::load(&self.axes);
            for _ in 0..self.times {
                let seen = axes.conjugate().rotate_unscaled(momentum);
                axes = axes.times(free_turn(inv_moments, seen, self.h)).normalized();
            }
            axes.x.store(&mut self.axes.x);
            axes.y.store(&mut self.axes.y);
            axes.z.store(&mut self.axes.z);
            axes.w.store(&mut self.axes.w);
        }
    }

    /// Different bodies that turn for a second at up to this rate (rad/s), the slower the later their lane: all of them, or one.
    fn turned(rate: Real, times: usize, only: Option<usize>) -> [Rotation; LANES] {
        let (zero, axes) = (WideVector::ZERO, WideRotation::IDENTITY);
        let h = 1.0 / times as Real;
        let mut turning = Turning { inv_moments: zero, momentum: zero, axes, h, times };
        let mut random = Random(7);
        for lane in 0..LANES {
            let first = random.within(0.2, 0.9);
            let spin = Vector::from_array([0; 3].map(|_| random.within(-1.0, 1.0)));
            if only.is_none_or(|only| only == lane) {
                let inv_moments = Vector::new(1.0 / first, 1.0, 1.0 / (first + 0.9));
                turning.inv_moments.set_lane(lane, inv_moments);
                turning.momentum.set_lane(lane, spin * (rate / (1 + lane) as Real));
            }
        }
        Simd::detect().run(&mut turning);
        let WideRotation { x, y, z, w } = &turning.axes;
        core::array::from_fn(|lane| Rotation::from_xyzw(x.0[lane], y.0[lane], z.0[lane], w.0[lane]))
    }

    /// The largest angle between them, if it is small: quaternions differ by half of it.
    fn largest_difference(some: [Rotation; LANES], others: [Rotation; LANES]) -> Real {
        let angle = |(a, b): (Rotation, Rotation)| {
            let [p, q] = [a, b].map(|q| q.to_array());
            let square = |sign: Real| -> Real {
                p.iter().zip(q).map(|(p, q)| (p - sign * q) * (p - sign * q)).sum()
            };
            2.0 * square(1.0).min(square(-1.0)).sqrt()
        };
        some.into_iter().zip(others).map(angle).fold(0.0, Real::max)
    }

    /// Half the step leaves a quarter of the error. (Fine steps come near enough to the truth; rounding of `f32` in 256 steps is
    /// some 3·10⁻⁵ rad.)
    #[test]
    fn bodies_arrive_where_they_would_to_second_order() {
        let truth = turned(4.0, 256, None);
        let [coarse, fine] =
            [8, 16].map(|times| largest_difference(turned(4.0, times, None), truth));
        assert!(coarse < 0.1 && coarse > 1.0e-3, "{coarse} rad");
        assert!((3.0..5.5).contains(&(coarse / fine)), "{coarse} rad, then {fine} rad");
    }

    /// Who turns fast is cut into pieces; its neighbours do not notice, to the last bit.
    #[test]
    fn bodies_do_not_depend_on_who_else_turns() {
        let all = turned(8.0, 4, None);
        for (lane, together) in all.into_iter().enumerate() {
            assert_eq!(turned(8.0, 4, Some(lane))[lane], together);
        }
    }
}
