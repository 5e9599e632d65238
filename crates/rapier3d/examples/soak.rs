//! Endurance test: bodies, joints, chains and meshes are inserted and removed for a hundred thousand steps,
//! and memory must not grow.
//!
//! About a hundred bodies fall on ground that is exchanged at intervals. Each step inserts one body and
//! removes the oldest. Some of them are meshes, some are joined to the body before, some become links of a
//! multibody. At intervals a line shows the memory of the process (Linux only), the numbers of objects, and
//! the numbers of slots of the sets. Slots are reused after removals, so their number stays at the largest
//! number of simultaneous objects.
//!
//! ```text
//! cargo run --release -p rapier3d --example soak [STEPS]
//! ```

use rapier3d::prelude::*;
use std::collections::VecDeque;
use std::io::Write;
use std::process::ExitCode;
use std::time::Instant;

const STEPS: usize = 100_000;
/// Number of simultaneous bodies.
const BODIES: usize = 100;
/// Lines of the table.
const LINES: usize = 20;
/// Number of steps between two exchanges of the ground.
const GROUND_LIFE: usize = 250;
/// Largest ratio of memory to that after the first tenth of the run. The allocator causes smaller variations.
const GROWTH_MAX: f64 = 1.1;

fn main() -> ExitCode {
    let steps = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(STEPS);
    let interval = (steps / LINES).max(1);
    let mut life = Life::new();
    let mut memory = Vec::new();
    println!("{}", Life::HEADER);
    for step in 1..=steps {
        life.go_on(step);
        if step % 100 == 0 {
            show_progress(step, steps);
        }
        if step % interval == 0 {
            memory.push(resident_kib());
            println!("\r\x1b[K{}", life.line(step));
        }
    }
    let early = memory.get(memory.len() / 10).copied().flatten();
    let late = memory.last().copied().flatten();
    let (Some(early), Some(late)) = (early, late) else { return ExitCode::SUCCESS };
    println!("memory after a tenth: {early} KiB; at the end: {late} KiB");
    if late as f64 <= GROWTH_MAX * early as f64 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn show_progress(step: usize, steps: usize) {
    let full = 40 * step / steps;
    print!("\r[{}{}] {step}", "#".repeat(full), ".".repeat(40 - full));
    let _ = std::io::stdout().flush();
}

/// Returns the resident memory of the process, or `None` on systems without this figure.
fn resident_kib() -> Option<usize> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

/// The world, and its objects.
struct Life {
    world: PhysicsWorld,
    bodies: VecDeque<RigidBodyHandle>,
    ground: ColliderHandle,
    /// Highest used slots of bodies, colliders, joints and links.
    slots: [u32; 4],
    start: Instant,
}

impl Life {
    const HEADER: &'static str = "    step  ms/step  memory KiB  bodies (slots)  colliders (slots)  joints (slots)  links (slots)  pairs  awake";

    fn new() -> Self {
        let mut world = PhysicsWorld::new();
        let ground = world.insert_collider(ground(0), None);
        Self { world, bodies: VecDeque::new(), ground, slots: [0; 4], start: Instant::now() }
    }

    fn go_on(&mut self, step: usize) {
        self.spawn(step);
        if self.bodies.len() > BODIES {
            let oldest = self.bodies.pop_front();
            oldest.and_then(|oldest| self.world.remove_body(oldest));
        }
        if step.is_multiple_of(GROUND_LIFE) {
            self.world.remove_collider(self.ground);
            self.ground = self.world.insert_collider(ground(step), None);
            self.note(1, self.ground.into_raw_parts().0);
        }
        self.world.step();
    }

    fn spawn(&mut self, step: usize) {
        let k = step as Real;
        let place = Vector::new(4.0 * (k * 0.37).sin(), 6.0, 4.0 * (k * 0.53).cos());
        let body =
            RigidBodyBuilder::dynamic().translation(place).ccd_enabled(step.is_multiple_of(7));
        let (body, collider) = self.world.insert(body, shape(step));
        self.note(0, body.into_raw_parts().0);
        self.note(1, collider.into_raw_parts().0);
        let before = self.bodies.back().copied();
        self.bodies.push_back(body);
        let Some(before) = before else { return };
        let hinge = SphericalJointBuilder::new().local_anchor1(Vector::X).local_anchor2(-Vector::X);
        match step % 5 {
            0 => {
                let joint = self.world.insert_impulse_joint(before, body, hinge);
                self.note(2, joint.into_raw_parts().0);
            }
            1 => {
                let link = self.world.insert_multibody_joint(before, body, hinge);
                self.note(3, link.map_or(0, |link| link.into_raw_parts().0));
            }
            _ => {}
        }
    }

    fn note(&mut self, which: usize, slot: u32) {
        self.slots[which] = self.slots[which].max(slot + 1);
    }

    fn line(&self, step: usize) -> String {
        let Self { world, slots: [bodies, colliders, joints, links], .. } = self;
        let memory = resident_kib().map_or_else(|| "-".into(), |kib| kib.to_string());
        format!(
            "{step:>8} {:>8.3} {memory:>11} {:>6} {bodies:>8} {:>9} {colliders:>8} {:>7} {joints:>7} {:>6} {links:>7} {:>6} {:>6}",
            self.start.elapsed().as_secs_f64() * 1000.0 / step as f64,
            world.bodies.len(),
            world.colliders.len(),
            world.impulse_joints.len(),
            world.multibody_joints.len(),
            world.contact_pairs().count(),
            world.active_bodies().len(),
        )
    }
}

/// Returns hills or a mesh, new each time.
fn ground(step: usize) -> ColliderBuilder {
    const SIDE: usize = 12;
    let height = |i: usize, j: usize| 0.3 * ((i * 7 + j * 3 + step) % 5) as Real;
    if (step / GROUND_LIFE).is_multiple_of(2) {
        let heights = (0..SIDE * SIDE).map(|k| height(k / SIDE, k % SIDE)).collect();
        let heights = rapier3d::parry::utils::Array2::new(SIDE, SIDE, heights);
        return ColliderBuilder::heightfield(heights, Vector::new(24.0, 1.0, 24.0));
    }
    let corners = (0..SIDE * SIDE).map(|k| {
        let (i, j) = (k / SIDE, k % SIDE);
        Vector::new(2.0 * i as Real - 11.0, height(i, j), 2.0 * j as Real - 11.0)
    });
    let squares = (0..SIDE - 1).flat_map(|i| (0..SIDE - 1).map(move |j| (i * SIDE + j) as u32));
    let triangles = squares.flat_map(|a| {
        let (right, down) = (a + 1, a + SIDE as u32);
        [[a, right, down], [right, down + 1, down]]
    });
    ColliderBuilder::trimesh(corners.collect(), triangles.collect()).unwrap_or_default()
}

fn shape(step: usize) -> ColliderBuilder {
    match step % 6 {
        0 => ColliderBuilder::ball(0.4),
        1 => ColliderBuilder::cuboid(0.3, 0.5, 0.4),
        2 => ColliderBuilder::capsule_y(0.3, 0.3),
        3 => ColliderBuilder::cylinder(0.4, 0.3),
        4 => {
            let corners =
                [-Vector::ONE, Vector::X, Vector::Y, Vector::Z].map(|corner| corner * 0.5);
            let faces = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
            ColliderBuilder::trimesh(corners.to_vec(), faces).unwrap_or_default().mass(1.0)
        }
        _ => ColliderBuilder::cuboid(0.5, 0.2, 0.5).sensor(step.is_multiple_of(4)),
    }
}
