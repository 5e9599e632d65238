//! Hard impacts: for all pairs of bodies and all speeds, energy never grows, and other bodies are
//! unaffected.

use super::stage::{Dice, add_ground, run, steps, weightless, world};
use super::table::Table;
use crate::dim::{about_z, components, cuboid, vec};
use rapier::prelude::*;

/// Radius of balls, and half the side of boxes (m).
pub const RADIUS: Real = 0.25;

/// Returns a collider with restitution `e` and this friction for all pairs.
pub fn surface(collider: ColliderBuilder, e: Real, friction: Real) -> ColliderBuilder {
    let collider = collider.restitution(e).friction(friction).mass(1.0);
    let collider = collider.restitution_combine_rule(CoefficientCombineRule::Max);
    collider.friction_combine_rule(CoefficientCombineRule::Max)
}

/// A ball with restitution `e` and this friction for all pairs.
pub fn ball(e: Real, friction: Real) -> ColliderBuilder {
    surface(ColliderBuilder::ball(RADIUS), e, friction)
}

/// Returns the kinetic energy of all bodies (J).
fn energy(world: &PhysicsWorld) -> Real {
    world.bodies.iter().map(|(_, body)| body.kinetic_energy()).sum()
}

/// Returns the momentum of all bodies (kg m/s).
fn momentum(world: &PhysicsWorld) -> Vector {
    world.bodies.iter().map(|(_, body)| body.linvel() * body.mass()).sum()
}

/// Returns the largest energy within this time, as a fraction of the initial energy, and the last one.
fn energies(world: &mut PhysicsWorld, seconds: Real) -> [Real; 2] {
    let first = energy(world);
    let (mut most, mut last): (Real, Real) = (0.0, 1.0);
    for _ in 0..steps(world, seconds) {
        world.step();
        last = energy(world) / first;
        most = most.max(last);
    }
    [most, last]
}

/// Adds four walls around the origin, at this distance.
fn add_walls(world: &mut PhysicsWorld, away: Real, e: Real, friction: Real) {
    for (x, y, across, up) in [
        (1.0, 0.0, 1.0, away + 2.0),
        (-1.0, 0.0, 1.0, away + 2.0),
        (0.0, 1.0, away + 2.0, 1.0),
        (0.0, -1.0, away + 2.0, 1.0),
    ] {
        let wall = surface(cuboid(across, up), e, friction);
        world.insert_collider(wall.translation(vec(x, y) * (away + 1.0)), None);
    }
}

/// The kinetic energy of spinning balls and boxes in a closed box never grows. Ranges: restitution 0 to 1,
/// friction 0 to 2, speeds up to 100 m/s.
#[test]
fn spinning_crowds_do_not_gain_energy() {
    let columns = ["shape", "e", "friction", "speed", "highest", "left"];
    let mut table = Table::new("16 bodies in a box, 1 s", &columns);
    for (name, shape) in [("ball", ColliderBuilder::ball(RADIUS)), ("box", cuboid(RADIUS, RADIUS))]
    {
        for e in [0.0, 0.3, 0.8, 1.0] {
            for friction in [0.0, 0.3, 2.0] {
                for speed in [1.0, 10.0, 100.0] {
                    let mut world = weightless(60);
                    let mut dice = Dice(11);
                    add_walls(&mut world, 2.5, e, friction);
                    for k in 0..16 {
                        let place = vec((k % 4) as Real - 1.5, (k / 4) as Real - 1.5);
                        let velocity = vec(dice.within(-speed, speed), dice.within(-speed, speed));
                        let spin = about_z(dice.within(-20.0, 20.0));
                        let body = RigidBodyBuilder::dynamic()
                            .translation(place)
                            .linvel(velocity)
                            .angvel(spin)
                            .ccd_enabled(true)
                            .can_sleep(false);
                        let own = e * (k % 3) as Real / 2.0;
                        world.insert(body, surface(shape.clone(), own, friction));
                    }
                    let [most, last] = energies(&mut world, 1.0);
                    table.row([
                        name.to_string(),
                        e.to_string(),
                        friction.to_string(),
                        speed.to_string(),
                        format!("{most:.5}"),
                        format!("{last:.5}"),
                    ]);
                    table.require(most < 1.001, &format!("energy rises to {most}"));
                }
            }
        }
    }
}

/// A spinning ball hits a floating column. Energy does not grow, and momentum is constant.
#[test]
fn stacks_that_are_hit_do_not_gain_energy() {
    let columns = ["shape", "e", "friction", "speed", "highest", "left"];
    let mut table = Table::new("stack of 6 that is hit from the side, 0.5 s", &columns);
    for (name, shape) in [("ball", ColliderBuilder::ball(RADIUS)), ("box", cuboid(RADIUS, RADIUS))]
    {
        for e in [0.0, 0.5, 1.0] {
            for friction in [0.0, 0.5, 2.0] {
                for speed in [1.0, 10.0, 30.0, 100.0] {
                    let mut world = weightless(60);
                    for k in 0..6 {
                        let body = RigidBodyBuilder::dynamic()
                            .translation(vec(0.0, 2.0 * RADIUS * k as Real));
                        world.insert(body, surface(shape.clone(), e, friction));
                    }
                    let ram = RigidBodyBuilder::dynamic()
                        .translation(vec(-1.0, 0.6))
                        .linvel(vec(speed, 0.0))
                        .angvel(about_z(10.0))
                        .ccd_enabled(true);
                    world.insert(ram, ball(e, friction));
                    let before = momentum(&world);
                    let [most, last] = energies(&mut world, 0.5);
                    let lost = (momentum(&world) - before).length() / speed;
                    table.row([
                        name.to_string(),
                        e.to_string(),
                        friction.to_string(),
                        speed.to_string(),
                        format!("{most:.5}"),
                        format!("{last:.5}"),
                    ]);
                    table.require(most < 1.001, &format!("energy rises to {most}"));
                    table.check("the lost momentum", lost, 0.0, 1.0e-4);
                }
            }
        }
    }
}

/// Impact of two balls with the masses `m1`, `m2` and the coefficient of restitution `e`:
/// `v1' = (m1 - e m2) v / (m1 + m2)`, `v2' = (1 + e) m1 v / (m1 + m2)`.
#[test]
fn unequal_masses_separate_by_newtons_law() {
    let mut table =
        Table::new("ball on ball at 3 m/s", &["ratio", "e", "speed", "first", "second"]);
    for ratio in [0.001, 0.1, 1.0, 10.0, 1000.0] {
        for e in [0.0, 0.5, 1.0] {
            for speed in [3.0, 30.0] {
                let mut world = weightless(60);
                let first = RigidBodyBuilder::dynamic()
                    .translation(vec(-1.0, 0.0))
                    .linvel(vec(speed, 0.0))
                    .ccd_enabled(true);
                let (first, _) = world.insert(first, ball(e, 0.0));
                let second = RigidBodyBuilder::dynamic();
                let (second, _) = world.insert(second, ball(e, 0.0).mass(ratio));
                run(&mut world, 0.5);
                let after = [first, second].map(|body| world.bodies[body].linvel().x);
                table.row([
                    ratio.to_string(),
                    e.to_string(),
                    speed.to_string(),
                    format!("{:.4}", after[0]),
                    format!("{:.4}", after[1]),
                ]);
                let sum = 1.0 + ratio;
                let tolerance = 1.0e-4 * speed;
                table.check("the first", after[0], (1.0 - e * ratio) * speed / sum, tolerance);
                table.check("the second", after[1], (1.0 + e) * speed / sum, tolerance);
            }
        }
    }
}

/// An elastic ball between two walls keeps its speed and stays between them.
#[test]
fn a_ball_between_two_walls() {
    let columns = ["gap", "speed", "foresight", "highest", "left", "outside"];
    let mut table = Table::new("elastic ball between walls, 1 s", &columns);
    for gap in [0.01, 0.1, 1.0] {
        for speed in [2.0, 10.0, 100.0] {
            // A wall without a contact in the step of the other impact cannot stop the ball in that step.
            for foresight in [false, true] {
                if !foresight && speed / 60.0 > gap {
                    continue;
                }
                let mut world = weightless(60);
                let half = RADIUS + 0.5 * gap;
                for side in [-1.0, 1.0] {
                    let wall = surface(cuboid(5.0, 2.0), 1.0, 0.0);
                    world.insert_collider(wall.translation(vec(side * (half + 5.0), 0.0)), None);
                }
                let body = RigidBodyBuilder::dynamic()
                    .linvel(vec(speed, 0.0))
                    .soft_ccd_prediction(if foresight { speed / 30.0 } else { 0.0 });
                let (body, _) = world.insert(body, ball(1.0, 0.0));
                let (mut outside, first): (Real, Real) = (0.0, energy(&world));
                let mut most: Real = 0.0;
                for _ in 0..60 {
                    world.step();
                    most = most.max(energy(&world) / first);
                    let beyond = world.bodies[body].translation().x.abs() - 0.5 * gap;
                    outside = outside.max(beyond);
                }
                let left = energy(&world) / first;
                table.row([
                    gap.to_string(),
                    speed.to_string(),
                    foresight.to_string(),
                    format!("{most:.5}"),
                    format!("{left:.5}"),
                    format!("{outside:.4}"),
                ]);
                table.require(most < 1.0001, "energy grows");
                table.require(left > 0.99, "energy is lost");
                table.check("how far it is in a wall", outside, 0.0, speed / 240.0);
            }
        }
    }
}

/// A symmetric body that two equal balls hit on both sides at the same time keeps its symmetry.
#[test]
fn symmetric_impacts_stay_symmetric() {
    let columns = ["between", "e", "speed", "left", "right", "middle"];
    let mut table = Table::new("balls that come from both sides", &columns);
    for between in 1..=5 {
        for e in [0.1, 0.5, 1.0] {
            for speed in [2.0, 20.0] {
                let mut world = weightless(60);
                let half = 0.5 * (between - 1) as Real;
                let middle: Vec<_> = (0..between)
                    .map(|k| {
                        let at = vec((k as Real - half) * 2.0 * RADIUS, 0.0);
                        let body = RigidBodyBuilder::dynamic().translation(at);
                        world.insert(body, ball(e, 0.0)).0
                    })
                    .collect();
                let sides = [-1.0, 1.0].map(|side| {
                    let body = RigidBodyBuilder::dynamic()
                        .translation(vec(side * (half * 2.0 * RADIUS + 1.0), 0.0))
                        .linvel(vec(-side * speed, 0.0));
                    world.insert(body, ball(e, 0.0)).0
                });
                run(&mut world, 0.6);
                let x = |body: RigidBodyHandle| world.bodies[body].linvel().x;
                let [left, right] = sides.map(x);
                let sums = (0..between).map(|k| (x(middle[k]) + x(middle[between - 1 - k])).abs());
                let worst = sums.fold(0.0, Real::max);
                table.row([
                    between.to_string(),
                    e.to_string(),
                    speed.to_string(),
                    format!("{left:.4}"),
                    format!("{right:.4}"),
                    format!("{worst:.5}"),
                ]);
                table.check("the sum of the outer two", left + right, 0.0, 2.0e-3 * speed);
                table.check("the sum of inner pairs", worst, 0.0, 2.0e-3 * speed);
            }
        }
    }
}

/// A ball breaks a rack of 15 elastic balls: momentum and energy are constant.
#[test]
fn a_break_shot_keeps_momentum_and_energy() {
    let columns = ["speed", "momentum", "aside", "energy", "moving", "asymmetry"];
    let mut table = Table::new("break shot", &columns);
    for speed in [2.0, 10.0, 30.0] {
        let mut world = weightless(240);
        let insert = |world: &mut PhysicsWorld, at: Vector, v: Vector| {
            let body = RigidBodyBuilder::dynamic().translation(at).linvel(v).can_sleep(false);
            world.insert(body, ball(1.0, 0.0)).0
        };
        let cue = insert(&mut world, vec(-1.5, 0.0), vec(speed, 0.0));
        let mut balls = vec![cue];
        let long = 2.0 * RADIUS * (0.75 as Real).sqrt();
        for row in 0..5 {
            for k in 0..=row {
                let y = (k as Real - 0.5 * row as Real) * 2.0 * RADIUS;
                balls.push(insert(&mut world, vec(row as Real * long, y), Vector::ZERO));
            }
        }
        let [most, left] = energies(&mut world, 2.0 / speed + 0.2);
        let p = momentum(&world);
        let moving = balls.iter().filter(|&&b| world.bodies[b].linvel().length() > 0.01 * speed);
        let moving = moving.count();
        let up: Real = balls
            .iter()
            .map(|&b| {
                let v = world.bodies[b].linvel();
                v.y * v.length()
            })
            .sum::<Real>()
            / (speed * speed);
        table.row([
            speed.to_string(),
            format!("{:+.2e}", p.x / speed - 1.0),
            format!("{:+.2e}", p.y / speed),
            format!("{left:.4}"),
            moving.to_string(),
            format!("{up:.4}"),
        ]);
        table.check("the momentum", p.x, speed, 1.0e-4 * speed);
        table.check("the momentum aside", p.y, 0.0, 1.0e-4 * speed);
        table.require(most < 1.001, "energy grows");
        table.require(left > 0.95, "energy is lost");
        table.check("how much one side gets more", up, 0.0, 0.01);
    }
}

/// A body without contact is not pushed: its bits are constant.
#[test]
fn impacts_do_not_cross_a_gap() {
    for e in [0.0, 0.5, 1.0] {
        let mut world = weightless(60);
        let near = RigidBodyBuilder::dynamic().linvel(vec(-20.0, 0.0)).translation(vec(2.0, 0.0));
        world.insert(near, ball(e, 0.5));
        let stands = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.0));
        world.insert(stands, ball(e, 0.5).mass(1000.0));
        // The other bodies are within the prediction distance, above and below the impact.
        let others = [1.0, -1.0].map(|side| {
            let body = RigidBodyBuilder::dynamic().translation(vec(0.1, side * 0.505));
            world.insert(body, ball(e, 0.5)).0
        });
        for _ in 0..8 {
            world.step();
        }
        for body in others {
            let body = &world.bodies[body];
            assert_eq!((body.linvel(), z(body)), (Vector::ZERO, 0.0), "e = {e}");
        }
    }
}

fn z(body: &RigidBody) -> Real {
    crate::dim::z_of(body.angvel())
}

/// An impact wakes a sleeping body, which bounces as if it had been awake.
#[test]
fn sleeping_bodies_bounce_like_awake_ones() {
    for e in [0.0, 0.5, 1.0] {
        let hit = |asleep: bool| {
            let mut world = world(60);
            let ground = add_ground(&mut world, 0.5);
            world.colliders[ground].set_restitution(e);
            let rest = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.25));
            let rests: Vec<_> = (0..3)
                .map(|k| {
                    let at = vec(2.0 * RADIUS * k as Real, RADIUS);
                    world
                        .insert(
                            rest.clone().translation(at),
                            surface(cuboid(RADIUS, RADIUS), e, 0.0),
                        )
                        .0
                })
                .collect();
            run(&mut world, 4.0);
            assert!(rests.iter().all(|&body| world.bodies[body].is_sleeping()));
            if !asleep {
                rests.iter().for_each(|&body| world.bodies[body].wake_up(true));
            }
            let comes =
                RigidBodyBuilder::dynamic().translation(vec(-1.0, RADIUS)).linvel(vec(6.0, 0.0));
            let (comes, _) = world.insert(comes, surface(cuboid(RADIUS, RADIUS), e, 0.0));
            run(&mut world, 0.25);
            let all = rests.iter().chain([&comes]);
            all.map(|&body| world.bodies[body].linvel().x).collect::<Vec<_>>()
        };
        let (asleep, awake) = (hit(true), hit(false));
        for (a, b) in asleep.iter().zip(&awake) {
            assert!((a - b).abs() < 0.02, "{asleep:?} instead of {awake:?}, e = {e}");
        }
    }
}

/// Islands are independent to the last bit.
#[test]
fn impacts_of_other_islands_change_nothing() {
    let swing = |disturbed: bool| {
        let mut world = world(60);
        let mut last = world.insert_body(RigidBodyBuilder::fixed());
        let links: Vec<_> = (0..6)
            .map(|k| {
                let body = RigidBodyBuilder::dynamic().translation(vec(0.5 + k as Real, 0.0));
                let (next, _) = world.insert(body, ball(0.5, 0.5));
                let joint =
                    crate::dim::hinge().local_anchor1(vec(if k == 0 { 0.0 } else { 0.5 }, 0.0));
                world.insert_impulse_joint(last, next, joint.local_anchor2(vec(-0.5, 0.0)));
                last = next;
                next
            })
            .collect();
        let comes = RigidBodyBuilder::dynamic().translation(vec(20.0, 0.0)).linvel(vec(6.0, 0.0));
        world.insert(comes, ball(1.0, 0.0));
        let away = if disturbed { 22.0 } else { 200.0 };
        let stands = RigidBodyBuilder::dynamic().translation(vec(away, 0.0)).can_sleep(false);
        world.insert(stands, ball(1.0, 0.0));
        run(&mut world, 1.0);
        let poses = links.iter().map(|&link| components(world.bodies[link].position()));
        poses.collect::<Vec<_>>()
    };
    assert_eq!(swing(false), swing(true));
}

/// A box slides into a wall, and an elastic ball follows it. The contact of box and wall must not
/// give the ball any velocity.
#[test]
fn a_stop_is_no_impact_on_other_bodies() {
    let columns = ["wall", "gap", "speed", "highest", "left"];
    let mut table = Table::new("ball behind a box that hits a wall", &columns);
    for wall in [0.0, 0.5, 1.0] {
        for gap in [0.0, 0.001, 0.02, 0.1] {
            for speed in [0.9, 3.0, 10.0, 60.0] {
                let mut world = weightless(60);
                let shape = cuboid(0.25, 1.0).restitution(wall);
                let shape = shape.restitution_combine_rule(CoefficientCombineRule::Min);
                world.insert_collider(shape.translation(vec(0.95, 0.0)), None);
                let shape = cuboid(RADIUS, RADIUS).mass(1.0).restitution(wall).friction(0.0);
                let body = RigidBodyBuilder::dynamic().linvel(vec(speed, 0.0)).can_sleep(false);
                world.insert(body.clone(), shape);
                let body = body.translation(vec(-2.0 * RADIUS - gap, 0.0));
                world.insert(body, ball(1.0, 0.0));
                let [most, last] = energies(&mut world, 0.7);
                table.row([
                    wall.to_string(),
                    gap.to_string(),
                    speed.to_string(),
                    format!("{most:.5}"),
                    format!("{last:.5}"),
                ]);
                table.require(most < 1.0005, "energy grows");
            }
        }
    }
}

/// A body that a force presses against a wall stays there: it approaches in every substep without an impact.
#[test]
fn bodies_under_load_stay_at_rest() {
    for force in [10.0, 1000.0, 10_000.0] {
        let mut world = weightless(60);
        world
            .insert_collider(surface(cuboid(1.0, 3.0), 1.0, 0.0).translation(vec(1.25, 0.0)), None);
        let body = RigidBodyBuilder::dynamic().can_sleep(false);
        let (body, _) = world.insert(body, ball(1.0, 0.0));
        world.bodies[body].add_force(vec(force, 0.0), true);
        for step in 0..120 {
            world.step();
            let body = &world.bodies[body];
            // A soft contact yields first.
            assert!(step < 60 || body.linvel().length() < 1.0e-3, "{force} N: {}", body.linvel());
            assert!(body.translation().x > -1.0e-3, "{force} N: {}", body.translation());
        }
    }
}
