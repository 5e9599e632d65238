//! Random edits at random times, in two equal worlds: both disable the same bodies and have the same bits.

use super::super::random::Dice;
use super::stage::{Disabled, Stage, step_alike};
use crate::dim::{about_z, vec};
use rapier::prelude::*;

const WORLDS: u64 = 16;
const STEPS: usize = 60;

/// Returns a number of any magnitude, usually a harmless one.
fn number(dice: &mut Dice) -> Real {
    let order = if dice.once_in(3) { dice.within(-20.0, 37.0) } else { dice.within(-3.0, 3.0) };
    let sign = if dice.once_in(2) { -1.0 } else { 1.0 };
    sign * Real::powf(10.0, order)
}

/// Edits a stage at random.
fn edit_at_random(stage: &mut Stage, dice: &mut Dice) {
    let Stage { world, suspect, neighbour, lift, sleeper, .. } = stage;
    // Links are excluded: see `a_link_takes_its_multibody_along`.
    let body = dice.pick(&[*suspect, *neighbour, *lift, *sleeper]);
    let (value, other) = (number(dice), number(dice));
    let record = &mut world.bodies[body];
    match dice.below(9) {
        0 => record.add_force(vec(value, other), true),
        1 => record.add_torque(about_z(value), true),
        2 => record.set_linvel(vec(value, other), true),
        3 => record.set_angvel(about_z(value), true),
        4 => record.set_gravity_scale(value, true),
        5 => record.set_next_kinematic_position(Pose::from_translation(vec(value, other))),
        6 => {
            let collider = record.colliders()[0];
            world.colliders[collider].set_mass(value.abs());
        }
        7 => {
            let model = dice.pick(&[MotorModel::ForceBased, MotorModel::AccelerationBased]);
            stage.drive(model, value.abs());
        }
        _ => world.integration_parameters.dt = dice.pick(&[1.0 / 60.0, 1.0e-3, 0.5, 10.0]),
    }
}

#[test]
fn random_edits_at_random_times() {
    let mut all: Vec<Disabled> = Vec::new();
    for seed in 0..WORLDS {
        let (mut stage, mut twin) = (Stage::new(), Stage::new());
        let mut dice = [Dice::new(seed), Dice::new(seed)];
        for step in 0..STEPS {
            if step % 4 == 0 {
                edit_at_random(&mut stage, &mut dice[0]);
                edit_at_random(&mut twin, &mut dice[1]);
            }
            all.extend(step_alike(step, &mut stage, &mut twin));
        }
    }
    assert!(all.len() > 4, "{all:?}");
}
