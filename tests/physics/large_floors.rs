//! Floors of a kilometre under bodies of half a metre. In single precision, the corners of such a floor have
//! an error of 0.03 mm, and searches of closest points must not multiply it.

use super::stage::{penetration, run, weightless, world};
use crate::dim::{assortment, box_hull, cuboid, sheet, tumble, vec};
use rapier::prelude::*;

/// Half of the floors' width (m).
const HALF_WIDTH: Real = 500.0;

/// Each shape, in 100 orientations, overlaps the floor by 1 cm. The first step finds the contact, with that
/// depth.
#[test]
fn all_shapes_touch_large_floors() {
    let depth = 0.01;
    let floors = [cuboid(HALF_WIDTH, 1.0).translation(vec(0.0, -1.0)), sheet(HALF_WIDTH)];
    for (kind, floor) in ["box", "sheet"].into_iter().zip(floors) {
        for shape in assortment() {
            for k in 0..100 {
                let mut world = weightless(60);
                world.insert_collider(floor.clone(), None);
                let rotation = tumble(0.37 * k as Real, 0.23 * k as Real);
                let body = RigidBodyBuilder::dynamic().rotation(rotation).build();
                let lowest = shape.shape.compute_aabb(body.position()).mins.y;
                let place = vec(9.1 * k as Real - 450.0, -lowest - depth);
                let body = RigidBodyBuilder::dynamic().rotation(rotation).translation(place);
                world.insert(body, shape.clone());
                world.step();
                let found = penetration(&world);
                let name = shape.shape.shape_type();
                assert!((found - depth).abs() < 1.0e-3, "{name:?} on a {kind}, {k}: {found}");
            }
        }
    }
}

/// A board of 2 m whose middle is 0.3 m beyond the edge of the floor tips over.
#[test]
fn boards_tip_over_the_edge_of_large_floors() {
    for board in [cuboid(1.0, 0.1), box_hull(1.0, 0.1)] {
        let mut world = world(60);
        world.insert_collider(cuboid(HALF_WIDTH, 1.0).translation(vec(-HALF_WIDTH, -1.0)), None);
        let body = RigidBodyBuilder::dynamic().translation(vec(0.3, 0.1));
        let (board, _) = world.insert(body, board);
        run(&mut world, 2.0);
        let height = world.bodies[board].translation().y;
        assert!(height < -1.0, "it rests at {height}");
    }
}
