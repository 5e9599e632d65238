//! Snapshots of earlier builds, one for each crate. The present build reads them, unless the format's number
//! has changed.

use super::scene::{step, world};
use crate::rapier::prelude::*;
use std::path::PathBuf;

/// Returns the path of this crate's sample.
fn path() -> PathBuf {
    let name = format!("{DIM}d-f{}.snapshot", 8 * size_of::<Real>());
    [env!("CARGO_MANIFEST_DIR"), "../../tests/worlds/samples", &name].iter().collect()
}

/// A sample that is saved again has the same bytes: no saved type has changed. After a change, raise `FORMAT`
/// in `src/api/snapshot/header.rs`, mark the change with **[snapshot]** in the changelog, and write new
/// samples with `SAVE_SAMPLES=1`.
#[test]
fn a_snapshot_of_an_earlier_build_is_read() {
    if std::env::var_os("SAVE_SAMPLES").is_some() {
        let mut world = world();
        (0..40).for_each(|_| step(&mut world));
        std::fs::write(path(), world.to_snapshot().expect("it can be saved")).expect("a file");
    }
    let sample = std::fs::read(path()).expect("the sample is part of the repository");
    match PhysicsWorld::from_snapshot(&sample) {
        Ok(mut world) => {
            assert!(world.to_snapshot().expect("it was saved") == sample, "a type has changed");
            (0..20).for_each(|_| step(&mut world));
        }
        Err(error) => panic!(
            "the format has changed under the same number, or a sample of the new one is missing: {error}"
        ),
    }
}
