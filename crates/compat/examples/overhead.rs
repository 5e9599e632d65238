//! Cost of the facade: a pile of boxes steps in the engine and in the facade over it.
//!
//! Without arguments, both worlds step in turn. The program prints the median times of a step, and the median
//! of the ratio. `overhead engine` and `overhead facade` step one world only, for programs that count
//! instructions. The argument `reading` also reads the contact pairs after each step.

use engine::pipeline::PhysicsWorld;
use rapier3d::prelude::*;
use std::time::Instant;

/// Boxes along an edge of the pile.
const EDGE: usize = 10;
const STEPS: usize = 200;
/// Repetitions of the pile, each with new worlds.
const REPETITIONS: usize = 5;

/// A world with the pile.
trait Pile {
    fn step(&mut self);
    /// Reads all contact pairs. Returns the sum of their impulses.
    fn total_impulse(&self) -> Real;
    fn bodies(&self) -> &engine::dynamics::RigidBodySet;
}

impl Pile for PhysicsWorld {
    fn step(&mut self) {
        PhysicsWorld::step(self);
    }

    fn total_impulse(&self) -> Real {
        self.contact_pairs().map(|(.., pair)| pair.total_impulse_magnitude()).sum()
    }

    fn bodies(&self) -> &engine::dynamics::RigidBodySet {
        &self.bodies
    }
}

/// The parts of a world, as programs for Rapier 0.32 own them.
#[derive(Default)]
struct Parts {
    pipeline: PhysicsPipeline,
    parameters: IntegrationParameters,
    islands: IslandManager,
    broad_phase: DefaultBroadPhase,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    ccd_solver: CCDSolver,
}

impl Pile for Parts {
    fn step(&mut self) {
        self.pipeline.step(
            Vector::Y * -9.81,
            &self.parameters,
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.ccd_solver,
            &(),
            &(),
        );
    }

    fn total_impulse(&self) -> Real {
        self.narrow_phase.contact_pairs().map(ContactPair::total_impulse_magnitude).sum()
    }

    fn bodies(&self) -> &engine::dynamics::RigidBodySet {
        &self.bodies
    }
}

/// Inserts the ground and the boxes. Odd layers are shifted by a third of a box.
fn fill(bodies: &mut engine::dynamics::RigidBodySet, colliders: &mut ColliderSet) {
    colliders.insert(ColliderBuilder::cuboid(50.0, 1.0, 50.0).translation(Vector::Y * -1.0));
    for index in 0..EDGE.pow(3) {
        let [x, y, z] = [index % EDGE, index / EDGE / EDGE, index / EDGE % EDGE];
        let shift = (y % 2) as Real * 0.33;
        let place = Vector::new(x as Real * 1.1 + shift, y as Real * 1.1 + 0.5, z as Real * 1.1);
        let body = RigidBodyBuilder::dynamic().translation(place).can_sleep(false);
        let body = bodies.insert(body);
        colliders.insert_with_parent(ColliderBuilder::cuboid(0.5, 0.5, 0.5), body, bodies);
    }
}

fn engine_pile() -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    fill(&mut world.bodies, &mut world.colliders);
    world
}

fn facade_pile() -> Parts {
    let mut world = Parts::default();
    fill(&mut world.bodies, &mut world.colliders);
    world
}

/// Takes a step, and reads the contact pairs if `reads` is `true`. Returns the time (µs).
fn timed_step(world: &mut impl Pile, reads: bool) -> f64 {
    let start = Instant::now();
    world.step();
    if reads {
        std::hint::black_box(world.total_impulse());
    }
    start.elapsed().as_secs_f64() * 1.0e6
}

fn run(mut world: impl Pile, reads: bool) {
    for _ in 0..STEPS {
        timed_step(&mut world, reads);
    }
}

/// Steps both worlds in turn. Appends the two times of each step (µs).
fn compare(times: &mut Vec<[f64; 2]>, reads: bool) {
    let (mut engine, mut facade) = (engine_pile(), facade_pile());
    for step in 0..STEPS {
        let first = (step % 2 == 0).then(|| timed_step(&mut engine, reads));
        let own = timed_step(&mut facade, reads);
        let engine = first.unwrap_or_else(|| timed_step(&mut engine, reads));
        times.push([engine, own]);
    }
    assert_eq!(engine.total_impulse(), facade.total_impulse());
    for ((_, one), (_, other)) in engine.bodies().iter().zip(facade.bodies().iter()) {
        assert_eq!(one.position(), other.position(), "the two worlds differ");
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let has = |name: &str| arguments.iter().any(|argument| argument == name);
    let reads = has("reading");
    if has("engine") {
        return run(engine_pile(), reads);
    }
    if has("facade") {
        return run(facade_pile(), reads);
    }
    let mut times = Vec::new();
    for _ in 0..REPETITIONS {
        compare(&mut times, reads);
    }
    let engine = median(times.iter().map(|pair| pair[0]));
    let facade = median(times.iter().map(|pair| pair[1]));
    let ratio = median(times.iter().map(|pair| pair[1] / pair[0]));
    println!("engine {engine:.0} µs, facade {facade:.0} µs a step, ratio {ratio:.3}");
}
