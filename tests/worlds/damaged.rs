//! Worlds that are loaded from damaged data: each number, list and variant of a saved world is changed, one at a time.
//!
//! The data is refused, or the world is loaded and goes on: nothing panics, and all numbers stay finite.

use super::damage::{changes, visit};
use super::saved::{Saved, load_all, load_into, save_all};
use super::scene::{copy, step, world};
use super::tree::Tree;
use crate::rapier::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// How often data was refused, and how often it was loaded.
#[derive(Debug, Default)]
struct Tally {
    refused: usize,
    loaded: usize,
    panicked: Vec<String>,
}

/// Loads a set with a change into a world whose other sets are loaded, too, or live.
fn try_change(world: &PhysicsWorld, set: usize, tree: &Tree, place: &str, tally: &mut Tally) {
    let run = || {
        let mut world = copy(world);
        load_into(&mut world, set, tree).map(|()| (0..3).for_each(|_| step(&mut world))).is_ok()
    };
    match catch_unwind(AssertUnwindSafe(run)) {
        Ok(true) => tally.loaded += 1,
        Ok(false) => tally.refused += 1,
        Err(_) => tally.panicked.push(place.chars().take(200).collect()),
    }
}

/// Changes each value of each set, but only one of `stride` of all changes, beginning with the one numbered `first`.
fn damage(saved: &Saved, world: &PhysicsWorld, (first, stride): (usize, usize)) {
    const NAMES: [&str; 7] =
        ["bodies", "colliders", "islands", "boxes", "pairs", "joints", "multibodies"];
    let (mut number, mut panics) = (first, Vec::new());
    for (set, name) in NAMES.into_iter().enumerate() {
        let mut tally = Tally::default();
        let whole = saved[set].clone();
        let mut places = Vec::new();
        visit(&mut whole.clone(), name, &mut |tree, path| {
            for change in changes(tree) {
                if number % stride == 0 {
                    places.push((path.to_string(), tree.clone(), change));
                }
                number += 1;
            }
        });
        for (path, old, change) in places {
            let mut tree = whole.clone();
            visit(&mut tree, name, &mut |value, at| {
                if at == path && *value == old {
                    *value = change.clone();
                }
            });
            try_change(world, set, &tree, &format!("{path} = {change:?}"), &mut tally);
        }
        println!("{name:>12}: {} refused, {} loaded", tally.refused, tally.loaded);
        assert!(tally.loaded + tally.refused > 0);
        panics.extend(tally.panicked);
    }
    assert!(panics.is_empty(), "{panics:#?}");
}

fn stepped() -> PhysicsWorld {
    let mut world = world();
    (0..12).for_each(|_| step(&mut world));
    world
}

/// Some of the changes, to a world whose other sets are live.
#[test]
fn damaged_sets_spoil_nothing() {
    let world = stepped();
    damage(&save_all(&world), &world, (0, 97));
}

/// Some of the changes, to a world with pending edits, all sets of which are loaded.
#[test]
fn damaged_worlds_with_edits_spoil_nothing() {
    let mut world = stepped();
    let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
    world.bodies.remove(bodies[1]);
    world.bodies[bodies[2]].set_linvel(Vector::X, true);
    world.remove_collider(world.bodies[bodies[3]].colliders()[0]);
    let saved = save_all(&world);
    damage(&saved, &load_all(&saved), (0, 101));
}

/// All changes; with `STRIDE` in the environment one of so many.
#[test]
#[ignore = "half an hour"]
fn all_damaged_sets_spoil_nothing() {
    let stride = std::env::var("STRIDE").ok().and_then(|stride| stride.parse().ok()).unwrap_or(1);
    let world = stepped();
    damage(&save_all(&world), &world, (1, stride));
}
