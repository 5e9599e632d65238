//! The records of a wheel: its parameters, its controls, and its state.

use crate::dim::math::{Real, Rotation, Vector, rotation_from_angle};
use crate::model::collider::ColliderHandle;

/// Parameters of springs, dampers and tyres, which the wheels of a vehicle often have in common.
///
/// [`DynamicRayCastVehicleController::add_wheel`](super::DynamicRayCastVehicleController::add_wheel) copies
/// them into the [`Wheel`], whose fields document them.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct WheelTuning {
    /// [`Wheel::suspension_stiffness`]: 5.88 by default.
    pub suspension_stiffness: Real,
    /// [`Wheel::damping_compression`]: 0.83 by default.
    pub suspension_compression: Real,
    /// [`Wheel::damping_relaxation`]: 0.88 by default.
    pub suspension_damping: Real,
    /// [`Wheel::max_suspension_travel`]: 5 by default.
    pub max_suspension_travel: Real,
    /// [`Wheel::side_friction_stiffness`]: 1 by default.
    pub side_friction_stiffness: Real,
    /// [`Wheel::friction_slip`]: 10.5 by default.
    pub friction_slip: Real,
    /// [`Wheel::max_suspension_force`]: 6000 by default.
    pub max_suspension_force: Real,
}

impl Default for WheelTuning {
    fn default() -> Self {
        Self {
            suspension_stiffness: 5.88,
            suspension_compression: 0.83,
            suspension_damping: 0.88,
            max_suspension_travel: 5.0,
            side_friction_stiffness: 1.0,
            friction_slip: 10.5,
            max_suspension_force: 6000.0,
        }
    }
}

/// Ray-cast result of a wheel at the last update.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct RayCastInfo {
    /// Normal of the ground, in world space: out of the ground, of unit length. In the air: against the
    /// suspension.
    pub contact_normal_ws: Vector,
    /// Contact point of the wheel, in world space. In the air: the lowest point of the wheel.
    pub contact_point_ws: Vector,
    /// Distance from the hard point to the middle of the wheel (length). In the air: the rest length.
    pub suspension_length: Real,
    /// Start of suspension and ray on the chassis, in world space.
    pub hard_point_ws: Vector,
    /// Whether the wheel is on the ground.
    pub is_in_contact: bool,
    /// The collider below the wheel.
    pub ground_object: Option<ColliderHandle>,
}

/// The ground below the wheel, also if it touches only during the next step.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Below {
    pub collider: ColliderHandle,
    pub normal: Vector,
    pub point: Vector,
    /// Compression of the spring (length); negative if the wheel is above the ground.
    pub compression: Real,
}

/// One wheel of a vehicle.
///
/// Parameters and controls are public fields; both may change at any time. Lengths are in the units of the
/// world, vectors that end in `_cs` in the frame of the chassis. Stiffness and damping are *per mass of the
/// chassis*, so a heavier chassis does not sink deeper.
///
/// A wheel with an unusable value is inactive, as if it were in the air. Unusable values are, for example,
/// non-finite numbers, a zero radius, an axle of zero length and a negative stiffness. `log` contains a
/// warning with the value. The other wheels are unaffected.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub struct Wheel {
    /// Start of the suspension on the chassis (the "hard point"), in the frame of the chassis.
    pub chassis_connection_point_cs: Vector,
    /// Direction of the suspension, down for most, in the frame of the chassis. Its length does not matter.
    pub direction_cs: Vector,
    /// The axle without steering, in the frame of the chassis. Its length does not matter. Its sign
    /// determines the forward direction: up × axle. A car that drives along +x with y up has the axle +z.
    pub axle_cs: Vector,
    /// Distance from the hard point to the middle of the wheel without load (length, at least 0).
    pub suspension_rest_length: Real,
    /// Largest compression of the suspension from its rest length (length, at least 0). Beyond it the force
    /// of the spring is constant, and the colliders of the chassis must stop the motion.
    pub max_suspension_travel: Real,
    /// The radius of the wheel (length).
    pub radius: Real,
    /// Force of the spring per compression, per mass of the chassis (1/s²).
    ///
    /// A car of mass m on n such wheels sinks by g / (n · stiffness) and bounces with √(n · stiffness) / 2π
    /// hertz. A soft family car has 25 to 50 (1.6 to 2.2 Hz on four wheels). A sports car has 60 to 100, and
    /// a racing car has 200 or more. The default of 5.88 is very soft: it sinks by 0.42 m on earth, which the
    /// rest length must allow.
    pub suspension_stiffness: Real,
    /// Force of the damper per speed during compression, per mass of the chassis (1/s).
    ///
    /// The damping ratio of n such wheels is ½ · damping · √(n / stiffness); 1 is critical, cars have 0.2 to
    /// 0.5.
    pub damping_compression: Real,
    /// The same while the suspension stretches. It is often a little more than during compression.
    pub damping_relaxation: Real,
    /// Largest force of the suspension along its direction (mass·length/s², at least 0).
    pub max_suspension_force: Real,
    /// Coefficient of friction µ of the tyre: drive, brakes and lateral grip together are at most µ times the
    /// load. Tyres have 1 on dry and 0.1 on icy roads; the default of 10.5 sticks to everything. The friction
    /// of the colliders has no effect.
    pub friction_slip: Real,
    /// Fraction of the lateral slip that the tyre aims to remove in one update, from 0 (as on ice) to 1.
    /// Larger values count as 1.
    pub side_friction_stiffness: Real,
    /// The fraction of lateral grip that makes the car roll, from 0 to 1.
    ///
    /// Friction on the ground acts below the centre of mass, and leans a car out of its curve or turns it
    /// over. The value 1 is this physical behaviour. At 0, friction acts at the height of the centre of mass,
    /// and the car stays level. Values in between interpolate. 0.1 by default, so that cars do not turn over.
    pub roll_influence: Real,
    /// Angle of steering about the direction opposite to [`Self::direction_cs`] (rad): positive to the left.
    pub steering: Real,
    /// Force of the engine along the rolling direction (mass·length/s²); negative to go backwards. It acts
    /// within the grip of the tyre.
    pub engine_force: Real,
    /// The largest braking impulse *in one update* (mass·length/s, at least 0, may be infinite). For a
    /// braking force set `force * dt`.
    ///
    /// It acts within the grip of the tyre: a wheel that is braked harder locks and slides.
    pub brake: Real,
    /// Rolling angle of the wheel (rad), positive forwards, by the last update. It grows without bound; whole
    /// turns can be subtracted at any time. See [`Self::rotation_cs`].
    pub rotation: Real,
    /// The force of the suspension in the last update (mass·length/s²).
    pub wheel_suspension_force: Real,
    /// The impulse along the direction of rolling, from the ground on the chassis, in the last update
    /// (mass·length/s).
    pub forward_impulse: Real,
    /// The impulse along the axle, from the ground on the chassis, in the last update (mass·length/s).
    pub side_impulse: Real,
    pub(super) raycast_info: RayCastInfo,
    pub(super) below: Option<Below>,
    pub(super) suspension_ws: Vector,
    pub(super) axle_ws: Vector,
    /// Spin (rad/s).
    pub(super) spin: Real,
    pub(super) is_sliding: bool,
    /// The impulses of the last update: along the normal, forward, to the side.
    pub(super) last_impulses: [Real; 3],
    /// Whether the log already contains that the wheel cannot be used.
    pub(super) is_reported: bool,
}

impl Wheel {
    /// A wheel of this make, to be placed.
    pub(super) fn tuned(tuning: &WheelTuning) -> Self {
        Self {
            chassis_connection_point_cs: Vector::ZERO,
            direction_cs: Vector::ZERO,
            axle_cs: Vector::ZERO,
            suspension_rest_length: 0.0,
            max_suspension_travel: tuning.max_suspension_travel,
            radius: 0.0,
            suspension_stiffness: tuning.suspension_stiffness,
            damping_compression: tuning.suspension_compression,
            damping_relaxation: tuning.suspension_damping,
            max_suspension_force: tuning.max_suspension_force,
            friction_slip: tuning.friction_slip,
            side_friction_stiffness: tuning.side_friction_stiffness,
            roll_influence: 0.1,
            steering: 0.0,
            engine_force: 0.0,
            brake: 0.0,
            rotation: 0.0,
            wheel_suspension_force: 0.0,
            forward_impulse: 0.0,
            side_impulse: 0.0,
            raycast_info: Self::nowhere(),
            below: None,
            suspension_ws: Vector::ZERO,
            axle_ws: Vector::ZERO,
            spin: 0.0,
            is_sliding: false,
            last_impulses: [0.0; 3],
            is_reported: false,
        }
    }

    /// Ray-cast result of the last update.
    pub fn raycast_info(&self) -> &RayCastInfo {
        &self.raycast_info
    }

    /// Direction of the suspension, in world space (unit length), as of the last update.
    pub fn suspension(&self) -> Vector {
        self.suspension_ws
    }

    /// The axle with steering, in world space (unit length), as of the last update.
    pub fn axle(&self) -> Vector {
        self.axle_ws
    }

    /// The middle of the wheel in world space, as of the last update.
    ///
    /// The step moves the chassis. To draw a wheel after the step, use [`Self::center_cs`].
    pub fn center(&self) -> Vector {
        self.raycast_info.hard_point_ws + self.suspension_ws * self.raycast_info.suspension_length
    }

    /// The middle of the wheel in the frame of the chassis, as of the last update.
    pub fn center_cs(&self) -> Vector {
        let down = self.direction_cs.normalize_or_zero();
        self.chassis_connection_point_cs + down * self.raycast_info.suspension_length
    }

    /// Rotation of the wheel in the frame of the chassis, by rolling and then by steering.
    ///
    /// For a wheel that is drawn with its axle along [`Self::axle_cs`]. Forward rolling is a negative
    /// rotation about the axle: its angle is `-rotation`.
    ///
    /// ```
    /// # use rapier3d::prelude::*;
    /// # fn pose_of_wheel(chassis: &RigidBody, wheel: &Wheel) -> Pose {
    /// let in_chassis = Pose::from_parts(wheel.center_cs(), wheel.rotation_cs());
    /// let in_world = *chassis.position() * in_chassis;
    /// # in_world
    /// # }
    /// ```
    pub fn rotation_cs(&self) -> Rotation {
        let rolled = rotation_from_angle(self.axle_cs.normalize_or_zero() * -self.rotation);
        let steered = rotation_from_angle(self.direction_cs.normalize_or_zero() * -self.steering);
        steered * rolled
    }

    /// Spin of the wheel (rad/s), positive forwards, as of the last update.
    pub fn spin(&self) -> Real {
        self.spin
    }

    /// Returns whether the tyre was at the limit of its grip in the last update: locked, spinning or
    /// drifting.
    pub fn is_sliding(&self) -> bool {
        self.is_sliding
    }
}
