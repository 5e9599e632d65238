//! Chains keep their length under any load.

use super::stage::post;
use crate::dim::{about_z, cuboid, hinge, loose_joint, vec};
use crate::suite::physics::stage::{RATES, Sample, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

const LINKS: usize = 20;
/// Half the length of a link.
const HALF: Real = 0.25;

/// Parameters of a chain.
#[derive(Copy, Clone, Debug)]
enum Kind {
    /// Hinges about the axis out of the plane.
    Hinges,
    /// Ball joints, and hinges about several axes in turn.
    Loose,
    /// Fixed joints: a beam.
    Fixed,
}

fn joint(kind: Kind, k: usize, anchor1: Vector, anchor2: Vector) -> GenericJoint {
    match kind {
        Kind::Hinges => hinge().local_anchor1(anchor1).local_anchor2(anchor2).build().into(),
        Kind::Loose => loose_joint(k, anchor1, anchor2),
        Kind::Fixed => {
            let joint = FixedJointBuilder::new().local_anchor1(anchor1).local_anchor2(anchor2);
            joint.build().into()
        }
    }
}

/// Adds a straight chain of links from the origin, at this angle from the horizontal, with a ball at its end
/// that weighs `ratio` links. Returns the ball.
fn chain(world: &mut PhysicsWorld, kind: Kind, angle: Real, ratio: Real) -> RigidBodyHandle {
    let mut last = post(world, Vector::ZERO);
    let mut anchor = Vector::ZERO;
    let along = vec(angle.cos(), -angle.sin());
    let body = |k: usize| {
        let at = along * ((2 * k + 1) as Real * HALF);
        RigidBodyBuilder::dynamic().translation(at).rotation(about_z(-angle))
    };
    for k in 0..LINKS {
        let link = cuboid(HALF, 0.05).mass(1.0).collision_groups(InteractionGroups::none());
        let (link, _) = world.insert(body(k), link);
        world.insert_impulse_joint(last, link, joint(kind, k, anchor, vec(-HALF, 0.0)));
        (last, anchor) = (link, vec(HALF, 0.0));
    }
    let ball = ColliderBuilder::ball(HALF).mass(ratio).collision_groups(InteractionGroups::none());
    let (ball, _) = world.insert(body(LINKS), ball);
    world.insert_impulse_joint(last, ball, joint(kind, LINKS, anchor, vec(-HALF, 0.0)));
    ball
}

/// Returns the largest total separation of a chain's joints in this time (s), as a fraction of its length.
fn stretch(world: &mut PhysicsWorld, seconds: Real) -> Real {
    let mut worst: Real = 0.0;
    for _ in 0..steps(world, seconds) {
        world.step();
        let gaps = world.impulse_joints().map(|(_, joint)| {
            let [one, two] = [joint.body1(), joint.body2()].map(|body| &world.bodies[body]);
            let anchor1 = *one.position() * joint.data.local_anchor1();
            (anchor1 - *two.position() * joint.data.local_anchor2()).length()
        });
        worst = worst.max(gaps.sum());
    }
    worst / (2.0 * HALF * LINKS as Real)
}

/// A chain with a heavy ball at its end falls from level without stretching.
#[test]
fn chains_do_not_stretch() {
    let mut table = Table::new("chain that falls from level", &["rate", "load", "stretch (%)"]);
    let mut sample = Sample::one_of(2);
    for rate in RATES {
        let loads = [(1.0, 0.005), (100.0, 0.03), (1000.0, 0.1), (1.0e4, 0.1), (1.0e5, 0.1)];
        for (ratio, allowed) in loads {
            if !sample.has_next() {
                continue;
            }
            let mut world = world(rate);
            chain(&mut world, Kind::Hinges, 0.0, ratio);
            let found = stretch(&mut world, if ratio > 1000.0 { 4.0 } else { 10.0 });
            table.row([rate.to_string(), ratio.to_string(), format!("{:.4}", 100.0 * found)]);
            table.require(found < allowed, "stretches");
        }
    }
}

/// Chains of every kind of joint keep their length under a load.
#[test]
fn chains_of_all_joints_hold_their_load() {
    let columns = ["rate", "joints", "load", "stretch (%)"];
    let mut table = Table::new("chain that swings from 60° below level, beam at level", &columns);
    let mut sample = Sample::one_of(2);
    for rate in RATES {
        for kind in [Kind::Hinges, Kind::Loose, Kind::Fixed] {
            for ratio in [100.0, 1000.0, 1.0e4] {
                if !sample.has_next() {
                    continue;
                }
                let mut world = world(rate);
                let is_beam = matches!(kind, Kind::Fixed);
                let ball = chain(&mut world, kind, if is_beam { 0.0 } else { 1.05 }, ratio);
                let found = stretch(&mut world, 5.0);
                table.row([
                    rate.to_string(),
                    format!("{kind:?}"),
                    ratio.to_string(),
                    format!("{:.4}", 100.0 * found),
                ]);
                table.require(found < 0.03, "stretches");
                if is_beam {
                    let sag = world.bodies[ball].translation().y;
                    table.check("the height of the beam's end", sag, 0.0, 0.1);
                }
            }
        }
    }
}

/// A chain between two posts carries a weight in its middle without stretching.
#[test]
fn bridges_hold_their_load() {
    let columns = ["rate", "joints", "load", "stretch (%)"];
    let mut table = Table::new("slack bridge under a weight", &columns);
    for rate in RATES {
        for kind in [Kind::Hinges, Kind::Loose] {
            for ratio in [100.0, 1000.0] {
                let mut world = world(rate);
                let middle = chain(&mut world, kind, 0.3, ratio);
                // Beyond the weight the chain rises again, symmetric to the first half.
                let turn = about_z(0.3);
                let start = world.bodies[middle].position() * vec(HALF, 0.0);
                let (mut previous, mut anchor) = (middle, vec(HALF, 0.0));
                for k in 0..LINKS {
                    let along = vec((0.3 as Real).cos(), (0.3 as Real).sin());
                    let at = start + along * ((2 * k + 1) as Real * HALF);
                    let body = RigidBodyBuilder::dynamic().translation(at).rotation(turn);
                    let link = cuboid(HALF, 0.05).mass(1.0);
                    let link = link.collision_groups(InteractionGroups::none());
                    let (link, _) = world.insert(body, link);
                    let joint = joint(Kind::Loose, 0, anchor, vec(-HALF, 0.0));
                    world.insert_impulse_joint(previous, link, joint);
                    (previous, anchor) = (link, vec(HALF, 0.0));
                }
                let end = *world.bodies[previous].position() * anchor;
                let post = post(&mut world, end);
                let joint = joint(Kind::Loose, 0, Vector::ZERO, anchor);
                world.insert_impulse_joint(post, previous, joint);
                let found = stretch(&mut world, 5.0);
                table.row([
                    rate.to_string(),
                    format!("{kind:?}"),
                    ratio.to_string(),
                    format!("{:.4}", 100.0 * found),
                ]);
                table.require(found < 0.03, "stretches");
            }
        }
    }
}
