//! Growing worlds: many copies of one simple arrangement, in the cells of a square.

use super::dim::{add_floors, cell, cube, layer_size, place_in_layer};
use super::ours::prelude::*;
use crate::growth::world::{SLEEP_DELAY, World};

/// Half the side of a box.
const HALF_EXTENT: Real = 0.5;

/// Distance of two boxes in a layer of a heap: boxes touch only the boxes above and below.
const SPACING_IN_LAYER: Real = 1.1;
/// Distance of two boxes that also touch their neighbours in the layer: slightly less than their side, so
/// that rounding removes no contact.
const SPACING_IN_DENSE_LAYER: Real = 0.999;

/// Distance of two cells with one box each.
const SPACING: Real = 2.0;

/// Builds a world.
pub fn build(world: World) -> PhysicsWorld {
    match world {
        World::Heaps { bodies, each, dense } => heaps(bodies, each, dense),
        World::Static { bodies, awake } => blocks(bodies, awake),
        World::Sleeping { bodies, awake } => sleepers(bodies, awake),
    }
}

/// Builds heaps with `each` boxes.
fn heaps(bodies: usize, each: usize, dense: bool) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let count = bodies.div_ceil(each);
    let side = side_of(count);
    let distance = if dense { SPACING_IN_DENSE_LAYER } else { SPACING_IN_LAYER };
    let base = base_of(each);
    let spacing = distance * base as Real + SPACING;
    add_floors(&mut world, side, spacing);
    for index in 0..count {
        let foot = cell(index, side, spacing);
        add_heap(&mut world, foot, base, each.min(bodies - index * each), distance);
    }
    world
}

/// Builds fixed blocks, with a dynamic box on some of them.
fn blocks(bodies: usize, awake: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let side = side_of(bodies);
    for index in 0..bodies {
        let place = cell(index, side, SPACING);
        world.insert(RigidBodyBuilder::fixed().translation(place), cube(HALF_EXTENT));
        if chosen(index, bodies, awake) {
            // The box is slightly smaller, so that in 2D the block above it is out of reach.
            let above = place + 1.8 * HALF_EXTENT * Vector::Y;
            world.insert(RigidBodyBuilder::dynamic().translation(above), cube(0.8 * HALF_EXTENT));
        }
    }
    world
}

/// Builds boxes that sleep on the floor, and among them some that may not sleep.
fn sleepers(bodies: usize, awake: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    let cells = bodies + awake;
    let side = side_of(cells);
    add_floors(&mut world, side, SPACING);
    for index in 0..cells {
        let place = cell(index, side, SPACING) + HALF_EXTENT * Vector::Y;
        let may_sleep = !chosen(index, cells, awake);
        let mut body = RigidBodyBuilder::dynamic().translation(place).can_sleep(may_sleep).build();
        body.activation_mut().time_until_sleep = SLEEP_DELAY;
        world.insert(body, cube(HALF_EXTENT));
    }
    world
}

/// Returns whether `index` is one of `few` indices that are spread evenly over `many`.
fn chosen(index: usize, many: usize, few: usize) -> bool {
    (index + 1) * few / many > index * few / many
}

/// Returns the side of the smallest square with so many cells.
fn side_of(cells: usize) -> usize {
    let root = cells.isqrt();
    if root * root < cells { root + 1 } else { root }
}

/// Returns the boxes along a side of a heap's lowest layer. Each layer's side is one box shorter than the
/// side of the layer below.
fn base_of(boxes: usize) -> usize {
    let (mut base, mut room) = (0, 0);
    while room < boxes {
        base += 1;
        room += layer_size(base);
    }
    base
}

/// Adds boxes in layers, each box on the corners of the boxes below.
fn add_heap(world: &mut PhysicsWorld, foot: Vector, base: usize, boxes: usize, distance: Real) {
    let mut left = boxes;
    for (level, side) in (1..=base).rev().enumerate() {
        let height = HALF_EXTENT * (2 * level + 1) as Real;
        for index in 0..layer_size(side).min(left) {
            let place = foot + distance * place_in_layer(index, side) + height * Vector::Y;
            world.insert(RigidBodyBuilder::dynamic().translation(place), cube(HALF_EXTENT));
        }
        left = left.saturating_sub(layer_size(side));
    }
}

#[cfg(test)]
mod tests {
    use super::super::template::Template;
    use super::*;

    #[test]
    fn worlds_have_the_requested_bodies() {
        let moving =
            |world: World| build(world).bodies.iter().filter(|(_, body)| body.is_dynamic()).count();
        assert_eq!(moving(World::Heaps { bodies: 95, each: 10, dense: false }), 95);
        assert_eq!(moving(World::Heaps { bodies: 70, each: 70, dense: true }), 70);
        assert_eq!(moving(World::Static { bodies: 101, awake: 10 }), 10);
        assert_eq!(moving(World::Sleeping { bodies: 90, awake: 10 }), 100);
    }

    #[test]
    fn bodies_that_may_sleep_do() {
        let template = Template::grown(World::Sleeping { bodies: 9, awake: 3 });
        let mut world = template.fresh_world();
        (0..60).for_each(|_| world.step());
        let asleep = world.bodies.iter().filter(|(_, body)| body.is_sleeping()).count();
        assert_eq!(asleep, 9);
    }

    #[test]
    fn loose_heaps_do_not_overlap() {
        let loose = World::Heaps { bodies: 60, each: 30, dense: false };
        for world in [loose, World::Static { bodies: 30, awake: 30 }] {
            let template = Template::grown(world);
            let poses: Vec<Pose> = template
                .bodies
                .iter()
                .map(|&body| *template.world.bodies[body].position())
                .collect();
            let overlap = super::super::overlap::overlap(&template, &poses).deepest;
            assert!(overlap < 1e-4, "{overlap}");
        }
    }
}
