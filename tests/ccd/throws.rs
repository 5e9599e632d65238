//! Thin bodies of every shape tumble on thin grounds of every kind, at oblique angles.

use crate::dim::thin::{THIN_GROUNDS, random_turn, sideways, thin_shapes};
use crate::dim::{about_z, vec};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Ranges of the speeds (m/s).
const SPEEDS: [[Real; 2]; 3] = [[0.0, 5.0], [5.0, 40.0], [40.0, 600.0]];
/// Largest sideways distance of a body that is still above the ground.
const SIDE_MAX: Real = 9.0;

/// Generator of reproducible numbers from -1 to 1 (xorshift).
struct Random(u64);

impl Random {
    /// The numbers of a seed. The first ones of similar seeds are similar.
    fn new(seed: u64) -> Self {
        let mut random = Self(0x9e37_79b9_7f4a_7c15 ^ seed);
        for _ in 0..20 {
            random.next();
        }
        random
    }

    fn next(&mut self) -> Real {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        ((self.0 >> 40) as f64 / (1_u64 << 23) as f64 - 1.0) as Real
    }

    fn take<const N: usize>(&mut self) -> [Real; N] {
        core::array::from_fn(|_| self.next())
    }
}

/// Returns whether a body is below the ground within some steps.
fn passes(
    lay: fn(&mut PhysicsWorld, Pose, Real),
    shape: &ColliderBuilder,
    [slow, fast]: [Real; 2],
    seed: u64,
) -> bool {
    let mut random = Random::new((seed + 1) * 0x1234_5677);
    let mut world = PhysicsWorld::new();
    lay(&mut world, Pose::IDENTITY, 0.5);
    let share = 0.5 + 0.5 * random.next();
    let speed = slow + (fast - slow) * share;
    let down = (vec(0.0, -1.0) + sideways(random.take()) * 0.7).normalize();
    let spin = if random.next() > 0.4 { 0.0 } else { 12.0 };
    let body = RigidBodyBuilder::dynamic()
        .translation(vec(0.3 * random.next(), 1.6 + 0.4 * random.next()))
        .rotation(random_turn(random.take().map(|angle: Real| 3.0 * angle)))
        .linvel(down * speed)
        .angvel(random_turn(random.take().map(|rate: Real| spin * rate)));
    let (body, _) = world.insert(body, shape.clone());
    for _ in 0..90 {
        world.step();
        let at = world.bodies[body].center_of_mass();
        if (at - vec(0.0, at.y)).length() > SIDE_MAX {
            return false;
        }
        if at.y < -0.03 {
            return true;
        }
    }
    false
}

/// Fails if more than a fraction `rate_max` of all throws pass.
fn count_passed(seeds: u64, rate_max: f64) {
    let title = format!("thin things that pass a thin ground, of {seeds}");
    let mut table = Table::new(&title, &["ground", "shape", "0-5 m/s", "5-40 m/s", "40-600 m/s"]);
    let (mut passed, mut thrown) = (0, 0);
    for (ground, lay) in THIN_GROUNDS {
        for (name, shape) in thin_shapes() {
            let counts = SPEEDS
                .map(|range| (0..seeds).filter(|&seed| passes(lay, &shape, range, seed)).count());
            let [slow, middle, fast] = counts.map(|count| count.to_string());
            table.row([ground.to_owned(), name.to_owned(), slow, middle, fast]);
            passed += counts.iter().sum::<usize>();
            thrown += seeds as usize * SPEEDS.len();
        }
    }
    let rate = passed as f64 / thrown as f64;
    println!("  {passed} of {thrown} pass: {:.3} %", 100.0 * rate);
    table.require(rate <= rate_max, &format!("{passed} of all {thrown} passed"));
}

#[test]
fn thin_bodies_do_not_pass_thin_grounds() {
    count_passed(3, 0.0);
}

/// Largest passing rate, as stated in `docs/guide/fast-bodies.md`.
const RATE_MAX: f64 = 0.01;

/// The same with more throws, which take minutes. Slivers on large pieces pass occasionally.
#[test]
#[ignore = "takes minutes"]
fn few_thin_bodies_pass_thin_grounds_in_many_throws() {
    count_passed(40, RATE_MAX);
}

/// Largest number of steps in a row in which CCD may hold a body in the air.
const HELD_STEPS_MAX: usize = 4;

/// Returns for how many steps in a row a thrown body moved less than a hundredth of the way of its velocity.
fn longest_hold(
    lay: fn(&mut PhysicsWorld, Pose, Real),
    shape: &ColliderBuilder,
    seed: u64,
) -> usize {
    let mut random = Random::new((seed + 1) * 0x0765_4321);
    let mut world = PhysicsWorld::new();
    lay(&mut world, Pose::IDENTITY, 0.5);
    let speed = 125.0 + 75.0 * random.next();
    let steep = 0.6 + 0.4 * random.next();
    let direction = (vec(0.0, -steep) + sideways(random.take())).normalize();
    let spin = 100.0 + 100.0 * random.next();
    let body = RigidBodyBuilder::dynamic()
        .translation(vec(0.0, 2.0))
        .rotation(random_turn(random.take().map(|angle: Real| 3.0 * angle)))
        .linvel(direction * speed)
        .angvel(random_turn(random.take().map(|rate: Real| spin * rate)));
    let (body, _) = world.insert(body, shape.clone());
    let (mut held, mut longest) = (0, 0);
    for _ in 0..120 {
        let before = world.bodies[body].center_of_mass();
        world.step();
        let body = &world.bodies[body];
        let way = body.center_of_mass().distance(before);
        let is_held = way < 0.01 * body.linvel().length() * world.integration_parameters.dt;
        held = if is_held && body.linvel().length() > 0.5 { held + 1 } else { 0 };
        longest = longest.max(held);
    }
    longest
}

/// A body that lands hard and spins moves on: CCD does not hold it in the air where no contact acts.
fn count_held(seeds: u64, rate_max: f64) {
    let title = format!("thin things that hang in the air, of {seeds}");
    let mut table = Table::new(&title, &["ground", "shape", "held", "longest"]);
    let (mut held, mut thrown) = (0, 0);
    for (ground, lay) in THIN_GROUNDS {
        for (name, shape) in thin_shapes() {
            let longest = (0..seeds).map(|seed| longest_hold(lay, &shape, seed));
            let longest: Vec<usize> = longest.collect();
            let count = longest.iter().filter(|&&steps| steps > HELD_STEPS_MAX).count();
            let most = longest.iter().max().map_or(String::new(), |most| most.to_string());
            table.row([ground.to_owned(), name.to_owned(), count.to_string(), most]);
            held += count;
            thrown += seeds as usize;
        }
    }
    println!("  {held} of {thrown} hang");
    table.require(held as f64 <= rate_max * thrown as f64, &format!("{held} of {thrown} hang"));
}

/// Largest rate of hanging bodies, as stated in `docs/guide/fast-bodies.md`: tips that are jammed in the
/// ground.
const HELD_RATE_MAX: f64 = 0.02;

#[test]
fn few_thin_bodies_hang_in_the_air() {
    count_held(3, HELD_RATE_MAX);
}

/// The same with more throws: 7 of 3,080 in 2D, 45 of 3,640 in 3D.
#[test]
#[ignore = "takes half a minute"]
fn few_thin_bodies_hang_in_the_air_in_many_throws() {
    count_held(40, HELD_RATE_MAX);
}

/// A ball that spins arrives at a wall that is nearer than a hundredth of its way in a step.
#[test]
fn spinning_balls_arrive_at_walls() {
    for distance in [0.03, 0.05, 0.06] {
        for spin in [30.0, 100.0, 1000.0] {
            let mut world = PhysicsWorld::new();
            world.gravity = Vector::ZERO;
            world.insert_collider(super::wall(), None);
            let body = RigidBodyBuilder::dynamic().linvel(vec(400.0, 0.0)).angvel(about_z(spin));
            let body = body.translation(vec(-0.01 - 0.12 - distance, 0.0));
            let (ball, _) = world.insert(body, ColliderBuilder::ball(0.12));
            (0..3).for_each(|_| world.step());
            let speed = world.bodies[ball].linvel().x;
            assert!(speed < 40.0, "{distance} m off, {spin} rad/s: {speed} m/s after three steps");
        }
    }
}
