//! Random operations on a world.

use super::play::Play;
use super::{
    bodies, colliders, drive, joints, loading, multibodies, queries, sets, steps, walkers,
};
use crate::Tally;
use crate::choices::Choices;

type Act = (&'static str, fn(&mut Play<'_>));

/// All operations. Repetitions increase their frequency.
const ACTS: [Act; 32] = [
    ("insert a body", bodies::insert),
    ("insert a body", bodies::insert),
    ("insert a body", bodies::insert),
    ("insert a body", bodies::insert),
    ("remove a body", bodies::remove),
    ("edit a body", bodies::edit),
    ("edit a body", bodies::edit),
    ("edit a body", bodies::edit),
    ("edit a body", bodies::edit),
    ("edit a body", bodies::edit),
    ("insert or remove a collider", colliders::insert_or_remove),
    ("insert or remove a collider", colliders::insert_or_remove),
    ("edit a collider", colliders::edit),
    ("edit a collider", colliders::edit),
    ("edit a collider", colliders::edit),
    ("edit a collider", colliders::edit),
    ("insert or remove a joint", joints::insert_or_remove),
    ("insert or remove a joint", joints::insert_or_remove),
    ("edit a joint", joints::edit),
    ("edit a joint", joints::edit),
    ("insert or remove a link", multibodies::insert_or_remove),
    ("insert or remove a link", multibodies::insert_or_remove),
    ("edit a multibody", multibodies::edit),
    ("edit a multibody", multibodies::edit),
    ("query", queries::query),
    ("walk", walkers::walk),
    ("drive", drive::drive),
    ("edit whole sets", sets::edit_sets),
    ("change parameters", |play| play.change_parameters()),
    ("reset parameters", |play| play.reset_parameters()),
    ("mix with a twin", sets::mix_with_twin),
    ("load a damaged copy", loading::load_damaged),
];

/// Creates a world and runs operations until the choices are used up.
pub fn run(choices: Choices<'_>) -> Tally {
    let mut play = Play::new(choices);
    let mut tally = Tally::default();
    while !play.choices.is_over() {
        for _ in 0..play.choices.below(6) {
            act(&mut play);
            tally.operations += 1;
        }
        tally.steps += steps::step(&mut play);
    }
    tally
}

fn act(play: &mut Play<'_>) {
    let (name, act) = play.choices.pick(&ACTS);
    play.choices.print(|| name.to_owned());
    act(play);
}
