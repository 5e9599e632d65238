//! Piles in a pit: the step at which all bodies sleep, by shape and seed.
//!
//! ```text
//! cargo run --release -p rapier3d --example piles [KIND [COUNT [STEPS]]]
//! ```
//!
//! Without a kind the table has all of them. A pile that does not sleep within the steps shows its awake
//! bodies and its kinetic energy.

use rapier3d::prelude::*;
use std::process::ExitCode;

/// Seeds of each pile.
const SEEDS: u64 = 3;
/// Bodies of a pile, unless the command line has a number.
const COUNT: usize = 250;
/// Steps of a pile, unless the command line has a number: 25 s.
const STEPS: usize = 1_500;
/// Half the width of the pit (m).
const PIT: Real = 3.0;
/// All kinds of piles.
const KINDS: [&str; 7] = ["cylinder", "cone", "box", "ball", "capsule", "hull", "mixed"];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number =
        |k: usize, other: usize| arguments.get(k).map_or(Some(other), |text| text.parse().ok());
    let (Some(count), Some(steps)) = (number(1, COUNT), number(2, STEPS)) else {
        eprintln!("piles: COUNT and STEPS are whole numbers");
        return ExitCode::FAILURE;
    };
    let kinds: Vec<&str> = match arguments.first() {
        None => KINDS.to_vec(),
        Some(kind) => KINDS.into_iter().filter(|other| other == kind).collect(),
    };
    println!(
        "{:>9} {:>6} {:>6} {:>10} {:>6} {:>10}",
        "kind", "bodies", "seed", "asleep at", "awake", "energy (J)"
    );
    for (kind, seed) in kinds.into_iter().flat_map(|kind| (1..=SEEDS).map(move |seed| (kind, seed)))
    {
        let mut world = pit(kind, count, seed);
        let asleep_at = (1..=steps).find(|_| {
            world.step();
            world.active_bodies().is_empty()
        });
        let asleep_at = asleep_at.map_or("never".to_string(), |step| step.to_string());
        let energy: Real = world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum();
        let awake = world.active_bodies().len();
        println!("{kind:>9} {count:>6} {seed:>6} {asleep_at:>10} {awake:>6} {energy:>10.4}");
    }
    ExitCode::SUCCESS
}

/// A reproducible sequence of numbers (SplitMix64).
struct Dice(u64);

impl Dice {
    fn within(&mut self, low: Real, high: Real) -> Real {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 40) as Real / (1_u64 << 24) as Real;
        low + (high - low) * unit
    }

    fn vector(&mut self, size: Real) -> Vector {
        Vector::from_array([0; 3].map(|_| self.within(-size, size)))
    }
}

/// A shape of 0.25 to 0.5 m; the mixed pile has all kinds in turn.
fn shape(kind: &str, k: usize, dice: &mut Dice) -> ColliderBuilder {
    let (a, b) = (dice.within(0.25, 0.5), dice.within(0.25, 0.5));
    match kind {
        "cylinder" => ColliderBuilder::cylinder(a, b),
        "cone" => ColliderBuilder::cone(a, b),
        "box" => ColliderBuilder::cuboid(a, b, dice.within(0.25, 0.5)),
        "ball" => ColliderBuilder::ball(a),
        "capsule" => ColliderBuilder::capsule_y(a, b),
        "hull" => {
            let corners = [0; 12].map(|_| dice.vector(1.0).normalize_or(Vector::Y) * 0.45);
            ColliderBuilder::convex_hull(&corners).expect("twelve points in space have a hull")
        }
        _ => shape(KINDS[k % 6], k, dice),
    }
}

/// Layers of 25 bodies above each other between four walls.
fn pit(kind: &str, count: usize, seed: u64) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let mut dice = Dice(seed);
    let floor = ColliderBuilder::cuboid(PIT + 1.0, 0.5, PIT + 1.0);
    world.insert_collider(floor.translation(Vector::Y * -0.5), None);
    for direction in [Vector::X, -Vector::X, Vector::Z, -Vector::Z] {
        let half = Vector::new(PIT + 1.0, 30.0, PIT + 1.0) - direction.abs() * (PIT + 0.5);
        let wall = ColliderBuilder::cuboid(half.x, half.y, half.z);
        world.insert_collider(wall.translation(direction * (PIT + 0.5) + Vector::Y * 30.0), None);
    }
    for k in 0..count {
        let [column, layer, row] = [k % 5, k / 25, k / 5 % 5].map(|n| 1.1 * n as Real);
        let wobble = dice.vector(0.05) * (Vector::ONE - Vector::Y);
        let at = Vector::new(column - 2.2, 0.8 + layer, row - 2.2) + wobble;
        let body = RigidBodyBuilder::dynamic().translation(at).rotation(dice.vector(2.0));
        let shape = shape(kind, k, &mut dice);
        world.insert(body, shape);
    }
    world
}
