//! All scenes give the expected hashes: with wide registers and with the baseline's, and on several threads
//! where there are any.

use golden::{EXPECTED, Settings, line, scenes};

/// With the feature `parallel`, eight threads take every scene through all parallel passes; one thread stands
/// for all counts without it.
const THREADS: &[usize] = if cfg!(feature = "parallel") { &[1, 2, 3, 8] } else { &[1] };

fn check(engine: &str) {
    let mut wrong = Vec::new();
    for scene in scenes().into_iter().filter(|scene| scene.engine == engine) {
        for (&threads, wide) in
            THREADS.iter().flat_map(|threads| [(threads, true), (threads, false)])
        {
            let found = line(&scene, scene.run(Settings { threads, wide }));
            if !EXPECTED.lines().any(|expected| expected == found) {
                wrong.push(format!("{found} ({threads} threads, wide registers: {wide})"));
            }
        }
    }
    assert!(wrong.is_empty(), "not in src/hashes.txt:\n{}", wrong.join("\n"));
}

#[test]
fn golden_hashes_in_2d() {
    check("rapier2d");
}

#[test]
fn golden_hashes_in_3d() {
    check("rapier3d");
}

#[test]
fn golden_hashes_in_2d_and_double_precision() {
    check("rapier2d-f64");
}

#[test]
fn golden_hashes_in_3d_and_double_precision() {
    check("rapier3d-f64");
}

/// The file holds one line per scene, in the order of the scenes.
#[test]
fn every_expected_line_belongs_to_a_scene() {
    let names: Vec<String> = scenes().iter().map(|scene| line(scene, 0)).collect();
    let without_hash = |line: &str| line[..line.len() - 16].to_owned();
    assert_eq!(EXPECTED.lines().count(), names.len());
    for (expected, name) in EXPECTED.lines().zip(&names) {
        assert_eq!(without_hash(expected), without_hash(name));
    }
}
