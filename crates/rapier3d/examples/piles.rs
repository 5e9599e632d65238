//! Piles that should come to rest: when they fall asleep, and how they move until then.
//!
//! ```text
//! cargo run --release -p rapier3d --example piles -- cylinder 250 1 2400
//! cargo run --release -p rapier3d --example piles -- wall 100 1 800
//! ```
//!
//! The arguments are what the pile is made of, how many (or how high), a seed, and how many steps it gets. Every so often a line
//! tells the kinetic energy, speeds, and how far the points of bodies drifted in the last second.

use rapier3d::prelude::*;

fn main() {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let word = |k: usize, other: &str| args.get(k).cloned().unwrap_or_else(|| other.to_string());
    let kind = word(0, "cylinder");
    let number = |k: usize, other: u64| args.get(k).map_or(other, |a| a.parse().unwrap());
    let (count, seed, steps) = (number(1, 250), number(2, 1), number(3, 2400));
    let mut world = match kind.as_str() {
        "wall" => wall(count as usize),
        "pyramid" => pyramid(count as usize),
        "cards" => cards(count as usize),
        _ => pit(&kind, count as usize, seed),
    };
    if std::env::var("NOCCD").is_ok() {
        world.integration_parameters.max_ccd_substeps = 0;
    }
    if std::env::var("AWAKE").is_ok() {
        let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
        for body in bodies {
            *world.bodies[body].activation_mut() = RigidBodyActivation::cannot_sleep();
        }
    }
    if let Ok(linear) = std::env::var("LINEAR") {
        let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
        for body in bodies {
            world.bodies[body].activation_mut().normalized_linear_threshold =
                linear.parse().unwrap();
        }
    }
    watch(&mut world, steps as usize, number(4, 120) as usize, number(5, 0) as usize);
}

struct Dice(u64);

impl Dice {
    fn within(&mut self, low: f32, high: f32) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 40) as f32 / (1_u64 << 24) as f32;
        low + (high - low) * unit
    }
}

fn shape(kind: &str, k: usize, dice: &mut Dice) -> ColliderBuilder {
    let (a, b) = (dice.within(0.25, 0.5), dice.within(0.25, 0.5));
    match kind {
        "cylinder" => ColliderBuilder::cylinder(a, b),
        "cone" => ColliderBuilder::cone(a, b),
        "box" => ColliderBuilder::cuboid(a, b, dice.within(0.25, 0.5)),
        "ball" => ColliderBuilder::ball(a),
        "capsule" => ColliderBuilder::capsule_y(a, b),
        "roundcylinder" => ColliderBuilder::round_cylinder(a, b, 0.05),
        "hull" => {
            let points: Vec<_> = (0..12)
                .map(|_| {
                    let v = Vector::new(
                        dice.within(-1.0, 1.0),
                        dice.within(-1.0, 1.0),
                        dice.within(-1.0, 1.0),
                    );
                    v.normalize_or_zero() * 0.45
                })
                .collect();
            ColliderBuilder::convex_hull(&points).unwrap()
        }
        _ => {
            let kinds = ["cylinder", "cone", "box", "ball", "capsule", "hull"];
            shape(kinds[k % 6], k, dice)
        }
    }
}

fn pit(kind: &str, count: usize, seed: u64) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let mut dice = Dice(seed);
    let half = 3.0;
    world.insert_collider(
        ColliderBuilder::cuboid(half + 1.0, 0.5, half + 1.0).translation(vector![0.0, -0.5, 0.0]),
        None,
    );
    for (x, z) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0_f32)] {
        let (hx, hz) = if x != 0.0 { (0.5, half + 1.0) } else { (half + 1.0, 0.5) };
        let wall = ColliderBuilder::cuboid(hx, 30.0, hz);
        world.insert_collider(
            wall.translation(vector![x * (half + 0.5), 30.0, z * (half + 0.5)]),
            None,
        );
    }
    for k in 0..count {
        let at = vector![
            (k % 5) as f32 * 1.1 - 2.2 + dice.within(-0.05, 0.05),
            0.8 + 1.1 * (k / 25) as f32,
            (k / 5 % 5) as f32 * 1.1 - 2.2 + dice.within(-0.05, 0.05)
        ];
        let turn = vector![dice.within(-2.0, 2.0), dice.within(-2.0, 2.0), dice.within(-2.0, 2.0)];
        let body = RigidBodyBuilder::dynamic().translation(at).rotation(turn);
        let shape = shape(kind, k, &mut dice);
        world.insert(body, shape);
    }
    world
}

fn ground(world: &mut PhysicsWorld) {
    world.insert_collider(
        ColliderBuilder::cuboid(200.0, 1.0, 200.0).translation(vector![0.0, -1.0, 0.0]),
        None,
    );
}

/// Bricks of 1 m x 0.5 m in a bond.
fn wall(rows: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    ground(&mut world);
    for row in 0..rows {
        for k in 0..20 {
            let x = k as f32 + if row % 2 == 0 { 0.0 } else { 0.5 };
            let body =
                RigidBodyBuilder::dynamic().translation(vector![x, 0.25 + 0.5 * row as f32, 0.0]);
            world.insert(body, ColliderBuilder::cuboid(0.5, 0.25, 0.5));
        }
    }
    world
}

fn pyramid(base: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    ground(&mut world);
    for row in 0..base {
        for k in 0..base - row {
            let x = k as f32 - 0.5 * (base - row) as f32;
            let body = RigidBodyBuilder::dynamic().translation(vector![x, 0.5 + row as f32, 0.0]);
            world.insert(body, ColliderBuilder::cuboid(0.5, 0.5, 0.5).friction(0.6));
        }
    }
    world
}

/// A house of cards of 2 mm, 40 cm long.
fn cards(storeys: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    ground(&mut world);
    let [length, thickness, width] = [0.2, 0.001, 0.125];
    let lean: f32 = std::env::var("LEAN").map_or(0.43, |a| a.parse().unwrap());
    let card = ColliderBuilder::cuboid(thickness, length, width).friction(0.8);
    let rise = length * lean.cos() + thickness * lean.sin();
    let run = length * lean.sin() + thickness * lean.cos();
    let spacing = 2.0 * length + 2.0 * thickness;
    for storey in 0..storeys {
        let floor = storey as f32 * (2.0 * rise + 2.0 * thickness);
        let tents = storeys - storey;
        for tent in 0..tents {
            let x = spacing * (tent as f32 - (tents - 1) as f32 / 2.0);
            for side in [-1.0, 1.0] {
                let body = RigidBodyBuilder::dynamic()
                    .translation(vector![x + side * run, floor + rise, 0.0])
                    .rotation(vector![0.0, 0.0, side * lean]);
                world.insert(body, card.clone());
            }
            if tent + 1 < tents {
                let middle = vector![x + 0.5 * spacing, floor + 2.0 * rise + thickness, 0.0];
                let lying = ColliderBuilder::cuboid(length, thickness, width).friction(0.8);
                world.insert(RigidBodyBuilder::dynamic().translation(middle), lying);
            }
        }
    }
    world
}

fn energy(world: &PhysicsWorld) -> f64 {
    world.bodies.iter().map(|(_, body)| f64::from(body.kinetic_energy())).sum()
}

/// Steps the world and prints a line every so often.
fn watch(world: &mut PhysicsWorld, steps: usize, every: usize, from: usize) {
    let poses = |world: &PhysicsWorld| -> Vec<Pose> {
        world.bodies.iter().map(|(_, body)| *body.position()).collect()
    };
    let start = poses(world);
    let mut marks = start.clone();
    println!(
        "  step  awake       energy   fastest    median     v>.05    drift/s    median   >1cm/s    who from start"
    );
    for step in 1..=steps {
        world.step();
        if step % every == 0 {
            print!("{step:>6} ");
            report(world, &start, &marks, every as f32 / 60.0);
            marks = poses(world);
        }
        if from > 0 && step >= from {
            detail(world, step);
        }
        if world.islands.num_active_bodies() == 0 {
            println!("all asleep at step {step}");
            break;
        }
    }
}

/// Prints energy, speeds and drifts; the last took place in a time `dt` since the poses `marks`.
fn report(world: &PhysicsWorld, start: &[Pose], marks: &[Pose], dt: f32) {
    let bodies = || world.bodies.iter().map(|(_, body)| body);
    let mut speeds: Vec<f32> =
        bodies().map(|body| body.linvel().length() + 0.4 * body.angvel().length()).collect();
    let from =
        |body: &RigidBody, mark: &Pose| (body.position().translation - mark.translation).length();
    let turn =
        |body: &RigidBody, mark: &Pose| 0.4 * body.position().rotation.angle_between(mark.rotation);
    let mut drifts: Vec<f32> = bodies()
        .zip(marks)
        .map(|(body, mark)| (from(body, mark) + turn(body, mark)) / dt)
        .collect();
    let who = (0..drifts.len()).max_by(|&a, &b| drifts[a].total_cmp(&drifts[b])).unwrap_or(0);
    let far = bodies().zip(start).map(|(body, mark)| from(body, mark)).fold(0.0, f32::max);
    let quick = speeds.iter().filter(|&&v| v > 0.05).count();
    let moving = drifts.iter().filter(|&&v| v > 0.01).count();
    speeds.sort_by(f32::total_cmp);
    drifts.sort_by(f32::total_cmp);
    let [fastest, farthest] =
        [&speeds, &drifts].map(|sorted| sorted.last().copied().unwrap_or(0.0));
    let [speed, drift] = [&speeds, &drifts].map(|sorted| sorted[sorted.len() / 2]);
    let awake = world.islands.num_active_bodies();
    println!(
        "{awake:>6} {:>12.5} {fastest:>9.5} {speed:>9.5} {quick:>9} {farthest:>10.6} {drift:>9.6} {moving:>8} {who:>6} {far:>10.5}",
        energy(world)
    );
}

/// Who is fastest, and all its contacts.
fn detail(world: &PhysicsWorld, step: usize) {
    let who = std::env::var("WHO").ok().map(|w| w.parse::<usize>().unwrap());
    let fastest = match who {
        Some(k) => world.bodies.iter().nth(k).unwrap(),
        None => world
            .bodies
            .iter()
            .max_by(|(_, a), (_, b)| {
                let v = |b: &RigidBody| b.linvel().length() + 0.4 * b.angvel().length();
                v(a).total_cmp(&v(b))
            })
            .unwrap(),
    };
    let (handle, body) = fastest;
    let collider = body.colliders()[0];
    println!(
        "step {step} body {:?} v {:.4?} w {:.4?} at {:.4?}",
        handle.into_raw_parts().0,
        body.linvel(),
        body.angvel(),
        body.translation()
    );
    for pair in world.narrow_phase.contact_pairs_with(collider) {
        for m in &pair.manifolds {
            let name = |c: ColliderHandle| {
                format!("{}:{:?}", c.into_raw_parts().0, world.colliders[c].shape().shape_type())
            };
            println!(
                "   {} - {} n {:.3?}",
                name(pair.collider1),
                name(pair.collider2),
                m.data.normal
            );
            for p in m.contacts() {
                println!(
                    "      {:.4?} dist {:.5} impulse {:.5} fid {:?} {:?}",
                    world.colliders[pair.collider1].position() * p.local_p1,
                    p.dist,
                    p.impulse,
                    p.fid1,
                    p.fid2
                );
            }
        }
    }
}
