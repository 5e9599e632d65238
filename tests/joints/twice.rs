//! What is held more often than it need be: joints that do the same share the load.
//!
//! Mechanics does not say which of three hinges bears a door, and the equations of such joints are singular. Of all forces
//! that hold, the solver should find the least: then equal joints bear equal loads, and none strains against another.

use super::stage::post;
use crate::dim::{cuboid, hinge, vec};
use crate::suite::physics::stage::{G, RATES, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// The mass of what hangs, and half its length.
const MASS: Real = 5.0;
const HALF: Real = 1.5;
/// A joint that breaks at this many times its share of the load should hold.
const RESERVE: Real = 3.0;

/// How a thing is held.
#[derive(Copy, Clone, Debug)]
enum Held {
    /// By this many hinges along its length, each on a post.
    ByPosts(usize),
    /// By this many hinges on one beam, which hangs on one post.
    ByBeam(usize),
    /// By this many joints in one place that hold everything.
    Welded(usize),
}

/// Joints that share a weight.
struct Shared {
    world: PhysicsWorld,
    joints: Vec<ImpulseJointHandle>,
    body: RigidBodyHandle,
}

fn body(world: &mut PhysicsWorld, half_height: Real, at: Vector) -> RigidBodyHandle {
    let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
    let shape = cuboid(HALF, half_height).mass(MASS).collision_groups(InteractionGroups::none());
    world.insert(body, shape).0
}

impl Shared {
    fn new(mut world: PhysicsWorld, held: Held) -> Self {
        // Not where numbers are round.
        let middle = vec(0.37, 1.13);
        let body = body(&mut world, 0.1, middle);
        let mut joints = Vec::new();
        let (Held::ByPosts(count) | Held::ByBeam(count) | Held::Welded(count)) = held;
        let beam = match held {
            Held::ByBeam(_) => Some(beam(&mut world, middle)),
            _ => None,
        };
        for k in 0..count {
            let along = vec(HALF * ((2 * k + 1) as Real / count as Real - 1.0), 0.1);
            let joint: GenericJoint = match held {
                Held::ByPosts(_) => hinge().local_anchor2(along).build().into(),
                Held::ByBeam(_) => {
                    let below = along - vec(0.0, 0.3);
                    hinge().local_anchor1(below).local_anchor2(along).build().into()
                }
                Held::Welded(_) => {
                    FixedJointBuilder::new().local_anchor2(vec(0.0, 0.1)).build().into()
                }
            };
            let from = beam.unwrap_or_else(|| {
                let anchor = vec(0.0, 0.1);
                post(
                    &mut world,
                    middle
                        + if joint.locked_axes == JointAxesMask::LOCKED_FIXED_AXES {
                            anchor
                        } else {
                            along
                        },
                )
            });
            joints.push(world.insert_impulse_joint(from, body, joint));
        }
        Self { world, joints, body }
    }

    fn force(&self, joint: ImpulseJointHandle) -> Vector {
        self.world.impulse_joints[joint].force()
    }
}

/// A beam above a place that hangs on a post.
fn beam(world: &mut PhysicsWorld, below: Vector) -> RigidBodyHandle {
    let at = below + vec(0.0, 0.3);
    let (beam, post) = (body(world, 0.1, at), post(world, at));
    world.insert_impulse_joint(post, beam, FixedJointBuilder::new());
    beam
}

#[test]
fn joints_that_do_the_same_bear_the_same() {
    let columns = ["rate", "held", "least", "most", "across (shares)", "moves (m)"];
    let mut table = Table::new("forces of joints that share a weight", &columns);
    for rate in RATES {
        for held in [
            Held::ByPosts(3),
            Held::ByPosts(25),
            Held::ByBeam(2),
            Held::ByBeam(25),
            Held::Welded(2),
            Held::Welded(5),
        ] {
            let mut scene = Shared::new(world(rate), held);
            let share = MASS * G / scene.joints.len() as Real;
            for &joint in &scene.joints {
                let joint = &mut scene.world.impulse_joints[joint].data;
                joint.set_break_thresholds(RESERVE * share, Real::INFINITY);
            }
            let start = scene.world.bodies[scene.body].translation();
            let (mut least, mut most, mut across) = (Real::INFINITY, 0.0 as Real, 0.0 as Real);
            let mut moves: Real = 0.0;
            let mut sum_off: Real = 0.0;
            for _ in 0..steps(&scene.world, 5.0) {
                scene.world.step();
                let mut sum = Vector::ZERO;
                for &joint in &scene.joints {
                    let force = scene.force(joint);
                    (least, most) = (least.min(force.y / share), most.max(force.y / share));
                    across = across.max((force - vec(0.0, force.y)).length() / share);
                    sum += force;
                }
                sum_off = sum_off.max((sum - vec(0.0, MASS * G)).length());
                let place = scene.world.bodies[scene.body].translation();
                moves = moves.max((place - start).length());
            }
            table.row([
                rate.to_string(),
                format!("{held:?}"),
                format!("{least:.4}"),
                format!("{most:.4}"),
                format!("{across:.4}"),
                format!("{moves:e}"),
            ]);
            let hold = scene
                .joints
                .iter()
                .all(|&joint| scene.world.impulse_joints[joint].data.is_enabled());
            table.require(hold, "breaks");
            table.check("sum of the forces", sum_off, 0.0, 0.01 * MASS * G);
            table.check("the least share", least, 1.0, 0.05);
            table.check("the largest share", most, 1.0, 0.05);
            table.check("force across", across, 0.0, 0.05);
            table.check("moves", moves, 0.0, 1.0e-4);
        }
    }
}
