//! The set of disabled bodies, and the motion of the others, are independent of the number of threads.

use super::stage::Stage;
use crate::dim::vec;
use rapier::prelude::*;

/// Runs a scene with all misuses, and returns the events of all steps and the final bits.
fn run() -> (Vec<QuarantineEvent>, Vec<String>) {
    let mut stage = Stage::new();
    stage.drive(MotorModel::ForceBased, 1.0e30);
    stage.suspect().set_linvel(vec(1.0e14, 0.0), true);
    stage.world.bodies[stage.links[1]].add_force(Vector::Y * 1.0e15, true);
    stage.world.bodies[stage.sleeper].add_force(Vector::Y * 1.0e30, true);
    let events = (0..100).flat_map(|_| stage.step().quarantines).collect();
    (events, stage.bits())
}

#[test]
fn the_same_on_any_number_of_threads() {
    let (events, bits) = run();
    assert!(events.len() >= 2, "the suspect and the sleeper at least: {events:?}");
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let (events_there, bits_there) = pool.install(run);
        // The comparison uses texts, because a value may be NaN, which is not equal to itself.
        assert_eq!(format!("{events_there:?}"), format!("{events:?}"), "{threads} threads");
        assert_eq!(bits_there, bits, "{threads} threads");
    }
}
