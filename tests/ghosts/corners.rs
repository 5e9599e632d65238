//! Floor and wall hold a body in a corner, each on its own side.

use crate::dim::grounds::box_mesh;
use crate::dim::{about_z, assortment, vec};
use crate::suite::physics::stage::{Dice, penetration, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Where the wall is (m).
const WALL: Real = 2.0;

/// A floor and a wall 4 m high, which a body can come to from above and from the left.
fn corner(is_mesh: bool) -> PhysicsWorld {
    let mut world = world(60);
    for (half, place) in [(vec(5.0, 0.5), vec(0.0, -0.5)), (vec(0.5, 2.0), vec(WALL + 0.5, 2.0))] {
        let block = if is_mesh { box_mesh(half) } else { crate::dim::cuboid(half.x, half.y) };
        world.insert_collider(block.translation(place).friction(0.3), None);
    }
    // Everything falls into the corner.
    world.gravity = vec(6.0, -9.81);
    world
}

/// A falling body penetrates at most 6 m/s · 1/60 s = 10 cm in a step, and is pushed out on its original
/// side. The exit is neither the top of the wall, 4 m away, nor its other side.
#[test]
fn no_body_is_pushed_out_of_the_wrong_side() {
    let columns = ["blocks", "shape", "deepest (m)", "farthest right (m)", "fastest up (m/s)"];
    let mut table = Table::new("bodies fall into a corner, 24 attitudes each", &columns);
    for is_mesh in [false, true] {
        for (index, collider) in assortment().into_iter().enumerate() {
            let mut dice = Dice(index as u64);
            let [mut deepest, mut farthest, mut fastest]: [Real; 3] = [0.0; 3];
            for _ in 0..24 {
                let mut world = corner(is_mesh);
                let body = RigidBodyBuilder::dynamic()
                    .translation(vec(0.9, 0.7))
                    .rotation(about_z(dice.within(-3.0, 3.0)));
                let (body, _) = world.insert(body, collider.clone().friction(0.3));
                for step in 0..steps(&world, 4.0) {
                    world.step();
                    deepest = deepest.max(penetration(&world));
                    farthest = farthest.max(world.bodies[body].translation().x);
                    if step > 60 {
                        fastest = fastest.max(world.bodies[body].linvel().y);
                    }
                }
            }
            table.row([
                if is_mesh { "meshes" } else { "boxes" }.to_string(),
                index.to_string(),
                format!("{deepest:.3}"),
                format!("{farthest:.3}"),
                format!("{fastest:.3}"),
            ]);
            table.require(deepest < 0.12, "deep in a block");
            table.require(farthest < WALL, "in the wall");
            table.require(fastest < 0.6, "is thrown up");
        }
    }
}
