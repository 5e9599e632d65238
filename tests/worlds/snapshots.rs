//! Snapshots of worlds as bytes.

use super::forged::{HEADER, load, sealed};
use super::saved::EDITS;
use super::scene::{step, world};
use crate::rapier::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};

fn snapshot(world: &PhysicsWorld) -> Vec<u8> {
    world.to_snapshot().expect("the world has no shape of the user's own")
}

/// SplitMix64 (Steele, Lea, Flood 2014).
fn random(state: &mut u64) -> usize {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (z >> 13) as usize
}

#[test]
fn a_world_restored_at_any_step_continues_like_the_original() {
    for (name, edit) in EDITS {
        let mut original = world();
        for k in 0..40 {
            if k == 15 {
                edit(&mut original);
            }
            let saved = snapshot(&original);
            let mut restored = PhysicsWorld::from_snapshot(&saved).expect("it was saved");
            assert!(saved == snapshot(&restored), "{name}: saved again at step {k}");
            step(&mut original);
            step(&mut restored);
            assert_eq!(original.hash(), restored.hash(), "{name}: step {k}");
            assert!(snapshot(&original) == snapshot(&restored), "{name}: bytes after step {k}");
        }
    }
}

/// The impulses with which a step starts are those of longer steps, wherever they are stored.
#[test]
fn a_world_of_changing_steps_continues_like_the_original() {
    let mut original = world();
    for k in 0..60 {
        original.integration_parameters.dt = [1.0 / 30.0, 1.0 / 144.0, 1.0 / 60.0][k % 3];
        let saved = snapshot(&original);
        let mut restored = PhysicsWorld::from_snapshot(&saved).expect("it was saved");
        step(&mut original);
        step(&mut restored);
        assert_eq!(original.hash(), restored.hash(), "step {k}");
    }
}

#[test]
fn gravity_and_parameters_are_part_of_a_snapshot() {
    let mut world = world();
    world.gravity = Vector::X * 3.0;
    world.integration_parameters.num_solver_iterations = 7;
    let restored = PhysicsWorld::from_snapshot(&snapshot(&world)).expect("it was saved");
    assert_eq!(restored.gravity, world.gravity);
    assert_eq!(restored.integration_parameters, world.integration_parameters);
}

#[test]
fn truncated_or_changed_snapshots_are_rejected() {
    let mut world = world();
    (0..10).for_each(|_| step(&mut world));
    let saved = snapshot(&world);
    for length in (0..saved.len()).step_by(101).chain(saved.len() - 30..saved.len()) {
        assert!(PhysicsWorld::from_snapshot(&saved[..length]).is_err(), "{length} bytes");
    }
    let mut state = 1;
    for _ in 0..500 {
        let mut damaged = saved.clone();
        let at = random(&mut state) % saved.len();
        damaged[at] ^= 1 << (random(&mut state) % 8);
        let refused = PhysicsWorld::from_snapshot(&damaged).err().expect("a bit has changed");
        let is_header = !matches!(refused, SnapshotError::Damaged { .. });
        assert!(at >= HEADER || is_header || (20..HEADER).contains(&at), "byte {at}: {refused}");
    }
}

/// Forged bytes with a valid checksum are rejected, or give a world that steps.
#[test]
fn forged_snapshots_never_panic() {
    let mut original = world();
    (0..10).for_each(|_| step(&mut original));
    let saved = snapshot(&original);
    let rounds = std::env::var("FORGERIES").ok().and_then(|rounds| rounds.parse().ok());
    let rounds = rounds.unwrap_or(2_000);
    let (mut state, mut refused, mut loaded) = (rounds as u64, 0, 0);
    for round in 0..rounds {
        let mut parts = saved[HEADER..].to_vec();
        for _ in 0..1 + round % 3 {
            let at = random(&mut state) % parts.len();
            match random(&mut state) % 4 {
                0 => parts[at] = random(&mut state) as u8,
                1 => parts[at] ^= 1 << (random(&mut state) % 8),
                2 => drop(parts.drain(at..parts.len().min(at + random(&mut state) % 40))),
                _ => parts.insert(at, 0xff),
            }
        }
        let outcome = catch_unwind(AssertUnwindSafe(|| load(&parts)));
        match outcome.unwrap_or_else(|_| panic!("round {round} panicked")) {
            true => loaded += 1,
            false => refused += 1,
        }
    }
    assert!(refused.min(loaded) > rounds / 10, "{refused} refused, {loaded} loaded");
    println!("{refused} forged snapshots were refused, {loaded} loaded and stepped");
}

#[test]
fn errors_name_the_cause() {
    let refused = |bytes: &[u8]| PhysicsWorld::from_snapshot(bytes).err().expect("it is changed");
    let saved = snapshot(&world());
    let with = |at: usize, byte: u8| {
        let mut changed = saved.clone();
        changed[at] = byte;
        refused(&changed)
    };
    assert_eq!(refused(b"not a snapshot at all, but a text"), SnapshotError::NotASnapshot);
    assert_eq!(with(8, 200), SnapshotError::Format { found: 200 });
    assert_eq!(with(10, 7), SnapshotError::Dimension { found: 7 });
    assert!(matches!(with(11, 2), SnapshotError::Precision { found: 16, .. }));
    // The data contains one number of gravity only.
    let refused = refused(&sealed(&[0; size_of::<Real>()]));
    let expected = format!("gravity: the data ends (at byte {})", size_of::<Real>());
    assert_eq!(refused.to_string(), expected);
}

#[test]
fn deltas_lead_from_one_step_to_the_next() {
    for (name, edit) in EDITS {
        let mut world = world();
        (0..20).for_each(|_| step(&mut world));
        let mut base = snapshot(&world);
        for k in 0..6 {
            if k == 2 {
                edit(&mut world);
            }
            step(&mut world);
            let next = snapshot(&world);
            let delta = snapshot_delta(&base, &next).expect("both are snapshots");
            assert!(delta.len() < next.len(), "{name}: {} of {} bytes", delta.len(), next.len());
            assert!(apply_snapshot_delta(&base, &delta).expect("it was just made") == next);
            base = next;
        }
    }
}

#[test]
fn deltas_of_other_snapshots_and_damaged_ones_are_rejected() {
    let mut world = world();
    let base = snapshot(&world);
    step(&mut world);
    let next = snapshot(&world);
    let delta = snapshot_delta(&base, &next).expect("both are snapshots");
    assert!(matches!(apply_snapshot_delta(&next, &delta), Err(SnapshotError::Base { .. })));
    assert!(snapshot_delta(&base, b"no snapshot").is_err());
    let mut state = 3;
    for _ in 0..500 {
        let mut damaged = delta.clone();
        let at = random(&mut state) % damaged.len();
        damaged[at] ^= 1 << (random(&mut state) % 8);
        assert!(apply_snapshot_delta(&base, &damaged).is_err(), "byte {at}");
        damaged.truncate(at);
        assert!(apply_snapshot_delta(&base, &damaged).is_err(), "{at} bytes");
    }
}
