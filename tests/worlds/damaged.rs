//! Worlds that are loaded from damaged data: each number, list and variant of a saved world is changed, one at a time.
//!
//! The data is refused, or the world is loaded and goes on: nothing panics, and all numbers stay finite.

use super::saved::{Saved, load_all, load_into, save_all};
use super::scene::{copy, step, world};
use super::tree::Tree;
use crate::rapier::prelude::*;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Returns what a value may be changed to.
fn changes(tree: &Tree) -> Vec<Tree> {
    match tree {
        Tree::Unit => vec![Tree::Some(Box::new(Tree::Unsigned(0)))],
        Tree::Bool(value) => vec![Tree::Bool(!value)],
        Tree::Unsigned(value) => {
            let max = [u128::from(u32::MAX), u128::from(u64::MAX)];
            let near = [value.wrapping_add(1), value.wrapping_sub(1)];
            let numbers = [0, 1, max[0], max[0] - 1, max[1], near[0], near[1], value ^ 0x10];
            numbers.into_iter().filter(|number| number != value).map(Tree::Unsigned).collect()
        }
        Tree::Signed(value) => [0, -1, i128::from(i32::MIN), i128::from(i32::MAX), value + 1]
            .into_iter()
            .map(Tree::Signed)
            .collect(),
        Tree::Float(value) => {
            let single = f64::from(f32::MAX);
            [
                0.0,
                -1.0,
                f64::NAN,
                f64::INFINITY,
                f64::NEG_INFINITY,
                single,
                -single,
                2.0 * value,
                -value,
            ]
            .into_iter()
            .map(Tree::Float)
            .collect()
        }
        Tree::Text(_) => vec![Tree::Text("Enabled".into()), Tree::Text("Dynamic".into())],
        Tree::Some(_) => vec![Tree::Unit],
        Tree::List(items) => changed_lists(items),
        Tree::Map(_) | Tree::Variant(..) => Vec::new(),
    }
}

fn changed_lists(items: &[Tree]) -> Vec<Tree> {
    let Some(first) = items.first() else { return Vec::new() };
    let (mut longer, mut turned) = (items.to_vec(), items.to_vec());
    longer.push(first.clone());
    turned.reverse();
    [items[1..].to_vec(), items[..items.len() - 1].to_vec(), Vec::new(), longer, turned]
        .map(Tree::List)
        .to_vec()
}

/// Calls back for each value of a tree, from the root down. The path says where it is.
fn visit(tree: &mut Tree, path: &str, visit_one: &mut impl FnMut(&mut Tree, &str)) {
    visit_one(tree, path);
    match tree {
        Tree::Some(inner) => visit(inner, path, visit_one),
        Tree::Variant(name, inner) => visit(inner, &format!("{path}.{name}"), visit_one),
        Tree::List(items) => {
            let items = items.iter_mut().enumerate();
            items.for_each(|(at, item)| visit(item, &format!("{path}[{at}]"), visit_one));
        }
        Tree::Map(entries) => entries.iter_mut().for_each(|(key, value)| {
            let key = match key {
                Tree::Text(key) => key.clone(),
                other => format!("{other:?}"),
            };
            visit(value, &format!("{path}.{key}"), visit_one);
        }),
        _ => {}
    }
}

/// How often data was refused, and how often it was loaded.
#[derive(Debug, Default)]
struct Tally {
    refused: usize,
    loaded: usize,
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
        Err(_) => panic!("{place} panics"),
    }
}

/// Changes each value of each set, but only one of `stride` of all changes, beginning with the one numbered `first`.
fn damage(saved: &Saved, world: &PhysicsWorld, (first, stride): (usize, usize)) {
    const NAMES: [&str; 7] =
        ["bodies", "colliders", "islands", "boxes", "pairs", "joints", "multibodies"];
    let mut number = first;
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
            let place = format!("{path} = {change:?}");
            try_change(world, set, &tree, &place.chars().take(200).collect::<String>(), &mut tally);
        }
        println!("{name:>12}: {tally:?}");
        assert!(tally.loaded + tally.refused > 0);
    }
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

/// All changes: minutes.
#[test]
#[ignore = "minutes"]
fn all_damaged_sets_spoil_nothing() {
    let world = stepped();
    damage(&save_all(&world), &world, (0, 1));
}
