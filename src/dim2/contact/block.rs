//! Memory layout of contact constraints.

use crate::base::wide::{LANES, Lane, Wide};
use crate::dim2::math::MAX_MANIFOLD_POINTS;
use crate::dim2::state::READ_ONLY;
use crate::dim2::wide::{WideSymmetric, WideVector};

/// Pairs of different points of one manifold.
const COUPLINGS: usize = MAX_MANIFOLD_POINTS * (MAX_MANIFOLD_POINTS - 1) / 2;

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
    /// Position of the point along the tangent, from the first centre of mass.
    #[inline(always)]
    pub fn place<W: Wide>(&self) -> [W; 1] {
        [W::load(&self.x)]
    }

    /// Stores the position of a point of the contact frame.
    #[inline(always)]
    pub fn store_place<W: Wide>(&mut self, local: WideVector<W>) {
        local.x.store(&mut self.x);
    }
}

/// [`LANES`] contact constraints of one colour.
///
/// The order of the fields is the order of use. The solve pass reads up to `coupling`, and the relax pass the
/// rest except the places, which are read at the end only.
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
    /// The points midway between the two surfaces when the step began, in world space.
    pub places: [WideVector<Lane>; MAX_MANIFOLD_POINTS],
}

// docs/data-layout.md counts these bytes.
const _: () =
    assert!(size_of::<ContactBlock>() == 30 * size_of::<Lane>() + 2 * LANES * size_of::<u32>());

/// Friction of each lane: one tangential row at the friction centre.
#[derive(Copy, Clone, Debug, Default)]
#[repr(C)]
pub(crate) struct FrictionRow {
    /// Coordinate of the friction centre along the normal, from the first centre of mass.
    pub height: Lane,
    pub coefficient: Lane,
    /// `1 / K` of the tangential row.
    pub mass: Lane,
    /// Target relative velocity along the tangent.
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
            places: [vector; MAX_MANIFOLD_POINTS],
        }
    };

    /// Copies the input of normal impulses from a lane of another block.
    pub fn copy_normal_lane(&mut self, lane: usize, from: &Self, source: usize) {
        let copy = |to: &mut Lane, from: &Lane| to.0[lane] = from.0[source];
        let copy_vector = |to: &mut WideVector<Lane>, from: &WideVector<Lane>| {
            to.set_lane(lane, from.lane(source));
        };
        copy_vector(&mut self.normal, &from.normal);
        copy_vector(&mut self.offset, &from.offset);
        for (to, from) in self.points.iter_mut().zip(&from.points) {
            copy(&mut to.x, &from.x);
        }
        for (to, from) in self.coupling.iter_mut().zip(&from.coupling) {
            copy(to, from);
        }
        for body in 0..2 {
            self.bodies[body][lane] = from.bodies[body][source];
            copy_vector(&mut self.inv_mass[body], &from.inv_mass[body]);
            copy(&mut self.inv_inertia[body], &from.inv_inertia[body]);
        }
    }

    /// Multiplies the impulses with which the next substep starts by a factor of each lane.
    pub fn scale_impulses(&mut self, factors: &Lane) {
        let normal = self.points.iter_mut().map(|point| &mut point.impulse);
        for lane in normal.chain(core::iter::once(&mut self.friction.impulse)) {
            for (impulse, factor) in lane.0.iter_mut().zip(factors.0) {
                *impulse *= factor;
            }
        }
    }

    /// The friction impulses, in world space, and those of torsional friction about the normals: none in the
    /// plane.
    #[inline(always)]
    pub fn friction_impulses<W: Wide>(&self) -> (WideVector<W>, W) {
        let n = WideVector::<W>::load(&self.normal);
        (WideVector { x: n.y, y: -n.x } * W::load(&self.friction.impulse), W::zero())
    }
}
