//! Links bounce like bodies.

use crate::dim::{about_z, cuboid, hinge, tumble, vec};
use crate::suite::joints::stage::bob;
use crate::suite::physics::stage::{G, RATES, add_ground, run, steps, substep, weightless, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

const RADIUS: Real = 0.25;

/// Returns a frictionless ball with this restitution for all pairs.
fn ball(restitution: Real) -> ColliderBuilder {
    let ball = ColliderBuilder::ball(RADIUS).restitution(restitution).friction(0.0);
    let ball = ball.restitution_combine_rule(CoefficientCombineRule::Max);
    ball.friction_combine_rule(CoefficientCombineRule::Min)
}

/// Role of the ball in a multibody.
#[derive(Copy, Clone, Debug)]
enum Belongs {
    /// The bob of an arm that is horizontal when the ball touches the ground.
    Bob,
    /// The free root, with another ball welded to it.
    Root,
    /// A ball that is welded to a free root.
    Weld,
}

/// Returns a world with ground and a ball that falls on it from `height`.
fn drop(
    rate: u32,
    belongs: Belongs,
    height: Real,
    restitution: Real,
) -> (PhysicsWorld, RigidBodyHandle) {
    let mut world = world(rate);
    add_ground(&mut world, 0.0);
    let at = vec(0.0, RADIUS + height);
    let (body, other) = match belongs {
        Belongs::Bob => {
            let length: Real = 4.0;
            let angle = (height / length).asin();
            let post = vec(-length, RADIUS);
            let root = world.insert_body(RigidBodyBuilder::fixed().translation(post));
            let at = post + vec(angle.cos(), angle.sin()) * length;
            let body = bob(1.0, 0.1).translation(at).rotation(crate::dim::about_z(angle));
            let body = world.insert_body(body);
            world.insert_collider(ball(restitution).density(0.0), Some(body));
            let joint = hinge().local_anchor2(vec(-length, 0.0));
            world.multibody_joints.insert(root, body, joint, true).expect("it fits");
            return (world, body);
        }
        Belongs::Root => (at, at + vec(1.0, 0.0)),
        Belongs::Weld => (at + vec(1.0, 0.0), at),
    };
    let [root, link] = [body, other]
        .map(|at| world.insert(RigidBodyBuilder::dynamic().translation(at), ball(restitution)).0);
    let weld = FixedJointBuilder::new().local_anchor1(other - body);
    world.multibody_joints.insert(root, link, weld, true).expect("it fits");
    (world, if matches!(belongs, Belongs::Root) { root } else { link })
}

/// Returns the apex of the ball after its first bounce, relative to its height at the contact.
fn apex(mut world: PhysicsWorld, body: RigidBodyHandle) -> Real {
    let (mut apex, mut rose): (Real, bool) = (0.0, false);
    for _ in 0..steps(&world, 2.0) {
        world.step();
        let body = &world.bodies[body];
        rose |= body.linvel().y > 0.0;
        if rose {
            apex = apex.max(body.translation().y - RADIUS);
            if body.linvel().y < 0.0 {
                break;
            }
        }
    }
    apex
}

/// A link that falls from the height `H` rises to `e² H`, like a single body.
#[test]
fn links_rise_as_high_as_bodies() {
    let columns = ["rate", "link", "restitution", "apex (m)", "formula", "error"];
    let mut table = Table::new("links that fall by 1 m", &columns);
    for rate in RATES {
        for belongs in [Belongs::Bob, Belongs::Root, Belongs::Weld] {
            for restitution in [0.0, 0.5, 1.0] {
                let (world, body) = drop(rate, belongs, 1.0, restitution);
                let (apex, formula) = (apex(world, body), restitution * restitution);
                table.row([
                    rate.to_string(),
                    format!("{belongs:?}"),
                    restitution.to_string(),
                    format!("{apex:.4}"),
                    format!("{formula:.4}"),
                    format!("{:+.4}", apex - formula),
                ]);
                // Bounces are accurate to second order: the error of the height is `(g h)²/2g`, and the apex
                // is between two steps.
                let between = G * (1.0 / rate as Real).powi(2) / 8.0;
                table.check("the apex", apex, formula, 0.005 + between);
            }
        }
    }
}

/// Returns the energy of all bodies (J), with heights at the middle of the last substep, in agreement with
/// the velocities.
fn energy(world: &PhysicsWorld) -> Real {
    let half = 0.5 * substep(world);
    let of = |(_, body): (RigidBodyHandle, &RigidBody)| {
        let height = body.center_of_mass().y - half * body.linvel().y;
        body.kinetic_energy() + body.mass() * world.gravity.length() * height
    };
    world.bodies.iter().filter(|(_, body)| body.is_dynamic()).map(of).sum()
}

/// Elastic chains that fall on the ground, or swing against it, gain no energy.
#[test]
fn chains_that_bounce_gain_no_energy() {
    let mut table = Table::new("elastic chains, 3 s", &["rate", "chain", "gain", "left"]);
    for rate in RATES {
        for (name, hangs) in [("free", false), ("hanging", true)] {
            let mut world = world(rate);
            add_ground(&mut world, 0.0);
            let mut parent = None;
            if hangs {
                let post = RigidBodyBuilder::fixed().translation(vec(-0.6, 1.5));
                parent = Some(world.insert_body(post));
            }
            for k in 0..5 {
                let at = vec(0.6 * k as Real, 1.5 + if hangs { 0.0 } else { 0.1 * k as Real });
                let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
                let (body, _) = world.insert(body, ball(1.0).mass(1.0));
                if let Some(parent) = parent {
                    let first = hangs && k == 0;
                    let apart = vec(0.6, if hangs { 0.0 } else { 0.1 });
                    let joint =
                        hinge().local_anchor1(if first { Vector::ZERO } else { apart * 0.5 });
                    let joint = joint.local_anchor2(apart * if first { -1.0 } else { -0.5 });
                    world.multibody_joints.insert(parent, body, joint, true).expect("it fits");
                }
                parent = Some(body);
            }
            for index in world.bodies.iter().map(|(body, _)| body).collect::<Vec<_>>() {
                let link = world.multibody_joints.rigid_body_link(index).copied();
                let index = link.expect("a link").multibody;
                let multibody = world.multibody_joints.get_multibody_mut(index).expect("there");
                multibody.set_self_contacts_enabled(false);
            }
            let (first, mut most) = (energy(&world), energy(&world));
            for _ in 0..steps(&world, 3.0) {
                world.step();
                most = most.max(energy(&world));
            }
            let fall = 5.0 * G * (1.5 - RADIUS);
            let (gain, left) = ((most - first) / fall, 1.0 + (energy(&world) - first) / fall);
            table.row([
                rate.to_string(),
                name.to_string(),
                format!("{gain:+.4}"),
                format!("{left:.4}"),
            ]);
            // Impacts are accurate to second order in the links' angle per substep, at about 20 rad/s. Single
            // impacts on links directly after another impact leave up to 7 % at any rate; this error is
            // unresolved.
            let tolerance = 0.1 + (10.0 / rate as Real).powi(2);
            table.require(gain < tolerance, &format!("gains {gain}, more than {tolerance}"));
        }
    }
}

/// A light rod and a heavy box are welded together and land on one corner after the other; some of
/// the impacts are elastic. The rod is the root of the tree and rotates about the box. The many
/// rounds of impacts in a substep, with corners in resting contact, must add no energy.
#[test]
fn welded_bodies_that_land_on_corners_gain_no_energy() {
    let mut table = Table::new("rod and box, 2 s", &["rate", "angle", "spin", "gain"]);
    for rate in RATES {
        for k in 0..24_u8 {
            let (angle, spin) = (0.5 * Real::from(k), Real::from(k % 5) - 2.0);
            let mut world = world(rate);
            add_ground(&mut world, 0.0);
            let turn = about_z(angle);
            let part = |arm: Vector| {
                let arm = Pose::new(Vector::ZERO, turn).rotation * arm;
                let velocity = vec(0.0, -2.0) + vec(-arm.y, arm.x) * spin;
                let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 2.5) + arm);
                body.rotation(turn).linvel(velocity).angvel(tumble(spin, 1.0)).can_sleep(false)
            };
            let rod = ColliderBuilder::capsule_x(0.4, 0.1).friction(0.0).mass(0.1);
            let (rod, _) = world.insert(part(vec(-1.5, 0.0)), rod);
            let heavy = cuboid(0.4, 0.2).friction(0.0).mass(0.7).restitution(0.5);
            let (heavy, _) = world.insert(part(Vector::ZERO), heavy);
            let weld = FixedJointBuilder::new().local_anchor1(vec(1.5, 0.0));
            world.multibody_joints.insert(rod, heavy, weld, true).expect("it fits");
            let (first, mut most) = (energy(&world), energy(&world));
            for _ in 0..steps(&world, 2.0) {
                world.step();
                most = most.max(energy(&world));
            }
            let gain = (most - first) / first;
            table.row([
                rate.to_string(),
                format!("{angle:.1}"),
                spin.to_string(),
                format!("{gain:+.4}"),
            ]);
            // The reason is the same, for a rotation of the whole at about 10 rad/s.
            let tolerance = 0.02 + (5.0 / rate as Real).powi(2);
            table.require(gain < tolerance, &format!("gains {gain}, more than {tolerance}"));
        }
    }
}

/// A ball falls on a pair of welded balls of the same total mass that lies on inelastic ground. The
/// impact drives the pair into the ground at up to the speed of the ball. The lost energy never
/// returns: the support by the ground is no impact on the falling ball, whether it is a body or a
/// link.
#[test]
fn energy_lost_in_an_impact_does_not_return() {
    let columns = ["rate", "is a link", "restitution", "gain"];
    let mut table = Table::new("ball on a pair on the ground", &columns);
    for rate in RATES {
        for is_link in [false, true] {
            for restitution in [0.1, 0.3, 0.5] {
                let mut world = world(rate);
                add_ground(&mut world, 0.0);
                let mut insert = |height: Real, restitution: Real, is_pair: bool| {
                    let mass = if is_pair { 0.5 } else { 1.0 };
                    let ball = ColliderBuilder::ball(RADIUS).friction(0.0);
                    let ball = ball.restitution(restitution).mass(mass);
                    let body = |x: Real| {
                        RigidBodyBuilder::dynamic().translation(vec(x, height)).can_sleep(false)
                    };
                    let (first, _) = world.insert(body(0.0), ball.clone());
                    if is_pair {
                        let (second, _) = world.insert(body(2.0 * RADIUS), ball);
                        let weld = FixedJointBuilder::new().local_anchor1(vec(2.0 * RADIUS, 0.0));
                        world.multibody_joints.insert(first, second, weld, true).expect("it fits");
                    }
                };
                insert(RADIUS, 0.0, true);
                // The combined coefficient of two materials is the mean.
                insert(3.0 * RADIUS + 1.0, 2.0 * restitution, is_link);
                let (mut least, mut gain): (Real, Real) = (energy(&world), 0.0);
                for _ in 0..steps(&world, 2.0) {
                    world.step();
                    least = least.min(energy(&world));
                    gain = gain.max((energy(&world) - least) / G);
                }
                table.row([
                    rate.to_string(),
                    is_link.to_string(),
                    restitution.to_string(),
                    format!("{gain:+.4}"),
                ]);
                // In a substep the impact drives the pair into the ground, and the ball into the pair, by up
                // to its speed times `h`. Soft contacts push a mass of 1, and of 2, out again.
                let tolerance = 3.0 * (2.0 * G).sqrt() * substep(&world);
                table.require(gain < tolerance, &format!("gains {gain}, more than {tolerance}"));
            }
        }
    }
}

/// A striker of two welded bodies of the total mass 1 hits a row of balls of mass 1. One of the balls may be
/// a link. The last ball leaves at the speed of the striker.
#[test]
fn links_transmit_an_impact() {
    let columns = ["rate", "link in the row", "last (m/s)", "others (m/s)", "energy"];
    let mut table = Table::new("row of balls hit by a link at 3 m/s", &columns);
    for rate in RATES {
        for link in [None, Some(2), Some(4)] {
            let mut world = weightless(rate);
            let mut insert = |x: Real, v: Real, is_pair: bool| {
                let mass = if is_pair { 0.5 } else { 1.0 };
                let body = |x: Real| {
                    RigidBodyBuilder::dynamic().translation(vec(x, 0.0)).linvel(vec(v, 0.0))
                };
                let (first, _) = world.insert(body(x), ball(1.0).mass(mass));
                if is_pair {
                    let second = world
                        .insert_body(bob(mass, 0.1).translation(vec(x, 0.0)).linvel(vec(v, 0.0)));
                    let weld = FixedJointBuilder::new();
                    world.multibody_joints.insert(second, first, weld, true).expect("it fits");
                }
                first
            };
            insert(-2.0 * 2.0 * RADIUS, 3.0, true);
            let balls: Vec<_> =
                (0..5).map(|k| insert(2.0 * RADIUS * k as Real, 0.0, link == Some(k))).collect();
            run(&mut world, 0.4);
            let speed = |k: usize| world.bodies[balls[k]].linvel().x;
            let others = (0..4).map(|k| speed(k).abs()).fold(0.0, Real::max);
            let energy: Real = world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum();
            table.row([
                rate.to_string(),
                format!("{link:?}"),
                format!("{:.4}", speed(4)),
                format!("{others:.4}"),
                format!("{:+.2e}", energy / 4.5 - 1.0),
            ]);
            // An approach below one centimetre per second stops without a bounce.
            table.check("the last one's speed", speed(4), 3.0, 0.03);
            table.require(energy < 4.5 * 1.0001, "the energy does not rise");
        }
    }
}

/// Newton's cradle of arms, each a multibody of its own, or all branches of one multibody: the last
/// ball leaves, the others stay.
#[test]
fn a_cradle_of_links() {
    let columns = ["rate", "roots", "speeds a tenth of a second after the impact"];
    let mut table = Table::new("cradle of 5 links at 2 m/s", &columns);
    let (length, angle): (Real, Real) = (2.0, -0.1);
    for rate in RATES {
        for is_one in [false, true] {
            let mut world = world(rate);
            let beam = world.insert_body(RigidBodyBuilder::fixed().translation(vec(0.0, length)));
            let mut balls = Vec::new();
            for k in 0..5 {
                let angle = if k == 0 { angle } else { 0.0 };
                let post = vec(2.0 * RADIUS * k as Real, length);
                let fallen = 2.0 * G * length * (1.0 - angle.cos());
                let spin = if k == 0 { (4.0 - fallen).sqrt() / length } else { 0.0 };
                let body = RigidBodyBuilder::dynamic()
                    .translation(post + vec(angle.sin(), -angle.cos()) * length)
                    .rotation(crate::dim::about_z(angle))
                    .linvel(vec(angle.cos(), angle.sin()) * (spin * length))
                    .angvel(crate::dim::about_z(spin))
                    .can_sleep(false);
                let (body, _) = world.insert(body, ball(1.0).mass(1.0));
                let root = if is_one {
                    beam
                } else {
                    world.insert_body(RigidBodyBuilder::fixed().translation(post))
                };
                let at = if is_one { post - vec(0.0, length) } else { Vector::ZERO };
                let joint = hinge().local_anchor1(at).local_anchor2(vec(0.0, length));
                world.multibody_joints.insert(root, body, joint, true).expect("it fits");
                balls.push(body);
            }
            run(&mut world, 0.2);
            let speeds: Vec<_> =
                balls.iter().map(|&ball| world.bodies[ball].linvel().length()).collect();
            let listed: Vec<_> = speeds.iter().map(|speed| format!("{speed:.3}")).collect();
            table.row([
                rate.to_string(),
                if is_one { "one" } else { "five" }.to_string(),
                listed.join(" "),
            ]);
            // After a tenth of a second a ball has risen by 2 cm, which reduces its speed by 0.1 m/s.
            for (k, speed) in speeds.into_iter().enumerate() {
                table.check("the speed", speed, if k == 4 { 1.9 } else { 0.0 }, 0.1);
            }
        }
    }
}
