//! Invalid values for the builders.

use super::listener::{listen, names};
use super::scene::Scene;
use super::values::{EDGES, edge_vectors};
use super::world::check;
use crate::dim::{about_z, hostile::broken_rotations, hostile::shapes_of_number, vec};
use rapier::prelude::*;

/// Name of a field of a body's builder, and its setter.
type Field = (&'static str, fn(RigidBodyBuilder, Real) -> RigidBodyBuilder);

const FIELDS: [Field; 10] = [
    ("position", |b, v| b.translation(vec(v, 1.0))),
    ("position", |b, v| b.rotation(about_z(v))),
    ("linvel", |b, v| b.linvel(vec(0.0, v))),
    ("angvel", |b, v| b.angvel(about_z(v))),
    ("gravity_scale", RigidBodyBuilder::gravity_scale),
    ("linear_damping", RigidBodyBuilder::linear_damping),
    ("angular_damping", RigidBodyBuilder::angular_damping),
    ("soft_ccd_prediction", RigidBodyBuilder::soft_ccd_prediction),
    ("additional_mass", RigidBodyBuilder::additional_mass),
    ("additional_mass_properties", |b, v| {
        let mut part = ColliderBuilder::ball(1.0).build().mass_properties();
        part.inv_mass = v;
        b.additional_mass_properties(part)
    }),
];

#[test]
fn a_body_is_built_or_rejected_by_name() {
    let distant = Scene::new().distant_in_the_end();
    for (field, set) in FIELDS {
        for value in EDGES {
            let builder = set(RigidBodyBuilder::dynamic(), value);
            let (body, heard) = listen(|| builder.build());
            match builder.try_build() {
                Ok(_) => assert!(heard.is_empty() && !value.is_nan(), "{field} {value}: {heard:?}"),
                Err(error) => {
                    assert_eq!(error.field, field);
                    let text = error.to_string();
                    // An infinite angle has become a rotation of NaN before the first read.
                    let named = names(&text, value) || names(&text, Real::NAN);
                    assert!(named, "{field} {value}: {text}");
                    assert_eq!(heard.len(), 1, "{field} {value}: {heard:?}");
                    assert!(heard[0].contains(&text), "{heard:?}");
                }
            }
            let mut scene = Scene::new();
            scene.world.insert(body, ColliderBuilder::ball(0.5).density(1.0));
            let end = scene.distant_in_the_end();
            assert!(
                end == distant || value.abs() > 900.0,
                "{field} {value} affects distant bodies"
            );
        }
    }
}

#[test]
fn a_body_is_built_without_invalid_rotations() {
    for rotation in broken_rotations() {
        let builder = RigidBodyBuilder::dynamic().pose(Pose::from_parts(Vector::ONE, rotation));
        assert_eq!(builder.try_build().unwrap_err().field, "position");
        let (body, heard) = listen(|| builder.build());
        assert_eq!((body.position(), heard.len()), (&Pose::IDENTITY, 1));
    }
    for count in [usize::MAX, 1_000_000] {
        let builder = RigidBodyBuilder::dynamic().additional_solver_iterations(count);
        let error = builder.try_build().unwrap_err();
        assert!(error.to_string().contains(&count.to_string()), "{error}");
        assert_eq!(listen(|| builder.build()).0.additional_solver_iterations(), 0);
    }
}

/// Drops the builder's collider onto the first pile, and inserts it into the ground without a body.
fn survive(builder: &ColliderBuilder, name: &str) {
    let mut scene = Scene::new();
    let world = &mut scene.world;
    let falling = RigidBodyBuilder::dynamic().translation(vec(0.2, 3.6));
    world.insert(falling, builder.build());
    let kinematic = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(0.1, 0.0));
    world.insert(kinematic.translation(vec(-3.0, 0.0)), builder.build());
    world.insert_collider(builder.build(), None);
    world.insert_collider(builder.build().clone(), Some(scene.body));
    for _ in 0..5 {
        world.step();
        check(world);
    }
    let _ = name;
}

/// A shape made from one number: a radius, a coordinate, a height, or a border radius.
#[test]
fn a_shape_is_built_or_rejected_by_name() {
    for (name, make) in shapes_of_number() {
        let usual = make(1.0).map(|builder| builder.try_build());
        assert!(matches!(usual, Some(Ok(_))), "{name} of 1: {usual:?}");
        for value in EDGES {
            let (made, _) = listen(|| make(value));
            let Some(builder) = made else { continue };
            let (collider, heard) = listen(|| builder.build());
            match builder.try_build() {
                Ok(_) => {
                    assert!(value.is_finite(), "{name} of {value} is accepted");
                    assert!(collider.is_enabled(), "{name} of {value}: {heard:?}");
                }
                Err(error) => {
                    let text = error.to_string();
                    // A derived value may be invalid.
                    let derived = ["degenerate", "cells", "bounding box"];
                    let named = names(&text, value)
                        || names(&text, -value)
                        || derived.iter().any(|word| text.contains(word));
                    assert!(named, "{name} of {value}: {text}");
                    assert!(heard.iter().any(|heard| heard.contains(&text)), "{name}: {heard:?}");
                    assert!(!collider.is_enabled() && collider.mass() == 0.0, "{name} of {value}");
                }
            }
            listen(|| survive(&builder, name));
        }
    }
}

/// Name and setter of a number of a collider's builder outside of its shape.
type Knob = (&'static str, fn(ColliderBuilder, Real) -> ColliderBuilder);

const KNOBS: [Knob; 9] = [
    ("friction", ColliderBuilder::friction),
    ("restitution", ColliderBuilder::restitution),
    ("density", ColliderBuilder::density),
    ("mass", ColliderBuilder::mass),
    ("contact_skin", ColliderBuilder::contact_skin),
    ("threshold", ColliderBuilder::contact_force_event_threshold),
    ("translation", |b, v| b.translation(vec(v, 0.0))),
    ("rotation", |b, v| b.rotation(about_z(v))),
    ("mass_properties", |b, v| {
        let mut mass = ColliderBuilder::ball(1.0).build().mass_properties();
        mass.inv_mass = v;
        b.mass_properties(mass)
    }),
];

#[test]
fn a_collider_is_built_or_rejected_by_name() {
    for (name, set) in KNOBS {
        for value in EDGES {
            let builder = set(ColliderBuilder::ball(0.5), value);
            if let Err(error) = builder.try_build() {
                let text = error.to_string();
                let named = names(&text, value) || (name == "rotation" && text.contains("NaN"));
                assert!(named, "{name} {value}: {text}");
                let (collider, heard) = listen(|| builder.build());
                assert!(heard.iter().any(|heard| heard.contains(&text)), "{name}: {heard:?}");
                assert!(!collider.is_enabled() && collider.mass() == 0.0, "{name} {value}");
            } else {
                assert!(!value.is_nan(), "{name} {value} is accepted");
            }
            listen(|| survive(&builder, name));
        }
    }
}

#[test]
fn any_vector_is_a_position_or_rejected() {
    for vector in edge_vectors() {
        let builder = ColliderBuilder::ball(0.5).translation(vector);
        let usable = vector.is_finite() && vector.abs().max_element() <= 1.0e15;
        assert_eq!(builder.try_build().is_ok(), usable, "{vector}");
        let body = RigidBodyBuilder::dynamic().translation(vector);
        assert_eq!(body.try_build().is_ok(), usable, "{vector}");
    }
}
