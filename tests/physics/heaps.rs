//! Heaps in a pit. 3D only: in the plane, balls of one size stack in rows.

use crate::suite::physics::stage::{add_ground, penetration, steps, world};
use rapier::prelude::*;

/// 216 balls of 1 m fall into a pit in which they lie in several layers, and stay awake. Once they lie, no
/// two of them overlap by more than 8 mm. The weight of the layers presses on the lowest.
#[test]
fn heaps_of_balls_hardly_overlap() {
    const HALF_SIDE: Real = 3.2;
    for rate in [60, 120] {
        let mut world = world(rate);
        add_ground(&mut world, 0.5);
        for axis in [Vector::X, Vector::Z] {
            for side in [1.0, -1.0] {
                let wall = ColliderBuilder::halfspace(axis * -side);
                world.insert_collider(wall.translation(axis * (side * HALF_SIDE)), None);
            }
        }
        for k in 0..216 {
            let [x, y, z] = [k % 6, k / 36, k / 6 % 6].map(|k| k as Real);
            let place = Vector::new(1.02 * x - 2.5 + 0.01 * y, 1.05 * y + 0.6, 1.02 * z - 2.5);
            let body = RigidBodyBuilder::dynamic().translation(place).can_sleep(false);
            world.insert(body, ColliderBuilder::ball(0.5));
        }
        let (all, settled) = (steps(&world, 12.0), steps(&world, 6.0));
        for step in 0..all {
            world.step();
            let overlap = penetration(&world);
            assert!(step < settled || overlap < 8e-3, "{rate} Hz, step {step}: {overlap} m");
        }
    }
}
