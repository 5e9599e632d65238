//! The joint between a link and its parent: its coordinates, and the pose that follows from them.

use crate::base::measure::is_coordinate;
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{
    ANG_DIM, ANG_ZERO, AngVector, DIM, Pose, Real, Rotation, SPATIAL_DIM, SpatialVector, Vector,
    integrate_rotation, rotation_from_angle, rotation_to_angle,
};
use crate::dim::spatial::{ANG_AXES, angle_about, angles_about, angular, join, rotation_about};
use crate::model::check::{is_non_negative, refuse};
use crate::model::joint::{GenericJoint, mask_of, nearest_turn};
use arrayvec::ArrayVec;

/// A spring along one axis of a joint.
#[derive(Copy, Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
struct Spring {
    stiffness: Real,
    rest: Real,
}

/// The joint between a link and its parent.
///
/// Each axis that [`GenericJoint::locked_axes`] leaves free is a degree of freedom with a coordinate. It is a
/// length along an axis of translation, or an angle (radians, continuous beyond whole turns) about an axis of
/// rotation. Three free rotations (3D) are stored as one rotation, which has no singular direction. Of two,
/// the second rotates about the axis that the first moves, like a universal joint.
///
/// The step reads the coordinates from the poses of the bodies, unless the bodies follow from them. A
/// displacement of the coordinates by the user is kept until the bodies have followed it, also if a body is
/// moved meanwhile.
///
/// Locked axes are exact, so `softness`, `break_force` and `break_torque` have no effect here. Coupled
/// rotations have a common limit on the swing of a ball joint; other couplings have no effect.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct MultibodyJoint {
    /// Locked axes, limits and motors of the joint. The parent is its first body.
    pub data: GenericJoint,
    /// Whether the joint moves at a prescribed velocity, independent of all forces (default: no).
    pub kinematic: bool,
    /// The coordinates by axis. Zero for locked axes, and for the rotations of a ball.
    coords: SpatialVector,
    /// The rotation of a ball.
    ball: Rotation,
    /// The coordinates of the bodies' poses. Other coordinates are displacements by the user, which the
    /// bodies have not followed yet.
    body_coords: SpatialVector,
    /// The same for the rotation of a ball.
    body_ball: Rotation,
    springs: [Spring; SPATIAL_DIM],
}

/// The free ones of a joint's axes of rotation, numbered from 0.
pub(crate) fn angular_axes(free: JointAxesMask) -> ArrayVec<usize, ANG_DIM> {
    (0..ANG_DIM).filter(|axis| free.contains(mask_of(JointAxis::ALL[DIM + axis]))).collect()
}

impl MultibodyJoint {
    /// A joint whose coordinates are all zero.
    pub fn new(data: GenericJoint, kinematic: bool) -> Self {
        let (coords, springs) = ([0.0; SPATIAL_DIM], [Spring::default(); SPATIAL_DIM]);
        let ball = Rotation::IDENTITY;
        let (body_coords, body_ball) = (coords, ball);
        Self { data, kinematic, coords, ball, body_coords, body_ball, springs }
    }

    /// The axes that are free.
    pub(crate) fn free_axes(&self) -> JointAxesMask {
        !self.data.locked_axes
    }

    /// Returns whether the rotations are those of a ball joint.
    pub(crate) fn is_ball(&self) -> bool {
        ANG_DIM == 3 && angular_axes(self.free_axes()).len() == ANG_DIM
    }

    /// Number of degrees of freedom: of free axes.
    pub fn ndofs(&self) -> usize {
        self.free_axes().bits().count_ones() as usize
    }

    /// The coordinates by axis (length units, radians). The rotations of a ball are given as one rotation
    /// vector.
    pub fn coords(&self) -> SpatialVector {
        if !self.is_ball() {
            return self.coords;
        }
        join(self.slide(), rotation_to_angle(&self.ball))
    }

    /// The coordinate of an axis.
    pub(crate) fn coordinate(&self, axis: JointAxis) -> Real {
        if axis as usize >= DIM && self.is_ball() {
            return self.coords()[axis as usize];
        }
        self.coords[axis as usize]
    }

    /// Translation along the free axes, in the joint's frame on the parent.
    pub(crate) fn slide(&self) -> Vector {
        crate::dim::spatial::linear(&self.coords)
    }

    /// Rotation of the joint's frame on the link relative to that on the parent.
    pub fn joint_rot(&self) -> Rotation {
        self.rotation_at(&self.coords, self.ball)
    }

    fn rotation_at(&self, coords: &SpatialVector, ball: Rotation) -> Rotation {
        let q = |axis: usize| coords[DIM + axis];
        match angular_axes(self.free_axes()).as_slice() {
            [] => Rotation::IDENTITY,
            &[a] => rotation_about(a, q(a)),
            &[a, b] => rotation_about(a, q(a)) * rotation_about(b, q(b)),
            _ => ball,
        }
    }

    /// Pose of the link's body in the frame of its parent's body.
    pub fn body_to_parent(&self) -> Pose {
        self.pose_at(&self.coords, self.ball)
    }

    fn pose_at(&self, coords: &SpatialVector, ball: Rotation) -> Pose {
        let translation = crate::dim::spatial::linear(coords);
        let joint = Pose::from_parts(translation, self.rotation_at(coords, ball));
        self.data.local_frame1 * joint * self.data.local_frame2.inverse()
    }

    /// Moves the coordinates by one displacement per degree of freedom (length units, radians), translations
    /// first, in the order of the axes. Missing displacements are 0.
    pub fn apply_displacement(&mut self, displacements: &[Real]) {
        self.displace(displacements, |ball, rotvec| {
            (rotation_from_angle(rotvec) * ball).normalize()
        });
    }

    /// Moves the coordinates for `dt` seconds at these velocities (length/s, rad/s), one per degree of
    /// freedom.
    pub fn integrate(&mut self, dt: Real, velocities: &[Real]) {
        let mut displacements = [0.0; SPATIAL_DIM];
        for (displacement, velocity) in displacements.iter_mut().zip(velocities) {
            *displacement = velocity * dt;
        }
        self.displace(&displacements, integrate_rotation);
    }

    fn displace(
        &mut self,
        displacements: &[Real],
        turn_ball: impl Fn(Rotation, AngVector) -> Rotation,
    ) {
        let mut by_axis = [0.0; SPATIAL_DIM];
        let free = self.free_axes();
        let axes = JointAxis::ALL.into_iter().filter(|axis| free.contains(mask_of(*axis)));
        for (axis, displacement) in axes.zip(displacements) {
            by_axis[axis as usize] = *displacement;
        }
        if self.is_ball() {
            self.ball = turn_ball(self.ball, angular(&by_axis));
            by_axis[DIM..].fill(0.0);
        }
        for (coordinate, displacement) in self.coords.iter_mut().zip(by_axis) {
            *coordinate += displacement;
        }
    }

    /// Returns whether the user moved the coordinates, and the bodies have not followed yet.
    pub(crate) fn is_displaced(&self) -> bool {
        self.coords != self.body_coords || self.ball != self.body_ball
    }

    /// The bodies have the poses of the coordinates.
    pub(crate) fn match_bodies(&mut self) {
        (self.body_coords, self.body_ball) = (self.coords, self.ball);
    }

    /// Discards the last reading, with its turns. Displacements by the user stay.
    pub(crate) fn discard_reading(&mut self) {
        for (coordinate, read) in self.coords.iter_mut().zip(&mut self.body_coords) {
            *coordinate -= core::mem::take(read);
        }
        let read = core::mem::replace(&mut self.body_ball, Rotation::IDENTITY);
        self.ball = if self.ball == read { Rotation::IDENTITY } else { self.ball * read.inverse() };
    }

    /// Pose of the link's body in the frame of its parent's body, without displacements by the user.
    pub(crate) fn undisplaced_body_to_parent(&self) -> Pose {
        self.pose_at(&self.body_coords, self.body_ball)
    }

    /// Sets the coordinates with which the link is nearest to `link`, a pose in the frame of the
    /// parent's body. Among equivalent angles, the closest to the old ones is selected. Displacements by the
    /// user are added.
    pub(crate) fn read_pose(&mut self, link: &Pose) {
        if !self.is_sound() {
            // Coordinates that are not finite are no displacement.
            let Self { data, kinematic, springs, .. } = self.clone();
            *self = Self { springs, ..Self::new(data, kinematic) };
        }
        let displaced = self.is_displaced().then_some((self.coords, self.ball));
        let old = (self.body_coords, self.body_ball);
        (self.coords, self.ball) = old;
        self.measure(link);
        self.match_bodies();
        if let Some((coords, ball)) = displaced {
            for axis in 0..SPATIAL_DIM {
                self.coords[axis] += coords[axis] - old.0[axis];
            }
            self.ball = (ball * old.1.inverse() * self.ball).normalize();
        }
    }

    /// The same without displacements.
    fn measure(&mut self, link: &Pose) {
        let (frame1, frame2) = (self.data.local_frame1, self.data.local_frame2);
        let relative = frame1.inverse() * *link * frame2;
        let free = self.free_axes();
        for axis in JointAxis::ALL.into_iter().take(DIM) {
            if free.contains(mask_of(axis)) {
                self.coords[axis as usize] = relative.translation[axis as usize];
            }
        }
        let data = &self.data;
        let mut set = |axis: usize, angle: Real| {
            let old = &mut self.coords[DIM + axis];
            // An exact zero is unlikely to be a measurement.
            let limits = data.limits(JointAxis::ALL[DIM + axis]).filter(|_| *old == 0.0);
            *old = match limits {
                Some(limits) => limits.first_reading(angle),
                None => nearest_turn(angle, *old),
            };
        };
        match angular_axes(free).as_slice() {
            [] => {}
            &[a] => set(a, angle_about(a, relative.rotation)),
            &[a, b] => {
                let [p, q] = angles_about([a, b], relative.rotation);
                set(a, p);
                set(b, q);
            }
            _ => self.ball = relative.rotation.normalize(),
        }
    }

    /// Brings coordinates that are beyond their limits back. The limits of a ball joint are kept.
    pub(crate) fn keep_limits(&mut self) {
        let free = self.free_axes();
        for axis in JointAxis::ALL.into_iter().filter(|axis| free.contains(mask_of(*axis))) {
            if let Some(limits) = self.data.limits(axis)
                && limits.min <= limits.max
            {
                let coordinate = &mut self.coords[axis as usize];
                *coordinate = coordinate.clamp(limits.min, limits.max);
            }
        }
    }

    /// The displacement along an axis from the coordinates of this joint to those of the same one, moved.
    pub(crate) fn displacement_to(&self, other: &Self, axis: JointAxis) -> Real {
        if axis as usize >= DIM && self.is_ball() {
            let rotvec = rotation_to_angle(&(other.ball * self.ball.inverse()));
            return join(Vector::ZERO, rotvec)[axis as usize];
        }
        other.coords[axis as usize] - self.coords[axis as usize]
    }

    /// Returns whether all coordinates are usable.
    pub(crate) fn is_sound(&self) -> bool {
        let mut coords = self.coords.iter().chain(&self.body_coords);
        coords.all(|&coordinate| is_coordinate(coordinate))
            && [self.ball, self.body_ball].iter().all(crate::dim::math::rotation_is_valid)
    }

    /// The axis of each rotation that is free, in the joint's frame on the parent.
    pub(crate) fn rotation_axes(&self, free: JointAxesMask) -> ArrayVec<AngVector, ANG_DIM> {
        let mut axes: ArrayVec<AngVector, ANG_DIM> = ArrayVec::new();
        match angular_axes(free).as_slice() {
            &[a, b] => {
                let first = rotation_about(a, self.coords[DIM + a]);
                axes.push(ANG_AXES[a]);
                axes.push(crate::dim::spatial::turn_axis(first, ANG_AXES[b]));
            }
            free => axes.extend(free.iter().map(|&axis| ANG_AXES[axis])),
        }
        axes
    }

    /// The spring along an axis: its stiffness (force per length, torque per radian) and its rest coordinate.
    #[cfg(not(feature = "upstream-036"))]
    pub fn spring(&self, axis: JointAxis) -> (Real, Real) {
        self.spring_at(axis as usize)
    }

    /// The spring along the axis with this number.
    pub(crate) fn spring_at(&self, axis: usize) -> (Real, Real) {
        let Spring { stiffness, rest } = self.springs[axis];
        (stiffness, rest)
    }

    /// Sets the spring along an axis: its stiffness (force per length, torque per radian; 0 for none, the
    /// default) and its rest coordinate. Its damping is
    /// [`Multibody::damping_mut`](super::Multibody::damping_mut).
    ///
    /// It is integrated implicitly, and stable at any stiffness.
    #[cfg(not(feature = "upstream-036"))]
    pub fn set_spring(&mut self, axis: JointAxis, stiffness: Real, rest: Real) {
        self.set_spring_at(axis as usize, stiffness, rest);
    }

    /// Sets the spring along the axis with this number.
    pub(crate) fn set_spring_at(&mut self, axis: usize, stiffness: Real, rest: Real) {
        if !is_non_negative(stiffness) || !rest.is_finite() {
            return refuse("the spring of a multibody joint", (stiffness, rest));
        }
        self.springs[axis] = Spring { stiffness, rest };
    }

    /// Angular velocity of the link relative to its parent (rad/s) at these velocities of the degrees of
    /// freedom, in the joint's frame on the parent.
    pub fn angular_velocity(&self, velocities: &[Real]) -> AngVector {
        let linear = self.ndofs() - angular_axes(self.free_axes()).len();
        let rates = velocities.iter().skip(linear);
        self.rotation_axes(self.free_axes())
            .iter()
            .zip(rates)
            .fold(ANG_ZERO, |sum, (axis, rate)| sum + *axis * *rate)
    }
}
