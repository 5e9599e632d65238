//! A wheel on the ground: three rows between the chassis and the collider below.
//!
//! A row pushes two bodies apart along a direction e, at a point each, with the impulse λ:
//!
//! ```text
//! velocity       v = e·(v_c + ω_c × r_c) − e·(v_g + ω_g × r_g)          J = (e, r_c × e, −e, −r_g × e)
//! inverse mass   w = J M⁻¹ Jᵀ
//! ```
//!
//! The normal row and the row along the direction of rolling act on both bodies where the wheel stands. The
//! row to the side acts on the chassis higher up, towards the height of the centre of mass
//! ([`Wheel::roll_influence`](super::wheel::Wheel::roll_influence)). It also *measures* there: a row that
//! measured elsewhere than it pushes could do work and rock the car up. Both bodies get equal and opposite
//! impulses, so momentum is conserved. The difference of the moment arms is an angular momentum that is
//! subtracted from the car's roll.

use super::grip::Drive;
use super::spring::Spring;
use super::wheel::{Below, Wheel};
use crate::dim::math::{AngularInertia, Real, Vector, mul_inertia, zero_inertia};

/// A body as input of the rows: its velocities at the end of the step, as far as they are known.
#[derive(Copy, Clone, Debug)]
pub(super) struct Mover {
    pub center: Vector,
    pub inv_mass: Vector,
    pub inv_inertia: AngularInertia,
    /// Velocities now, before anything acted.
    pub old_linvel: Vector,
    pub old_angvel: Vector,
    /// Velocities at the end of the step.
    pub linvel: Vector,
    pub angvel: Vector,
}

impl Mover {
    /// Bodies that no impulse moves.
    pub fn fixed() -> Self {
        Self {
            center: Vector::ZERO,
            inv_mass: Vector::ZERO,
            inv_inertia: zero_inertia(),
            old_linvel: Vector::ZERO,
            old_angvel: Vector::ZERO,
            linvel: Vector::ZERO,
            angvel: Vector::ZERO,
        }
    }
}

/// One row of one wheel.
#[derive(Copy, Clone, Debug)]
pub(super) struct Row {
    direction: Vector,
    /// For the chassis and the ground: the moment of the direction, and the response to an impulse.
    moment: [Vector; 2],
    linear: [Vector; 2],
    angular: [Vector; 2],
    pub inv_mass: Real,
    pub impulse: Real,
}

impl Row {
    /// A row along a direction, through a point of the chassis and one of the ground.
    pub fn new(direction: Vector, points: [Vector; 2], movers: [&Mover; 2]) -> Self {
        let moment = [0, 1].map(|i| (points[i] - movers[i].center).cross(direction));
        let linear = movers.map(|mover| mover.inv_mass * direction);
        let angular = [0, 1].map(|i| mul_inertia(&movers[i].inv_inertia, moment[i]));
        let part = |i: usize| direction.dot(linear[i]) + moment[i].dot(angular[i]);
        Self { direction, moment, linear, angular, inv_mass: part(0) + part(1), impulse: 0.0 }
    }

    /// The velocity of the chassis against the ground at the end of the step.
    pub fn velocity(&self, chassis: &Mover, ground: &Mover) -> Real {
        let linear = self.direction.dot(chassis.linvel - ground.linvel);
        linear + self.moment[0].dot(chassis.angvel) - self.moment[1].dot(ground.angvel)
    }

    /// The same before anything acted.
    pub fn old_velocity(&self, chassis: &Mover, ground: &Mover) -> Real {
        let linear = self.direction.dot(chassis.old_linvel - ground.old_linvel);
        linear + self.moment[0].dot(chassis.old_angvel) - self.moment[1].dot(ground.old_angvel)
    }

    /// The impulse at which the velocity would be `target`.
    pub fn impulse_for(&self, target: Real, chassis: &Mover, ground: &Mover) -> Real {
        if self.inv_mass > 0.0 {
            self.impulse + (target - self.velocity(chassis, ground)) / self.inv_mass
        } else {
            0.0
        }
    }

    /// Changes the impulse, and with it both velocities.
    pub fn set_impulse(&mut self, impulse: Real, chassis: &mut Mover, ground: &mut Mover) {
        let change = impulse - self.impulse;
        self.impulse = impulse;
        chassis.linvel += self.linear[0] * change;
        chassis.angvel += self.angular[0] * change;
        ground.linvel -= self.linear[1] * change;
        ground.angvel -= self.angular[1] * change;
    }

    /// The impulse and its moment about a centre of mass, on the chassis (`0`) or the ground (`1`).
    pub fn wrench(&self, side: usize) -> (Vector, Vector) {
        let impulse = if side == 0 { self.impulse } else { -self.impulse };
        (self.direction * impulse, self.moment[side] * impulse)
    }
}

/// A wheel on the ground.
#[derive(Copy, Clone, Debug)]
pub(super) struct WheelContact {
    pub wheel: usize,
    /// Index of the body below it.
    pub ground: usize,
    pub normal: Row,
    pub forward: Row,
    pub side: Row,
    pub spring: Spring,
    pub drive: Drive,
    pub friction: Real,
    /// The admissible lateral slip (length units per second).
    pub side_target: Real,
    pub is_sliding: bool,
}

/// Common data of all wheels of a vehicle in one update.
#[derive(Copy, Clone, Debug)]
pub(super) struct Vehicle {
    /// Up, as the chassis has it, in world space.
    pub up: Vector,
    pub mass: Real,
    pub dt: Real,
}

impl WheelContact {
    /// A wheel in contact with the mover of this index, now or in the next step. `None` if it has no contact,
    /// or if its axle points into the ground, so that it has no rolling direction.
    pub fn new(
        index: usize,
        wheel: &Wheel,
        below: &Below,
        ground: usize,
        movers: [&Mover; 2],
        vehicle: &Vehicle,
    ) -> Option<Self> {
        let [chassis, ground_mover] = movers;
        let Below { normal, point, .. } = *below;
        let side = wheel.axle_ws.reject_from_normalized(normal).try_normalize()?;
        let forward = normal.cross(side);
        let height = (chassis.center - point).dot(vehicle.up);
        let raised = point + vehicle.up * (height * (1.0 - wheel.roll_influence));

        let normal = Row::new(normal, [point, point], movers);
        let side = Row::new(side, [raised, point], movers);
        let velocities =
            [normal.old_velocity(chassis, ground_mover), normal.velocity(chassis, ground_mover)];
        let slip = side.old_velocity(chassis, ground_mover);
        Some(Self {
            wheel: index,
            ground,
            forward: Row::new(forward, [point, point], movers),
            spring: Spring::new(wheel, below, velocities, normal.inv_mass, vehicle)?,
            normal,
            side,
            drive: Drive { engine: wheel.engine_force * vehicle.dt, brake: wheel.brake },
            friction: wheel.friction_slip,
            side_target: slip * (1.0 - wheel.side_friction_stiffness.min(1.0)),
            is_sliding: false,
        })
    }

    /// The three rows.
    pub fn rows(&self) -> [&Row; 3] {
        [&self.normal, &self.forward, &self.side]
    }
}
