//! Edits of masses. The centre of mass moves, but a rigid body is the same body: every point of it keeps its
//! velocity. Its joints therefore get no impulse, and parted bodies have the momentum of the whole.

use crate::dim::{ang_length, cuboid, hinge, moment, slab, spin_momentum, tumble, vec, z_of};
use rapier::prelude::*;

/// A body that moves and spins, with two colliders at different distances from its origin.
struct Spinning {
    world: PhysicsWorld,
    body: RigidBodyHandle,
    /// A body that touches nothing, with a collider of its own.
    other: RigidBodyHandle,
    colliders: [ColliderHandle; 2],
}

/// An edit of a mass, with its name.
type Edit = (&'static str, fn(&mut Spinning));

/// A type of bodies, with its name.
type Kind = (&'static str, fn() -> RigidBodyBuilder);

impl Spinning {
    fn new(body: RigidBodyBuilder, steps: usize) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::ZERO;
        let other = RigidBodyBuilder::dynamic().translation(vec(20.0, 0.0));
        let (other, _) = world.insert(other, ColliderBuilder::ball(0.5));
        let body = world.insert_body(body.linvel(vec(1.0, -2.0)).angvel(tumble(5.0, 2.0)));
        let weights = [vec(1.0, 0.5), vec(-1.5, 0.25)];
        let colliders = weights.map(|at| {
            let weight = cuboid(0.3, 0.2).translation(at).density(2.0);
            world.insert_collider(weight, Some(body))
        });
        (0..steps).for_each(|_| world.step());
        // The steps after the edit must not move the body.
        world.integration_parameters.dt = 1.0e-6;
        Self { world, body, other, colliders }
    }

    fn edited(&mut self) -> &mut Collider {
        &mut self.world.colliders[self.colliders[0]]
    }

    /// Returns the velocities of three points of the body.
    fn velocities(&self) -> [Vector; 3] {
        let body = &self.world.bodies[self.body];
        [vec(0.0, 0.0), vec(1.0, 0.0), vec(-0.5, 2.0)]
            .map(|point| body.velocity_at_point(body.position() * point))
    }
}

/// A part with a distant centre of mass.
fn ballast() -> MassProperties {
    MassProperties { local_com: vec(0.7, -1.1), ..slab() }
}

const EDITS: [Edit; 22] = [
    ("insertion", |s| {
        let weight = ColliderBuilder::ball(0.4).translation(vec(0.3, 2.0)).density(3.0);
        s.world.insert_collider(weight, Some(s.body));
    }),
    ("removal", |s| drop(s.world.remove_collider(s.colliders[0]))),
    ("removal of all", |s| {
        s.colliders.into_iter().for_each(|it| drop(s.world.remove_collider(it)));
    }),
    ("removal without waking", |s| {
        let PhysicsWorld { colliders, islands, bodies, .. } = &mut s.world;
        colliders.remove(s.colliders[0], islands, bodies, false);
    }),
    ("set_enabled", |s| s.edited().set_enabled(false)),
    ("set_density", |s| s.edited().set_density(50.0)),
    ("set_density(0)", |s| s.edited().set_density(0.0)),
    ("set_mass", |s| s.edited().set_mass(9.0)),
    ("set_mass_properties", |s| s.edited().set_mass_properties(ballast())),
    ("set_shape", |s| s.edited().set_shape(SharedShape::ball(1.0))),
    ("shape_mut", |s| {
        let shape = s.edited().shape_mut();
        shape.as_cuboid_mut().expect("it is a box").half_extents *= 3.0;
    }),
    ("set_position_wrt_parent", |s| s.edited().set_position_wrt_parent(Pose::IDENTITY)),
    ("set_translation_wrt_parent", |s| s.edited().set_translation_wrt_parent(vec(0.0, 3.0))),
    ("set_parent(None)", |s| {
        s.world.colliders.set_parent(s.colliders[0], None, &mut s.world.bodies);
    }),
    ("set_parent(other)", |s| {
        s.world.colliders.set_parent(s.colliders[0], Some(s.other), &mut s.world.bodies);
    }),
    ("set_parent(this)", |s| {
        let other = s.world.bodies[s.other].colliders()[0];
        s.world.colliders.set_parent(other, Some(s.body), &mut s.world.bodies);
    }),
    ("set_sensor", |s| s.edited().set_sensor(true)),
    ("copy_from", |s| {
        let other = ColliderBuilder::ball(0.9).density(4.0).build();
        s.edited().copy_from(&other);
    }),
    ("set_additional_mass_properties", |s| {
        s.world.bodies[s.body].set_additional_mass_properties(ballast(), true);
    }),
    ("set_additional_mass without density", |s| {
        s.colliders.into_iter().for_each(|it| s.world.colliders[it].set_density(0.0));
        s.world.bodies[s.body].set_additional_mass(3.0, false);
    }),
    ("recompute_mass_properties_from_colliders", |s| {
        s.edited().set_mass(7.0);
        let PhysicsWorld { colliders, bodies, .. } = &mut s.world;
        bodies[s.body].recompute_mass_properties_from_colliders(colliders);
    }),
    ("two at once", |s| {
        s.edited().set_mass(7.0);
        let weight = ColliderBuilder::ball(0.4).translation(vec(0.3, 2.0)).density(3.0);
        s.world.insert_collider(weight, Some(s.body));
    }),
];

/// Returns the largest change of a point's velocity, after the edit and after the step that applies it.
fn largest_change(mut scene: Spinning, edit: fn(&mut Spinning)) -> Real {
    let before = scene.velocities();
    edit(&mut scene);
    scene.world.step();
    let after = scene.velocities();
    let changes = before.into_iter().zip(after).map(|(before, after)| (before - after).length());
    changes.fold(0.0, Real::max)
}

/// A mass that is moved, added or removed changes the velocity of no point: ω is constant, and the new centre
/// of mass has the velocity that its point had. Points accelerate by up to 70 m/s², in a step of 1e-6 s.
#[test]
fn edits_of_masses_change_the_velocity_of_no_point() {
    let limit = 1.0e-4 + 1.0e3 * Real::EPSILON;
    let types: [Kind; 2] = [
        ("dynamic", RigidBodyBuilder::dynamic),
        ("velocity-based", RigidBodyBuilder::kinematic_velocity_based),
    ];
    println!("| edit | body | steps before | change of velocity (m/s) |\n|---|---|--:|--:|");
    let mut failures = Vec::new();
    for (name, edit) in EDITS {
        for (kind, body) in types {
            for steps in [10, 0] {
                // An attachment before the first step belongs to the description of the body.
                let attaches = ["insertion", "set_parent(this)", "two at once"].contains(&name);
                let is_assembly = steps == 0 && attaches;
                let change = largest_change(Spinning::new(body(), steps), edit);
                println!("| {name} | {kind} | {steps} | {change:.1e} |");
                if change > limit && !is_assembly {
                    failures.push((name, kind, steps, change));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

/// A change of the type keeps the velocities, too, although the reference point of `linvel` changes.
#[test]
fn changes_of_the_type_change_the_velocity_of_no_point() {
    use RigidBodyType::{Dynamic, KinematicPositionBased, KinematicVelocityBased};
    let to_type: [Edit; 4] = [
        ("velocity-based", |s| {
            s.world.bodies[s.body].set_body_type(KinematicVelocityBased, true);
        }),
        ("to and fro", |s| {
            s.world.bodies[s.body].set_body_type(KinematicVelocityBased, true);
            s.world.step();
            s.world.bodies[s.body].set_body_type(Dynamic, true);
        }),
        ("at once to and fro", |s| {
            s.world.bodies[s.body].set_body_type(KinematicVelocityBased, true);
            s.world.bodies[s.body].set_body_type(Dynamic, true);
        }),
        ("over position-based", |s| {
            s.world.bodies[s.body].set_body_type(KinematicPositionBased, true);
            s.world.bodies[s.body].set_body_type(Dynamic, true);
        }),
    ];
    for (name, edit) in to_type {
        let change = largest_change(Spinning::new(RigidBodyBuilder::dynamic(), 10), edit);
        println!("{name}: {change:.1e} m/s");
        assert!(change < 2.0e-4, "{name}: {change}");
    }
}

/// The builder's velocity is that of the centre of mass of the whole body, whatever was attached in which
/// order: a dumbbell with an angular velocity spins on the spot.
#[test]
fn a_new_dumbbell_spins_on_the_spot() {
    let mut world = PhysicsWorld::new();
    world.gravity = Vector::ZERO;
    let body = world.insert_body(RigidBodyBuilder::dynamic().angvel(tumble(5.0, 0.0)));
    for x in [3.0, -1.0, 1.0, 5.0] {
        let ball = ColliderBuilder::ball(0.2).translation(vec(x, 0.0)).mass(1.0);
        world.insert_collider(ball, Some(body));
    }
    (0..60).for_each(|_| world.step());
    let center = world.bodies[body].center_of_mass();
    assert!((center - vec(2.0, 0.0)).length() < 1.0e-4, "it drifted to {center}");
}

/// A dumbbell of two balls of 1 kg loses one of them, which flies on as a body of its own with the velocity
/// of its point. Momentum and angular momentum about the origin are those of the dumbbell.
#[test]
fn parts_of_a_dumbbell_have_its_momentum() {
    for steps in [0, 1, 30] {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::ZERO;
        let body = RigidBodyBuilder::dynamic().linvel(vec(0.5, 0.25)).angvel(tumble(5.0, 1.0));
        let body = world.insert_body(body);
        let ball = || ColliderBuilder::ball(0.25).mass(1.0);
        let balls =
            [1.0, -1.0].map(|x| world.insert_collider(ball().translation(vec(x, 0.0)), Some(body)));
        (0..steps).for_each(|_| world.step());
        let before = momenta(&world);
        let place = world.colliders[balls[1]].translation();
        let whole = &world.bodies[body];
        let part = RigidBodyBuilder::dynamic()
            .translation(place)
            .linvel(whole.velocity_at_point(place))
            .angvel(whole.angvel());
        world.remove_collider(balls[1]);
        world.insert(part, ball());
        world.step();
        let after = momenta(&world);
        let change = [(before.0 - after.0).length(), ang_length(before.1 - after.1)];
        println!("after {steps} steps: p changes by {:.1e}, L by {:.1e}", change[0], change[1]);
        assert!(change[0] < 1.0e-4 && change[1] < 1.0e-3, "{steps} steps: {before:?}, {after:?}");
    }
}

/// Returns momentum, and angular momentum about the origin.
fn momenta(world: &PhysicsWorld) -> (Vector, AngVector) {
    let mut sum = (Vector::ZERO, AngVector::default());
    for (_, body) in world.bodies.iter() {
        let momentum = body.linvel() * body.mass();
        sum.0 += momentum;
        sum.1 += moment(body.center_of_mass(), momentum) + spin_momentum(body);
    }
    sum
}

/// A pendulum gets a second bob: the hinge gets no impulse, so the angular velocity stays. The same holds
/// for hinges of both kinds of joints, and for a free pair of links.
#[test]
fn pendulums_keep_their_angular_velocity_at_new_masses() {
    println!("| joint | anchor | before (rad/s) | after |\n|---|---|--:|--:|");
    for (kind, is_multibody) in [("impulse", false), ("multibody", true)] {
        for (root, base) in [
            ("fixed", RigidBodyBuilder::fixed()),
            ("free", RigidBodyBuilder::dynamic().additional_mass_properties(slab())),
        ] {
            let mut world = PhysicsWorld::new();
            let base = world.insert_body(base);
            let bob = RigidBodyBuilder::dynamic().translation(vec(1.0, 0.0)).can_sleep(false);
            let (bob, _) = world.insert(bob, ColliderBuilder::ball(0.1).mass(1.0));
            let joint = hinge().local_anchor2(vec(-1.0, 0.0)).build();
            match is_multibody {
                true => drop(world.multibody_joints.insert(base, bob, joint, true)),
                false => drop(world.impulse_joints.insert(base, bob, joint, true)),
            }
            world.bodies[bob].apply_impulse(vec(0.0, -2.0), true);
            (0..20).for_each(|_| world.step());
            let before = z_of(world.bodies[bob].angvel());
            let weight = ColliderBuilder::ball(0.1).translation(vec(-0.5, 0.5)).mass(3.0);
            world.insert_collider(weight, Some(bob));
            world.integration_parameters.dt = 1.0e-5;
            (0..4).for_each(|_| world.step());
            let after = z_of(world.bodies[bob].angvel());
            println!("| {kind} | {root} | {before:.4} | {after:.4} |");
            // Gravity changes it by less than 1e-3 rad/s in these steps.
            assert!((after - before).abs() < 2.0e-3, "{kind}, {root}: {before} to {after}");
        }
    }
}

/// `linvel` of a velocity-based body is the velocity of its centre of mass, about which it rotates: a centre
/// at the distance r from the origin moves with it, and the origin moves on a circle about the centre.
#[test]
fn velocity_based_bodies_rotate_about_their_centre_of_mass() {
    let (mut world, offset) = (PhysicsWorld::new(), vec(1.0, 0.0));
    let body = RigidBodyBuilder::kinematic_velocity_based().translation(vec(2.0, 1.0));
    let body = body.angvel(tumble(1.0, 0.0)).linvel(vec(0.5, 0.0));
    let (body, _) = world.insert(body, cuboid(1.0, 0.1).translation(offset));
    (0..60).for_each(|_| world.step());
    let body = &world.bodies[body];
    let center = vec(2.0, 1.0) + offset + vec(0.5, 0.0);
    assert!((body.center_of_mass() - center).length() < 1.0e-4, "{}", body.center_of_mass());
    // After one radian.
    let origin = center - vec((1.0 as Real).cos(), (1.0 as Real).sin());
    assert!((body.translation() - origin).length() < 1.0e-3, "{}", body.translation());
}

/// A resting box gets lighter or heavier by three orders of magnitude: it stays where it is, because the last
/// contact impulse is no more than a guess.
#[test]
fn resting_bodies_of_another_mass_stay_at_rest() {
    for factor in [1.0e-3, 1.0e3] as [Real; 2] {
        let mut world = PhysicsWorld::new();
        world.insert_collider(cuboid(10.0, 1.0).translation(vec(0.0, -1.0)), None);
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 0.5));
        let (body, collider) = world.insert(body, cuboid(0.5, 0.5).mass(10.0));
        (0..30).for_each(|_| world.step());
        world.colliders[collider].set_mass(10.0 * factor);
        let (mut highest, mut fastest) = (0.0, 0.0);
        for _ in 0..60 {
            world.step();
            let body = &world.bodies[body];
            highest = Real::max(highest, (body.translation().y - 0.5).abs());
            fastest = Real::max(fastest, body.linvel().length());
        }
        println!("times {factor}: {:.2} mm, {fastest:.4} m/s", 1.0e3 * highest);
        assert!(highest < 2.0e-3 && fastest < 0.05, "times {factor}: {highest} m, {fastest} m/s");
    }
}
