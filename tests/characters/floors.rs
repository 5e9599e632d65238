//! "My character stumbles over the internal edges of the floor."

use super::stage::{CAPSULE, DT, FOOT, GAP_TOLERANCE, OFFSET, Walker};
use crate::dim::floors::{heights, mesh};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Returns the largest deviations of the speed in one step, as a fraction, and of the height. The character
/// walks over a level floor at 4/s.
pub fn stumbles(floor: Vec<ColliderBuilder>, shape: ColliderBuilder) -> (Real, Real) {
    let mut world = PhysicsWorld::new();
    for part in floor {
        world.insert_collider(part, None);
    }
    let mut walker = Walker::of(world, shape, vec(-7.77, 0.1 + FOOT)).settled();
    let height = walker.place().y;
    let (mut speed, mut bump): (Real, Real) = (0.0, 0.0);
    for _ in 0..200 {
        let movement = walker.step(vec(4.0, 0.0));
        assert!(movement.grounded, "left the ground at {}", walker.place());
        speed = speed.max((movement.translation.x / (4.0 * DT) - 1.0).abs());
        bump = bump.max((walker.place().y - height).abs());
    }
    (speed, bump)
}

/// Returns level floors made of parts.
pub fn level_floors() -> Vec<(&'static str, Vec<ColliderBuilder>)> {
    let tiles = (-30..30).map(|i| cuboid(0.25, 0.25).translation(vec(0.5 * i as Real, -0.25)));
    let flat = |_: Real| 0.0;
    vec![
        ("one box", vec![cuboid(20.0, 1.0).translation(vec(0.0, -1.0))]),
        ("tiles", tiles.collect()),
        ("mesh", vec![mesh(20.0, 80, flat)]),
        ("heightfield", vec![heights(20.0, 80, flat)]),
    ]
}

#[test]
fn internal_edges_of_level_floors_have_no_effect() {
    let capsule = ColliderBuilder::capsule_y(CAPSULE.0, CAPSULE.1);
    for shape in [capsule, cuboid(0.3, FOOT)] {
        for (name, floor) in level_floors() {
            let (speed, bump) = stumbles(floor, shape.clone());
            assert!(speed < 1.0e-3, "{name}: speed off by {speed}");
            assert!(bump < GAP_TOLERANCE, "{name}: bump of {bump}");
        }
    }
}

/// On hills made of facets, the displacement of each step has the desired length, except at the edges between
/// facets. The character never leaves the ground or sinks in.
#[test]
fn walking_over_hills_keeps_the_speed() {
    let hills = |x: Real| 0.6 * (0.8 * x).sin();
    for floor in [mesh(20.0, 80, hills), heights(20.0, 80, hills)] {
        let mut world = PhysicsWorld::new();
        world.insert_collider(floor, None);
        let mut walker = Walker::new(world, vec(-7.77, 1.0 + FOOT)).settled();
        let mut total = 0.0;
        for _ in 0..200 {
            let movement = walker.step(vec(4.0, 0.0));
            let at = walker.place();
            assert!(movement.grounded, "left the ground at {at}");
            total += movement.translation.length();
            // For an upright capsule on a slope, the lowest point is higher than the ground by r (1/cos - 1),
            // 0.04 here.
            let above = walker.feet() - hills(at.x);
            assert!((OFFSET - 0.02..0.09).contains(&above), "{above} above the ground at {at}");
        }
        let share = total / (200.0 * 4.0 * DT);
        assert!((share - 1.0).abs() < 0.02, "went {share} of the way");
    }
}
