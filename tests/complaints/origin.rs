//! "Moving everything back to the origin throws my piles over."

use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::{run, world};
use rapier::prelude::*;

/// Builds a tower of five cubes on a slab with its own body.
fn tower(world: &mut PhysicsWorld, x: Real) -> Vec<RigidBodyHandle> {
    let slab = RigidBodyBuilder::fixed().translation(vec(x, -0.5));
    world.insert(slab, cuboid(3.0, 0.5));
    let mut cube = |k: u8| {
        let body = RigidBodyBuilder::dynamic().translation(vec(x, 0.5 + Real::from(k)));
        world.insert(body, cuboid(0.5, 0.5)).0
    };
    (0..5).map(&mut cube).collect()
}

/// Moves all bodies, including fixed ones, without waking any.
fn shift(world: &mut PhysicsWorld, by: Vector) {
    for (_, body) in world.bodies.iter_mut() {
        let place = body.translation() + by;
        body.set_translation(place, false);
    }
}

/// Sleeping bodies stay asleep at exactly their new pose, and awake bodies keep their relative height. At
/// 1000 m, single precision has a resolution of 0.06 mm, and a tower settles by a few of these.
#[test]
fn an_origin_shift_disturbs_no_pile() {
    for awake in [false, true] {
        let mut world = world(60);
        let cubes = tower(&mut world, 1000.0);
        for &cube in cubes.iter().filter(|_| awake) {
            *world.bodies[cube].activation_mut() = RigidBodyActivation::cannot_sleep();
        }
        run(&mut world, 10.0);
        assert_eq!(world.bodies[cubes[4]].is_sleeping(), !awake);
        let by = vec(-1000.0, 250.0);
        let wanted: Vec<_> =
            cubes.iter().map(|&cube| world.bodies[cube].translation() + by).collect();
        shift(&mut world, by);
        for _ in 0..120 {
            world.step();
            for (&cube, &wanted) in cubes.iter().zip(&wanted) {
                let body = &world.bodies[cube];
                assert_eq!(body.is_sleeping(), !awake);
                let off = (body.translation() - wanted).length();
                assert!(off <= if awake { 1.0e-3 } else { 0.0 }, "{off} m off");
                assert!(body.linvel().length() < 1.0e-2, "{}", body.linvel());
            }
        }
    }
}
