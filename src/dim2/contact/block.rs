//! The memory of contact constraints: what goes in, and what the passes read and write.

use crate::base::wide::{LANES, Lane, Wide};
use crate::dim2::math::{MAX_MANIFOLD_POINTS, Real, Vector};
use crate::dim2::state::READ_ONLY;
use crate::dim2::wide::{WideSymmetric, WideVector};
use crate::model::contact::WidePlacement;

/// Pairs of different points of one manifold.
pub(crate) const COUPLINGS: usize = MAX_MANIFOLD_POINTS * (MAX_MANIFOLD_POINTS - 1) / 2;

/// What the solver is told of a block's manifolds, and what it tells back of where they are.
#[derive(Clone, Debug)]
pub(crate) struct ContactInput {
    /// Solver indices of the two bodies, with [`READ_ONLY`] where it applies.
    pub bodies: [[u32; LANES]; 2],
    /// One where the body is the world (a fixed body or none): it has no centre of mass.
    pub is_world: [Lane; 2],
    /// Factors on the inverse masses of the two bodies: zero where the other one is dominant.
    pub mass_factors: [Lane; 2],
    /// How the bodies stood when the contacts were placed.
    pub placement: WidePlacement,
    /// From the first centre of mass to the points as they were placed, in world space.
    pub levers: [WideVector<Lane>; MAX_MANIFOLD_POINTS],
    /// Separations of the points as they were placed.
    pub placed_separations: [Lane; MAX_MANIFOLD_POINTS],
    /// One for points that are there, zero for the others.
    pub present: [Lane; MAX_MANIFOLD_POINTS],
    /// Normal impulses with which to start.
    pub impulses: [Lane; MAX_MANIFOLD_POINTS],
    pub friction: Lane,
    pub restitution: Lane,
    /// Velocity of the second surface relative to the first, in world space.
    pub tangent_velocity: WideVector<Lane>,
    /// Friction impulse with which to start, in world space.
    pub friction_impulse: WideVector<Lane>,

    /// Out: the normal in world space.
    pub world_normal: WideVector<Lane>,
    /// Out: the points midway between the two surfaces, in world space.
    pub points: [WideVector<Lane>; MAX_MANIFOLD_POINTS],
    /// Out: their separations.
    pub separations: [Lane; MAX_MANIFOLD_POINTS],
}

impl ContactInput {
    /// No manifold in any lane. A lane that stays empty acts on the world alone, and not on that.
    pub const EMPTY: Self = {
        let vector = WideVector::ZERO;
        Self {
            bodies: [[READ_ONLY; LANES]; 2],
            is_world: [Lane::splat(1.0); 2],
            mass_factors: [Lane::ZERO; 2],
            placement: WidePlacement::NOWHERE,
            levers: [vector; MAX_MANIFOLD_POINTS],
            placed_separations: [Lane::ZERO; MAX_MANIFOLD_POINTS],
            present: [Lane::ZERO; MAX_MANIFOLD_POINTS],
            impulses: [Lane::ZERO; MAX_MANIFOLD_POINTS],
            friction: Lane::ZERO,
            restitution: Lane::ZERO,
            tangent_velocity: vector,
            friction_impulse: vector,
            world_normal: vector,
            points: [vector; MAX_MANIFOLD_POINTS],
            separations: [Lane::ZERO; MAX_MANIFOLD_POINTS],
        }
    };

    /// Nothing: there is no twist about a normal in the plane.
    pub fn set_twist_impulse(&mut self, _lane: usize, _impulse: Real) {}

    /// Nothing: points do not have friction of their own.
    pub fn set_tangent_impulse(&mut self, _point: usize, _lane: usize, _impulse: [Real; 1]) {}
}

/// One contact point of each lane. Absent points have no mass, so their impulse stays zero.
#[derive(Copy, Clone, Debug, Default)]
#[repr(C)]
pub(crate) struct PointRow {
    /// Tangential coordinate of the point in the contact frame, from the first centre of mass.
    pub x: Lane,
    /// Separation when the step began.
    pub separation: Lane,
    /// `1 / K_ii`.
    pub mass: Lane,
    /// Normal impulse of this substep.
    pub impulse: Lane,
}

impl PointRow {
    /// Where the point is along the tangent, from the first centre of mass.
    #[inline(always)]
    pub fn place<W: Wide>(&self) -> [W; 1] {
        [W::load(&self.x)]
    }
}

/// [`LANES`] contact constraints of one colour.
///
/// The order of the fields is the order of use: the solve pass reads up to `coupling`, the relax
/// pass the rest.
#[derive(Clone, Debug)]
#[repr(C)]
pub(crate) struct ContactBlock {
    pub bodies: [[u32; LANES]; 2],
    pub normal: WideVector<Lane>,
    pub inv_mass: [WideVector<Lane>; 2],
    pub inv_inertia: [WideSymmetric<Lane>; 2],
    /// `c = x1 - x2` in the contact frame.
    pub offset: WideVector<Lane>,
    pub points: [PointRow; MAX_MANIFOLD_POINTS],
    /// `K_01`.
    pub coupling: [Lane; COUPLINGS],

    pub friction: FrictionRow,
    /// Sum of the normal impulses of all substeps.
    pub totals: [Lane; MAX_MANIFOLD_POINTS],
}

// docs/data-layout.md counts these bytes.
const _: () =
    assert!(size_of::<ContactBlock>() == 26 * size_of::<Lane>() + 2 * LANES * size_of::<u32>());

/// Friction of each lane: one tangential row at the friction centre.
#[derive(Copy, Clone, Debug, Default)]
#[repr(C)]
pub(crate) struct FrictionRow {
    /// Coordinate of the friction centre along the normal, from the first centre of mass.
    pub height: Lane,
    pub coefficient: Lane,
    /// `1 / K` of the tangential row.
    pub mass: Lane,
    /// Wanted relative velocity along the tangent.
    pub surface_velocity: Lane,
    /// Friction impulse of this substep along the tangent.
    pub impulse: Lane,
}

impl ContactBlock {
    /// No constraint in any lane.
    pub const EMPTY: Self = {
        let zero = Lane::ZERO;
        let vector = WideVector::ZERO;
        let point = PointRow { x: zero, separation: zero, mass: zero, impulse: zero };
        let friction = FrictionRow {
            height: zero,
            coefficient: zero,
            mass: zero,
            surface_velocity: zero,
            impulse: zero,
        };
        Self {
            bodies: [[READ_ONLY; LANES]; 2],
            normal: vector,
            inv_mass: [vector; 2],
            inv_inertia: [zero; 2],
            offset: vector,
            points: [point; MAX_MANIFOLD_POINTS],
            coupling: [zero; COUPLINGS],
            friction,
            totals: [zero; MAX_MANIFOLD_POINTS],
        }
    };

    /// Scales the impulses with which the next substep starts.
    pub fn scale_impulses(&mut self, factor: Real) {
        let normal = self.points.iter_mut().map(|point| &mut point.impulse);
        for lane in normal.chain(core::iter::once(&mut self.friction.impulse)) {
            for impulse in &mut lane.0 {
                *impulse *= factor;
            }
        }
    }

    /// The friction impulse of one lane, in world space.
    pub fn friction_impulse(&self, lane: usize) -> Vector {
        let n = self.normal.lane(lane);
        Vector::new(n.y, -n.x) * self.friction.impulse.0[lane]
    }

    /// Zero: there is no twist about a normal in the plane.
    pub fn twist_impulse(&self, _lane: usize) -> Real {
        0.0
    }
}
