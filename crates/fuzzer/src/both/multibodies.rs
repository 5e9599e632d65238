//! Operations on multibodies.

use super::dim::AXES;
use super::joints::{change, some_joint};
use super::play::{JOINTS_MAX, Play};
use super::rapier::prelude::*;
use super::values::{some_pose, some_real};

/// Inserts or removes a link, or removes a multibody.
pub fn insert_or_remove(play: &mut Play<'_>) {
    let (body1, body2, handle) = (play.body(), play.body(), play.link());
    let set = &mut play.world.multibody_joints;
    let choices = &mut play.choices;
    match choices.below(10) {
        0 | 1 => {
            let existed = set.contains(handle);
            assert_eq!(set.remove(handle, choices.coin()).is_some(), existed);
            assert!(set.remove(handle, true).is_none(), "{handle:?} was removed twice");
        }
        2 => set.remove_multibody_articulations(handle, choices.coin()),
        3 => set.remove_joints_attached_to_rigid_body(body1),
        4 if set.len() < JOINTS_MAX => {
            play.links.extend(set.insert_kinematic(body1, body2, some_joint(choices), true));
        }
        _ if set.len() < JOINTS_MAX => {
            play.links.extend(set.insert(body1, body2, some_joint(choices), choices.coin()));
        }
        _ => {}
    }
}

/// Edits or queries a multibody.
pub fn edit(play: &mut Play<'_>) {
    let (handle, other) = (play.link(), play.link());
    let Play { choices, world, .. } = play;
    let other = world.multibody_joints.get(other).map_or(0, |(_, id)| id);
    let Some((multibody, id)) = world.multibody_joints.get_mut(handle) else { return };
    let value = some_real(choices);
    match choices.below(14) {
        0..=3 => {
            if let Some(link) = multibody.link_mut(id) {
                change(&mut link.joint.data, choices);
            }
        }
        4 => {
            let axes = [choices.pick(&AXES), choices.pick(&AXES)];
            let _ = multibody.add_dof_coupling(id, axes[0], other, axes[1], value, 0.0);
        }
        5 => drop(multibody.remove_dof_coupling(choices.below(3))),
        6 => multibody.damping_mut().fill(value),
        7 => multibody.armature_mut().fill(value),
        8 => multibody.frictions_mut().fill(value),
        9 => multibody.generalized_velocity_mut().fill(value),
        10 => multibody.set_self_contacts_enabled(choices.coin()),
        11 => {
            let displacements = vec![value; choices.below(9)];
            multibody.apply_displacements(&displacements);
        }
        12 => {
            multibody.forward_kinematics(&world.bodies, choices.coin());
            multibody.update_rigid_bodies(&mut world.bodies, true);
        }
        _ => query(play, handle, id),
    }
}

fn query(play: &mut Play<'_>, handle: MultibodyJointHandle, id: usize) {
    let Play { choices, world, .. } = play;
    let Some((multibody, _)) = world.multibody_joints.get(handle) else { return };
    let mut displacements = vec![0.0; choices.below(9)];
    let target = some_pose(choices, 2.0);
    let options = InverseKinematicsOption::default();
    let all = |_: &MultibodyLink| true;
    multibody.inverse_kinematics(&world.bodies, id, &options, &target, all, &mut displacements);
    multibody.body_jacobian(id);
    multibody.mass_matrix();
    multibody.bias_forces();
    multibody.accelerations_of(&displacements);
    multibody.kinematic_branch(id);
}
