//! Operations on colliders.

use super::dim::{SHAPES, about_z, shape};
use super::groups::OTHERS;
use super::play::{COLLIDERS_MAX, Play};
use super::rapier::prelude::*;
use super::values::choose;
use super::values::{some_pose, some_positive, some_real, some_vector, within};
use crate::choices::Choices;

/// Returns a collider of any kind.
pub fn some_collider(choices: &mut Choices<'_>) -> ColliderBuilder {
    let kind = if choices.coin() { choices.below(2) } else { choices.below(SHAPES) };
    let size = if choices.once_in(50) { some_real(choices) } else { within(choices, 0.2, 0.8) };
    let collider = shape(kind, size, choices).unwrap_or_default().collision_groups(OTHERS);
    if choices.coin() {
        return collider;
    }
    let events = choices.pick(&[ActiveEvents::empty(), ActiveEvents::all()]);
    let hooks = choices.pick(&[ActiveHooks::empty(), ActiveHooks::all()]);
    collider
        .active_events(events)
        .active_hooks(hooks)
        .restitution(some_positive(choices))
        .friction(some_positive(choices))
        .contact_skin(if choices.once_in(4) { some_positive(choices) } else { 0.0 })
        .position(if choices.once_in(4) { some_pose(choices, 1.0) } else { Pose::IDENTITY })
        .sensor(choices.once_in(5))
        .enabled(!choices.once_in(20))
}

/// Inserts or removes a collider.
pub fn insert_or_remove(play: &mut Play<'_>) {
    let parent = if play.choices.once_in(4) { None } else { Some(play.body()) };
    if play.choices.coin() || play.world.colliders.len() >= COLLIDERS_MAX {
        let handle = play.collider();
        let existed = play.world.colliders.contains(handle);
        let PhysicsWorld { colliders, islands, bodies, .. } = &mut play.world;
        let removed = colliders.remove(handle, islands, bodies, play.choices.coin());
        assert_eq!(removed.is_some(), existed);
        assert!(play.world.remove_collider(handle).is_none(), "{handle:?} was removed twice");
        if let Some(collider) = removed.filter(|_| play.choices.coin()) {
            play.colliders.push(play.world.insert_collider(collider, parent));
        }
    } else {
        let collider = some_collider(&mut play.choices);
        play.colliders.push(play.world.insert_collider(collider, parent));
    }
}

/// Edits one collider, or all colliders.
pub fn edit(play: &mut Play<'_>) {
    let (handle, other, body) = (play.collider(), play.collider(), play.body());
    let Play { choices, world, isolated_bodies, .. } = play;
    match choose(choices, 24) {
        0 | 1 => {
            let parent = if choices.once_in(3) { None } else { Some(body) };
            world.colliders.set_parent(handle, parent, &mut world.bodies);
        }
        2 => {
            let copy = world.colliders.get(other).cloned();
            if let (Some(copy), Some(collider)) = (copy, world.colliders.get_mut(handle)) {
                collider.copy_from(&copy);
            }
        }
        3 => {
            let copy = world.colliders.get(other).cloned();
            if let (Some(copy), Some(collider)) = (copy, world.colliders.get_mut(handle)) {
                *collider = copy;
            }
        }
        4 => {
            if let (Some(one), Some(two)) = world.colliders.get_pair_mut(handle, other) {
                core::mem::swap(one, two);
            }
        }
        5 => {
            let others = world
                .colliders
                .iter_mut()
                .filter(|(handle, _)| !isolated_bodies.colliders.contains(handle));
            others.for_each(|(_, collider)| change_interaction(collider, choices));
        }
        choice => {
            let Some(collider) = world.colliders.get_mut(handle) else { return };
            match choice % 3 {
                0 => place(collider, choices),
                1 => change_interaction(collider, choices),
                _ => change_material(collider, choices),
            }
        }
    }
}

fn place(collider: &mut Collider, choices: &mut Choices<'_>) {
    let pose = some_pose(choices, 2.0);
    match choose(choices, 6) {
        0 => collider.set_position(pose),
        1 => collider.set_translation(pose.translation),
        2 => collider.set_rotation(pose.rotation),
        3 => collider.set_position_wrt_parent(pose),
        4 => collider.set_translation_wrt_parent(some_vector(choices, 1.0)),
        _ => collider.set_rotation_wrt_parent(about_z(some_real(choices))),
    }
}

fn change_interaction(collider: &mut Collider, choices: &mut Choices<'_>) {
    let groups = [
        OTHERS,
        InteractionGroups::none(),
        InteractionGroups::new(Group::GROUP_1, Group::GROUP_2),
        OTHERS.with_test_mode(InteractionTestMode::Or),
    ];
    match choose(choices, 8) {
        0 => collider.set_enabled(!choices.once_in(3)),
        1 => collider.set_sensor(choices.once_in(3)),
        2 => collider.set_collision_groups(choices.pick(&groups)),
        3 => collider.set_solver_groups(choices.pick(&groups)),
        4 => {
            let all = ActiveCollisionTypes::all();
            let types = [all, ActiveCollisionTypes::default(), ActiveCollisionTypes::FIXED_FIXED];
            collider.set_active_collision_types(choices.pick(&types));
        }
        5 => {
            let hooks = [ActiveHooks::empty(), ActiveHooks::all()];
            collider.set_active_hooks(choices.pick(&hooks));
        }
        6 => {
            let events = [ActiveEvents::empty(), ActiveEvents::all()];
            collider.set_active_events(choices.pick(&events));
        }
        _ => collider.set_contact_force_event_threshold(some_real(choices)),
    }
}

fn change_material(collider: &mut Collider, choices: &mut Choices<'_>) {
    let value = some_real(choices);
    match choose(choices, 10) {
        0 => collider.set_friction(value),
        1 => collider.set_restitution(value),
        2 => collider.set_contact_skin(value),
        3 => collider.set_density(value),
        4 => collider.set_mass(value),
        5 => collider.set_shape(some_collider(choices).shape),
        6 => {
            let properties = ColliderBuilder::ball(value).build().mass_properties();
            collider.set_mass_properties(properties);
        }
        7 => {
            if let Some(ball) = collider.shape_mut().as_ball_mut() {
                ball.radius = value;
            }
        }
        8 => collider.set_friction_combine_rule(CoefficientCombineRule::GeometricMean),
        _ => collider.set_restitution_combine_rule(CoefficientCombineRule::Max),
    }
}
