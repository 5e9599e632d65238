//! Shapes without volume, and shapes from the geometry library's own constructors.
//!
//! Flat hulls once fell through the floor without a message: a density gave their body no mass, and no
//! contact could stop it. Such a body now takes the mass of its surface. Shapes that cannot collide are
//! rejected with a reason.

use super::listener::listen;
use crate::dim::hostile::{unsound_shapes, weightless_shapes};
use crate::dim::{about_z, cuboid, vec};
use crate::suite::physics::stage::{add_ground, run, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

const SIZES: [Real; 4] = [8.0e-4, 0.05, 1.0, 10.0];
const ANGLES: [Real; 3] = [0.0, 0.4, 2.0];

/// Bodies of flat shapes alone come to rest on a floor, and weigh density times area or length.
#[test]
fn shapes_without_volume_rest_on_a_floor() {
    let columns = ["shape", "size (m)", "of 3 rest", "overlap (m)", "centre (m)"];
    let mut table = Table::new("shapes without volume that fall on a 2 m floor", &columns);
    let names = weightless_shapes(1.0, 0.0).into_iter().map(|(name, ..)| name);
    for (kind, name) in names.enumerate() {
        for size in SIZES {
            let (mut rest, mut deepest_of_all, mut least) = (0, Real::NEG_INFINITY, Real::INFINITY);
            for angle in ANGLES {
                let (_, shape, measure) = weightless_shapes(size, angle).swap_remove(kind);
                let mut world = world(60);
                let ground = add_ground(&mut world, 0.5);
                let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 1.5 * size + 0.01));
                let (body, collider) = world.insert(body, shape.density(3.0));
                run(&mut world, 3.0);
                let mass = world.bodies[body].mass();
                assert!((mass / (3.0 * measure) - 1.0).abs() < 0.02, "{name} of {size}: {mass} kg");
                // Resting contacts overlap by a millimetre, impacts by slightly more. (The boxes of compounds
                // are not tight.)
                let pair = world.contact_pair(ground, collider);
                let deepest = pair.and_then(ContactPair::find_deepest_contact);
                let depth = deepest.map_or(Real::NAN, |(_, _, depth)| depth);
                let height = world.bodies[body].center_of_mass().y;
                let stays = depth.abs() < 3.0e-3 + 2.0e-3 * size && height > -3.0e-3;
                rest += usize::from(stays);
                (deepest_of_all, least) = (deepest_of_all.max(depth), least.min(height));
            }
            let [depth, height] = [deepest_of_all, least].map(|length| format!("{length:.4}"));
            table.row([name.into(), size.to_string(), rest.to_string(), depth, height]);
            table.require(rest == ANGLES.len(), "it does not rest on the floor");
        }
    }
}

/// `additional_mass` on colliders of density 0 gives the inertia of the same shapes with this mass.
#[test]
fn additional_mass_is_spread_over_shapes_without_density() {
    let solids =
        [ColliderBuilder::ball(0.5), cuboid(0.5, 0.2), ColliderBuilder::capsule_y(0.5, 0.2)];
    let flat = weightless_shapes(0.5, 0.4).into_iter().map(|(_, shape, _)| shape);
    for shape in solids.into_iter().chain(flat) {
        let name = format!("{:?}", shape.shape.shape_type());
        let mut world = world(60);
        world.gravity = Vector::ZERO;
        let plain = world.insert(RigidBodyBuilder::dynamic(), shape.clone().mass(2.0)).0;
        let builder = RigidBodyBuilder::dynamic().additional_mass(2.0).translation(vec(9.0, 0.0));
        let added = world.insert(builder, shape.clone().density(0.0)).0;
        let later = RigidBodyBuilder::dynamic().translation(vec(18.0, 0.0));
        let later = world.insert(later, shape.density(0.0)).0;
        world.bodies[later].set_additional_mass(2.0, true);
        for stepped in [false, true] {
            let spin = |handle: RigidBodyHandle| {
                let mut body = world.bodies[handle].clone();
                body.apply_torque_impulse(about_z(0.01), true);
                (body.mass(), crate::dim::z_of(body.angvel()))
            };
            let (expected, found, late) = (spin(plain), spin(added), spin(later));
            assert!(expected.1 > 0.0, "{name}");
            for (mass, angvel) in [found, late] {
                let close =
                    (mass - 2.0).abs() < 1.0e-4 && (angvel / expected.1 - 1.0).abs() < 1.0e-3;
                assert!(close, "{name} stepped {stepped}: {mass} kg, {angvel} of {}", expected.1);
            }
            world.step();
        }
    }
}

/// A cube with all its mass from `additional_mass` does not balance on its edge.
#[test]
fn a_tilted_cube_of_additional_mass_falls_on_a_face() {
    for tilt in [0.2, 0.6, 1.0] as [Real; 3] {
        let mut world = world(60);
        add_ground(&mut world, 0.5);
        let builder = RigidBodyBuilder::dynamic().additional_mass(3.0).rotation(about_z(tilt));
        let shape = cuboid(0.5, 0.5).density(0.0);
        let (body, _) = world.insert(builder.translation(vec(0.0, 0.75)), shape);
        run(&mut world, 4.0);
        let height = world.bodies[body].translation().y;
        assert!((height - 0.5).abs() < 0.02, "tilted by {tilt} it stands at {height}");
    }
}

/// Shapes with volume keep their mass beside shapes without.
#[test]
fn shapes_without_volume_add_nothing_to_bodies_with_mass() {
    for (name, shape, _) in weightless_shapes(1.0, 0.4) {
        let mut world = world(60);
        let body = world.insert_body(RigidBodyBuilder::dynamic());
        let ball = ColliderBuilder::ball(0.5);
        let weight = ball.build().mass();
        world.insert_collider(shape, Some(body));
        world.insert_collider(ball, Some(body));
        assert!((world.bodies[body].mass() / weight - 1.0).abs() < 1.0e-5, "{name}");
        world.step();
        assert!((world.bodies[body].mass() / weight - 1.0).abs() < 1.0e-5, "{name}, stepped");
    }
}

/// A body without mass, which contacts cannot stop, is reported once per change. Other bodies are not
/// reported.
#[test]
fn a_dynamic_body_without_mass_is_reported() {
    let count = |body: RigidBodyBuilder, shape: ColliderBuilder| {
        let mut world = world(60);
        let ((), heard) = listen(|| {
            world.insert(body, shape);
            run(&mut world, 0.1);
        });
        heard.iter().filter(|line| line.contains("no mass")).count()
    };
    let ball = || ColliderBuilder::ball(0.5);
    assert_eq!(count(RigidBodyBuilder::dynamic(), ball().density(0.0)), 1);
    assert_eq!(count(RigidBodyBuilder::dynamic(), ball()), 0);
    assert_eq!(count(RigidBodyBuilder::fixed(), ball().density(0.0)), 0);
    assert_eq!(count(RigidBodyBuilder::dynamic(), ball().density(0.0).sensor(true)), 0);
    assert_eq!(count(RigidBodyBuilder::dynamic().additional_mass(1.0), ball().density(0.0)), 0);
    for (_, shape, _) in weightless_shapes(1.0, 0.0) {
        assert_eq!(count(RigidBodyBuilder::dynamic(), shape), 0);
    }
}

/// Shapes that cannot collide are rejected by every constructor and setter.
#[test]
fn unsound_shapes_are_refused_with_a_reason() {
    for (name, word, shape) in unsound_shapes() {
        let shape = shape.unwrap_or_else(|| panic!("{name} is not made"));
        let builder = ColliderBuilder::new(shape.clone());
        for error in [builder.try_build().unwrap_err(), builder.try_shape().unwrap_err()] {
            assert!(error.to_string().contains(word), "{name}: {error}");
        }
        let (collider, heard) = listen(|| builder.build());
        assert!(!collider.is_enabled() && heard.len() == 1, "{name}: {heard:?}");
        let mut collider = ColliderBuilder::ball(1.0).build();
        let ((), heard) = listen(|| collider.set_shape(shape.clone()));
        assert!(collider.shape().as_ball().is_some() && heard.len() == 1, "{name}: {heard:?}");
        let compound = ColliderBuilder::compound(vec![(Pose::IDENTITY, shape)]);
        assert!(compound.try_build().unwrap_err().to_string().contains(word), "{name}");
    }
}

/// The `try_` constructors return the reason for `None`.
#[test]
fn failed_hulls_return_the_reason() {
    let line = vec![Vector::ONE; 9];
    let reason = |points: &[Vector]| {
        assert!(ColliderBuilder::convex_hull(points).is_none());
        assert!(ColliderBuilder::try_round_convex_hull(points, 0.1).is_err());
        ColliderBuilder::try_convex_hull(points).unwrap_err().to_string()
    };
    assert!(reason(&line).contains("convex hull"), "{}", reason(&line));
    assert!(reason(&line[..1]).contains("1 elements"), "{}", reason(&line[..1]));
    assert!(reason(&[Vector::NAN; 5]).contains("NaN"), "{}", reason(&[Vector::NAN; 5]));
    let error = ColliderBuilder::try_round_convex_hull(&line, -1.0).unwrap_err();
    assert!(error.to_string().contains("border_radius is -1"), "{error}");
    let shape = ColliderBuilder::ball(0.5).try_shape().unwrap();
    assert_eq!(shape.as_ball().map(|ball| ball.radius), Some(0.5));
    assert!(ColliderBuilder::ball(-0.5).try_shape().unwrap_err().to_string().contains("radius"));
}
