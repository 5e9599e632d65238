//! Chains of thin limbs in impacts gain no energy (3D).

use crate::suite::physics::stage::{Dice, G, run, steps, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Adds four capsules side by side, connected by ball joints and thrown along X.
fn throw(world: &mut PhysicsWorld, speed: Real, friction: Real) -> Vec<RigidBodyHandle> {
    let mut links = Vec::new();
    for k in 0..4_u8 {
        let k = Real::from(k);
        let place = Vector::new(-2.0, 1.4 + 0.1 * k, 0.3 * (k - 1.5));
        let body = RigidBodyBuilder::dynamic().translation(place).linvel(Vector::X * speed);
        let capsule = ColliderBuilder::capsule_z(0.1, 0.05).friction(friction);
        let (body, _) = world.insert(body.can_sleep(false), capsule);
        if let Some(&last) = links.last() {
            let joint = SphericalJointBuilder::new()
                .local_anchor1(Vector::new(0.0, 0.05, 0.15))
                .local_anchor2(Vector::new(0.0, -0.05, -0.15));
            world.insert_multibody_joint(last, body, joint).expect("the joint fits");
        }
        links.push(body);
    }
    links
}

/// Returns the energy of the links relative to the ground.
fn energy(world: &PhysicsWorld, links: &[RigidBodyHandle]) -> Real {
    let of = |body: &RigidBody| body.kinetic_energy() + body.mass() * G * body.translation().y;
    links.iter().map(|&link| of(&world.bodies[link])).sum()
}

/// Walls, ground and joints do no work. The correction of an overlap does: the overlap of 5 mm at
/// these speeds must lift no link by more than that.
#[test]
fn chains_that_hit_a_corner_gain_no_energy() {
    let mut table = Table::new("chains thrown into a corner", &["speed", "friction", "most"]);
    for speed in [5.0, 10.0, 20.0, 40.0, 80.0, 200.0] {
        for friction in [0.0, 0.5] {
            let mut world = world(60);
            let ground = ColliderBuilder::cuboid(60.0, 1.0, 60.0);
            world.insert_collider(ground.translation(Vector::NEG_Y), None);
            let wall = ColliderBuilder::cuboid(1.0, 30.0, 30.0);
            world.insert_collider(wall.translation(Vector::X), None);
            let links = throw(&mut world, speed, friction);
            let (start, mut most) = (energy(&world, &links), 0.0);
            for _ in 0..steps(&world, 5.0) {
                run(&mut world, 1.0 / 60.0);
                most = Real::max(most, energy(&world, &links) / start);
            }
            table.row([speed, friction, most].map(|number| format!("{number:.3}")));
            table.require(most < 1.05, "energy came from nowhere");
        }
    }
}

/// A socket joins a rod and a ball at the ends of long arms. A rotation of one or two degrees in a substep
/// moves the end of such an arm far. Contacts that do not follow this motion add energy. Gravity alone does
/// work here.
#[test]
fn bodies_on_long_arms_gain_no_energy_from_the_ground() {
    let mut table = Table::new("thrown on the ground", &["case", "largest gain in a step"]);
    let mut dice = Dice(1);
    for case in 0..200_u16 {
        let mut world = world(60);
        world.insert_collider(ColliderBuilder::halfspace(Vector::Y), None);
        let at =
            if case % 2 == 0 { Vector::new(0.0, 2.5, 0.0) } else { Vector::new(1.5, 1.0, 0.0) };
        let places = [Vector::new(3.0, 1.0, 0.0), at];
        let shapes = [ColliderBuilder::capsule_x(0.4, 0.12), ColliderBuilder::ball(0.4)];
        let restitution = if case % 3 == 0 { 0.0 } else { dice.within(0.0, 1.0) };
        let links = [0, 1].map(|k| {
            let velocity = [0; 3].map(|_| dice.within(-4.0, 4.0));
            let body = RigidBodyBuilder::dynamic().translation(places[k]);
            let body = body.linvel(Vector::from_array(velocity)).can_sleep(false);
            let shape = shapes[k].clone().restitution(restitution);
            let shape = shape.density(dice.within(0.5, 3.0)).friction(dice.within(0.0, 1.0));
            world.insert(body, shape).0
        });
        let arm = (places[1] - places[0]) * 0.5;
        let joint = SphericalJointBuilder::new().local_anchor1(arm).local_anchor2(-arm);
        world.insert_multibody_joint(links[0], links[1], joint).expect("the joint fits");
        let start = energy(&world, &links);
        let (mut last, mut gain): (Real, Real) = (start, 0.0);
        for _ in 0..steps(&world, 3.0) {
            world.step();
            let now = energy(&world, &links);
            gain = gain.max((now - last) / start);
            last = now;
        }
        table.row([case.to_string(), format!("{gain:.4}")]);
        // The correction of penetration does work, and the heights are those at the end of the substep.
        table.require(gain < 0.03, "energy came from nowhere");
    }
}

/// Chains do not pass thin walls under the pressure of their other links: a board of 2 cm, and a sheet
/// without thickness.
#[test]
fn chains_do_not_whip_through_walls() {
    for is_sheet in [false, true] {
        for speed in [50.0, 100.0, 400.0, 1000.0] {
            for phase in 0..4_u8 {
                let mut world = world(60);
                let ground = ColliderBuilder::cuboid(60.0, 1.0, 60.0);
                world.insert_collider(ground.translation(Vector::NEG_Y), None);
                world.insert_collider(if is_sheet { sheet() } else { board() }, None);
                let links = throw(&mut world, speed, 0.25 * Real::from(phase));
                for _ in 0..240 {
                    world.step();
                    let beyond =
                        |link: &&RigidBodyHandle| world.bodies[**link].translation().x > 0.0;
                    let passed = links.iter().filter(beyond).count();
                    assert_eq!(passed, 0, "{speed} m/s, phase {phase}, a sheet: {is_sheet}");
                }
            }
        }
    }
}

fn board() -> ColliderBuilder {
    ColliderBuilder::cuboid(0.01, 30.0, 30.0)
}

fn sheet() -> ColliderBuilder {
    let corners = [(-30.0, -30.0), (30.0, -30.0), (30.0, 30.0), (-30.0, 30.0)];
    let corners = corners.map(|(y, z)| Vector::new(0.0, y, z)).to_vec();
    ColliderBuilder::trimesh(corners, vec![[0, 1, 2], [0, 2, 3]]).expect("two triangles")
}
