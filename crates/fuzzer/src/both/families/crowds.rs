//! Crowds: many objects at one place. The work of a step stays within the bounds in
//! `docs/guide/parameters.md`.
//!
//! Work is counted in pairs and contact points, so the result is independent of the machine. In a manual run,
//! a string of bytes that takes more than a minute is a finding as well. The report names the slowest string.

use super::dim::SHAPES;
use super::dim::shape;
use super::rapier::prelude::*;
use super::room::block;
use super::values::within;
use super::world::check;
use crate::Tally;
use crate::choices::Choices;

const STEPS: usize = 8;
/// Number of owners that a pair may have had.
const OWNERS: usize = 2;
/// Number of cells of the grid over the contact region.
const CELLS_MAX: usize = 256;
/// Number of main directions. Each cell keeps the deepest contact of each.
const DIRECTIONS: usize = 2 * DIM;
/// Largest number of patches without the grid.
const PLACES_MAX: usize = 1024;
/// Number of points per patch.
const POINTS_MAX: usize = 4;

/// Places many bodies at one point.
pub fn run(choices: &mut Choices<'_>) -> Tally {
    let mut world = PhysicsWorld::new();
    let limits = [choices.below(8) + 1, choices.below(8) + 1];
    world.integration_parameters.max_neighbors_per_collider = limits[0];
    world.integration_parameters.max_sensor_neighbors_per_collider = limits[1];
    let ground = block(Vector::splat(5.0)).translation(Vector::Y * -5.0);
    world.insert_collider(ground, None);
    let count = 20 + choices.below(60);
    let kind = choices.below(SHAPES);
    for _ in 0..count {
        // Equal bodies are the worst case: each overlaps all others.
        let kind = if choices.once_in(4) { choices.below(SHAPES) } else { kind };
        let spread = if choices.coin() { 0.0 } else { 0.3 };
        let at = Vector::Y + Vector::X * within(choices, -spread, spread);
        let body = RigidBodyBuilder::dynamic().translation(at);
        let solid = shape(kind, 0.4, choices).unwrap_or_else(|| block(Vector::splat(0.4)));
        world.insert(body, solid.sensor(choices.once_in(5)).density(1.0));
    }
    let mut tally = Tally { operations: count, steps: 0 };
    for _ in 0..STEPS {
        world.step();
        tally.steps += 1;
        check(&world);
        check_work(&world, limits);
        choices.print(|| format!("step {}: {}", tally.steps, counted(&world)));
    }
    tally
}

fn counted(world: &PhysicsWorld) -> String {
    let cd = &world.physics_pipeline.counters.cd;
    format!("{} contact pairs, {} with sensors", cd.ncontact_pairs, cd.nintersection_pairs)
}

/// Checks the numbers of pairs and points. A moving collider owns a limited number of pairs with colliders of
/// its size, and as many with larger ones. Pairs with fixed colliders are unlimited: here, each collider has
/// one of them. A pair changes its owner when velocities change the sizes of the fat AABBs. The new owner may
/// then have more pairs than its limit ([`OWNERS`]).
fn check_work(world: &PhysicsWorld, [neighbors_max, sensors_max]: [usize; 2]) {
    let (cd, count) = (&world.physics_pipeline.counters.cd, world.colliders.len());
    let contacts_max = OWNERS * count * (2 * neighbors_max + 1);
    let sensed_max = OWNERS * count * (2 * sensors_max + 1);
    let is_bounded = cd.ncontact_pairs <= contacts_max && cd.nintersection_pairs <= sensed_max;
    assert!(
        is_bounded,
        "{} of at most {contacts_max} and {sensed_max} for {count} colliders",
        counted(world)
    );
    for (one, two, pair) in world.contact_pairs() {
        let points: usize = pair.manifolds.iter().map(|manifold| manifold.contacts().len()).sum();
        let places = PLACES_MAX.max(CELLS_MAX * DIRECTIONS);
        assert!(points <= POINTS_MAX * places, "{one:?} and {two:?} touch at {points} points");
    }
}
