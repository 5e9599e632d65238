//! Worlds that are loaded from damaged data: each number, list and variant of a saved world is changed, one
//! at a time.
//!
//! The data is rejected, or the loaded world continues: there is no panic, and all numbers stay finite.

use super::damage::{changes, visit};
use super::saved::EDITS;
use super::scene::{copy, step, world};
use super::sets::{Saved, load_all, load_into, save_all};
use super::tree::Tree;
use super::twins::{outcome, outcome_anew};
use crate::rapier::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Numbers of rejected and of loaded data.
#[derive(Debug, Default)]
struct Tally {
    refused: usize,
    loaded: usize,
    panicked: Vec<String>,
}

impl Tally {
    /// Checks that both numbers are large. Otherwise the changes would prove nothing.
    fn check(&self) {
        let fewest = (self.refused + self.loaded) / 10;
        assert!(fewest > 0 && self.refused.min(self.loaded) >= fewest, "{self:?}");
    }
}

/// Loads a set with changes into a world with its other sets loaded as well, or live. Steps it directly, and
/// after an edit.
fn try_change(world: &PhysicsWorld, set: usize, tree: &Tree, edit: fn(&mut PhysicsWorld)) -> bool {
    let mut world = copy(world);
    if load_into(&mut world, set, tree).is_err() {
        return false;
    }
    let mut edited = copy(&world);
    edit(&mut edited);
    for world in [&mut world, &mut edited] {
        (0..3).for_each(|_| step(world));
    }
    true
}

/// Selection of changes of a world.
struct Selection {
    /// Index of the first change.
    first: usize,
    /// Step between selected indices.
    stride: usize,
    /// Number of simultaneous changes.
    at_once: usize,
}

/// A value of a tree, and its replacement.
struct Change {
    path: String,
    old: Tree,
    new: Tree,
}

/// Returns the changes of a selection; `number` counts all changes.
fn selected(whole: &Tree, name: &str, number: &mut usize, stride: usize) -> Vec<Change> {
    let mut selected = Vec::new();
    visit(&mut whole.clone(), name, &mut |tree, path| {
        for new in changes(tree) {
            if number.is_multiple_of(stride) {
                selected.push(Change { path: path.to_string(), old: tree.clone(), new });
            }
            *number += 1;
        }
    });
    selected
}

/// Changes values of each set.
fn damage(saved: &Saved, world: &PhysicsWorld, selection: &Selection) {
    const NAMES: [&str; 7] =
        ["bodies", "colliders", "islands", "boxes", "pairs", "joints", "multibodies"];
    let (mut number, mut tally) = (selection.first, Tally::default());
    for (set, name) in NAMES.into_iter().enumerate() {
        let before = (tally.refused, tally.loaded);
        let list = selected(&saved[set], name, &mut number, selection.stride);
        for at in 0..list.len() {
            let mut tree = saved[set].clone();
            let mut place = String::new();
            for k in 0..selection.at_once {
                let Change { path, old, new } = &list[(at + k * list.len() / 2) % list.len()];
                place = format!("{place}{path} = {new:?}; ").chars().take(300).collect();
                visit(&mut tree, name, &mut |value, there| {
                    if there == path && value == old {
                        *value = new.clone();
                    }
                });
            }
            let (edit, act) = EDITS[at % EDITS.len()];
            match catch_unwind(AssertUnwindSafe(|| try_change(world, set, &tree, act))) {
                Ok(true) => tally.loaded += 1,
                Ok(false) => tally.refused += 1,
                Err(_) => tally.panicked.push(format!("{place}{edit}")),
            }
        }
        let (refused, loaded) = (tally.refused - before.0, tally.loaded - before.1);
        println!("{name:>12}: {refused} refused, {loaded} loaded");
    }
    assert!(tally.panicked.is_empty(), "{:#?}", tally.panicked);
    tally.check();
}

fn stepped() -> PhysicsWorld {
    let mut world = world();
    (0..12).for_each(|_| step(&mut world));
    world
}

/// Some of the changes are made to a world with its other sets live.
#[test]
fn damaged_sets_are_harmless() {
    let world = stepped();
    damage(&save_all(&world), &world, &Selection { first: 0, stride: 197, at_once: 1 });
}

/// Some of the changes are made to a world with pending edits, with all sets loaded.
#[test]
fn damaged_worlds_with_edits_are_harmless() {
    let mut world = stepped();
    let bodies: Vec<_> = world.bodies.iter().map(|(handle, _)| handle).collect();
    world.bodies.remove(bodies[1]);
    world.bodies[bodies[2]].set_linvel(Vector::X, true);
    world.remove_collider(world.bodies[bodies[3]].colliders()[0]);
    let saved = save_all(&world);
    let selection = Selection { first: 0, stride: 211, at_once: 1 };
    damage(&saved, &load_all(&saved).expect("it was saved"), &selection);
}

/// Two changes are made at a time. One may hide the other.
#[test]
fn sets_with_two_damages_are_harmless() {
    let world = stepped();
    damage(&save_all(&world), &world, &Selection { first: 7, stride: 307, at_once: 2 });
}

/// Returns replacements by set number and end of the path. Each replacement contradicts another value, but no
/// list becomes too short for it.
fn contradictions() -> [(usize, &'static str, Tree); 14] {
    let (text, number) = (|text: &str| Tree::Text(text.into()), Tree::Unsigned);
    [
        // A body has changes without an entry in the list of changes.
        (0, ".changes", number(RigidBodyChanges::TYPE.bits().into())),
        (0, ".changes", number(RigidBodyChanges::ENABLED_OR_DISABLED.bits().into())),
        (1, ".changes", number(ColliderChanges::PARENT.bits().into())),
        // The colliders of a pair are not allowed to touch.
        (1, ".flags.enabled", text("Disabled")),
        (1, ".sensor", Tree::Bool(true)),
        (1, ".parent_type", Tree::Some(Box::new(text("KinematicPositionBased")))),
        // Normals are not unit vectors.
        (4, ".local_n1[0]", Tree::Float(3.0e38)),
        (4, ".anchor_normal[1]", Tree::Float(0.5)),
        (4, ".data.normal[1]", Tree::Float(0.5)),
        (2, ".parts_bodies", Tree::Bool(true)),
        (2, ".attached", Tree::Bool(false)),
        (3, ".sizes[1]", number(1)),
        (3, ".sensor_bits[0]", number(0)),
        (5, ".data.enabled", text("Disabled")),
    ]
}

/// The step detects each contradiction and resyncs the world. A world without a resync would keep its islands
/// and impulses, and have other bits.
#[test]
fn contradictions_are_detected() {
    let (saved, mut unnoticed) = (save_all(&stepped()), 0);
    for (set, end, new) in contradictions() {
        let (mut damaged, mut is_changed) = (saved.clone(), false);
        visit(&mut damaged[set], "", &mut |value, path| {
            if path.ends_with(end) && *value != new && !is_changed {
                *value = new.clone();
                is_changed = true;
            }
        });
        assert!(is_changed, "there is no {end}");
        let loaded = load_all(&damaged).expect("no set is damaged by itself");
        let expected = outcome_anew(copy(&loaded));
        let is_noticed = outcome(loaded) == expected;
        println!("set {set}, {end} = {new:?} is noticed: {is_noticed}");
        unnoticed += usize::from(!is_noticed);
    }
    assert_eq!(unnoticed, 0, "contradictions are not noticed");
}

/// A coupling with a missing link is rejected.
#[test]
fn couplings_of_missing_links_are_rejected() {
    let world = stepped();
    for end in [".link1", ".link2"] {
        let mut damaged = save_all(&world)[6].clone();
        let mut count = 0;
        visit(&mut damaged, "", &mut |value, path| {
            if path.ends_with(end) {
                (*value, count) = (Tree::Unsigned(99), count + 1);
            }
        });
        assert_eq!(count, 1, "there is one gear");
        assert!(load_into(&mut copy(&world), 6, &damaged).is_err(), "{end} is 99");
    }
}

/// A contact skin that the setter rejects is also rejected at loading: its contacts would be infinitely far
/// apart.
#[test]
fn skins_that_no_setter_accepts_are_rejected() {
    let world = stepped();
    for skin in [-1.0, f64::from(f32::MAX), f64::INFINITY, f64::NAN] {
        let mut damaged = save_all(&world)[1].clone();
        visit(&mut damaged, "", &mut |value, path| {
            if path.ends_with(".contact_skin") {
                *value = Tree::Float(skin);
            }
        });
        assert!(load_into(&mut copy(&world), 1, &damaged).is_err(), "a skin of {skin}");
    }
}

/// All changes; the environment variable `STRIDE` reduces their number by this factor.
#[test]
#[ignore = "half an hour"]
fn all_damaged_sets_are_harmless() {
    let stride = std::env::var("STRIDE").ok().and_then(|stride| stride.parse().ok()).unwrap_or(1);
    let world = stepped();
    damage(&save_all(&world), &world, &Selection { first: 1, stride, at_once: 1 });
}
