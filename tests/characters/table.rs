//! All figures in one table.

use super::floors::{level_floors, stumbles};
use super::platforms::{ride, rocking};
use super::slopes::walk_on_slope;
use super::stage::{CAPSULE, GAP_TOLERANCE, Walker, level};
use super::stairs::goes_up;
use super::walls::{corridor, pushed_by_wall};
use crate::dim::vec;
use crate::suite::physics::table::Table;
use rapier::control::CharacterSlopeSpeed;
use rapier::prelude::*;

fn row(table: &mut Table, what: &str, figure: Real, limit: Real) {
    table.row([what.to_owned(), format!("{figure:.1e}"), format!("{limit:.0e}")]);
    table.require(figure <= limit, "is too much");
}

#[test]
fn the_character_table() {
    let mut table = Table::new("character", &["figure", "is", "at most"]);
    let mut walker = Walker::new(level(), vec(0.3, 1.2)).settled();
    let place = walker.place();
    walker.steps(3600, Vector::ZERO);
    row(&mut table, "way while standing for 60 s", (walker.place() - place).length(), 0.0);
    for (what, speed) in [("up", 4.0), ("down", -4.0)] {
        let (share, in_the_air) = walk_on_slope(30.0, speed, CharacterSlopeSpeed::Constant);
        row(&mut table, &format!("speed error, 30° {what}"), (share - 1.0).abs(), 0.01);
        row(&mut table, &format!("steps off the ground, 30° {what}"), in_the_air as Real, 0.0);
    }
    let capsule = ColliderBuilder::capsule_y(CAPSULE.0, CAPSULE.1);
    let highest = (1..60)
        .map(|cm| 0.01 * cm as Real)
        .filter(|&height| goes_up(&capsule, height, 0.4, 3.0))
        .fold(0.0, Real::max);
    row(&mut table, "highest step of at most 0.4, short by", 0.4 - highest, 0.011);
    for (what, speed) in [("up", 3.0), ("down", -3.0)] {
        let gap = ride(0.0, 0.0, speed, true);
        row(&mut table, &format!("gap error on a lift {what}"), gap, GAP_TOLERANCE);
    }
    let gap = ride(4.0, 5.0, 0.0, true);
    row(&mut table, "gap error on a lift up and down", gap, GAP_TOLERANCE);
    row(&mut table, "gap error on a rocking raft", rocking().1, 2.0e-3);
    if let Some((off, gap)) = crate::dim::turntable() {
        row(&mut table, "wandering on a turntable in 10 s", off, 1.0e-3);
        row(&mut table, "gap error on a turntable", gap, GAP_TOLERANCE);
    }
    let slowest = [0.5, 0.0, -0.5, -1.0, -1.5].map(corridor).into_iter().fold(0.0, Real::max);
    row(&mut table, "speed error in narrow corridors", slowest, 0.01);
    let short = [-1.0, -6.0].map(pushed_by_wall).into_iter().fold(0.0, Real::max);
    row(&mut table, "gap short of a moving wall's step", short, GAP_TOLERANCE);
    for (name, floor) in level_floors() {
        let (speed, bump) = stumbles(floor, capsule.clone());
        row(&mut table, &format!("speed error over {name}"), speed, 1.0e-3);
        row(&mut table, &format!("bumps over {name}"), bump, GAP_TOLERANCE);
    }
}
