//! Bodies that impulse joints connect stop together.

use super::{PHASES, RADIUS, SPEEDS, wall};
use crate::dim::{hinge, vec};
use crate::suite::physics::stage::weightless;
use crate::suite::physics::table::Table;
use rapier::prelude::*;

const LINKS: usize = 6;

struct Chain {
    bodies: Vec<RigidBodyHandle>,
    joints: Vec<ImpulseJointHandle>,
}

/// A row of balls with hinges between them that flies obliquely towards the plane x = 0.
fn add_chain(world: &mut PhysicsWorld, at: Vector, aslant: Real, speed: Real) -> Chain {
    let step = vec(aslant, 1.0).normalize() * (4.0 * RADIUS);
    let mut chain = Chain { bodies: Vec::new(), joints: Vec::new() };
    for k in 0..LINKS {
        let body = RigidBodyBuilder::dynamic().translation(at + step * k as Real);
        let body = body.linvel(vec(speed, 0.0)).can_sleep(false);
        let (body, _) = world.insert(body, ColliderBuilder::ball(RADIUS).friction(0.0));
        if let Some(&last) = chain.bodies.last() {
            let joint = hinge().local_anchor1(step * 0.5).local_anchor2(step * -0.5);
            chain.joints.push(world.insert_impulse_joint(last, body, joint));
        }
        chain.bodies.push(body);
    }
    chain
}

/// Returns the largest separation of a joint (m).
fn gap(world: &PhysicsWorld, chain: &Chain) -> Real {
    let gaps = chain.joints.iter().map(|&joint| {
        let joint = &world.impulse_joints.get(joint).expect("it is there");
        let at = |body: RigidBodyHandle, anchor: Vector| world.bodies[body].position() * anchor;
        let data = &joint.data;
        let first = at(joint.body1(), data.local_anchor1());
        (first - at(joint.body2(), data.local_anchor2())).length()
    });
    gaps.fold(0.0, Real::max)
}

fn energy(world: &PhysicsWorld, chain: &Chain) -> Real {
    chain.bodies.iter().map(|&body| world.bodies[body].kinetic_energy()).sum()
}

/// No ball of a chain passes the wall, and joints recover the separation that the impact causes.
///
/// The joints do separate. The balls are 20 cm apart and move by 40 cm in a substep at 100 m/s. So they
/// rotate about the stopped ball by radians at once. Stopping each ball alone would separate them by the
/// motion of a whole step. From 400 m/s on, the rest of the chain spins faster than substeps resolve, and the
/// joints stay apart for that time.
#[test]
fn chains_hit_walls_as_wholes() {
    let columns = ["speed", "aslant", "passed", "gap (mm)", "left (mm)", "energy"];
    let mut table = Table::new("chains of balls of 10 cm that hit a wall of 2 cm", &columns);
    for speed in SPEEDS {
        for aslant in [0.0, 0.3, 1.0] {
            let (mut passed, mut widest, mut left): (usize, Real, Real) = (0, 0.0, 0.0);
            let mut most: Real = 0.0;
            for phase in 0..PHASES {
                let mut world = weightless(60);
                world.insert_collider(wall(), None);
                let way = speed / 60.0 * (2.0 + phase as Real / PHASES as Real) + 1.5;
                let chain = add_chain(&mut world, vec(-way, 0.0), aslant, speed);
                let start = energy(&world, &chain);
                let mut passes = false;
                for _ in 0..60 {
                    world.step();
                    let beyond = |&body: &RigidBodyHandle| world.bodies[body].translation().x > 0.0;
                    passes |= chain.bodies.iter().any(beyond);
                    widest = widest.max(gap(&world, &chain));
                    most = most.max(energy(&world, &chain) / start);
                }
                passed += usize::from(passes);
                left = left.max(gap(&world, &chain));
            }
            let cells = [format!("{speed}"), format!("{aslant}"), passed.to_string()];
            let [a, b, c] = cells;
            let [widest_mm, left_mm] = [widest, left].map(|gap| format!("{:.1}", 1000.0 * gap));
            table.row([a, b, c, widest_mm, left_mm, format!("{most:.3}")]);
            table.require(passed == 0, "chains passed");
            // Path length of a ball in one step, at the speeds that the substeps can integrate.
            if speed <= 100.0 {
                table.require(left < 0.01, "joints stayed torn");
                // The bound is the motion of one step.
                table.require(widest < speed / 60.0, "a joint was torn");
                table.require(most < 1.1, "energy came from nowhere");
            }
        }
    }
}

/// The balls of a row stop with the first: none is ahead of the others in the step of the impact.
#[test]
fn the_first_stops_all() {
    let mut world = weightless(60);
    world.insert_collider(wall(), None);
    let chain = add_chain(&mut world, vec(-3.0, 0.0), 1.0, 100.0);
    let before = gap(&world, &chain);
    let mut stopped = 0;
    while stopped == 0 {
        world.step();
        stopped = world.physics_pipeline.counters.ccd.num_substeps;
    }
    assert_eq!(stopped, LINKS);
    let wider = gap(&world, &chain) - before;
    assert!(wider < 1.0e-4, "the joints gave way by {wider} m");
}
