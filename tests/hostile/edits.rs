//! Edits of body and collider properties between any two steps, for touching, moving and sleeping bodies.

use super::scene::Scene;
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// Name of an edit, and the edit. Its second argument is the number of the step.
type Edit = (&'static str, fn(&mut Scene, usize));

const EDITS: [Edit; 22] = [
    ("nothing", |_, _| {}),
    ("type", |s, i| s.body().set_body_type(TYPES[i % 4], i % 2 == 0)),
    ("body enabled", |s, i| s.body().set_enabled(i % 2 == 1)),
    ("body enabled twice", |s, _| {
        s.body().set_enabled(false);
        s.body().set_enabled(true);
    }),
    ("collider enabled", |s, i| s.collider().set_enabled(i % 2 == 1)),
    ("sensor", |s, i| s.collider().set_sensor(i % 2 == 0)),
    ("shape", |s, i| {
        let size = if i % 2 == 0 { 0.2 } else { 0.6 };
        s.collider().set_shape(cuboid(size, size).shape);
    }),
    ("collision groups", |s, i| s.collider().set_collision_groups(groups(i))),
    ("solver groups", |s, i| s.collider().set_solver_groups(groups(i))),
    ("parent", |s, i| {
        let parent = [Some(s.neighbours[0]), None, Some(s.neighbours[1]), Some(s.body)][i % 4];
        s.world.colliders.set_parent(s.collider, parent, &mut s.world.bodies);
    }),
    ("removal of the collider", |s, i| {
        if i % 2 == 0 {
            s.world.remove_collider(s.collider);
        } else {
            s.collider = s.world.insert_collider(cuboid(0.5, 0.5), Some(s.body));
        }
    }),
    ("removal of the body", |s, i| {
        let removed = s.world.remove_body(s.body);
        if let Some(body) = removed {
            s.body = s.world.insert_body(body);
            if i % 3 > 0 {
                s.collider = s.world.insert_collider(cuboid(0.5, 0.5), Some(s.body));
            }
        }
    }),
    ("removal of the support", |s, i| {
        if i == 0 {
            s.world.remove_body(s.neighbours[0]);
        }
    }),
    ("removal of all three", |s, i| {
        if i == 0 {
            for handle in [s.neighbours[0], s.body, s.neighbours[1]] {
                s.world.remove_body(handle);
                assert!(s.world.remove_body(handle).is_none());
            }
        } else if i == 1 {
            s.body = s.world.insert_body(RigidBodyBuilder::dynamic());
            s.collider = s.world.insert_collider(cuboid(0.5, 0.5), Some(s.body));
        }
    }),
    ("leap", |s, i| s.body().set_translation(vec(0.0, if i % 2 == 0 { 1.5 } else { 9.0 }), true)),
    ("leap without waking", |s, i| {
        s.body().set_translation(vec(0.0, if i % 2 == 0 { 1.5 } else { 9.0 }), false);
    }),
    ("sleep", |s, i| if i % 2 == 0 { s.body().sleep() } else { s.body().wake_up(true) }),
    ("sleep of all", |s, i| {
        for (_, body) in s.world.bodies.iter_mut().skip(4) {
            if i % 3 == 0 { body.sleep() } else { body.wake_up(false) }
        }
    }),
    ("dominance", |s, i| s.body().set_dominance_group(i as i8 % 3 - 1)),
    ("locked", |s, i| {
        s.body().lock_translations(i % 2 == 0, i % 3 == 0);
        s.body().lock_rotations(i % 3 == 0, i % 2 == 0);
    }),
    ("mass", |s, i| s.collider().set_density(if i % 2 == 0 { 0.0 } else { 100.0 })),
    ("everything", |s, i| {
        for (_, edit) in EDITS.iter().take(17).skip(1) {
            if s.world.bodies.contains(s.body) && s.world.colliders.contains(s.collider) {
                edit(s, i);
            }
        }
    }),
];

const TYPES: [RigidBodyType; 4] = [
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::Dynamic,
    RigidBodyType::KinematicVelocityBased,
];

fn groups(step: usize) -> InteractionGroups {
    if step.is_multiple_of(2) { InteractionGroups::none() } else { InteractionGroups::all() }
}

/// Repeats an edit after every `pause` steps.
fn edit_between_steps(scene: &mut Scene, edit: fn(&mut Scene, usize), pause: usize) {
    for step in 0..24 {
        let is_there = scene.world.bodies.contains(scene.body)
            && scene.world.colliders.contains(scene.collider);
        if is_there || step < 2 {
            edit(scene, step);
        } else if scene.world.bodies.contains(scene.body) {
            scene.collider = scene.world.insert_collider(cuboid(0.5, 0.5), Some(scene.body));
        }
        scene.steps(pause);
    }
}

#[test]
fn edits_of_touching_bodies_affect_no_other_body() {
    let mut untouched = Scene::new();
    untouched.steps(24);
    let expected = untouched.distant_in_the_end();
    for (name, edit) in EDITS {
        let mut scene = Scene::new();
        edit_between_steps(&mut scene, edit, 1);
        assert!(scene.distant_in_the_end() == expected, "{name} affects distant bodies");
    }
}

#[test]
fn edits_of_sleeping_bodies_affect_no_other_body() {
    let asleep = || {
        let mut scene = Scene::new();
        scene.steps(600);
        assert!(scene.body().is_sleeping() && scene.world.active_bodies().is_empty());
        scene
    };
    let expected = asleep().distant_in_the_end();
    for pause in [1, 3, 40] {
        for (name, edit) in EDITS {
            let mut scene = asleep();
            edit_between_steps(&mut scene, edit, pause);
            assert!(scene.distant_in_the_end() == expected, "{name} wakes distant bodies");
        }
    }
}

/// All edits again, for bodies that kinematic bodies push.
#[test]
fn edits_of_pushed_bodies_keep_the_invariants() {
    for (_, edit) in EDITS {
        let mut scene = Scene::new();
        let pusher = RigidBodyBuilder::kinematic_velocity_based().linvel(vec(1.0, 0.1));
        scene.world.insert(pusher.translation(vec(-1.5, 1.0)), cuboid(0.5, 1.0));
        let sensor = ColliderBuilder::ball(3.0).sensor(true);
        scene.world.insert_collider(sensor, Some(scene.neighbours[1]));
        edit_between_steps(&mut scene, edit, 2);
    }
}
