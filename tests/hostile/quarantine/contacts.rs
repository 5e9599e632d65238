//! Hooks that write unusable numbers to contacts: these are omitted, and no body is disabled.

use super::stage::{Numbers, Stage, beside_its_twin};
use crate::dim::vec;
use rapier::prelude::*;

/// Returns two stages with hooks that pass different numbers to the suspect's contacts.
fn with_hooks(hooks: Numbers, of_twin: Numbers) -> [Stage; 2] {
    [hooks, of_twin].map(|hooks| {
        let mut stage = Stage::new();
        let collider = stage.suspect().colliders()[0];
        stage.world.colliders[collider].set_active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS);
        stage.hooks = hooks;
        stage
    })
}

/// Checks that the result equals that of zeros, and that each pair is reported with its colliders.
fn are_as_zeros(hooks: Numbers, of_twin: Numbers, is_cause: impl Fn(QuarantineCause) -> bool) {
    let [mut stage, mut twin] = with_hooks(hooks, of_twin);
    assert_eq!(beside_its_twin(&mut stage, &mut twin), []);
    let [mut stage, _] = with_hooks(hooks, of_twin);
    let own = stage.suspect().colliders()[0];
    let events = stage.step().quarantines;
    assert!(!events.is_empty(), "the suspect touches others");
    for event in events {
        let QuarantineEvent::Contact { collider1, collider2, cause } = event else {
            panic!("{event:?}")
        };
        assert!([collider1, collider2].contains(&own) && is_cause(cause), "{event:?}");
    }
}

#[test]
fn invalid_restitution() {
    for value in [1.0e8, 1.0e30, Real::MAX] {
        are_as_zeros(
            Numbers { restitution: Some(value), ..Numbers::default() },
            Numbers { restitution: Some(0.0), ..Numbers::default() },
            |cause| cause == QuarantineCause::Restitution(value),
        );
    }
}

#[test]
fn invalid_belt_velocity() {
    let velocity = vec(1.0e30, 0.0);
    are_as_zeros(
        Numbers { tangent_velocity: Some(velocity), ..Numbers::default() },
        Numbers { tangent_velocity: Some(Vector::ZERO), ..Numbers::default() },
        |cause| cause == QuarantineCause::TangentVelocity(velocity),
    );
}
