//! Surfaces with one side, from behind and from the front.
//!
//! Contacts push toward the front only. The path search once stopped bodies from behind, too: they hung in
//! the air without a contact, while their velocity grew.

use crate::dim::shapes::{PASSED_MAX, bodies, one_sided_floors, ridges, slender_bodies};
use crate::dim::{about_z, cuboid, vec};
use crate::suite::physics::stage::{Dice, run, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Heights (m) and speeds (m/s) of falls.
const FALLS: [[Real; 2]; 6] =
    [[0.3, 0.0], [1.0, 0.0], [3.0, 0.0], [1.0, 10.0], [3.0, 30.0], [3.0, 100.0]];

/// Returns height and vertical velocity of a body 2 s after it fell onto a floor.
fn fall_on(
    floor: &ColliderBuilder,
    shape: ColliderBuilder,
    [height, speed]: [Real; 2],
) -> [Real; 2] {
    let mut world = world(60);
    world.insert_collider(floor.clone(), None);
    let body = RigidBodyBuilder::dynamic().translation(vec(0.13, height));
    let (body, _) = world.insert(body.linvel(vec(0.0, -speed)), shape);
    run(&mut world, 2.0);
    [world.bodies[body].translation().y, world.bodies[body].linvel().y]
}

/// Bodies pass the back of a surface, and rest on its front.
#[test]
fn backs_are_passed_and_fronts_are_not() {
    let columns = ["floor", "body", "highest from behind (m)", "worst on the front (m)"];
    let mut table = Table::new("falls onto surfaces with one side", &columns);
    for (floor_name, back, front) in one_sided_floors() {
        for (name, shape, rest) in bodies() {
            let fall = |floor: &ColliderBuilder, [height, speed]: [Real; 2]| {
                fall_on(floor, shape.clone(), [rest + height, speed])
            };
            let passed = FALLS.map(|start| fall(&back, start)[0]);
            let highest = passed.into_iter().fold(Real::NEG_INFINITY, Real::max);
            // A body that lands at 100 m/s may tilt, and then rolls off.
            let landed = FALLS[..5].iter().map(|start| fall(&front, *start)[0] - rest);
            let worst = landed.map(Real::abs).fold(0.0, Real::max);
            let cells = [highest, worst].map(|figure| format!("{figure:.4}"));
            let [first, second] = cells;
            table.row([floor_name.into(), name.into(), first, second]);
            // A free fall of 2 s is 20 m long. Contacts may push a body that leaves.
            table.require(highest < -5.0, "it hangs");
            table.require(worst < 2.0e-3, "it does not rest on the front");
        }
    }
}

/// Long bodies fall through the back of a surface at any angle: they are not stopped when their middle is in
/// front, and one end still behind.
#[test]
fn long_bodies_pass_backs() {
    let mut table = Table::new("long bodies from behind", &["floor", "body", "highest (m)"]);
    let long = [
        ("rod", cuboid(1.5, 0.03)),
        ("capsule", ColliderBuilder::capsule_x(1.0, 0.1)),
        ("thin capsule", ColliderBuilder::capsule_x(1.5, 0.0)),
    ];
    for (floor_name, back, _) in one_sided_floors() {
        for (name, shape) in &long {
            let mut highest = Real::NEG_INFINITY;
            for turned in [0.0, 0.3, 0.7, 1.2, 1.57] {
                for [height, speed] in FALLS {
                    let mut world = world(60);
                    world.insert_collider(back.clone(), None);
                    let body = RigidBodyBuilder::dynamic().translation(vec(0.13, 2.0 + height));
                    let body = body.rotation(about_z(turned)).linvel(vec(0.0, -speed));
                    let (body, _) = world.insert(body, shape.clone().mass(1.0));
                    run(&mut world, 2.0);
                    highest = highest.max(world.bodies[body].translation().y);
                }
            }
            table.row([floor_name.into(), (*name).into(), format!("{highest:.4}")]);
            // A free fall of 2 s is 20 m long. Contacts may push a body that leaves.
            table.require(highest < -5.0, "it hangs");
        }
    }
}

/// Bodies without thickness that fall on ridges do not pass them. In 2D, some slide through the lowest point
/// of a valley along one of its sides: a known limit.
#[test]
fn slender_bodies_do_not_pass_ridges() {
    let columns = ["body", "speed (m/s)", "passed, of 40"];
    let mut table = Table::new("bodies without thickness on ridges", &columns);
    for (name, shape) in slender_bodies() {
        for speed in [0.0, 1.0, 3.0, 10.0] {
            let passes = |seed: u64| {
                let mut dice = Dice(seed);
                let mut world = world(60);
                world.insert_collider(ridges(), None);
                let body = RigidBodyBuilder::dynamic().linvel(vec(0.0, -speed));
                let body = body.translation(vec(dice.within(-2.0, 2.0), 1.0));
                let body = body.rotation(about_z(dice.within(-1.5, 1.5)));
                let (body, _) = world.insert(body, shape.clone());
                run(&mut world, 3.0);
                world.bodies[body].translation().y < -0.5
            };
            let passed = (0..40).filter(|seed| passes(*seed)).count();
            table.row([name.into(), speed.to_string(), passed.to_string()]);
            table.require((0..=PASSED_MAX).contains(&passed), "bodies passed");
        }
    }
}
