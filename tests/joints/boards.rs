//! Chains of light and heavy boards that fall on the ground (3D).
//!
//! A light board between the ground and what comes down behind it bears a hundred times its weight, and is held stiffly at
//! both ends: a contact pushes into joints that hold against it.

use crate::suite::physics::stage::{RATES, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Densities of the boards, in turn.
const DENSITIES: [Real; 3] = [100.0, 1000.0, 10_000.0];
const BOARDS: usize = 6;
/// From where they are thrown.
const HEIGHT: Real = 7.0;

/// Neither the ground nor joints do work, friction takes some, and contacts have no restitution. What the undoing of overlap
/// and of gaps may lend for some steps is to be far less than this.
const ROOM: Real = 0.02;

/// Vectors within a cube of half length 1, one after another.
struct Dice(u64);

impl Dice {
    fn number(&mut self) -> Real {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as Real / (1_u64 << 23) as Real - 1.0
    }

    fn vector(&mut self) -> Vector {
        Vector::new(self.number(), self.number(), self.number())
    }
}

/// A chain of boards above the ground that turns and flies as a whole.
fn throw(
    world: &mut PhysicsWorld,
    dice: &mut Dice,
    limits: Option<[Real; 2]>,
) -> Vec<RigidBodyHandle> {
    let ground = ColliderBuilder::cuboid(50.0, 0.5, 50.0).translation(Vector::Y * -0.5);
    world.insert_collider(ground, None);
    let [turn, velocity, spin] = [1.0, 3.0, 2.0].map(|size| dice.vector() * size);
    let mut boards: Vec<RigidBodyHandle> = Vec::new();
    for n in 0..BOARDS {
        let arm = Rotation::from_scaled_axis(turn) * (Vector::X * n as Real);
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * HEIGHT + arm);
        let body = body.rotation(turn).angvel(spin).linvel(velocity + spin.cross(arm));
        let shape = ColliderBuilder::cuboid(0.4, 0.03, 0.15).density(DENSITIES[n % 3]);
        let (board, _) = world.insert(body.can_sleep(false), shape);
        if let Some(&last) = boards.last() {
            let hinge = RevoluteJointBuilder::new(Vector::new(0.1, 0.3, 1.0))
                .local_anchor1(Vector::X * 0.5)
                .local_anchor2(Vector::X * -0.5)
                .contacts_enabled(false);
            let hinge = limits.map_or(hinge, |limits| hinge.limits(limits));
            world.insert_impulse_joint(last, board, hinge);
        }
        boards.push(board);
    }
    boards
}

/// The energy of bodies, seen from the ground.
fn energy(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> Real {
    let of = |body: &RigidBody| {
        body.kinetic_energy() + body.mass() * world.gravity.length() * body.center_of_mass().y
    };
    bodies.iter().map(|body| of(&world.bodies[*body])).sum()
}

/// A thrown chain of unlike boards never has more energy than it began with.
#[test]
fn thrown_chains_of_unlike_boards_gain_no_energy() {
    let columns = ["rate", "limits", "throw", "most energy"];
    let mut table = Table::new("six boards of 1:10:100 on hinges, thrown from 7 m", &columns);
    for rate in RATES {
        for limits in [None, Some([-1.0, 1.0])] {
            let mut dice = Dice(12345);
            for k in 0..8 {
                let mut world = world(rate);
                let boards = throw(&mut world, &mut dice, limits);
                let (start, mut most) = (energy(&world, &boards), 0.0);
                for _ in 0..steps(&world, 3.0) {
                    world.step();
                    most = Real::max(most, energy(&world, &boards) / start);
                }
                let limited = if limits.is_some() { "yes" } else { "no" };
                table.row([rate.to_string(), limited.into(), k.to_string(), format!("{most:.4}")]);
                table.require(most < 1.0 + ROOM, "gains energy");
            }
        }
    }
}
