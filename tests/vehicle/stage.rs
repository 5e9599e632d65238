//! A test car and its ground.

use crate::suite::physics::stage::world;
use rapier::prelude::*;

/// Mass of the car (kg).
pub const MASS: Real = 1000.0;
/// Half the distance between the axles, and half the distance between the wheels of one axle (m).
pub const HALF_BASE: Real = 1.3;
pub const HALF_TRACK: Real = 0.8;
/// Stiffness (1/s²), damping (1/s) and rest length (m) of the suspension. With four wheels they give 2 Hz and
/// a damping ratio of 0.3.
pub const STIFFNESS: Real = 40.0;
pub const DAMPING: Real = 1.9;
pub const REST_LENGTH: Real = 0.4;
/// Radius of the wheels (m).
pub const RADIUS: Real = 0.3;
/// Distance of the suspensions below the centre of mass (m).
pub const HANG: Real = 0.2;
/// Compression of the springs at rest: `m g / 4 k` (m).
pub const SAG: Real = 9.81 / (4.0 * STIFFNESS);
/// Height of the centre of mass above the ground at rest (m).
pub const HEIGHT: Real = HANG + REST_LENGTH + RADIUS - SAG;

/// Tested numbers of steps per second.
pub const RATES: [u32; 3] = [30, 60, 120];

/// A car in a world.
pub struct Road {
    pub world: PhysicsWorld,
    pub car: DynamicRayCastVehicleController,
}

/// Returns the tuning of the car, with this coefficient of friction.
pub fn tuning(friction: Real) -> WheelTuning {
    WheelTuning {
        suspension_stiffness: STIFFNESS,
        suspension_compression: DAMPING,
        suspension_damping: DAMPING,
        friction_slip: friction,
        max_suspension_force: 1.0e5,
        ..WheelTuning::default()
    }
}

/// Adds a car that drives along x on its wheels, at a pose of its centre of mass. It never sleeps.
pub fn add_car(
    world: &mut PhysicsWorld,
    pose: Pose,
    friction: Real,
) -> DynamicRayCastVehicleController {
    let body = RigidBodyBuilder::dynamic().pose(pose).can_sleep(false);
    let shape = ColliderBuilder::cuboid(2.0, 0.3, 0.9).mass(MASS);
    let (chassis, _) = world.insert(body, shape);
    let mut car = DynamicRayCastVehicleController::new(chassis);
    for (x, z) in corners() {
        let place = Vector::new(x, -HANG, z);
        car.add_wheel(place, -Vector::Y, Vector::Z, REST_LENGTH, RADIUS, &tuning(friction));
    }
    car
}

/// Returns the positions of the wheels: front left, front right, rear left, rear right.
pub fn corners() -> [(Real, Real); 4] {
    let (x, z) = (HALF_BASE, HALF_TRACK);
    [(x, -z), (x, z), (-x, -z), (-x, z)]
}

impl Road {
    /// Creates a car that stands on a plane, which rises by this angle (rad) towards +x.
    pub fn new(rate: u32, slope: Real, friction: Real) -> Self {
        let mut world = world(rate);
        let turn = Rotation::from_rotation_z(slope);
        let plane = ColliderBuilder::cuboid(2000.0, 1.0, 2000.0)
            .position(Pose::from_parts(turn * -Vector::Y, turn));
        world.insert_collider(plane, None);
        world.step();
        let pose = Pose::from_parts(turn * Vector::Y * HEIGHT, turn);
        let car = add_car(&mut world, pose, friction);
        Self { world, car }
    }

    /// Creates a car on level ground.
    pub fn level(rate: u32, friction: Real) -> Self {
        Self::new(rate, 0.0, friction)
    }

    /// Runs one update and one step.
    pub fn step(&mut self) {
        let dt = self.world.integration_parameters.dt;
        self.car.update_vehicle(dt, self.world.query_pipeline_mut(QueryFilter::default()));
        self.world.step();
    }

    /// Runs updates and steps for this time (s).
    pub fn run(&mut self, seconds: Real) {
        let steps = (seconds / self.world.integration_parameters.dt).round() as usize;
        (0..steps).for_each(|_| self.step());
    }

    /// Returns the chassis.
    pub fn chassis(&self) -> &RigidBody {
        &self.world.bodies[self.car.chassis]
    }

    /// Edits each wheel.
    pub fn wheels(&mut self, set: impl FnMut(&mut Wheel)) {
        self.car.wheels_mut().iter_mut().for_each(set);
    }
}
