//! What the fuzzer does to colliders.

use super::super::random::Dice;
use super::super::values::{some_real, some_vector};
use super::Victim;
use super::bodies::{some_collider, some_pose};
use crate::dim::about_z;
use rapier::prelude::*;

/// One collider more or less.
pub fn insert_or_remove(victim: &mut Victim) {
    let parent = if victim.dice.once_in(4) { None } else { Some(victim.body()) };
    let remove = victim.dice.coin() || victim.world.colliders.len() > 90;
    if remove {
        let handle = victim.collider();
        let existed = victim.world.colliders.contains(handle);
        let PhysicsWorld { colliders, islands, bodies, .. } = &mut victim.world;
        let removed = colliders.remove(handle, islands, bodies, victim.dice.coin());
        assert_eq!(removed.is_some(), existed);
        let again = removed.filter(|_| victim.dice.coin());
        assert!(victim.world.remove_collider(handle).is_none(), "{handle:?} was removed twice");
        if let Some(collider) = again {
            victim.colliders.push(victim.world.insert_collider(collider, parent));
        }
    } else {
        let collider = some_collider(&mut victim.dice);
        victim.colliders.push(victim.world.insert_collider(collider, parent));
    }
}

/// Changes something about one collider.
pub fn edit(victim: &mut Victim) {
    let (handle, other, body) = (victim.collider(), victim.collider(), victim.body());
    let dice = &mut victim.dice;
    match dice.below(12) {
        0 => {
            let parent = if dice.once_in(3) { None } else { Some(body) };
            victim.world.colliders.set_parent(handle, parent, &mut victim.world.bodies);
        }
        1 => {
            let copy = victim.world.colliders.get(other).cloned();
            if let (Some(copy), Some(collider)) = (copy, victim.world.colliders.get_mut(handle)) {
                collider.copy_from(&copy);
            }
        }
        2 if dice.once_in(10) => {
            for (_, collider) in victim.world.colliders.iter_mut() {
                meet_others(collider, dice);
            }
        }
        choice => {
            let Some(collider) = victim.world.colliders.get_mut(handle) else { return };
            match choice % 3 {
                0 => place(collider, dice),
                1 => meet_others(collider, dice),
                _ => change_matter(collider, dice),
            }
        }
    }
}

fn place(collider: &mut Collider, dice: &mut Dice) {
    let pose = some_pose(dice);
    match dice.below(6) {
        0 => collider.set_position(pose),
        1 => collider.set_translation(pose.translation),
        2 => collider.set_rotation(pose.rotation),
        3 => collider.set_position_wrt_parent(pose),
        4 => collider.set_translation_wrt_parent(some_vector(dice, 1.0)),
        _ => collider.set_rotation_wrt_parent(about_z(some_real(dice))),
    }
}

fn meet_others(collider: &mut Collider, dice: &mut Dice) {
    let groups = |dice: &mut Dice| match dice.below(4) {
        0 => InteractionGroups::none(),
        1 => InteractionGroups::new(Group::GROUP_1, Group::GROUP_2),
        _ => InteractionGroups::all(),
    };
    match dice.below(8) {
        0 => collider.set_enabled(!dice.once_in(3)),
        1 => collider.set_sensor(dice.once_in(3)),
        2 => collider.set_collision_groups(groups(dice)),
        3 => collider.set_solver_groups(groups(dice)),
        4 => {
            let all = ActiveCollisionTypes::all();
            let types = [all, ActiveCollisionTypes::default(), ActiveCollisionTypes::FIXED_FIXED];
            collider.set_active_collision_types(dice.pick(&types));
        }
        5 => {
            let hooks = [ActiveHooks::empty(), ActiveHooks::all()];
            collider.set_active_hooks(dice.pick(&hooks));
        }
        6 => {
            let events = [ActiveEvents::empty(), ActiveEvents::all()];
            collider.set_active_events(dice.pick(&events));
        }
        _ => collider.set_contact_force_event_threshold(some_real(dice)),
    }
}

fn change_matter(collider: &mut Collider, dice: &mut Dice) {
    let value = some_real(dice);
    match dice.below(10) {
        0 => collider.set_friction(value),
        1 => collider.set_restitution(value),
        2 => collider.set_contact_skin(value),
        3 => collider.set_density(value),
        4 => collider.set_mass(value),
        5 => collider.set_shape(some_collider(dice).shape),
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
