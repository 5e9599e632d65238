//! Convex decompositions and the error of their volume.
//!
//! With parry's parameters the notches of a comb were filled: a ball rested a metre above its place.

use crate::dim::shapes::{combs, notched};
use crate::dim::vec;
use crate::suite::physics::stage::{run, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// The default decomposition keeps the volume of shapes with notches and holes to 5 %, and reports its error.
#[test]
fn decompositions_keep_the_volume() {
    let columns = ["shape", "parts", "volume", "expected", "error (%)"];
    let mut table = Table::new("default decompositions", &columns);
    for (name, vertices, indices, volume) in notched() {
        let builder = ColliderBuilder::convex_decomposition(&vertices, &indices);
        let parts = builder.shape.as_compound().map_or(0, |compound| compound.shapes().len());
        let found = builder.build().mass();
        let reported = builder.decomposition_error(&vertices, &indices).expect("it is closed");
        let error = found / volume - 1.0;
        table.row([
            name.into(),
            parts.to_string(),
            format!("{found:.3}"),
            format!("{volume:.3}"),
            format!("{:.1}", 100.0 * error),
        ]);
        table.check("the reported error", reported, error, 1.0e-3);
        table.require(error.abs() < 0.05, "the volume differs");
    }
}

/// A ball falls into the notch of a comb. The bottom of a notch may be off by the size of a voxel.
#[test]
fn balls_fall_into_notches() {
    let (vertices, indices, bottom, voxel) = combs();
    let mut world = world(60);
    world.insert_collider(ColliderBuilder::convex_decomposition(&vertices, &indices), None);
    let ball = RigidBodyBuilder::dynamic().translation(vec(1.5, 3.0));
    let (ball, _) = world.insert(ball, ColliderBuilder::ball(0.4));
    run(&mut world, 3.0);
    let height = world.bodies[ball].translation().y - 0.4 - bottom;
    assert!(height.abs() < voxel + 2.0e-3, "{height} m above the notch");
}

/// Surfaces that are open, or wound in different directions, have no known volume.
#[test]
fn open_surfaces_have_no_known_error() {
    let (_, vertices, mut indices, _) = notched().swap_remove(0);
    let builder = ColliderBuilder::convex_decomposition(&vertices, &indices);
    assert!(ColliderBuilder::ball(1.0).decomposition_error(&vertices, &indices).is_none());
    indices[0].swap(0, 1);
    assert!(builder.decomposition_error(&vertices, &indices).is_none());
    indices.remove(0);
    assert!(builder.decomposition_error(&vertices, &indices).is_none());
    indices[0][0] = u32::MAX;
    assert!(builder.decomposition_error(&vertices, &indices).is_none());
}
