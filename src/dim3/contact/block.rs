//! Memory layout of contact constraints.

use super::tangents::TangentMass;
use crate::base::wide::{LANES, Lane, Wide};
use crate::dim3::math::MAX_MANIFOLD_POINTS;
use crate::dim3::state::READ_ONLY;
use crate::dim3::wide::{WideVector, cross};

/// Pairs of different points of one manifold.
const COUPLINGS: usize = MAX_MANIFOLD_POINTS * (MAX_MANIFOLD_POINTS - 1) / 2;

/// One contact point of each lane. Absent points have no mass, so their impulse stays zero.
#[derive(Copy, Clone, Debug, Default)]
#[repr(C)]
pub(crate) struct PointRow {
    /// First two coordinates of the point in the contact frame, from the first centre of mass.
    pub x: Lane,
    pub y: Lane,
    /// Separation when the step began.
    pub separation: Lane,
    /// `1 / K_ii`.
    pub mass: Lane,
    /// Normal impulse of this substep.
    pub impulse: Lane,
}

impl PointRow {
    /// Position of the point in the contact plane, from the first centre of mass.
    #[inline(always)]
    pub fn place<W: Wide>(&self) -> [W; 2] {
        [W::load(&self.x), W::load(&self.y)]
    }

    /// Stores the position of a point of the contact frame.
    #[inline(always)]
    pub fn store_place<W: Wide>(&mut self, local: WideVector<W>) {
        local.x.store(&mut self.x);
        local.y.store(&mut self.y);
    }
}

/// [`LANES`] contact constraints of one colour.
///
/// The order of the fields is the order of use. The solve pass reads up to `inv_inertia`, and the relax pass
/// the rest except the places, which are read at the end only.
#[derive(Clone, Debug)]
#[repr(C)]
pub(crate) struct ContactBlock {
    pub bodies: [[u32; LANES]; 2],
    pub normal: WideVector<Lane>,
    pub tangent: WideVector<Lane>,
    pub inv_mass: [WideVector<Lane>; 2],
    /// `c = x1 - x2` in the contact frame.
    pub offset: WideVector<Lane>,
    pub points: [PointRow; MAX_MANIFOLD_POINTS],
    /// `K_ij` for i < j: 01 02 03 12 13 23.
    pub coupling: [Lane; COUPLINGS],
    /// The angular velocities, in world space, of the two bodies per unit of moment about each axis of the
    /// contact frame: `I⁻¹ t1`, `I⁻¹ t2`, `I⁻¹ n`. Normal impulses need the first two.
    pub inv_inertia: [[WideVector<Lane>; 2]; 3],

    pub friction: FrictionRow,
    /// Sum of the normal impulses of all substeps.
    pub totals: [Lane; MAX_MANIFOLD_POINTS],
    /// The points midway between the two surfaces when the step began, in world space.
    pub places: [WideVector<Lane>; MAX_MANIFOLD_POINTS],
}

// docs/data-layout.md counts these bytes.
const _: () =
    assert!(size_of::<ContactBlock>() == 92 * size_of::<Lane>() + 2 * LANES * size_of::<u32>());

/// Friction of each lane: two tangential rows and one about the normal, at the friction centre.
#[derive(Copy, Clone, Debug, Default)]
#[repr(C)]
pub(crate) struct FrictionRow {
    /// The friction centre in the contact frame, from the first centre of mass.
    pub center: WideVector<Lane>,
    pub coefficient: Lane,
    pub tangent_mass: TangentMass<Lane>,
    pub torsional_mass: Lane,
    /// Mean distance of the points from the friction centre: the radius of torsional friction.
    pub radius: Lane,
    /// `K_13` and `K_23`: effect of a torsional impulse on the velocities along the two tangents.
    pub torsional_coupling: [Lane; 2],
    /// Target relative velocity along the two tangents.
    pub surface_velocity: [Lane; 2],
    /// Friction impulses of this substep: along the two tangents, and about the normal.
    pub impulse: [Lane; 3],
}

impl ContactBlock {
    /// No constraint in any lane.
    pub const EMPTY: Self = {
        let zero = Lane::ZERO;
        let vector = WideVector::ZERO;
        let point = PointRow { x: zero, y: zero, separation: zero, mass: zero, impulse: zero };
        let friction = FrictionRow {
            center: vector,
            coefficient: zero,
            tangent_mass: TangentMass::ZERO,
            torsional_mass: zero,
            radius: zero,
            torsional_coupling: [zero; 2],
            surface_velocity: [zero; 2],
            impulse: [zero; 3],
        };
        Self {
            bodies: [[READ_ONLY; LANES]; 2],
            normal: vector,
            tangent: vector,
            inv_mass: [vector; 2],
            offset: vector,
            points: [point; MAX_MANIFOLD_POINTS],
            coupling: [zero; COUPLINGS],
            inv_inertia: [[vector; 2]; 3],
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
        copy_vector(&mut self.tangent, &from.tangent);
        copy_vector(&mut self.offset, &from.offset);
        for (to, from) in self.points.iter_mut().zip(&from.points) {
            copy(&mut to.x, &from.x);
            copy(&mut to.y, &from.y);
        }
        for (to, from) in self.coupling.iter_mut().zip(&from.coupling) {
            copy(to, from);
        }
        for body in 0..2 {
            self.bodies[body][lane] = from.bodies[body][source];
            copy_vector(&mut self.inv_mass[body], &from.inv_mass[body]);
            for (to, from) in self.inv_inertia.iter_mut().zip(&from.inv_inertia) {
                copy_vector(&mut to[body], &from[body]);
            }
        }
    }

    /// Multiplies the impulses with which the next substep starts by a factor of each lane.
    pub fn scale_impulses(&mut self, factors: &Lane) {
        let normal = self.points.iter_mut().map(|point| &mut point.impulse);
        for lane in normal.chain(&mut self.friction.impulse) {
            for (impulse, factor) in lane.0.iter_mut().zip(factors.0) {
                *impulse *= factor;
            }
        }
    }

    /// The friction impulses, in world space, and those of torsional friction about the normals.
    #[inline(always)]
    pub fn friction_impulses<W: Wide>(&self) -> (WideVector<W>, W) {
        let (n, t1) = (WideVector::<W>::load(&self.normal), WideVector::load(&self.tangent));
        let [x, y, torsion] = &self.friction.impulse;
        (t1 * W::load(x) + cross(n, t1) * W::load(y), W::load(torsion))
    }
}
