//! Crowds: many things at one place. The work of a step stays within the bounds that `docs/guide/parameters.md` states.
//!
//! Work is counted in pairs and contact points, so the result does not depend on the machine. (By hand, a string of bytes that takes more than a minute is a
//! finding, too, and the slowest one is named.)

use super::dim::SHAPES;
use super::dim::shape;
use super::rapier::prelude::*;
use super::room::block;
use super::values::within;
use super::world::check;
use crate::Tally;
use crate::choices::Choices;

const STEPS: usize = 8;
/// How many owners a pair may have had.
const OWNERS: usize = 2;
/// A grid over the region of contact has so many cells.
const CELLS_MAX: usize = 256;
/// Each cell keeps the deepest contact of each main direction.
const DIRECTIONS: usize = 2 * DIM;
/// Up to so many places of contact the grid is not used.
const PLACES_MAX: usize = 1024;
/// Points of one place of contact.
const POINTS_MAX: usize = 4;

/// Puts many bodies at one place.
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
        // Equal ones are the worst case: each overlaps all others.
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
        choices.tell(|| format!("step {}: {}", tally.steps, counted(&world)));
    }
    tally
}

fn counted(world: &PhysicsWorld) -> String {
    let cd = &world.physics_pipeline.counters.cd;
    format!("{} contact pairs, {} with sensors", cd.ncontact_pairs, cd.nintersection_pairs)
}

/// A moving collider owns a limited number of pairs with others of its size, and as many with larger ones. The pairs with fixed colliders are not limited: here,
/// each collider has one of them. A pair changes its owner when the boxes, which grow with the velocity, change their sizes. Then the new owner may have more than
/// it could have accepted ([`OWNERS`]).
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
