//! Scaled and mirrored shapes.

use crate::dim::{cube, mesh, shapes, vector, wedge};
use crate::plugin::prelude::*;
use crate::plugin::rapier::parry::bounding_volume::Aabb;
use crate::scene::*;
use bevy::ecs::system::RunSystemOnce;
use bevy::prelude::*;

fn bounds(app: &App, entity: Entity) -> Aabb {
    physics(app).collider(entity).expect("a collider").compute_aabb()
}

fn scaled(app: &mut App, shape: Collider, scale: Vec3) -> Entity {
    let entity = app.world_mut().spawn((shape, Transform::from_scale(scale))).id();
    app.update();
    entity
}

#[track_caller]
fn assert_mirrored(name: &str, old: &Aabb, new: &Aabb, signs: [Scalar; 2]) {
    let expected = |axis: usize| match signs[axis] < 0.0 {
        true => [-old.maxs[axis], -old.mins[axis]],
        false => [old.mins[axis], old.maxs[axis]],
    };
    for axis in 0..2 {
        for (found, expected) in [new.mins[axis], new.maxs[axis]].into_iter().zip(expected(axis)) {
            assert!((found - expected).abs() < 0.02, "{name}: {new:?} of {old:?}");
        }
    }
}

#[test]
fn a_flip_mirrors_a_shape_at_its_insertion_and_later() {
    for (name, shape) in shapes() {
        let mut app = weightless();
        let upright = scaled(&mut app, shape.clone(), Vec3::ONE);
        let (old, mass) = (bounds(&app, upright), physics(&app).collider(upright).unwrap().mass());
        for signs in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
            let scale = Vec3::new(signs[0] as f32, signs[1] as f32, 1.0);
            let flipped = scaled(&mut app, shape.clone(), scale);
            assert_mirrored(name, &old, &bounds(&app, flipped), signs);
            edit::<Transform>(&mut app, upright).scale = scale;
            app.update();
            assert_mirrored(name, &old, &bounds(&app, upright), signs);
            let new_mass = physics(&app).collider(upright).unwrap().mass();
            assert!((new_mass - mass).abs() <= 0.05 * mass, "{name}: {new_mass} instead of {mass}");
        }
    }
}

#[test]
fn a_body_rests_on_a_mirrored_mesh_and_hull() {
    for shape in [mesh(), wedge()] {
        let mut app = app();
        let scale = Vec3::new(-4.0, 1.0, 4.0);
        app.world_mut().spawn((shape, at(0.0, 0.0).with_scale(scale)));
        let bundle = (RigidBody::Dynamic, Collider::ball(0.25), at(-1.0, 1.5));
        let body = app.world_mut().spawn((bundle, LockedAxes(AxesMask::TRANSLATION_LOCKED_X))).id();
        run(&mut app, 64 * 2);
        // The slope from (-4, 0) to (0, 1): the ball touches it above, at a distance of its radius.
        let slope = 0.75 + 0.25 * f64::from(17.0_f32.sqrt()) / 4.0;
        assert_near(position(&app, body).y, slope, 0.02);
    }
}

#[test]
fn uneven_scales_keep_normals_perpendicular() {
    let slanted = vector(1.0, 1.0) / Scalar::sqrt(2.0);
    for shape in [wedge(), Collider::halfspace(slanted)] {
        let mut app = weightless();
        scaled(&mut app, shape, Vec3::new(2.0, 1.0, 1.0));
        let look = |query: SpatialQuery| {
            let (from, along) = (vector(3.0, 3.0), vector(-2.5, -2.75));
            query.cast_ray(from, along, 2.0, &SpatialFilter::default())
        };
        let hit = app.world_mut().run_system_once(look).expect("it runs").expect("a hit");
        let expected = vector(1.0, 2.0) / Scalar::sqrt(5.0);
        assert_near((hit.normal - expected).length(), 0.0, 1.0e-3);
    }
}

#[derive(Resource, Default)]
struct Reports(Vec<String>);

#[test]
fn borders_scale_evenly_or_are_refused() {
    let mut app = weightless();
    app.init_resource::<Reports>();
    app.add_observer(|on: On<Refused>, mut reports: ResMut<Reports>| {
        reports.0.push(on.reason.to_string());
    });
    let round = || shapes().into_iter().find(|(name, _)| *name == "round cuboid").unwrap().1;
    let large = scaled(&mut app, round(), Vec3::splat(2.0));
    assert_near(bounds(&app, large).maxs.x, 1.0, 1.0e-5);
    let uneven = scaled(&mut app, round(), Vec3::new(2.0, 1.0, 1.0));
    assert!(physics(&app).collider(uneven).is_none());
    let reports = &app.world().resource::<Reports>().0;
    assert!(matches!(&reports[..], [report] if report.contains("even")), "{reports:?}");
}

#[test]
fn a_size_of_zero_at_the_start_is_no_end() {
    let mut app = weightless();
    let ball = scaled(&mut app, Collider::ball(0.5), Vec3::ZERO);
    run(&mut app, 2);
    assert!(physics(&app).collider(ball).is_none());
    edit::<Transform>(&mut app, ball).scale = Vec3::ONE;
    run(&mut app, 2);
    assert_near(bounds(&app, ball).maxs.x, 0.5, 1.0e-5);
    // Below an ancestor of size 0, and with an invalid place.
    let group = app.world_mut().spawn(Transform::from_scale(Vec3::ZERO)).id();
    let part = app.world_mut().spawn((cube(0.5), at(2.0, 0.0), ChildOf(group))).id();
    let lost = app.world_mut().spawn((cube(0.5), at(f32::NAN, 0.0))).id();
    run(&mut app, 2);
    edit::<Transform>(&mut app, group).scale = Vec3::ONE;
    edit::<Transform>(&mut app, lost).translation.x = 5.0;
    run(&mut app, 2);
    assert_near(bounds(&app, part).maxs.x, 2.5, 1.0e-5);
    assert_near(bounds(&app, lost).maxs.x, 5.5, 1.0e-5);
}

#[test]
fn a_flip_of_a_body_mirrors_its_parts() {
    let mut app = weightless();
    let flipped = Transform::from_scale(Vec3::new(-1.0, 1.0, 1.0));
    let body = app.world_mut().spawn((RigidBody::Dynamic, flipped)).id();
    let tilted = at(1.0, 0.0).with_rotation(Quat::from_rotation_z(0.5));
    let part = app.world_mut().spawn((cube(0.5), tilted, ChildOf(body))).id();
    run(&mut app, 4);
    let pose = *physics(&app).collider(part).unwrap().position();
    assert_near(pose.translation.x, -1.0, 1.0e-5);
    let x_axis = pose.rotation * crate::dim::engine_vector(1.0, 0.0);
    // The renderer's matrix mirrors the rotation, too.
    let shown = get::<GlobalTransform>(&app, part).affine().transform_vector3(Vec3::X);
    assert_near(x_axis.x, -shown.x, 1.0e-5);
    assert_near(x_axis.y, -shown.y, 1.0e-5);
}
