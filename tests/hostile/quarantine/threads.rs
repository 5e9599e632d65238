//! The set of disabled bodies, and the motion of the others, are independent of the number of threads.

use super::stage::Stage;
use crate::dim::vec;
use rapier::prelude::*;

/// Everything at once: what each step told, and the end.
fn run() -> (Vec<QuarantineEvent>, Vec<String>) {
    let mut stage = Stage::new();
    stage.drive(MotorModel::ForceBased, 1.0e30);
    stage.suspect().set_linvel(vec(1.0e14, 0.0), true);
    stage.world.bodies[stage.links[1]].add_force(Vector::Y * 1.0e15, true);
    stage.world.bodies[stage.sleeper].add_force(Vector::Y * 1.0e30, true);
    let told = (0..100).flat_map(|_| stage.step().quarantines).collect();
    (told, stage.bits())
}

#[test]
fn the_same_on_any_number_of_threads() {
    let (told, bits) = run();
    assert!(told.len() >= 2, "the suspect and the sleeper at least: {told:?}");
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let (told_there, bits_there) = pool.install(run);
        // As texts: what was found may be no number, which is not equal to itself.
        assert_eq!(format!("{told_there:?}"), format!("{told:?}"), "{threads} threads");
        assert_eq!(bits_there, bits, "{threads} threads");
    }
}
