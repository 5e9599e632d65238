//! Mirrored and scaled shapes.
//!
//! parry's `scaled` leaves hulls inside out under a negative factor, and tilts their normals under an uneven
//! one. Such a hull had no mass, and bodies fell through it; height fields with a negative scale caught
//! nothing.

use crate::dim::cuboid;
use crate::dim::shapes::{Scaled, scaled_shapes, scales};
use crate::dim::vec;
use crate::suite::physics::stage::{add_ground, run, world};
use crate::suite::physics::table::Table;
use rapier::parry::shape::{Ball, Capsule};
use rapier::prelude::*;

/// Returns the height of a box above a floor with its top at this height.
fn height_on(floor: &ColliderBuilder, top: Real) -> Real {
    let mut world = world(60);
    world.insert_collider(floor.clone(), None);
    let body = RigidBodyBuilder::dynamic().translation(vec(0.13, top + 1.5));
    let (body, _) = world.insert(body, cuboid(0.5, 0.5));
    run(&mut world, 3.0);
    world.bodies[body].translation().y - 0.5 - top
}

/// Scaled shapes carry boxes, and weigh what their scaled points enclose.
#[test]
fn scaled_shapes_carry_boxes_and_weigh_their_volume() {
    let columns = ["shape", "scale", "height (m)", "mass (kg)", "expected (kg)"];
    let mut table = Table::new("shapes scaled by parry as floors", &columns);
    for scale in scales() {
        for Scaled { name, shape, top, mass } in scaled_shapes(scale) {
            let floor = ColliderBuilder::new(shape);
            let floor = floor.try_build().map(|_| floor).unwrap_or_else(|error| {
                panic!("{name} scaled by {scale}: {error}");
            });
            let (height, found) = (height_on(&floor, top), floor.build().mass());
            let [first, second, third] = [height, found, mass].map(|figure| format!("{figure:.4}"));
            table.row([name.into(), scale.to_string(), first, second, third]);
            table.require(height.abs() < 2.0e-3, "the box does not rest on it");
            table.require((found - mass).abs() <= 2.0e-3 * mass, "its mass is not its volume");
        }
    }
}

/// Mirrored bodies fall on a floor and rest there.
#[test]
fn scaled_bodies_rest_on_a_floor() {
    for scale in scales() {
        for Scaled { name, shape, mass, .. } in scaled_shapes(scale) {
            if mass == 0.0 {
                continue;
            }
            let mut world = world(60);
            add_ground(&mut world, 0.5);
            let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 1.5));
            let (body, collider) = world.insert(body, ColliderBuilder::new(shape));
            run(&mut world, 4.0);
            let lowest = world.colliders[collider].compute_aabb().mins.y;
            let speed = world.bodies[body].linvel().length();
            assert!(
                lowest.abs() < 3.0e-3 && speed < 0.01,
                "{name} {scale}: {lowest} m, {speed} m/s"
            );
        }
    }
}

/// Edits of a shape are accepted like new shapes, also within compounds.
#[test]
fn setters_and_compounds_repair_mirrored_shapes() {
    for scale in scales() {
        for Scaled { name, shape, top, mass } in scaled_shapes(scale) {
            let mut collider = ColliderBuilder::ball(1.0).build();
            collider.set_shape(shape.clone());
            assert!((collider.mass() - mass).abs() <= 2.0e-3 * mass, "{name}: {}", collider.mass());
            if mass > 0.0 && shape.as_trimesh().is_none() {
                let part = ColliderBuilder::compound(vec![(Pose::IDENTITY, shape)]);
                let height = height_on(&part, top);
                assert!(height.abs() < 2.0e-3, "{name} {scale} in a compound: {height} m");
            }
        }
    }
}

/// Balls and capsules under an uneven or a mirroring scale are hulls, as large whichever way they are
/// mirrored. In 2D, parry's corners of a mirrored ball run clockwise, and such polygons were refused.
#[test]
fn mirrored_round_shapes_are_as_large_as_others() {
    let end = Vector::Y * 0.5;
    let shapes: [(&str, &dyn Shape); 2] =
        [("ball", &Ball::new(0.5)), ("capsule", &Capsule::new(-end, end, 0.3))];
    for scale in scales() {
        for (name, shape) in shapes {
            let mass = |scale: Vector| {
                let scaled = SharedShape(shape.scale_dyn(scale, 16).expect("a shape").into());
                let built = ColliderBuilder::new(scaled).try_build();
                built.unwrap_or_else(|error| panic!("{name} {scale}: {error}")).mass()
            };
            let [found, expected] = [scale, scale.abs()].map(mass);
            let is_same = found > 0.0 && (found - expected).abs() < 0.05 * expected;
            assert!(is_same, "{name} {scale}: {found} kg, not {expected}");
        }
    }
}
