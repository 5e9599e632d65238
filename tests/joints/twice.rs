//! Redundant joints share the load.
//!
//! Mechanics does not determine which of three hinges carries a door: the equations of redundant
//! joints are singular. The solver finds the smallest forces that hold. Equal joints then carry equal
//! loads, and none acts against another.

use super::stage::post;
use crate::dim::{about_z, ang_length, cuboid, hinge, vec};
use crate::suite::physics::stage::{G, RATES, Sample, run, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Mass of the board, and half its length.
const MASS: Real = 5.0;
const HALF: Real = 1.5;
/// Breaking force of a joint, as a multiple of its fraction of the load. It should not break.
const RESERVE: Real = 3.0;

/// Support of a board.
#[derive(Copy, Clone, Debug)]
enum Held {
    /// This number of hinges along its length, each on a separate post.
    ByPosts(usize),
    /// This number of hinges on one beam, which hangs on one post.
    ByBeam(usize),
    /// This number of fixed joints in one place.
    Welded(usize),
}

/// A board on joints that share its weight.
struct Shared {
    world: PhysicsWorld,
    joints: Vec<ImpulseJointHandle>,
    board: RigidBodyHandle,
}

/// Adds a board at a place, rotated by an angle.
fn board(world: &mut PhysicsWorld, at: Vector, angle: Real) -> RigidBodyHandle {
    let body =
        RigidBodyBuilder::dynamic().translation(at).rotation(about_z(angle)).can_sleep(false);
    let shape = cuboid(HALF, 0.1).mass(MASS).collision_groups(InteractionGroups::none());
    world.insert(body, shape).0
}

impl Shared {
    /// Builds the scene at an angle, so that numbers are not round. Joints break at [`RESERVE`] times their
    /// fraction of the load.
    fn new(mut world: PhysicsWorld, held: Held, angle: Real) -> Self {
        let middle = vec(0.37, 1.13);
        let board = board(&mut world, middle, angle);
        let beam = match held {
            Held::ByBeam(_) => Some(beam(&mut world, middle, angle)),
            _ => None,
        };
        let (Held::ByPosts(count) | Held::ByBeam(count) | Held::Welded(count)) = held;
        let share = MASS * G / count as Real;
        let mut joints = Vec::new();
        for k in 0..count {
            let along = vec(HALF * ((2 * k + 1) as Real / count as Real - 1.0), 0.0);
            let (mut joint, anchor): (GenericJoint, _) = match held {
                Held::Welded(_) => (FixedJointBuilder::new().build().into(), vec(0.0, 0.0)),
                _ => (hinge().build().into(), along),
            };
            joint.set_local_anchor2(anchor).set_break_thresholds(RESERVE * share, Real::INFINITY);
            let place = *world.bodies[board].position() * anchor;
            let holder = beam.unwrap_or_else(|| post(&mut world, place));
            let holder_pose = world.bodies[holder].position();
            joint.set_local_anchor1(holder_pose.inverse() * place);
            if beam.is_none() {
                joint.local_frame1.rotation =
                    *world.bodies[board].rotation() * joint.local_frame2.rotation;
            }
            joints.push(world.insert_impulse_joint(holder, board, joint));
        }
        Self { world, joints, board }
    }

    fn forces(&self) -> impl Iterator<Item = Vector> {
        self.joints.iter().map(|&joint| self.world.impulse_joints[joint].force())
    }
}

/// Adds a beam beside a board that is welded to one post.
fn beam(world: &mut PhysicsWorld, beside: Vector, angle: Real) -> RigidBodyHandle {
    let (beam, post) = (board(world, beside + vec(0.0, 0.3), angle), post(world, beside));
    let weld = FixedJointBuilder::new().local_anchor2(vec(0.0, 0.0)).build();
    let mut weld: GenericJoint = weld.into();
    let pose = world.bodies[post].position().inverse() * *world.bodies[beam].position();
    weld.local_frame1 = pose;
    world.insert_impulse_joint(post, beam, weld);
    beam
}

/// Equal redundant joints carry equal forces, from the first step on and for five seconds.
#[test]
fn equal_redundant_joints_carry_equal_loads() {
    let columns = ["rate", "held", "least", "most", "across (shares)", "moves (m)"];
    let mut table = Table::new("forces of joints that share a weight", &columns);
    let mut sample = Sample::one_of(2);
    let ways = [
        (Held::ByPosts(2), 0.0),
        (Held::ByPosts(3), 0.4),
        (Held::ByPosts(25), 0.4),
        (Held::ByBeam(3), 0.4),
        (Held::ByBeam(25), 0.0),
        (Held::Welded(2), 0.4),
        (Held::Welded(5), 0.4),
    ];
    for rate in RATES {
        for (held, angle) in ways {
            if !sample.has_next() {
                continue;
            }
            let mut scene = Shared::new(world(rate), held, angle);
            let (start, weight) = (scene.world.bodies[scene.board].translation(), MASS * G);
            let share = weight / scene.joints.len() as Real;
            let [mut least, mut most, mut across, mut off, mut moves] =
                [Real::INFINITY, 0.0, 0.0, 0.0, 0.0];
            for _ in 0..steps(&scene.world, 5.0) {
                scene.world.step();
                for force in scene.forces() {
                    (least, most) = (least.min(force.y / share), most.max(force.y / share));
                    across = (force - vec(0.0, force.y)).length().max(across * share) / share;
                }
                let sum = scene.forces().fold(Vector::ZERO, |sum, force| sum + force);
                off = (sum - vec(0.0, weight)).length().max(off);
                moves = (scene.world.bodies[scene.board].translation() - start).length().max(moves);
            }
            table.row([
                rate.to_string(),
                format!("{held:?}"),
                format!("{least:.4}"),
                format!("{most:.4}"),
                format!("{across:.4}"),
                format!("{moves:e}"),
            ]);
            let mut joints = scene.world.impulse_joints();
            table.require(joints.all(|(_, joint)| joint.data.is_enabled()), "breaks");
            table.check("the sum of the forces is off and that", off, 0.0, 0.01 * weight);
            table.check("the least share", least, 1.0, 0.05);
            table.check("the largest share", most, 1.0, 0.05);
            table.check("the force across", across, 0.0, 0.05);
            table.check("the way it moves", moves, 0.0, 1.0e-4);
        }
    }
}

/// Planks and 25 hinges form a hanging bridge. The direction out of its plane is redundant and has no
/// load: the forces there must be zero.
#[test]
fn hinges_of_a_bridge_do_not_strain_sideways() {
    const COUNT: usize = 24;
    let columns = ["rate", "bears (weights)", "torque (weights · m)", "least", "most (weights)"];
    let mut table = Table::new("a bridge of 24 planks at rest", &columns);
    for rate in RATES {
        let mut world = world(rate);
        let (half, mut end, mut joints) = (0.25, vec(0.0, 0.0), Vec::new());
        let mut last = post(&mut world, end);
        for k in 0..COUNT {
            // Angles are from -0.5 to 0.5 rad.
            let angle = (2 * k + 1) as Real / (2 * COUNT) as Real - 0.5;
            let along = vec(angle.cos(), angle.sin()) * half;
            let plank = RigidBodyBuilder::dynamic().translation(end + along);
            let plank = plank.rotation(about_z(angle)).linear_damping(1.0).angular_damping(1.0);
            let shape = cuboid(half, 0.05).mass(1.0).collision_groups(InteractionGroups::none());
            let (plank, _) = world.insert(plank.can_sleep(false), shape);
            let anchor = if k == 0 { 0.0 } else { half };
            let joint = hinge().local_anchor1(vec(anchor, 0.0)).local_anchor2(vec(-half, 0.0));
            joints.push(world.insert_impulse_joint(last, plank, joint));
            (last, end) = (plank, end + along * 2.0);
        }
        let bank = post(&mut world, end);
        let joint = hinge().local_anchor1(vec(half, 0.0)).local_anchor2(Vector::ZERO);
        joints.push(world.insert_impulse_joint(last, bank, joint));
        run(&mut world, 10.0);
        let [mut sideways, mut torque, mut least, mut most] =
            [0.0 as Real, 0.0, Real::INFINITY, 0.0];
        for _ in 0..steps(&world, 5.0) {
            world.step();
            for &joint in &joints {
                let joint = &world.impulse_joints[joint];
                let force = joint.force();
                let flat = vec(force.x, force.y);
                sideways = sideways.max((force - flat).length());
                torque = torque.max(ang_length(joint.torque()));
            }
            let ends = [joints[0], joints[COUNT]].map(|joint| world.impulse_joints[joint].force());
            let load = (ends[0].y - ends[1].y) / (COUNT as Real * G);
            (least, most) = (least.min(load), most.max(load));
        }
        table.row([
            rate.to_string(),
            format!("{:e}", sideways / G),
            format!("{:e}", torque / G),
            format!("{least:.4}"),
            format!("{most:.4}"),
        ]);
        table.check("the force sideways", sideways, 0.0, 0.01 * G);
        table.check("the torque", torque, 0.0, 0.01 * G);
        table.check("the least share of the weight that the banks bear", least, 1.0, 0.01);
        table.check("the largest", most, 1.0, 0.01);
    }
}
