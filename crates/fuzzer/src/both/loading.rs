//! Saving, damaging, loading and stepping a copy of the world.

use super::damage::{changes, visit};
use super::play::Play;
use super::saved::{Saved, load_all, save_all};
use super::world::check;

/// Number of steps after loading.
const STEPS: usize = 3;

/// Saves the sets, changes any number of their values, and steps the world if it loads.
pub fn load_damaged(play: &mut Play<'_>) {
    let world = &play.world;
    let mut sets = save_all(world);
    for _ in 0..play.choices.below(4) {
        damage(play, &mut sets);
    }
    let loaded = load_all(&sets);
    play.choices.print(|| format!("    refused: {:?}", loaded.as_ref().err()));
    if let Ok(mut loaded) = loaded {
        for _ in 0..STEPS {
            loaded.step();
            check(&loaded);
        }
    }
}

/// Changes one value of a set at any position.
fn damage(play: &mut Play<'_>, sets: &mut Saved) {
    let choices = &mut play.choices;
    let set = choices.below(sets.len());
    let mut count = 0;
    visit(&mut sets[set], "", &mut |_, _| count += 1);
    let (coarse, fine, change) = (choices.below(256), choices.below(256), choices.below(256));
    let chosen = (256 * coarse + fine) % count;
    let mut number = 0;
    visit(&mut sets[set], "", &mut |value, path| {
        if number == chosen {
            let changes = changes(value);
            if let Some(changed) = changes.get(change % changes.len().max(1)) {
                choices.print(|| format!("    set {set}: {path}: {value:?} becomes {changed:?}"));
                *value = changed.clone();
            }
        }
        number += 1;
    });
}
