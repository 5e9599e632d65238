//! Kinematic bodies that translate and rotate: cages, walls and doors. No ball tunnels through them, and no
//! ball leaves a cage.
//!
//! `docs/guide/fast-bodies.md` guarantees this for balls of 10 cm or more at up to 200 m/s. Walls move at up
//! to 100 m/s, doors rotate at up to 20 rad/s, cages at up to 12 rad/s. There is no gravity, and no obstacle
//! behind a ball that could squeeze it.

use super::dim::about_z;
use super::rapier::prelude::*;
use super::room::block;
use super::values::within;
use super::world::check;
use crate::Tally;
use crate::choices::Choices;

const DT: Real = 1.0 / 60.0;
/// Half the thickness of all walls (m).
const HALF_THICKNESS: Real = 0.01;
/// Half the width of the cage (m).
const CAGE: Real = 2.0;
/// Length of the door (m).
const DOOR: Real = 2.5;
/// Largest radius of a ball (m).
const RADIUS_MAX: Real = 0.3;

type Scene = fn(&mut PhysicsWorld, &mut Choices<'_>) -> Tally;
const SCENES: [Scene; 4] = [cage, cage, wall, door];

/// Runs one scene.
pub fn run(choices: &mut Choices<'_>) -> Tally {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    choices.pick(&SCENES)(&mut world, choices)
}

/// Kinematic body with a constant velocity, driven by velocity or by its next position.
struct Driven {
    body: RigidBodyHandle,
    velocity: Vector,
    spin: Real,
    angle: Real,
    is_position_based: bool,
}

impl Driven {
    fn add(
        world: &mut PhysicsWorld,
        [from, velocity]: [Vector; 2],
        spin: Real,
        choices: &mut Choices<'_>,
    ) -> Self {
        let is_position_based = choices.coin();
        let builder = match is_position_based {
            true => RigidBodyBuilder::kinematic_position_based(),
            false => {
                RigidBodyBuilder::kinematic_velocity_based().linvel(velocity).angvel(about_z(spin))
            }
        };
        choices.print(|| format!("{velocity} m/s, {spin} rad/s, by position: {is_position_based}"));
        let body = world.insert_body(builder.translation(from));
        Self { body, velocity, spin, angle: 0.0, is_position_based }
    }

    /// Sets the pose of the body after the next step.
    fn advance(&mut self, world: &mut PhysicsWorld) {
        if self.is_position_based {
            self.angle += self.spin * DT;
            let body = &mut world.bodies[self.body];
            let place = body.translation() + self.velocity * DT;
            let turned = RigidBodyBuilder::fixed().rotation(about_z(self.angle)).build();
            body.set_next_kinematic_position(Pose::from_parts(place, *turned.rotation()));
        }
    }

    /// Steps the world, and returns the ball's position in the body's frame before and after the step.
    fn step(&mut self, world: &mut PhysicsWorld, ball: RigidBodyHandle) -> [Vector; 2] {
        let seen = |world: &PhysicsWorld| {
            let at = world.bodies[ball].translation();
            world.bodies[self.body].position().inverse_transform_point(at)
        };
        let before = seen(world);
        let body = self.body;
        self.advance(world);
        world.step();
        check(world);
        let at = world.bodies[ball].translation();
        [before, world.bodies[body].position().inverse_transform_point(at)]
    }
}

/// Creates a closed cage that rotates and moves, with balls inside.
fn cage(world: &mut PhysicsWorld, choices: &mut Choices<'_>) -> Tally {
    let spin = within(choices, -12.0, 12.0);
    let velocity = if choices.coin() { Vector::ZERO } else { some_velocity(choices, 10.0) };
    let mut cage = Driven::add(world, [Vector::ZERO, velocity], spin, choices);
    for axis in Vector::AXES {
        for side in [1.0, -1.0] {
            let half = Vector::splat(CAGE + 2.0 * HALF_THICKNESS) * (Vector::ONE - axis)
                + axis * HALF_THICKNESS;
            let wall = block(half).translation(axis * (side * (CAGE + HALF_THICKNESS)));
            world.insert_collider(wall.restitution(within(choices, 0.0, 1.0)), Some(cage.body));
        }
    }
    let count = choices.below(4) + 1;
    let balls: Vec<_> = (0..count)
        .map(|k| {
            let corner = Vector::X * (2.0 * (k % 2) as Real - 1.0)
                + Vector::Y * (2.0 * (k / 2) as Real - 1.0);
            add_ball(world, corner * 0.8, 200.0, choices)
        })
        .collect();
    let mut tally = Tally { operations: count, steps: 0 };
    for _ in 0..150 {
        let [_, first] = cage.step(world, balls[0]);
        tally.steps += 1;
        choices.print(|| format!("step {}: the first ball is at {first}", tally.steps));
        for &ball in &balls {
            let at = world.bodies[ball].translation();
            let seen = world.bodies[cage.body].position().inverse_transform_point(at);
            let is_inside = seen.abs().max_element() < CAGE + 2.0 * HALF_THICKNESS;
            assert!(is_inside, "a ball left the cage: its position there is {seen}");
        }
    }
    tally
}

fn add_ball(
    world: &mut PhysicsWorld,
    at: Vector,
    speed: f64,
    choices: &mut Choices<'_>,
) -> RigidBodyHandle {
    let radius = within(choices, 0.05, f64::from(RADIUS_MAX));
    let speed = if choices.once_in(4) { 0.0 } else { speed * choices.within(0.0, 1.0) };
    let velocity = some_velocity(choices, 1.0).normalize_or_zero() * speed as Real;
    choices.print(|| format!("a ball of {radius} m at {at} with {velocity} m/s"));
    let body = RigidBodyBuilder::dynamic()
        .translation(at)
        .linvel(velocity)
        .ccd_enabled(choices.once_in(4))
        .sleeping(choices.once_in(4));
    let ball = ColliderBuilder::ball(radius).restitution(within(choices, 0.0, 1.0));
    world.insert(body, ball).0
}

fn some_velocity(choices: &mut Choices<'_>, size: f64) -> Vector {
    Vector::from_array(Vector::ZERO.to_array().map(|_| within(choices, -size, size)))
}

/// Creates a moving wall, and a ball that approaches it or moves away more slowly.
fn wall(world: &mut PhysicsWorld, choices: &mut Choices<'_>) -> Tally {
    let speed = within(choices, 5.0, 100.0);
    let start = 2.0 + speed * DT * within(choices, 0.0, 2.0);
    let drive = [Vector::X * start, Vector::X * -speed];
    let mut wall = Driven::add(world, drive, 0.0, choices);
    let half = Vector::splat(5.0) * (Vector::ONE - Vector::X) + Vector::X * HALF_THICKNESS;
    world.insert_collider(block(half), Some(wall.body));
    let ball = add_ball(world, Vector::ZERO, 0.0, choices);
    let velocity = Vector::X * within(choices, -0.5 * f64::from(speed), 100.0);
    world.bodies[ball].set_linvel(velocity, true);
    let mut tally = Tally { operations: 1, steps: 0 };
    for _ in 0..40 {
        let [_, seen] = wall.step(world, ball);
        tally.steps += 1;
        choices.print(|| format!("step {}: the ball is at {seen}", tally.steps));
        assert!(
            seen.x < HALF_THICKNESS,
            "a wall at {speed} m/s passed a ball at {velocity}: {seen}"
        );
    }
    tally
}

/// Creates a door that rotates about its hinge, and a ball in its path.
fn door(world: &mut PhysicsWorld, choices: &mut Choices<'_>) -> Tally {
    let rate = within(choices, 1.0, 20.0);
    let mut door = Driven::add(world, [Vector::ZERO; 2], rate, choices);
    let half = Vector::splat(0.5 * DOOR) * (Vector::ONE - Vector::Y) + Vector::Y * HALF_THICKNESS;
    world.insert_collider(block(half).translation(Vector::X * (0.5 * DOOR)), Some(door.body));
    let at = Vector::X * within(choices, 0.3, 2.2) + Vector::Y * within(choices, 0.35, 1.5);
    let ball = add_ball(world, at, 0.0, choices);
    let mut tally = Tally { operations: 1, steps: 0 };
    let steps = (DOOR / rate / DT) as usize;
    for _ in 0..steps {
        let [before, seen] = door.step(world, ball);
        tally.steps += 1;
        choices.print(|| format!("step {}: the ball is at {seen}", tally.steps));
        // A ball beyond the end of the door, or at the hinge, is not in its path.
        let is_before_end = before.length().max(seen.length()) < DOOR - RADIUS_MAX;
        let is_beside = seen.x > 0.0 && is_before_end;
        let is_passed = before.y > 0.0 && seen.y < 0.0 && is_beside;
        assert!(!is_passed, "a door at {rate} rad/s passed a ball: it is at {seen}");
    }
    tally
}
