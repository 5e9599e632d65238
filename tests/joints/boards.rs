//! Chains of light and heavy boards that fall on the ground (3D).
//!
//! A light board between the ground and the following boards carries a hundred times its weight.
//! Stiff joints hold both of its ends: a contact acts against joints.

use crate::suite::physics::stage::{RATES, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Densities of the boards, in turn.
const DENSITIES: [Real; 3] = [100.0, 1000.0, 10_000.0];
/// Initial height of the chains.
const HEIGHT: Real = 7.0;

/// Largest energy gain, as a fraction. Neither the ground nor joints do work, friction dissipates energy, and
/// no contact returns more than it absorbed. The temporary energy of position corrections must be far
/// smaller.
const GAIN_MAX: Real = 0.02;

/// Generator of vectors within a cube of half length 1.
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

/// Parameters of a thrown chain.
#[derive(Copy, Clone)]
struct Chain {
    boards: usize,
    /// Densities of the boards, in turn.
    densities: [Real; 3],
    limits: Option<[Real; 2]>,
    /// Whether ball joints connect the boards instead of hinges.
    balls: bool,
    restitution: Real,
}

/// Adds a chain of boards above the ground with a common linear and angular velocity.
fn throw(world: &mut PhysicsWorld, dice: &mut Dice, chain: Chain) -> Vec<RigidBodyHandle> {
    let ground = ColliderBuilder::cuboid(50.0, 0.5, 50.0).translation(Vector::Y * -0.5);
    world.insert_collider(ground.restitution(chain.restitution), None);
    let [turn, velocity, spin] = [1.0, 3.0, 2.0].map(|size| dice.vector() * size);
    let mut boards: Vec<RigidBodyHandle> = Vec::new();
    for n in 0..chain.boards {
        let arm = Rotation::from_scaled_axis(turn) * (Vector::X * n as Real);
        let body = RigidBodyBuilder::dynamic().translation(Vector::Y * HEIGHT + arm);
        let body = body.rotation(turn).angvel(spin).linvel(velocity + spin.cross(arm));
        let shape = ColliderBuilder::cuboid(0.4, 0.03, 0.15).density(chain.densities[n % 3]);
        let shape = shape.restitution(chain.restitution);
        let (board, _) = world.insert(body.can_sleep(false), shape);
        if let Some(&last) = boards.last() {
            world.insert_impulse_joint(last, board, joint(chain));
        }
        boards.push(board);
    }
    boards
}

/// Returns the joint between a chain's boards.
fn joint(chain: Chain) -> GenericJoint {
    let anchors = [Vector::X * 0.5, Vector::X * -0.5];
    if chain.balls {
        let ball = SphericalJointBuilder::new().local_anchor1(anchors[0]).local_anchor2(anchors[1]);
        return ball.contacts_enabled(false).into();
    }
    let hinge = RevoluteJointBuilder::new(Vector::new(0.1, 0.3, 1.0));
    let hinge = hinge.local_anchor1(anchors[0]).local_anchor2(anchors[1]).contacts_enabled(false);
    chain.limits.map_or(hinge, |limits| hinge.limits(limits)).into()
}

/// Returns the energy of bodies relative to the ground.
fn energy(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> Real {
    let of = |body: &RigidBody| {
        body.kinetic_energy() + body.mass() * world.gravity.length() * body.center_of_mass().y
    };
    bodies.iter().map(|body| of(&world.bodies[*body])).sum()
}

/// Returns the largest energy of each throw, as a fraction of its initial energy.
fn most_energies(chain: Chain, rate: u32, throws: usize) -> Vec<Real> {
    let mut dice = Dice(12345);
    let most_of_one = |_| {
        let mut world = world(rate);
        let boards = throw(&mut world, &mut dice, chain);
        let (start, mut most) = (energy(&world, &boards), 0.0);
        for _ in 0..steps(&world, 3.0) {
            world.step();
            let now = energy(&world, &boards) / start;
            assert!(
                now.is_finite() && boards.iter().all(|&board| world.bodies[board].is_enabled())
            );
            most = Real::max(most, now);
        }
        most
    };
    (0..throws).map(most_of_one).collect()
}

/// Throws chains at these rates, with and without limits, and requires that none gains energy.
fn require_no_gain(title: &str, chain: Chain, rates: &[u32], throws: usize) {
    let mut table = Table::new(title, &["rate", "limits", "throw", "most energy"]);
    for &rate in rates {
        for limits in [None, Some([-1.0, 1.0])] {
            let energies = most_energies(Chain { limits, ..chain }, rate, throws);
            for (k, most) in energies.into_iter().enumerate() {
                let limited = if limits.is_some() { "yes" } else { "no" };
                table.row([rate.to_string(), limited.into(), k.to_string(), format!("{most:.4}")]);
                table.require(most < 1.0 + GAIN_MAX, "gains energy");
            }
        }
    }
}

/// A thrown chain of boards with different densities never exceeds its initial energy.
#[test]
fn thrown_chains_of_unlike_boards_gain_no_energy() {
    let chain =
        Chain { boards: 6, densities: DENSITIES, limits: None, balls: false, restitution: 0.0 };
    require_no_gain("six boards of 1:10:100 on hinges, thrown from 7 m", chain, &RATES, 8);
}

/// The same holds for elastic chains. A board that rotates by a radian in a step is hit through joints that
/// rotate with it. The impulse that these joints absorb must not be applied twice.
#[test]
fn thrown_chains_that_bounce_gain_no_energy() {
    let chain =
        Chain { boards: 4, densities: DENSITIES, limits: None, balls: false, restitution: 0.9 };
    require_no_gain("four boards of 1:10:100 that bounce, e = 0.9", chain, &[30, 60], 12);
}

/// Chains of equal boards are solved iteratively, so an impact propagates one joint per iteration. One of
/// these chains begins with its lower end in the ground, and must be hit there like a chain that arrived
/// earlier.
#[test]
fn thrown_chains_of_like_boards_that_bounce_gain_no_energy() {
    let densities = [1000.0; 3];
    let chain = Chain { boards: 10, densities, limits: None, balls: false, restitution: 0.9 };
    require_no_gain("ten like boards that bounce, e = 0.9", chain, &[120], 6);
}

/// The board at one end of a chain. Its joint is its only connection to other boards.
struct FreeEnd {
    board: RigidBodyHandle,
    joint: ImpulseJointHandle,
    /// One if the board is the joint's second body, which gets the joint's force; minus one if it is the
    /// first.
    side: Real,
}

impl FreeEnd {
    fn all(world: &PhysicsWorld, boards: &[RigidBodyHandle]) -> Vec<Self> {
        let ends = [(boards[0], -1.0), (boards[boards.len() - 1], 1.0)].into_iter();
        let of = |(board, side)| {
            let mut joints = world.impulse_joints.attached_joints(board);
            let (_, _, joint, _) = joints.next().expect("the board is joined");
            Self { board, joint, side }
        };
        ends.map(of).collect()
    }

    /// Returns whether any contact pressed on the board in the last step.
    fn is_touched(&self, world: &PhysicsWorld) -> bool {
        let collider = world.bodies[self.board].colliders()[0];
        let mut pairs = world.narrow_phase.contact_pairs_with(collider);
        pairs.any(|pair| pair.total_impulse_magnitude() != 0.0)
    }

    /// Returns the reported impulse of the joint on the board in the last step.
    fn given(&self, world: &PhysicsWorld) -> Vector {
        world.impulse_joints[self.joint].force() * (self.side * world.integration_parameters.dt)
    }
}

/// The reported impulse of a joint in a step with an impact equals the change of the board at its end:
/// `m Δv = (F + m g) dt`. Each round of impacts may apply only a fraction. Steps in which continuous
/// collision detection stops a board are excluded: the board then lacks the weight of the remaining time.
#[test]
fn joints_report_the_impulses_of_impacts() {
    let mut dice = Dice(4321);
    let columns = ["rate", "boards", "balls", "steps with impacts", "largest error", "of"];
    let mut table = Table::new("forces of joints at free ends in impacts", &columns);
    for rate in [60, 120, 240] {
        for (boards, balls) in [(2, false), (2, true), (3, false), (3, true)] {
            let (mut impacts, mut worst, mut of) = (0, 0.0, 0.0);
            for restitution in [0.5, 0.9, 1.0].repeat(4) {
                let mut world = world(rate);
                let chain =
                    Chain { boards, densities: DENSITIES, limits: None, balls, restitution };
                let boards = throw(&mut world, &mut dice, chain);
                world.integration_parameters.max_ccd_substeps = 0;
                let ends = FreeEnd::all(&world, &boards);
                let dt = world.integration_parameters.dt;
                for _ in 0..steps(&world, 3.0) {
                    let before =
                        boards.iter().map(|b| world.bodies[*b].linvel()).collect::<Vec<_>>();
                    world.step();
                    let before = [before[0], before[before.len() - 1]];
                    for (end, before) in ends.iter().zip(before) {
                        let body = &world.bodies[end.board];
                        let (got, given) =
                            ((body.linvel() - before) * body.mass(), end.given(&world));
                        let weight = world.gravity * (body.mass() * dt);
                        // An impact: an impulse larger than any in free flight.
                        if end.is_touched(&world) || given.length() < body.mass() * 1.0 {
                            continue;
                        }
                        impacts += 1;
                        let error = (got - weight - given).length() / given.length();
                        if error > worst {
                            (worst, of) = (error, given.length() / body.mass());
                        }
                    }
                }
            }
            table.row([
                rate.to_string(),
                boards.to_string(),
                balls.to_string(),
                impacts.to_string(),
                format!("{worst:.5}"),
                format!("{of:.3} m/s"),
            ]);
            table.require(worst < 1.0e-3, "another impulse than the board got");
        }
    }
}
