//! The motion that follows an edit of a sleeping body, and bodies that stay asleep.

use super::stage::Resting;
use crate::dim::{about_z, angle, cuboid, slab, vec};
use rapier::prelude::*;

/// An edit of a sleeping box, and whether the box has moved as expected two seconds later.
type Case = (&'static str, fn(&mut Resting), fn(&RigidBody) -> bool);
/// An edit, with its name.
type Edit = (&'static str, fn(&mut Resting));

fn tips(body: &RigidBody) -> bool {
    angle(body.rotation()).abs() > 0.3
}

fn leaves(body: &RigidBody) -> bool {
    body.translation().y > 0.8
}

const CASES: [Case; 8] = [
    (
        "a heavy overhanging collider",
        |s| {
            let weight = cuboid(0.5, 0.5).translation(vec(1.0, 0.5)).density(10.0);
            s.world.insert_collider(weight, Some(s.body));
        },
        tips,
    ),
    (
        "set_mass_properties",
        |s| {
            let beside = MassProperties { local_com: vec(0.9, 0.0), ..slab() };
            s.box_collider().set_mass_properties(beside);
        },
        tips,
    ),
    (
        "set_additional_mass_properties",
        |s| {
            let mut beside = MassProperties { local_com: vec(0.9, 0.0), ..slab() };
            beside.set_mass(100.0, true);
            s.body().set_additional_mass_properties(beside, true);
        },
        tips,
    ),
    (
        "a fixed collider that appears inside",
        |s| {
            s.world.insert_collider(cuboid(0.5, 0.2).translation(vec(0.0, 0.2)), None);
        },
        leaves,
    ),
    (
        "a fixed collider that is enabled",
        |s| {
            let inside = s
                .world
                .insert_collider(cuboid(0.5, 0.2).translation(vec(0.0, 0.2)).enabled(false), None);
            s.world.step();
            s.world.colliders[inside].set_enabled(true);
        },
        leaves,
    ),
    (
        "a sensor that becomes solid",
        |s| {
            let inside = s
                .world
                .insert_collider(cuboid(0.5, 0.2).translation(vec(0.0, 0.2)).sensor(true), None);
            s.world.step();
            s.world.colliders[inside].set_sensor(false);
        },
        leaves,
    ),
    (
        "a fixed body that is moved inside",
        |s| {
            let body = RigidBodyBuilder::fixed().translation(vec(9.0, 9.0));
            let (body, _) = s.world.insert(body, cuboid(0.5, 0.2));
            s.world.step();
            s.world.bodies[body].set_translation(vec(0.0, 0.2), false);
        },
        leaves,
    ),
    (
        "a fixed body that is enabled",
        |s| {
            let body = RigidBodyBuilder::fixed().translation(vec(0.0, 0.2)).enabled(false);
            let (body, _) = s.world.insert(body, cuboid(0.5, 0.2));
            s.world.step();
            s.world.bodies[body].set_enabled(true);
        },
        leaves,
    ),
];
/// The motion that an edit causes follows: the box tips, slides or is pushed out.
#[test]
fn edited_bodies_tip_and_leave() {
    for (name, edit, moves) in CASES {
        let mut scene = Resting::asleep();
        edit(&mut scene);
        (0..120).for_each(|_| scene.world.step());
        let body = scene.body();
        println!("{name}: at {}, {:.2} rad", body.translation(), angle(body.rotation()));
        assert!(moves(body), "{name}: it stays at {}", body.translation());
    }
}

/// A box sleeps on a slope of 20 degrees until the friction of either side becomes zero. Then it slides down
/// by `g t² sin(α) / 2`.
#[test]
fn sleeping_bodies_slide_without_friction() {
    for side in ["the box", "the slope"] {
        let mut world = PhysicsWorld::new();
        let tilt: Real = 0.35;
        let slope = cuboid(50.0, 1.0).rotation(about_z(tilt)).friction(0.8);
        let slope = slope.friction_combine_rule(CoefficientCombineRule::Min);
        let slope = world.insert_collider(slope, None);
        let up = vec(-tilt.sin(), tilt.cos());
        let body = RigidBodyBuilder::dynamic().translation(up * 1.5).rotation(about_z(tilt));
        let (body, collider) = world.insert(body, cuboid(0.5, 0.5).friction(0.8));
        (0..200).for_each(|_| world.step());
        assert!(world.bodies[body].is_sleeping());
        let start = world.bodies[body].translation();
        let edited = if side == "the box" { collider } else { slope };
        world.colliders[edited].set_friction(0.0);
        (0..60).for_each(|_| world.step());
        let slid = world.bodies[body].translation().distance(start);
        let expected = 0.5 * 9.81 * tilt.sin();
        println!("friction of {side} 0: {slid:.3} m in 1 s, {expected:.3} m by the formula");
        assert!((slid - expected).abs() < 0.05 * expected, "{side}: {slid} m");
    }
}

/// Bodies that the user inserts asleep stay asleep on what they touch, and so do those that the user moves
/// without waking.
#[test]
fn bodies_inserted_asleep_stay_asleep() {
    let mut scene = Resting::asleep();
    let asleep = RigidBodyBuilder::dynamic().sleeping(true);
    let on_top = scene.world.insert(asleep.clone().translation(vec(0.0, 1.5)), cuboid(0.5, 0.5)).0;
    let beside = scene.world.insert(asleep.translation(vec(4.0, 0.5)), cuboid(0.5, 0.5)).0;
    (0..10).for_each(|_| scene.world.step());
    for body in [scene.body, on_top, beside] {
        assert!(scene.world.bodies[body].is_sleeping(), "{body:?} woke");
    }
    scene.world.bodies[beside].set_translation(vec(7.0, 0.5), false);
    scene.world.step();
}

/// An edit just before a body would fall asleep keeps it awake until it moves.
#[test]
fn edits_restart_the_time_until_sleep() {
    let mut scene = Resting::falling();
    let mut steps = 0;
    while !scene.body().is_sleeping() {
        scene.world.step();
        steps += 1;
    }
    let edits: [Edit; 3] = [
        ("ground disabled", |s| s.ground().set_enabled(false)),
        ("ground without solver groups", |s| {
            s.ground().set_solver_groups(InteractionGroups::none())
        }),
        ("ground a sensor", |s| s.ground().set_sensor(true)),
    ];
    for (name, edit) in edits {
        for before in 1..4 {
            let mut scene = Resting::falling();
            (0..steps - before).for_each(|_| scene.world.step());
            edit(&mut scene);
            (0..30).for_each(|_| scene.world.step());
            let y = scene.body().translation().y;
            assert!(y < 0.0, "{name} {before} steps before sleep: it floats at {y}");
        }
    }
}
