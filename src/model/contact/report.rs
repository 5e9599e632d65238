//! What the solver tells of contact manifolds, one after the other.

use crate::dim::math::{DIM, MAX_MANIFOLD_POINTS, Real, Vector};

/// Where what stands in a report, behind the normal at 0.
const FRICTION: usize = DIM;
const TWIST: usize = 2 * DIM;
const IS_SOUND: usize = TWIST + 1;
const POINTS: usize = IS_SOUND + 1;
const POINT_LEN: usize = DIM + 3;
/// Where what stands in the numbers of a point, behind its place.
const SEPARATION: usize = DIM;
const TOTAL: usize = DIM + 1;
const IMPULSE: usize = DIM + 2;

/// What the solver tells of one manifold, in one cache line (3D: two; single precision). Somebody may ask for any of them.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct ContactReport([Real; Self::LEN]);

impl ContactReport {
    /// Numbers in a report.
    pub const LEN: usize = POINTS + MAX_MANIFOLD_POINTS * POINT_LEN;

    /// Nothing.
    pub const EMPTY: Self = Self([0.0; Self::LEN]);

    /// The numbers, for who knows their order: normal, friction impulse, twist impulse, are all finite; then point by point place,
    /// separation, total impulse, last impulse.
    pub fn numbers_mut(&mut self) -> &mut [Real; Self::LEN] {
        &mut self.0
    }

    /// Where among the numbers it stands whether all are finite.
    pub const IS_SOUND: usize = IS_SOUND;

    /// Did all numbers stay finite?
    pub fn is_sound(&self) -> bool {
        self.0[IS_SOUND] != 0.0
    }

    /// The normal in world space.
    pub fn normal(&self) -> Vector {
        Vector::from_slice(&self.0)
    }

    /// The friction impulse of the last substep, in world space.
    pub fn friction_impulse(&self) -> Vector {
        Vector::from_slice(&self.0[FRICTION..])
    }

    /// The twist impulse of the last substep, about the normal: zero in the plane.
    pub fn twist_impulse(&self) -> Real {
        self.0[TWIST]
    }

    /// A point midway between the two surfaces, in world space.
    pub fn point(&self, point: usize) -> Vector {
        Vector::from_slice(self.of_point(point))
    }

    /// The separation of a point.
    pub fn separation(&self, point: usize) -> Real {
        self.of_point(point)[SEPARATION]
    }

    /// The sum of the normal impulses of a point over all substeps.
    pub fn total(&self, point: usize) -> Real {
        self.of_point(point)[TOTAL]
    }

    /// The normal impulse of a point in the last substep.
    pub fn impulse(&self, point: usize) -> Real {
        self.of_point(point)[IMPULSE]
    }

    fn of_point(&self, point: usize) -> &[Real] {
        &self.0[POINTS + point * POINT_LEN..]
    }
}
