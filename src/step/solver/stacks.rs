//! Stacks: how much stiffer than usual the contacts of an island must be so that it stands.
//!
//! A contact yields by a length `δ` for each body that it carries ([`Softness`](crate::model::params::Softness)):
//!
//! ```text
//! δ = 2 σ g h² / β        (2: the corners of a face between two cubes; 2.5 for squares)
//! ```
//!
//! With the default parameters that is 0.3 mm, whatever the size of the bodies. The lowest contact of a stack
//! of `L` layers yields by `L δ`. Each contact also yields freely by the allowed overlap `e`. Relative to its
//! bodies that is little for crates, and more than the thickness of a tile. Three errors follow from it. All
//! fall with the square of the number of substeps.
//!
//! *Sag.* A body carries `L/2` others on average. Its overlap with the next one, relative to its size `2t`,
//! has the mean `(L/2 δ + e) ⟨1/2t⟩`. Each of the two is kept below [`SAG_MAX`].
//!
//! *Lean.* The contacts of a layer with half width `a` resist a rotation with the stiffness `N m g/L (a² +
//! s²)/δ`. `N` bodies of mass `m` are in the island, and `s²` is the variance of their positions across the
//! narrow direction. The load tips the layer by the moment `N m g H` per angle, at a mean height `H` of the
//! bodies. The stiffness must be larger by [`LEAN_RATIO_MIN`], for the layers lean on top of each other, and
//! a stack on a slope loads one edge of its contacts:
//!
//! ```text
//! (a² + s²) / (L δ H)  >  32, in the plane 128
//! ```
//!
//! (Frozen anchors keep a level stack from buckling without that:
//! [`AnchorFrame`](crate::model::contact::AnchorFrame). On a slope or when pushed it creeps until it falls.)
//!
//! *Play.* Each layer may tilt by `e/2a` relative to the next. That moves the mass by `e t L²/6a = e L H/6a`,
//! which may be a twentieth of `a`:
//!
//! ```text
//! e L H / (a² + s²)  <  0.3
//! ```
//!
//! The number of layers is that of a stack of equal bodies with the same thickness and mean height: `L =
//! H/t`. It is computed from the bodies alone, not from contacts or impulses. Both change from step to step
//! even at rest, and with them the substeps would change and the stack would hop.
//!
//! Bodies that fall or fly are part of no stack ([`RESTING`]).
//!
//! A compliance that depends on the load was tried, and made stacks tremble (`softness`). An allowed overlap
//! proportional to the size of bodies was tried as well: falling piles of small bodies became livelier.

use crate::dim::contact::{CORNER_YIELD, LEAN_RATIO_MIN};
use crate::dim::mass::{SecondMoment, narrow_moment, second_moment};
use crate::dim::math::{DIM, Real, Vector, ang_length_squared};
use crate::model::body::RigidBody;
use crate::model::params::{CONTACT_COMPLIANCE, CONTACT_ERP_SCALE, IntegrationParameters};

/// Largest mean overlap of two bodies on each other, relative to the thickness of a body.
const SAG_MAX: Real = 0.01;
/// Largest `e L H / (a² + s²)`.
const PLAY_MAX: Real = 0.3;
/// Bodies are at rest up to a kinetic energy of half this fraction of `m g t`: cubes of 1 m up to 0.3 m/s.
/// With 0.1, elastic balls got other substeps at the top of their bounces, and gained energy.
const RESTING: Real = 0.02;

/// How far contacts give way with the usual substeps.
#[derive(Copy, Clone, Debug)]
pub(super) struct Give {
    /// The yield `δ` per carried body (length).
    yielding: Real,
    /// The allowed overlap `e` (length).
    play: Real,
}

impl Give {
    /// For substeps of `h` seconds, whose contacts have the spring of substeps of `reference` seconds.
    ///
    /// Zero for parameters that do not correct overlap: no number of substeps makes these contacts stiff.
    pub fn new(params: &IntegrationParameters, gravity: Real, h: Real, reference: Real) -> Self {
        let fraction = params.erp * CONTACT_ERP_SCALE;
        if fraction > 0.0 {
            let force = CORNER_YIELD * CONTACT_COMPLIANCE * gravity;
            let yielding = force * reference * reference / fraction;
            Self { yielding, play: params.allowed_error(h) }
        } else {
            Self { yielding: 0.0, play: 0.0 }
        }
    }
}

/// The bodies of an island as a stack.
#[derive(Copy, Clone, Debug)]
pub(super) struct Stack {
    /// Number of bodies.
    count: Real,
    /// Mean height of the bodies above the lowest surface (length).
    height: Real,
    /// Mean of one over the bodies' thicknesses `2t` (1/length).
    inv_thickness: Real,
    /// `a² + s²` (length²).
    width_squared: Real,
    /// Length (s) of the substeps of the last step; zero if there was none.
    last_substep: Real,
}

/// What a stack depends on of a body, stored contiguously because it is read twice.
#[derive(Copy, Clone, Debug)]
pub(super) struct Member {
    center: Vector,
    linvel: Vector,
    /// Largest speed of a point about the centre of mass (length/s).
    spin: Real,
    /// `t` (length).
    thickness: Real,
    extent: Real,
    last_substep: Real,
}

impl Member {
    /// `None` for a body without thickness.
    pub fn of(body: &RigidBody) -> Option<Self> {
        let is_solid = body.thickness > 0.0 && body.thickness.is_finite();
        is_solid.then(|| Self {
            center: body.mprops.world_com,
            linvel: body.vels.linvel,
            spin: ang_length_squared(body.vels.angvel).sqrt() * body.extent,
            thickness: body.thickness,
            extent: body.extent,
            last_substep: body.substep,
        })
    }

    fn rests(&self, drift: Vector, gravity: Real) -> bool {
        let speed = (self.linvel - drift).length() + self.spin;
        speed * speed <= RESTING * gravity * self.thickness
    }
}

/// Sums over bodies, relative to the centre of the first.
struct Sums {
    count: Real,
    lowest: Real,
    heights: Real,
    inv_thicknesses: Real,
    widths_squared: Real,
    offsets: Vector,
    moment: SecondMoment,
}

impl Sums {
    /// Includes a body at this position.
    fn include(&mut self, body: &Member, position: Vector, up: Vector) {
        let height = position.dot(up);
        let offset = position - up * height;
        self.count += 1.0;
        self.lowest = self.lowest.min(height - body.thickness);
        self.heights += height;
        self.inv_thicknesses += 0.5 / body.thickness;
        // For cubes, the square of half the width.
        self.widths_squared += body.extent * body.extent / DIM as Real;
        self.offsets += offset;
        self.moment += second_moment(offset);
    }
}

impl Stack {
    /// The stack of those of these bodies that rest relative to their mean velocity; `None` for less than
    /// three. The unit vector `up` is opposite to gravity.
    pub fn of(members: &[Member], gravity: Real, up: Vector) -> Option<Self> {
        debug_assert!((up.length() - 1.0).abs() < 1.0e-3 && gravity > 0.0);
        let velocities = members.iter().fold(Vector::ZERO, |sum, body| sum + body.linvel);
        let drift = velocities / (members.len() as Real).max(1.0);
        let mut resting = members.iter().filter(|body| body.rests(drift, gravity));
        let first = resting.next()?;
        let mut sums = Sums {
            count: 0.0,
            lowest: Real::INFINITY,
            heights: 0.0,
            inv_thicknesses: 0.0,
            widths_squared: 0.0,
            offsets: Vector::ZERO,
            moment: second_moment(Vector::ZERO),
        };
        sums.include(first, Vector::ZERO, up);
        for body in resting {
            sums.include(body, body.center - first.center, up);
        }
        (sums.count > 2.0).then(|| Self::new(&sums, first.last_substep))
    }

    fn new(sums: &Sums, last_substep: Real) -> Self {
        let share = 1.0 / sums.count;
        let variance = sums.moment * share - second_moment(sums.offsets * share);
        Self {
            count: sums.count,
            height: sums.heights * share - sums.lowest,
            inv_thickness: sums.inv_thicknesses * share,
            width_squared: sums.widths_squared * share + narrow_moment(variance),
            last_substep,
        }
    }

    /// Returns whether the stack needs more than `factor` times the usual substeps, which took `last_h`
    /// seconds in the last step.
    ///
    /// It keeps its substeps until half their stiffness is sufficient. Otherwise it could alternate between
    /// two numbers of substeps, and hop.
    pub fn is_soft(&self, factor: usize, give: Give, last_h: Real) -> bool {
        let (factor, stiffness) = (factor as Real, self.stiffness(give));
        let had_more = self.last_substep > 0.0 && self.last_substep * factor < 0.75 * last_h;
        stiffness > factor * factor || had_more && 2.0 * stiffness > factor * factor
    }

    /// The stiffness that contacts must have, relative to the usual one.
    fn stiffness(&self, Give { yielding, play }: Give) -> Real {
        let layers = (2.0 * self.height * self.inv_thickness).min(self.count);
        // Bodies of an island that are apart in the air are no taller than the stack that they would make.
        let height = 0.5 * layers / self.inv_thickness;
        let sag = (0.5 * layers * yielding).max(play) * self.inv_thickness / SAG_MAX;
        let slenderness = layers * height / self.width_squared;
        sag.max(slenderness * yielding * LEAN_RATIO_MIN).max(slenderness * play / PLAY_MAX)
    }
}
