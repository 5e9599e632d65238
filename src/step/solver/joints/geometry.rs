//! Current geometry of the joints of a block.

use super::block::{AxisRow, JointBlock};
use super::rows::Row;
use crate::base::wide::Wide;
use crate::dim::joint::{
    angular_to_frame, angular_to_world, axes, components, frame_between, from_components,
    linear_to_world, locked_rotations,
};
use crate::dim::math::{ANG_DIM, DIM, SPATIAL_DIM};
use crate::dim::state::WideDisplacement;
use crate::dim::wide::{WideAngVector, WideRotation, WideVector, torque};

/// Frames and moment arms of a block's joints after the bodies have moved.
pub(super) struct Geometry<W> {
    /// Axes of the first frame.
    pub axes: [WideVector<W>; DIM],
    /// From each centre of mass to the second anchor.
    pub arms: [WideVector<W>; 2],
    /// From anchor to anchor, along the axes.
    pub separation: [W; DIM],
    /// Both frames.
    frames: [WideRotation<W>; 2],
    /// Relative rotation of the second body since the step began.
    rotvec: WideAngVector<W>,
    /// One for locked rotations, zero for free rotations.
    locks: [W; ANG_DIM],
}

impl<W: Wide> Geometry<W> {
    /// After these displacements since the step began.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn new(block: &JointBlock, displacements: &[WideDisplacement<W>; 2]) -> Self {
        let [d1, d2] = displacements;
        let (turn1, turn2) = (d1.rotation(), d2.rotation());
        let old1 = WideVector::load(&block.arms[0]);
        let old2 = WideVector::load(&block.arms[1]);
        let (arm1, arm2) = (turn1.rotate(old1), turn2.rotate(old2));
        let separation = WideVector::load(&block.separation)
            + (d2.linear - d1.linear)
            + ((arm2 - old2) - (arm1 - old1));
        let frame1 = turn1.times(WideRotation::load(&block.frames[0]));
        let frame2 = turn2.times(WideRotation::load(&block.frames[1]));
        let axes = axes(frame1);
        let mut along = [W::zero(); DIM];
        for (along, axis) in along.iter_mut().zip(&axes) {
            *along = axis.dot(separation);
        }
        let mut locks = [W::zero(); ANG_DIM];
        for (lock, lane) in locks.iter_mut().zip(&block.locked[DIM..]) {
            *lock = W::load(lane);
        }
        Self {
            axes,
            arms: [arm1 + separation, arm2],
            separation: along,
            frames: [frame1, frame2],
            rotvec: d2.angular - d1.angular,
            locks,
        }
    }

    /// The second frame as seen from the first.
    #[inline(always)]
    fn between(&self) -> WideRotation<W> {
        let [first, second] = self.frames;
        frame_between(first, second)
    }

    /// The directions that change the errors about the axes if they were locked.
    #[inline(always)]
    pub fn locked_directions(&self) -> [WideAngVector<W>; ANG_DIM] {
        locked_rotations(self.between(), &self.locks, &self.axes).1
    }

    /// The errors and the rows of the first axes if they were locked: of all, or of the translations alone.
    #[inline(always)]
    pub fn locked_axes<const N: usize>(&self) -> ([W; N], [Row<W>; N]) {
        let (mut errors, mut rows) = ([W::zero(); N], [Row::zero(); N]);
        for k in 0..DIM {
            errors[k] = self.separation[k];
            rows[k] = self.row_along(self.axes[k]);
        }
        if N > DIM {
            let (angles, directions) = locked_rotations(self.between(), &self.locks, &self.axes);
            for k in 0..ANG_DIM {
                errors[DIM + k] = angles[k];
                rows[DIM + k].angular = [directions[k]; 2];
            }
        }
        (errors, rows)
    }

    /// The `errors` of the locked axes in components along the axes of an earlier moment, along which
    /// impulses act. The axes rotate with the first body, and errors along the second body's axes require
    /// impulses that are rotated relative to them. In a substep with a rotation of a quarter of a radian, a
    /// Newton step would leave a tenth instead of a thirtieth. Rotations are measured in the middle of the
    /// substep, which is the average rotation of an added impulse.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn errors_seen_from<const N: usize>(
        &self,
        errors: [W; N],
        earlier: &Self,
        block: &JointBlock,
    ) -> [W; N] {
        let mut of_locked = [W::zero(); SPATIAL_DIM];
        for k in 0..N {
            let is_locked = W::zero().lt(W::load(&block.locked[k]));
            of_locked[k] = W::select(is_locked, errors[k], W::zero());
        }
        let (linear, angular) = from_components(of_locked);
        let (linear, mut middle) = (linear_to_world(&self.axes, linear), earlier.axes);
        let mut seen = [W::zero(); N];
        for (seen, axis) in seen.iter_mut().zip(&earlier.axes) {
            *seen = axis.dot(linear);
        }
        if N == DIM {
            return seen;
        }
        for (middle, axis) in middle.iter_mut().zip(&self.axes) {
            let scale = W::splat(1.0) / (W::splat(1.0) + middle.dot(*axis)).max(W::splat(0.1));
            *middle = (*middle + *axis) * scale;
        }
        let angular = angular_to_frame(&middle, angular_to_world(&self.axes, angular));
        seen[DIM..].copy_from_slice(&components(linear, angular)[DIM..]);
        seen
    }

    /// The row of a translation along a direction that turns with the first body.
    #[inline(always)]
    fn row_along(&self, direction: WideVector<W>) -> Row<W> {
        let [arm1, arm2] = self.arms;
        Row { linear: direction, angular: [torque(arm1, direction), torque(arm2, direction)] }
    }

    /// The row and the position of a free axis.
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    pub fn free_row(&self, row: &AxisRow) -> (Row<W>, W) {
        let (direction, distance) = self.translation(row);
        let mut along = self.row_along(direction);
        let rotvec = angular_to_frame(&self.axes, self.rotvec);
        let (about, angle) = row.angle_tracker.measure(self.between(), rotvec);
        let about = angular_to_world(&self.axes, about);
        along.angular = [along.angular[0] + about, along.angular[1] + about];
        (along, distance + angle)
    }

    /// The direction of an axis of translation, and the displacement of the joint along it.
    #[inline(always)]
    fn translation(&self, row: &AxisRow) -> (WideVector<W>, W) {
        let single = WideVector::load(&row.linear);
        let (mut squares, mut towards) = (W::zero(), WideVector::zero());
        for k in 0..DIM {
            let along = self.separation[k] * W::load(&row.coupled[k]);
            squares = squares + along * along;
            towards = towards + self.axes[k] * along;
        }
        let single = linear_to_world(&self.axes, single);
        let position = single.dot(self.separation_vector());
        let coupled = W::splat(1.0e-30).lt(squares);
        let length = W::select(coupled, squares, W::splat(1.0)).sqrt();
        let unit = towards * (W::splat(1.0) / length);
        // If the anchors coincide, the first axis is the direction.
        (WideVector::select(coupled, unit, single), W::select(coupled, length, position))
    }

    #[inline(always)]
    fn separation_vector(&self) -> WideVector<W> {
        let mut sum = WideVector::zero();
        for (&axis, &along) in self.axes.iter().zip(&self.separation) {
            sum = sum + axis * along;
        }
        sum
    }
}
