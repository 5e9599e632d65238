//! The solver's results of contact manifolds, contiguous.

use crate::base::wide::{LANES, Wide, scatter};
use crate::dim::math::{DIM, MAX_MANIFOLD_POINTS, Real, Vector};
use crate::dim::wide::WideVector;

/// Offsets in a report, after the normal at 0.
const FRICTION: usize = DIM;
const TORSION: usize = 2 * DIM;
const SOUND_FLAG: usize = TORSION + 1;
const POINTS: usize = SOUND_FLAG + 1;
const POINT_LEN: usize = DIM + 3;
/// Offsets in the numbers of a point, after its position.
const SEPARATION: usize = DIM;
const TOTAL: usize = DIM + 1;
const IMPULSE: usize = DIM + 2;

/// The solver's results of one manifold, in one cache line (3D: two; single precision). Access is random.
#[derive(Copy, Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct ContactReport([Real; Self::LEN]);

impl ContactReport {
    /// Numbers in a report.
    const LEN: usize = POINTS + MAX_MANIFOLD_POINTS * POINT_LEN;

    /// An empty report.
    pub const EMPTY: Self = Self([0.0; Self::LEN]);

    /// Returns whether all numbers are finite.
    pub fn is_sound(&self) -> bool {
        self.0[SOUND_FLAG] != 0.0
    }

    /// The normal in world space.
    pub fn normal(&self) -> Vector {
        Vector::from_slice(&self.0)
    }

    /// The friction impulse of the last substep, in world space.
    pub fn friction_impulse(&self) -> Vector {
        Vector::from_slice(&self.0[FRICTION..])
    }

    /// The torsional impulse with which the next step starts, about the normal; zero in 2D.
    pub fn torsional_impulse(&self) -> Real {
        self.0[TORSION]
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

    /// The normal impulse of a point with which the next step starts.
    pub fn impulse(&self, point: usize) -> Real {
        self.of_point(point)[IMPULSE]
    }

    fn of_point(&self, point: usize) -> &[Real] {
        &self.0[POINTS + point * POINT_LEN..]
    }
}

/// A report per lane, while it is written.
pub(crate) struct WideReport<W> {
    numbers: [W; ContactReport::LEN],
}

impl<W: Wide> WideReport<W> {
    /// A report with these normals, friction impulses of the last substep, and torsional impulses with which
    /// the next step starts.
    #[inline(always)]
    pub fn new(normal: WideVector<W>, friction: WideVector<W>, torsion: W) -> Self {
        let mut numbers = [W::zero(); ContactReport::LEN];
        numbers[..FRICTION].copy_from_slice(&normal.components());
        numbers[FRICTION..TORSION].copy_from_slice(&friction.components());
        numbers[TORSION] = torsion;
        Self { numbers }
    }

    /// Sets a point: its position, its separation, the impulse of all substeps, and the one with which the
    /// next step starts.
    #[inline(always)]
    pub fn set_point(&mut self, k: usize, place: WideVector<W>, separation: W, impulses: [W; 2]) {
        let numbers = &mut self.numbers[POINTS + k * POINT_LEN..][..POINT_LEN];
        numbers[..SEPARATION].copy_from_slice(&place.components());
        numbers[SEPARATION] = separation;
        [numbers[TOTAL], numbers[IMPULSE]] = impulses;
    }

    /// Finds out, and reports, in which lanes all numbers stayed finite.
    #[inline(always)]
    pub fn find_sound(&mut self) -> W::Mask {
        let zero = W::zero();
        // Stays zero unless a number is not finite: 0·∞ and 0·NaN are NaN.
        let mut probe = zero;
        for number in self.numbers {
            probe = probe + zero * number;
        }
        let is_sound = probe.le(zero);
        self.numbers[SOUND_FLAG] = W::select(is_sound, W::splat(1.0), zero);
        is_sound
    }

    /// Writes the report of each lane.
    #[inline(always)]
    pub fn write(self, reports: &mut [ContactReport; LANES]) {
        scatter(self.numbers, reports.each_mut().map(|report| Some(&mut report.0)));
    }
}
