//! What tips over an edge lands on the ground, not in it.

use super::stage::{RATES, add_ground, steps, world};
use crate::dim::{about_z, cuboid, vec};
use rapier::prelude::*;

/// A pillar that leans too far falls over its lower edge. The edge stands still all the while, so the
/// contact points there do not move; those of the side that comes down must be found all the same.
#[test]
fn a_falling_pillar_does_not_sink_in() {
    for rate in RATES {
        let mut world = world(rate);
        add_ground(&mut world, 0.5);
        let lean: Real = -0.3;
        let (half_width, half_height): (Real, Real) = (0.2, 1.0);
        let middle = half_width * lean.sin().abs() + half_height * lean.cos();
        let body =
            RigidBodyBuilder::dynamic().translation(vec(0.0, middle)).rotation(about_z(lean));
        let (_, collider) = world.insert(body, cuboid(half_width, half_height));
        let mut deepest: Real = 0.0;
        for _ in 0..steps(&world, 3.0) {
            world.step();
            deepest = deepest.max(-world.colliders[collider].compute_aabb().mins.y);
        }
        // Its top arrives at 5 m/s; contacts are looked for once a step.
        let tolerance = 5.0 / rate as Real + 0.01;
        assert!(deepest < tolerance, "at {rate} Hz it sank {deepest} into the ground");
    }
}
