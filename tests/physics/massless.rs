//! Dynamic bodies without mass. Gravity is a force, `m g`: without mass it is zero, as every other force has
//! no effect. Such a body keeps its velocity, and contacts and joints cannot move it.

use super::stage::{RATES, rounding, run, steps, world};
use super::table::Table;
use crate::dim::{cuboid, hinge, vec};
use rapier::prelude::*;

type Kind =
    (&'static str, fn(RigidBodyBuilder) -> RigidBodyBuilder, fn() -> Option<ColliderBuilder>);

/// Bodies without mass, for every reason.
fn kinds() -> [Kind; 8] {
    [
        ("no collider", |body| body, || None),
        ("density 0", |body| body, || Some(ColliderBuilder::ball(0.5).density(0.0))),
        ("mass 0", |body| body, || Some(ColliderBuilder::ball(0.5).mass(0.0))),
        ("a sensor", |body| body, || Some(ColliderBuilder::ball(0.5).density(0.0).sensor(true))),
        ("additional mass 0", |body| body.additional_mass(0.0), || None),
        ("gravity scale 5", |body| body.gravity_scale(5.0), || None),
        ("locked rotations", |body| body.lock_rotations(), || None),
        ("a bullet", |body| body.ccd_enabled(true), || None),
    ]
}

/// A body at rest stays at its place, whatever forces act on it. A body with a velocity keeps it: `x = v t`.
#[test]
fn a_body_without_mass_keeps_its_velocity() {
    let columns = ["kind", "rate", "at rest: moved (m)", "thrown: error (m)", "speed (m/s)"];
    let mut table = Table::new("bodies without mass after 2 s, one thrown with 5 m/s", &columns);
    for (name, settings, shape) in kinds() {
        for rate in RATES {
            let mut world = world(rate);
            let velocity = vec(3.0, 4.0);
            let [rest, thrown] = [(0.0, Vector::ZERO), (50.0, velocity)].map(|(x, linvel)| {
                let body = RigidBodyBuilder::dynamic().translation(vec(x, 1.0)).linvel(linvel);
                let body = world.insert_body(settings(body));
                if let Some(shape) = shape() {
                    world.insert_collider(shape, Some(body));
                }
                world.bodies[body].add_force(vec(100.0, -30.0), true);
                world.bodies[body].apply_impulse(vec(-7.0, 9.0), true);
                body
            });
            run(&mut world, 2.0);
            let moved = (world.bodies[rest].translation() - vec(0.0, 1.0)).length();
            let error = world.bodies[thrown].translation() - (vec(50.0, 1.0) + velocity * 2.0);
            let speed = world.bodies[thrown].linvel().length();
            let figures =
                [format!("{moved:.1e}"), format!("{:.1e}", error.length()), speed.to_string()];
            let [at_rest, of_thrown, fast] = figures;
            table.row([name.into(), rate.to_string(), at_rest, of_thrown, fast]);
            table.check("the movement at rest", moved, 0.0, 0.0);
            let tolerance = rounding(4 * steps(&world, 2.0), 60.0);
            table.check("the error of the path", error.length(), 0.0, tolerance);
            table.check("the speed", speed, 5.0, 0.0);
        }
    }
}

/// A body that loses its mass in mid-air keeps its velocity, and falls again with a new mass.
#[test]
fn gravity_acts_as_long_as_there_is_mass() {
    let mut world = world(60);
    let (body, collider) = world.insert(RigidBodyBuilder::dynamic(), ColliderBuilder::ball(0.5));
    run(&mut world, 0.5);
    world.colliders[collider].set_density(0.0);
    world.step();
    let speed = world.bodies[body].linvel().y;
    run(&mut world, 1.0);
    assert!(speed < -4.0 && world.bodies[body].linvel().y == speed, "{speed} m/s without mass");
    world.colliders[collider].set_density(1.0);
    run(&mut world, 0.5);
    assert!(world.bodies[body].linvel().y < speed - 4.0, "with mass it falls on");
}

/// What hangs on a body without mass moves as if it hung on a fixed body.
#[test]
fn a_body_without_mass_is_an_anchor() {
    let anchors = [vec(0.0, 0.0), vec(-1.0, 0.0)];
    let joints: [(&str, GenericJoint); 5] = [
        ("hinge", hinge().local_anchor1(anchors[0]).local_anchor2(anchors[1]).build().into()),
        ("fixed", FixedJointBuilder::new().local_anchor2(anchors[1]).build().into()),
        ("rope", RopeJointBuilder::new(1.5).build().into()),
        ("spring", SpringJointBuilder::new(Vector::ZERO, Vector::ZERO, 1.0, 50.0).build().into()),
        ("slider", PrismaticJointBuilder::new(Vector::Y).local_anchor2(anchors[1]).build().into()),
    ];
    let mut table =
        Table::new("weights on an anchor after 1 s", &["joint", "x", "y", "anchor moved"]);
    for (name, joint) in joints {
        let [on_fixed, on_massless] =
            [RigidBodyBuilder::fixed(), RigidBodyBuilder::dynamic()].map(|hook| {
                let mut world = world(60);
                let hook = world.insert_body(hook.translation(vec(2.0, 10.0)));
                let weight = RigidBodyBuilder::dynamic().translation(vec(3.0, 10.0));
                let (weight, _) = world.insert(weight, cuboid(0.25, 0.25));
                world.insert_impulse_joint(hook, weight, joint);
                run(&mut world, 1.0);
                (world.bodies[weight].translation(), world.bodies[hook].translation())
            });
        let moved = (on_massless.1 - vec(2.0, 10.0)).length();
        let [x, y] = [on_massless.0.x, on_massless.0.y].map(|number| format!("{number:.4}"));
        table.row([name.into(), x, y, format!("{moved:.1e}")]);
        table.check("the movement of the anchor", moved, 0.0, 0.0);
        // The two solve the same equations, but may do so in another order.
        table.check("the weight", (on_massless.0 - on_fixed.0).length(), 0.0, 1.0e-4);
    }
}

/// A plate without mass carries a weight in mid-air.
#[test]
fn a_body_without_mass_carries_others() {
    for rate in RATES {
        let mut world = world(rate);
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 5.0));
        let (plate, _) = world.insert(body, cuboid(2.0, 0.5).density(0.0));
        let weight = RigidBodyBuilder::dynamic().translation(vec(0.0, 7.0));
        let (weight, _) = world.insert(weight, cuboid(0.5, 0.5));
        run(&mut world, 3.0);
        let [plate, weight] = [plate, weight].map(|body| world.bodies[body].translation());
        // A resting contact overlaps by the allowed error, one millimetre, and half as much again.
        let height = weight.y - 6.0;
        assert!(plate == vec(0.0, 5.0) && height.abs() < 2.0e-3, "{plate}, {weight} at {rate} Hz");
    }
}
