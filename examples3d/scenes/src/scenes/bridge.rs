//! Bridges of planks on hinges under a load of boulders.

use crate::common::{Law, Scene, SceneInfo};
use crate::kit::{add, add_fixed, cube, hinge, turn};
use crate::rapier::prelude::*;
use gallery::{Category, View};

/// Entry in the list.
pub const INFO: SceneInfo = SceneInfo {
    name: "bridge",
    description: "Two bridges of planks on hinges: one carries boulders of ten times a plank's weight, some hinges of the other break under them.",
    category: Category::Joints,
    steps: 130,
    law: Law { overlap_max: 0.05, height_min: -8.0, reach_max: 14.0, gap_max: 0.02, ..Law::NONE },
    source: file!(),
    build,
};

/// Number of planks of a bridge, and their half extents.
const PLANKS: usize = 24;
const HALF: Vector = Vector::new(0.45, 0.1, 1.2);
/// Distance of neighbouring hinges, and the radius of the arc on which they hang.
const PITCH: Real = 1.0;
const RADIUS: Real = 30.0;
/// Breaking force of the weak hinges of one bridge (mass · length / s²), and the number of hinges per weak
/// one.
const STRENGTH: Real = 350.0;
const WEAK: usize = 6;

/// Builds the scene.
pub fn build() -> Scene {
    let mut world = PhysicsWorld::new();
    add_fixed(&mut world, -Vector::Y * 9.0, ColliderBuilder::cuboid(200.0, 1.0, 200.0));
    for (z, strength) in [(-2.5, Real::INFINITY), (2.5, STRENGTH)] {
        add_bridge(&mut world, z, strength);
        for i in 0..5 {
            let place = Vector::new(3.0 * (i as Real - 2.0), 2.0 + 0.5 * i as Real, z);
            add(&mut world, place, ColliderBuilder::ball(0.55).density(6.0));
        }
        add(&mut world, Vector::new(-9.0, 1.5, z), cube(0.5));
    }
    Scene::new(world, View::orbit(25.0, 16.0))
}

/// Adds two banks with planks in between, each joined to the next at the middle of its edge. They hang on an
/// arc. Straight planks would need infinite tension to carry a load.
fn add_bridge(world: &mut PhysicsWorld, z: Real, strength: Real) {
    // Angle of a plank about the arc's centre, and of all planks on one side.
    let step = 2.0 * (0.5 * PITCH / RADIUS).asin();
    let side = 0.5 * PLANKS as Real * step;
    let top = RADIUS * side.cos();
    let bank = Vector::new(1.5, 1.0, 1.5);
    let [left, right] = [-1.0, 1.0].map(|sign| {
        let place = Vector::new(sign * (RADIUS * side.sin() + bank.x), -bank.y, z);
        add_fixed(world, place, ColliderBuilder::cuboid(bank.x, bank.y, bank.z))
    });
    let edge = Vector::X * (0.5 * PITCH);
    let mut last = (left, Vector::new(bank.x, bank.y, 0.0));
    for i in 0..PLANKS {
        let angle = (i as Real + 0.5) * step - side;
        let middle = RADIUS * (0.5 * step).cos();
        let place = Vector::new(middle * angle.sin(), top - middle * angle.cos(), z);
        let body = RigidBodyBuilder::dynamic().translation(place).rotation(turn(angle));
        let (plank, _) = world.insert(body, ColliderBuilder::cuboid(HALF.x, HALF.y, HALF.z));
        let force = if i % WEAK == WEAK / 2 { strength } else { Real::INFINITY };
        let joint = hinge()
            .local_anchor1(last.1)
            .local_anchor2(-edge)
            .break_thresholds(force, Real::INFINITY)
            .contacts_enabled(false);
        world.insert_impulse_joint(last.0, plank, joint);
        last = (plank, edge);
    }
    // The hinges keep the planks in line. The last hinge omits that: redundant constraints have no unique
    // solution.
    let carries = JointAxesMask::LIN_X | JointAxesMask::LIN_Y;
    let joint = GenericJointBuilder::new(carries)
        .local_anchor1(Vector::new(-bank.x, bank.y, 0.0))
        .local_anchor2(last.1)
        .contacts_enabled(false);
    world.insert_impulse_joint(right, last.0, joint);
}
