//! Worst-case steps: time and memory of scenes with growing pairs, triangles or bodies, as the scene doubles.
//!
//! Each line runs in a separate process, so that its peak memory (Linux only) is that of its scene.
//! "Exponent" is the growth of the time relative to the line before: 1 is proportional, 2 is quadratic.
//! `tests/hostile/bounds.rs` states the bounds and counts work instead of time.
//!
//! ```text
//! cargo run --release -p rapier3d --example crowds [SCENE [SIZE [STEPS]]]
//! ```

use rapier3d::parry::utils::Array2;
use rapier3d::prelude::*;
use std::process::Command;
use std::time::Instant;

/// Number of timed steps.
const STEPS: usize = 3;

/// A scene: its name, its timed sizes, and its builder.
type Scene = (&'static str, [usize; 3], fn(usize) -> PhysicsWorld);

const SCENES: [Scene; 11] = [
    ("sensors", [1_250, 2_500, 5_000], sensors),
    ("boxes", [1_250, 2_500, 5_000], boxes),
    ("colliders", [750, 1_500, 3_000], colliders),
    ("mesh", [50_000, 125_000, 500_000], |triangles| body_over_mesh(triangles, plate(), 0.5)),
    ("sunk", [50_000, 125_000, 500_000], |triangles| body_over_mesh(triangles, plate(), 0.0)),
    ("field", [40_000, 250_000, 1_000_000], box_over_field),
    ("meshes", [1_250, 2_500, 5_000], dynamic_meshes),
    ("balls", [1_250, 2_500, 5_000], meshes_at_one_point),
    ("soups", [1_250, 2_500, 5_000], triangle_soups),
    ("compounds", [500, 1_000, 2_000], compounds),
    ("joints", [10, 100, 1_000], joints),
];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |at: usize| arguments.get(at).and_then(|text| text.parse().ok());
    let is_wanted = |name: &str| arguments.first().is_none_or(|wanted| wanted == name);
    if let Some(size) = number(1) {
        let steps = number(2).unwrap_or(STEPS);
        SCENES.iter().filter(|scene| is_wanted(scene.0)).for_each(|scene| run(scene, size, steps));
        return;
    }
    println!("{:>10} {:>8} {:>10} {:>9} {:>8}", "scene", "size", "worst (s)", "exponent", "MiB");
    for scene in SCENES.iter().filter(|scene| is_wanted(scene.0)) {
        print_growth(scene);
    }
}

/// Runs a scene at its sizes, each in another process.
fn print_growth((name, sizes, _): &Scene) {
    let mut last: Option<(usize, f64)> = None;
    for &size in sizes {
        let Ok(program) = std::env::current_exe() else { return };
        let output = Command::new(program).args([name, &size.to_string()[..]]).output();
        let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
        let text = text.unwrap_or_default();
        let time = text.split_whitespace().next().and_then(|word| word.parse().ok());
        let time: f64 = time.unwrap_or(f64::NAN);
        let grown = last.map(|(size0, time0)| {
            format!("{:.2}", (time / time0).ln() / (size as f64 / size0 as f64).ln())
        });
        let exponent = grown.unwrap_or_default();
        let rest = text.trim().split_once(' ').map_or("", |(_, rest)| rest);
        println!("{name:>10} {size:>8} {time:>10.3} {exponent:>9} {rest}");
        last = Some((size, time));
    }
}

/// Prints the longest step, the peak memory, and the counters.
fn run((_, _, build): &Scene, size: usize, steps: usize) {
    let mut world = build(size);
    let before = peak_mib();
    let (mut worst, mut fastest): (f64, Real) = (0.0, 0.0);
    for _ in 0..steps {
        let start = Instant::now();
        world.step();
        worst = worst.max(start.elapsed().as_secs_f64());
        let speeds = world.bodies.iter().map(|(_, body)| body.linvel().length());
        fastest = speeds.fold(fastest, Real::max);
    }
    let counters = &world.physics_pipeline.counters;
    println!(
        "{worst:.4} {:>8} fastest {fastest:.1} m/s, contact pairs {}, points {}, crowded {}",
        peak_mib() - before,
        counters.cd.ncontact_pairs,
        counters.solver.ncontacts,
        counters.cd.ncrowded,
    );
}

/// Returns the peak memory of the process.
fn peak_mib() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM:"));
    let word = line.and_then(|line| line.split_whitespace().nth(1));
    word.and_then(|word| word.parse::<usize>().ok()).unwrap_or(0) / 1024
}

fn with_ground() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
    world
}

fn cube(half: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half, half, half)
}

fn heap(count: usize, collider: &ColliderBuilder) -> PhysicsWorld {
    let mut world = with_ground();
    for _ in 0..count {
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y);
        world.insert(body, collider.clone());
    }
    world
}

/// Sensors of dynamic bodies at one point.
fn sensors(count: usize) -> PhysicsWorld {
    heap(count, &cube(0.5).sensor(true))
}

/// Boxes at one point.
fn boxes(count: usize) -> PhysicsWorld {
    heap(count, &cube(0.5))
}

/// Two bodies of many colliders that all overlap.
fn colliders(count: usize) -> PhysicsWorld {
    let mut world = with_ground();
    for side in [-0.1, 0.1] {
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(side, 1.0, 0.0));
        let (body, _) = world.insert(body, cube(0.5));
        for k in 1..count {
            let at = Vector::X * (0.01 * (k % 7) as Real);
            world.insert_collider(cube(0.5).translation(at), Some(body));
        }
    }
    world
}

/// Returns the height of hilly ground.
fn height(x: Real, z: Real) -> Real {
    0.3 * (0.31 * x).sin() * (0.23 * z).cos()
}

/// Returns a hilly square of this many triangles, about as wide as `width`.
fn hills(triangles: usize, width: Real) -> (Vec<Vector>, Vec<[u32; 3]>) {
    let side = ((triangles as f64 / 2.0).sqrt() as u32).max(2);
    let at = |k: u32| width * (k as Real / side as Real - 0.5);
    let row = side + 1;
    let points = (0..row * row).map(|k| {
        let (x, z) = (at(k % row), at(k / row));
        Vector::new(x, height(x, z), z)
    });
    let cells = (0..side * side).map(|k| (k / side) * row + k % side);
    let halves = cells.flat_map(|k| [[k, k + row, k + 1], [k + 1, k + row, k + row + 1]]);
    (points.collect(), halves.collect())
}

/// A plate as large as the ground.
fn plate() -> ColliderBuilder {
    ColliderBuilder::cuboid(50.0, 0.5, 50.0)
}

/// A body over a mesh.
fn body_over_mesh(triangles: usize, collider: ColliderBuilder, level: Real) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let (points, indices) = hills(triangles, 100.0);
    let mesh = ColliderBuilder::trimesh(points, indices).expect("hills are a mesh");
    world.insert_collider(mesh, None);
    let body = RigidBodyBuilder::dynamic().translation(Vector::Y * level);
    world.insert(body, collider);
    world
}

/// A box as large as the height field that it lies on.
fn box_over_field(cells: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let side = (cells as f64).sqrt() as usize;
    let mut heights = Array2::zeros(side + 1, side + 1);
    for column in 0..=side {
        for row in 0..=side {
            let at = |k: usize| 100.0 * (k as Real / side as Real - 0.5);
            heights[(row, column)] = height(at(column), at(row));
        }
    }
    let field = ColliderBuilder::heightfield(heights, Vector::new(100.0, 1.0, 100.0));
    world.insert_collider(field, None);
    let body = RigidBodyBuilder::dynamic().translation(Vector::Y * 0.5);
    world.insert(body, plate());
    world
}

/// Ten overlapping dynamic meshes of this many triangles.
fn dynamic_meshes(triangles: usize) -> PhysicsWorld {
    let mut world = with_ground();
    for k in 0..10_u8 {
        let (points, indices) = hills(triangles, 20.0);
        let mesh = ColliderBuilder::trimesh(points, indices).expect("hills are a mesh");
        let at = Vector::new(0.0, 2.0 + 0.01 * Real::from(k), 0.0);
        let body = RigidBodyBuilder::dynamic().translation(at).rotation(Vector::Y * Real::from(k));
        world.insert(body, mesh.density(1.0));
    }
    world
}

/// Ten dynamic spheres of this many triangles at nearly one point.
fn meshes_at_one_point(triangles: usize) -> PhysicsWorld {
    let mut world = with_ground();
    let columns = ((triangles as f64 / 2.0).sqrt() as u32).max(3);
    let points = (0..columns * (columns + 1)).map(|k| {
        let (column, row) = (k % columns, k / columns);
        let (turn, rise) = (column as Real / columns as Real, row as Real / columns as Real);
        let (turn, rise) = (std::f32::consts::TAU * turn, std::f32::consts::PI * rise);
        Vector::new(rise.sin() * turn.cos(), rise.cos(), rise.sin() * turn.sin())
    });
    let points: Vec<_> = points.collect();
    let cells = (0..columns * columns).map(|k| (k, (k / columns) * columns + (k + 1) % columns));
    let halves = cells.flat_map(|(a, b)| [[a, a + columns, b], [b, a + columns, b + columns]]);
    let indices: Vec<_> = halves.collect();
    for k in 0..10_u8 {
        let mesh = ColliderBuilder::trimesh(points.clone(), indices.clone()).expect("a sphere");
        let at = Vector::new(0.0, 2.0 + 0.001 * Real::from(k), 0.0);
        let body = RigidBodyBuilder::dynamic().translation(at).rotation(Vector::X * Real::from(k));
        world.insert(body, mesh.density(1.0));
    }
    world
}

/// Two dynamic meshes of this many large triangles, all of which cross.
fn triangle_soups(triangles: usize) -> PhysicsWorld {
    let mut world = with_ground();
    for side in [-0.1, 0.1] {
        let corner = |k: usize| {
            let k = k as Real;
            Vector::new((k * 1.7).sin(), (k * 2.3).sin(), (k * 3.1).cos())
        };
        let indices = (0..triangles as u32).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]);
        let points = (0..3 * triangles).map(corner).collect();
        let mesh = ColliderBuilder::trimesh(points, indices.collect()).expect("a soup is a mesh");
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(side, 2.0, 0.0));
        world.insert(body, mesh.density(1.0));
    }
    world
}

/// Two compounds of this many parts at one point.
fn compounds(parts: usize) -> PhysicsWorld {
    let mut world = with_ground();
    let part = |k: usize| {
        (
            Pose::from_translation(Vector::X * (0.01 * (k % 7) as Real)),
            SharedShape::cuboid(0.5, 0.5, 0.5),
        )
    };
    for side in [-0.1, 0.1] {
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(side, 1.0, 0.0));
        world.insert(body, ColliderBuilder::compound((0..parts).map(part).collect()));
    }
    world
}

/// Chains with links far away from their joints' anchors.
fn joints(count: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let mut last = world.insert_body(RigidBodyBuilder::fixed());
    for k in 0..count {
        let at = Vector::new(1.0e4 * (k as Real * 0.7).sin(), 1.0e4 * (k as Real).cos(), 0.0);
        let (body, _) = world.insert(RigidBodyBuilder::dynamic().translation(at), cube(0.1));
        let joint = SphericalJointBuilder::new().local_anchor1(Vector::X).local_anchor2(-Vector::X);
        world.insert_impulse_joint(last, body, joint);
        last = body;
    }
    world
}
