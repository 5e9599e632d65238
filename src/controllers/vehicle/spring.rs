//! The suspension as a row: a spring and a damper that only push, integrated implicitly.
//!
//! A suspension of the length L points along the unit vector d from the hard point to the ground, whose
//! normal is n. The ground is compliant along n only. If the chassis moves with v at the contact (relative to
//! the ground),
//!
//! ```text
//! compression   x = L₀ − L,    ẋ = −vₙ / cosφ,    vₙ = n·v,    cosφ = −n·d
//! force         F = k x + c ẋ   along d,          0 ≤ F ≤ Fₘₐₓ
//! ```
//!
//! and by virtual work the ground presses with N = F / cosφ along n. (Near a right angle of φ, cosφ is
//! limited to [`COSINE_MIN`]: the wheel scrapes along a wall.)
//!
//! **Over a step.** From beginning (₀) to end (₁) the force is to be that of a moment in between,
//!
//! ```text
//! F = k (x₀ + α dt ẋ₀ + β dt (ẋ₁ − ẋ₀)) + c (ẋ₀ + γ (ẋ₁ − ẋ₀))
//! ```
//!
//! The means of a motion with constant acceleration are α = γ = ½, β = ⅙. The order is two, so a soft spring
//! oscillates with its own frequency and damping at any rate. But such a scheme explodes on stiff springs.
//! With α = β = γ = 1 it is implicit Euler, which is always stable and damps every oscillation. The method
//! interpolates from one to the other by the stiffness of the spring for this step. (Exponential fitting:
//! Werner Liniger, Ralph Willoughby, "Efficient integration methods for stiff systems of ordinary
//! differential equations", SIAM J. Numer. Anal. 1970. Here it uses rational functions with the same limits.)
//! With q = dt² k w and r = dt c w, w the inverse mass of the row,
//!
//! ```text
//! t = q / (q + 4)     α = ½ + ½ t     β = ⅙ + ⅚ t     γ = ½ + ½ r / (r + 6)
//! ```
//!
//! The oscillation decays: the largest eigenvalue of the step is below 1. This holds for one mass, impulses
//! in 1 to 32 substeps, q up to 10⁶ and r up to 10⁵. It also decays if w is wrong by a factor of four, as it
//! is for a car on four wheels. At 60 Hz a swing of 1.5 Hz has its frequency to 0.02 % and its damping ratio
//! to 0.01.
//!
//! **Before it touches.** A wheel above the ground by less than the possible motion of the step has a row
//! with its negative compression. The row acts only if the wheel arrives. A row that starts after penetration
//! would start with a compressed stiff spring, and the wheel would hop for ever.
//!
//! As an impulse λ = dt N, with ẋ₁ = −v₁ / cosφ:  λ = b − G v₁, where
//!
//! ```text
//! G = dt (β dt k + γ c) / cos²φ
//! b = dt (k x₀ + ((α − β) dt k + (1 − γ) c) ẋ₀) / cosφ
//! ```

use super::contact::Vehicle;
use super::wheel::{Below, Wheel};
use crate::dim::math::Real;

/// Minimum cosine of the angle between suspension and normal in the equations.
const COSINE_MIN: Real = 0.1;

/// The impulse λ of a suspension on its contact, as a function of the velocity v along the normal at the end
/// of the step. It is `λ = bias − softness · v`, from 0 to `limit`.
#[derive(Copy, Clone, Debug)]
pub(super) struct Spring {
    bias: Real,
    softness: Real,
    limit: Real,
    /// From the impulse to the force along the suspension.
    pub force_of_impulse: Real,
}

impl Spring {
    /// The suspension of a wheel with something below it. The `velocities` are those of the chassis relative
    /// to the ground along the normal: now, and at the end of the step without wheel forces. `inv_mass` is
    /// that of the row. `None` if the wheel will not touch the ground.
    pub fn new(
        wheel: &Wheel,
        below: &Below,
        velocities: [Real; 2],
        inv_mass: Real,
        vehicle: &Vehicle,
    ) -> Option<Self> {
        let (dt, mass) = (vehicle.dt, vehicle.mass);
        let cosine = (-below.normal.dot(wheel.suspension_ws)).max(COSINE_MIN);
        let [closing, closing_later] = velocities.map(|velocity| -velocity / cosine);
        let touching = fraction_of_step(below.compression, closing_later * dt)?;
        let damping =
            if closing > 0.0 { wheel.damping_compression } else { wheel.damping_relaxation };
        let (k, c) = (wheel.suspension_stiffness * mass, damping * mass * touching);

        let w = inv_mass / (cosine * cosine);
        let (q, r) = (dt * dt * k * w, dt * c * w);
        let t = q / (q + 4.0);
        let (alpha, beta) = (0.5 + 0.5 * t, (1.0 + 5.0 * t) / 6.0);
        let gamma = 0.5 + 0.5 * r / (r + 6.0);

        let of_closing = (alpha - beta) * dt * k + (1.0 - gamma) * c;
        Some(Self {
            bias: dt * (k * below.compression + of_closing * closing) / cosine,
            softness: dt * (beta * dt * k + gamma * c) / (cosine * cosine),
            limit: wheel.max_suspension_force * dt / cosine,
            force_of_impulse: cosine / dt,
        })
    }

    /// The impulse in place of `impulse`, at which the velocity is `velocity` and which changes it by
    /// `inv_mass` each unit.
    pub fn solve(&self, impulse: Real, velocity: Real, inv_mass: Real) -> Real {
        let Self { bias, softness, limit, .. } = *self;
        let free = velocity - inv_mass * impulse;
        let target = (bias - softness * free) / (1.0 + softness * inv_mass);
        if target.is_finite() { target.clamp(0.0, limit) } else { 0.0 }
    }
}

/// The fraction of the step in which the wheel touches the ground, if the compression grows by `closing` in
/// it. A damper acts on the ground only. `None` if the wheel does not get there.
fn fraction_of_step(compression: Real, closing: Real) -> Option<Real> {
    if compression >= 0.0 {
        return Some(1.0);
    }
    let end = compression + closing;
    (end > 0.0).then(|| end / closing)
}
