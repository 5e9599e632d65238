//! Kinematic bodies that move and rotate towards other bodies: walls, doors, cages, pistons.

use super::PHASES;
use crate::dim::grounds::box_mesh;
use crate::dim::{about_z, cuboid, vec};
use crate::suite::physics::stage::weightless;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

const DT: Real = 1.0 / 60.0;

/// A ball, and a wall of 2 cm that approaches it.
struct Meeting {
    radius: Real,
    ball: Real,
    wall: Real,
}

impl Meeting {
    /// Returns the number of balls, of 20, that the wall passes.
    fn count_passed(&self, position_based: bool, shape: &ColliderBuilder, bullet: bool) -> usize {
        (0..PHASES).filter(|&phase| self.passes(position_based, shape, bullet, phase)).count()
    }

    fn passes(
        &self,
        position_based: bool,
        shape: &ColliderBuilder,
        bullet: bool,
        phase: usize,
    ) -> bool {
        let mut world = weightless(60);
        let start = 2.0 + (self.ball + self.wall) * DT * phase as Real / PHASES as Real;
        let builder = match position_based {
            true => RigidBodyBuilder::kinematic_position_based(),
            false => RigidBodyBuilder::kinematic_velocity_based().linvel(vec(-self.wall, 0.0)),
        };
        let (wall, _) = world.insert(builder.translation(vec(start, 0.0)), shape.clone());
        let ball = RigidBodyBuilder::dynamic().linvel(vec(self.ball, 0.0)).ccd_enabled(bullet);
        let (ball, _) = world.insert(ball, ColliderBuilder::ball(self.radius));
        (1..=40).any(|step| {
            let next = vec(start - self.wall * DT * step as Real, 0.0);
            if position_based {
                world.bodies[wall].set_next_kinematic_translation(next);
            }
            world.step();
            world.bodies[ball].translation().x > world.bodies[wall].translation().x
        })
    }
}

/// Number of balls that pass through a moving kinematic wall: zero.
#[test]
fn moving_walls_do_not_pass_balls() {
    let columns = ["radius", "ball", "wall", "velocity", "position", "mesh", "bullet"];
    let mut table = Table::new("balls that a wall of 2 cm passes, of 20", &columns);
    let (board, shell) = (cuboid(0.01, 5.0), box_mesh(vec(0.01, 5.0)));
    for [radius, ball, wall] in [
        [0.05, 30.0, 6.0],
        [0.05, 0.0, 5.0],
        [0.05, 0.0, 30.0],
        [0.05, 100.0, 100.0],
        [0.2, -3.0, 40.0],
        [0.5, 0.0, 12.0],
        [0.5, 0.0, 100.0],
    ] {
        let meeting = Meeting { radius, ball, wall };
        let counts = [
            meeting.count_passed(false, &board, false),
            meeting.count_passed(true, &board, false),
            meeting.count_passed(true, &shell, false),
            meeting.count_passed(false, &board, true),
        ];
        let [a, b, c, d] = counts.map(|count| count.to_string());
        table.row([radius.to_string(), ball.to_string(), wall.to_string(), a, b, c, d]);
        table.require(counts == [0; 4], "the wall passed balls");
    }
}

/// Counts balls at rest that a door of 2.5 m on a hinge at the origin passes, at nine distances from it.
fn count_passed_by_door(rate: Real, radius: Real, asleep: bool) -> usize {
    let passes = |place: usize| {
        let mut world = weightless(60);
        let at = vec(0.5 + 0.2 * place as Real, 1.0);
        let ball = RigidBodyBuilder::dynamic().translation(at).sleeping(asleep);
        let (ball, _) = world.insert(ball, ColliderBuilder::ball(radius));
        let door = RigidBodyBuilder::kinematic_velocity_based().angvel(about_z(rate));
        let (door, _) = world.insert(door, cuboid(1.25, 0.01).translation(vec(1.25, 0.0)));
        let mut before = 1.0;
        (0..(2.5 / rate / DT) as usize).any(|_| {
            world.step();
            let at = world.bodies[ball].translation();
            let seen = world.bodies[door].position().inverse_transform_point(at);
            // A ball beyond the end of the door does not count.
            let passed = before > 0.0 && seen.y < 0.0 && seen.x > 0.0 && seen.x < 2.5;
            before = seen.y;
            passed
        })
    };
    (0..9).filter(|&place| passes(place)).count()
}

/// Number of balls at rest that pass through a turning door: zero.
#[test]
fn doors_sweep_balls_along() {
    let columns = ["spin (rad/s)", "radius (m)", "awake", "asleep"];
    let mut table = Table::new("balls at rest that a door passes, of 9", &columns);
    for rate in [1.0, 3.0, 10.0, 20.0] {
        for radius in [0.05, 0.2, 0.4] {
            let counts = [false, true].map(|asleep| count_passed_by_door(rate, radius, asleep));
            let [awake, asleep] = counts.map(|count| count.to_string());
            table.row([rate.to_string(), radius.to_string(), awake, asleep]);
            table.require(counts == [0; 2], "the door passed balls");
        }
    }
}

/// Returns whether a sweeping blade of 2 cm passes a ball of 10 cm that lands on a floor. The blade is at the
/// tip of an arm that rotates at 10 rad/s.
fn blade_passes(arm: Real, speed: Real, phase: usize) -> bool {
    let (mut world, blade_speed) = (weightless(60), 10.0 * arm);
    world.insert_collider(cuboid(20.0, 0.1).translation(vec(0.0, -0.1)), None);
    let start = -blade_speed * DT * (3.0 + phase as Real / PHASES as Real) - 0.06;
    let blade = RigidBodyBuilder::kinematic_velocity_based()
        .translation(vec(start, 1.01))
        .linvel(vec(blade_speed, 0.0));
    let (blade, _) = world.insert(blade, cuboid(0.01, 1.0));
    // The ball lands in the fourth step, and the blade arrives in that step.
    let height = 0.05 + speed * DT * 3.3;
    let ball = RigidBodyBuilder::dynamic().translation(vec(0.0, height)).linvel(vec(0.0, -speed));
    let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.05));
    (0..10).any(|_| {
        world.step();
        let (at, edge) = (world.bodies[ball].translation(), world.bodies[blade].translation());
        at.y < 1.0 && at.x < edge.x
    })
}

/// Number of landing balls that pass through a rotating blade above the floor: zero.
#[test]
fn sweeping_blades_do_not_pass_landing_balls() {
    let columns = ["arm (m)", "5 m/s", "10 m/s", "20 m/s", "30 m/s"];
    let mut table = Table::new("balls that land and that a blade passes, of 20", &columns);
    for arm in [0.5, 1.0, 1.5, 2.0] {
        let counts = [5.0, 10.0, 20.0, 30.0]
            .map(|speed| (0..PHASES).filter(|&phase| blade_passes(arm, speed, phase)).count());
        let [a, b, c, d] = counts.map(|count| count.to_string());
        table.row([arm.to_string(), a, b, c, d]);
        table.require(counts == [0; 4], "the blade passed balls");
    }
}

/// Collision detection alone moves no kinematic body, and wakes no body in its path.
#[test]
fn detection_alone_wakes_nothing() {
    let mut world = weightless(60);
    let ball = RigidBodyBuilder::dynamic().translation(vec(0.0, 1.0)).sleeping(true);
    let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.05));
    let wall = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(0.0, 60.0));
    world.insert(wall, cuboid(1.0, 0.01));
    for _ in 0..3 {
        world.detect_collisions(&(), &());
        assert!(world.bodies[ball].is_sleeping());
    }
    world.step();
    assert!(!world.bodies[ball].is_sleeping());
}

/// Balls fly in a closed cage with walls of 2 cm that rotates about its centre. Number of balls
/// outside: zero.
#[test]
fn turning_cages_hold_balls() {
    let columns = ["spin (rad/s)", "0 m/s", "5 m/s", "30 m/s", "200 m/s"];
    let mut table = Table::new("balls that leave a turning cage, of 10", &columns);
    for rate in [0.5, 1.2, 5.0, 12.0] {
        let counts = [0.0, 5.0, 30.0, 200.0]
            .map(|speed| (0..10).filter(|&seed| leaves_cage(rate, speed, seed as Real)).count());
        let [a, b, c, d] = counts.map(|count| count.to_string());
        table.row([rate.to_string(), a, b, c, d]);
        table.require(counts == [0; 4], "balls left the cage");
    }
}

fn leaves_cage(rate: Real, speed: Real, seed: Real) -> bool {
    let mut world = weightless(60);
    let cage = RigidBodyBuilder::kinematic_velocity_based().angvel(about_z(rate));
    let cage = world.insert_body(cage);
    for side in 0..4 {
        let turned = about_z(core::f64::consts::FRAC_PI_2 as Real * side as Real);
        let place = Pose::new(vec(0.0, 0.0), turned) * vec(0.0, 2.01);
        let wall = cuboid(2.02, 0.01).translation(place).rotation(turned);
        world.insert_collider(wall, Some(cage));
    }
    let velocity = vec(seed.sin(), (1.7 * seed).cos()) * speed;
    let at = vec(0.9 * (2.3 * seed).sin(), 0.9 * (0.7 * seed).cos());
    let ball = RigidBodyBuilder::dynamic().translation(at).linvel(velocity);
    let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.05).restitution(0.8));
    (0..150).any(|_| {
        world.step();
        let at = world.bodies[ball].translation();
        world.bodies[cage].position().inverse_transform_point(at).abs().max_element() > 2.02
    })
}

/// A ball between a piston and a wall never passes the wall.
#[test]
fn pistons_push_nothing_through_walls() {
    for speed in [1.0, 10.0, 100.0] {
        for radius in [0.05, 0.3] {
            let mut world = weightless(60);
            world.insert_collider(cuboid(0.01, 5.0).translation(vec(-0.01, 0.0)), None);
            let ball = RigidBodyBuilder::dynamic().translation(vec(1.0, 0.0));
            let (ball, _) = world.insert(ball, ColliderBuilder::ball(radius));
            let piston = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(-speed, 0.0));
            let (piston, _) = world.insert(piston.translation(vec(2.0, 0.0)), cuboid(0.1, 5.0));
            for step in 0..200 {
                world.step();
                let (at, end) =
                    (world.bodies[ball].translation(), world.bodies[piston].translation());
                if end.x < 0.1 + 0.5 * radius {
                    break;
                }
                assert!(at.x > 0.0, "{speed} m/s, radius {radius}: {at} in step {step}");
                assert!(at.x < end.x, "{speed} m/s, radius {radius}: {at} behind {end}");
            }
        }
    }
}

/// Worlds with resting kinematic bodies run no CCD search.
#[test]
fn resting_kinematic_bodies_cost_nothing() {
    let mut world = weightless(60);
    world.insert(RigidBodyBuilder::kinematic_velocity_based(), cuboid(1.0, 0.1));
    let ball = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5)).linvel(vec(0.0, -0.1));
    world.insert(ball, ColliderBuilder::ball(0.3));
    for _ in 0..30 {
        world.step();
        let ccd = &world.physics_pipeline.counters.ccd;
        assert_eq!((ccd.num_fast_bodies, ccd.num_searches), (0, 0));
    }
}
