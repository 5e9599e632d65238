//! Cars on a landscape with ramps.

use crate::common::{Controls, Law, Scene, SceneInfo};
use crate::kit::{HALF_TURN, add_fixed, add_pyramid, cube};
use crate::rapier::parry::utils::Array2;
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "vehicle",
    description: "Three cars on rays: one jumps a ramp into a wall of boxes, one circles in the hills, one parks on a slope.",
    category: Category::Controllers,
    steps: 270,
    law: Law { overlap_max: 0.05, height_min: 0.0, ..Law::NONE },
    source: file!(),
    build,
};

/// Cells along each side of the landscape, and its length.
const CELLS: usize = 160;
const SIDE: Real = 160.0;
/// Half extents of a chassis.
const HALF: Vector = Vector::new(2.0, 0.35, 0.9);
/// Radius and half width of the wheels.
const WHEEL: (Real, Real) = (0.42, 0.18);

/// Speed of the car that circles.
const CIRCLING_SPEED: Real = 6.0;

/// Car, and the colliders that show its wheels.
#[derive(Clone)]
struct Car {
    controller: DynamicRayCastVehicleController,
    tyres: Vec<ColliderHandle>,
}

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    add_landscape(&mut world);
    add_ramp(&mut world, Vector::new(-6.0, 0.0, 0.0));
    add_pyramid(&mut world, Vector::new(14.0, 0.0, 0.0), 7, &cube(0.5).density(20.0), 0.5);

    let east = Rotation::IDENTITY;
    let mut jumper = add_car(&mut world, Vector::new(-25.0, 1.0, 0.0), east);
    let mut circler = add_car(&mut world, Vector::new(0.0, 2.0, 16.0), east);
    let uphill = Rotation::from_rotation_y(-0.5 * HALF_TURN);
    let mut parker = add_car(&mut world, Vector::new(6.0, 3.0, -13.0), uphill);
    world.step(); // The rays hit the ground of the last step.

    let controls = Controls::new("Arrow keys drive the yellow car.");
    let keys = controls.clone();
    Scene::new(world, View::orbit(60.0, 24.0))
        .controlled(controls)
        .focusing(Vector::new(-3.0, 0.0, -10.0), Vector::new(18.0, 4.0, 9.0))
        .script(move |world, step| {
            match keys.direction() {
                Some([right, up]) => {
                    let brake = if up == 0.0 { 20.0 } else { 0.0 };
                    jumper.drive(1500.0 * up, -0.5 * right, brake);
                }
                // Full throttle over the ramp; the brake at the wall.
                None if step < 220 => jumper.drive(1500.0, 0.0, 0.0),
                None => jumper.drive(0.0, 0.0, 60.0),
            }
            // The second car circles in the hills, no faster than its tyres hold.
            let throttle = if circler.speed(world) < CIRCLING_SPEED { 700.0 } else { 0.0 };
            circler.drive(throttle, -0.35, 0.0);
            // The third car only needs the brake.
            parker.drive(0.0, 0.0, Real::INFINITY);
            for car in [&mut jumper, &mut circler, &mut parker] {
                car.update(world);
            }
        })
}

/// Adds hills around a level road along x.
fn add_landscape(world: &mut PhysicsWorld) {
    let mut heights = Array2::zeros(CELLS + 1, CELLS + 1);
    for i in 0..=CELLS {
        for j in 0..=CELLS {
            let [z, x] = [i, j].map(|n| (n as Real / CELLS as Real - 0.5) * SIDE);
            let hills = 1.0 - (0.35 * x).cos() * (0.35 * z).cos();
            let off_road = ((z.abs() - 5.0) / 10.0).clamp(0.0, 1.0);
            heights[(i, j)] = off_road * (1.2 * hills + 0.12 * (z.abs() - 5.0));
        }
    }
    let field = ColliderBuilder::heightfield(heights, Vector::new(SIDE, 1.0, SIDE));
    world.insert(RigidBodyBuilder::fixed(), field);
}

/// Adds a ramp, as a mesh, that rises along x.
fn add_ramp(world: &mut PhysicsWorld, foot: Vector) {
    let profile = [(0.0, -0.2), (5.0, 0.9), (8.0, 1.9), (8.0, -0.2)];
    let mut vertices = Vec::new();
    for (x, y) in profile {
        vertices.extend([Vector::new(x, y, -2.0), Vector::new(x, y, 2.0)]);
    }
    let mut triangles = Vec::new();
    for strip in 0..3 {
        let [a, b, c, d] = [0, 1, 2, 3].map(|corner| 2 * strip + corner);
        triangles.extend([[a, b, c], [b, d, c]]);
    }
    triangles.extend([[0, 2, 6], [2, 4, 6], [1, 7, 3], [3, 7, 5]]);
    let ramp = ColliderBuilder::trimesh(vertices, triangles).expect("the ramp has triangles");
    add_fixed(world, foot, ramp);
}

/// Adds a car that drives along its x axis.
fn add_car(world: &mut PhysicsWorld, place: Vector, rotation: Rotation) -> Car {
    let body = RigidBodyBuilder::dynamic().pose(Pose::from_parts(place, rotation));
    let shape = ColliderBuilder::cuboid(HALF.x, HALF.y, HALF.z).mass(1200.0);
    let (chassis, _) = world.insert(body, shape);
    let cabin = ColliderBuilder::cuboid(0.9, 0.3, 0.75).translation(Vector::new(-0.3, 0.65, 0.0));
    world.insert_collider(cabin.density(1.0), Some(chassis));

    let mut controller = DynamicRayCastVehicleController::new(chassis);
    let tuning = WheelTuning {
        suspension_stiffness: 40.0,
        suspension_compression: 2.0,
        suspension_damping: 3.0,
        friction_slip: 1.5,
        max_suspension_force: 60_000.0,
        ..WheelTuning::default()
    };
    let (radius, half_width) = WHEEL;
    let mut tyres = Vec::new();
    for (x, z) in [(1.35, -0.9), (1.35, 0.9), (-1.35, -0.9), (-1.35, 0.9)] {
        let hang = Vector::new(x, -0.1, z);
        controller.add_wheel(hang, -Vector::Y, Vector::Z, 0.4, radius, &tuning);
        // The tyre is visible only: it has no mass and no collisions, and rays ignore the chassis.
        let tyre = ColliderBuilder::cylinder(half_width, radius)
            .density(0.0)
            .collision_groups(InteractionGroups::none());
        tyres.push(world.insert_collider(tyre, Some(chassis)));
    }
    Car { controller, tyres }
}

impl Car {
    fn speed(&self, world: &PhysicsWorld) -> Real {
        world.bodies[self.controller.chassis].linvel().length()
    }

    /// Sets engine force and brake of each wheel, and the steering angle of the front wheels.
    fn drive(&mut self, engine_force: Real, steering: Real, brake: Real) {
        for (index, wheel) in self.controller.wheels_mut().iter_mut().enumerate() {
            wheel.engine_force = engine_force;
            wheel.steering = if index < 2 { steering } else { 0.0 };
            wheel.brake = brake;
        }
    }

    /// Updates the wheels, and moves their visible colliders.
    fn update(&mut self, world: &mut PhysicsWorld) {
        let dt = world.integration_parameters.dt;
        self.controller.update_vehicle(dt, world.query_pipeline_mut(QueryFilter::default()));
        // The axis of a cylinder is y, that of a wheel z.
        let upright = Rotation::from_rotation_x(0.5 * HALF_TURN);
        for (wheel, &tyre) in self.controller.wheels().iter().zip(&self.tyres) {
            let pose = Pose::from_parts(wheel.center_cs(), wheel.rotation_cs() * upright);
            world.colliders[tyre].set_position_wrt_parent(pose);
        }
    }
}
