//! Edits that wake: whatever can change forces or motion wakes the bodies that it concerns, on both sides of
//! a contact. `docs/guide/sleeping.md` has the same table.

use super::stage::Resting;
use crate::dim::{about_z, cuboid, hinge, slab, vec};
use rapier::prelude::*;

/// A setter: its name, an edit of a sleeping box on the ground, and whether the box wakes.
type Row = (&'static str, fn(&mut Resting), bool);
/// An edit of a joint, with its name, and whether it wakes the bodies.
type JointRow = (&'static str, fn(&mut Joined), bool);

/// The edits of the collider of the ground.
const OF_THE_GROUND: [Row; 22] = [
    ("set_friction", |s| s.ground().set_friction(0.1), true),
    (
        "set_friction_combine_rule",
        |s| s.ground().set_friction_combine_rule(CoefficientCombineRule::Max),
        true,
    ),
    ("set_restitution", |s| s.ground().set_restitution(0.7), true),
    (
        "set_restitution_combine_rule",
        |s| s.ground().set_restitution_combine_rule(CoefficientCombineRule::Max),
        true,
    ),
    ("set_contact_skin", |s| s.ground().set_contact_skin(0.01), true),
    ("set_shape", |s| s.ground().set_shape(cuboid(40.0, 1.0).shape), true),
    (
        "shape_mut",
        |s| {
            let _ = s.ground().shape_mut();
        },
        true,
    ),
    ("set_position", |s| s.ground().set_translation(vec(1.0, -1.0)), true),
    ("set_sensor", |s| s.ground().set_sensor(true), true),
    ("set_enabled", |s| s.ground().set_enabled(false), true),
    ("set_collision_groups", |s| s.ground().set_collision_groups(InteractionGroups::none()), true),
    ("set_solver_groups", |s| s.ground().set_solver_groups(InteractionGroups::none()), true),
    (
        "set_active_collision_types",
        |s| s.each(|it| it.set_active_collision_types(ActiveCollisionTypes::empty())),
        true,
    ),
    (
        "set_active_hooks",
        |s| s.ground().set_active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS),
        true,
    ),
    ("set_active_events", |s| s.ground().set_active_events(ActiveEvents::all()), false),
    (
        "set_contact_force_event_threshold",
        |s| s.ground().set_contact_force_event_threshold(1.0),
        false,
    ),
    ("user_data", |s| s.ground().user_data = 7, false),
    ("set_density", |s| s.ground().set_density(7.0), false),
    (
        "copy_from",
        |s| {
            let mut copy = s.ground().clone();
            copy.set_friction(0.3);
            s.ground().copy_from(&copy);
        },
        true,
    ),
    (
        "ColliderSet::insert",
        |s| {
            let _ = s
                .world
                .insert_collider(ColliderBuilder::ball(0.4).translation(vec(0.0, 0.6)), None);
        },
        true,
    ),
    (
        "ColliderSet::insert elsewhere",
        |s| {
            let _ = s
                .world
                .insert_collider(ColliderBuilder::ball(0.4).translation(vec(5.0, 0.6)), None);
        },
        false,
    ),
    ("ColliderSet::remove", |s| drop(s.world.remove_collider(s.ground)), true),
];

/// The edits of the collider of the box.
const OF_THE_BOX: [Row; 21] = [
    ("set_friction", |s| s.box_collider().set_friction(0.1), true),
    ("set_restitution", |s| s.box_collider().set_restitution(0.7), true),
    ("set_contact_skin", |s| s.box_collider().set_contact_skin(0.01), true),
    ("set_shape", |s| s.box_collider().set_shape(cuboid(0.4, 0.5).shape), true),
    ("set_density", |s| s.box_collider().set_density(7.0), true),
    ("set_mass", |s| s.box_collider().set_mass(7.0), true),
    ("set_mass_properties", |s| s.box_collider().set_mass_properties(slab()), true),
    (
        "set_position_wrt_parent",
        |s| s.box_collider().set_translation_wrt_parent(vec(0.1, 0.0)),
        true,
    ),
    ("set_sensor", |s| s.box_collider().set_sensor(true), true),
    ("set_enabled", |s| s.box_collider().set_enabled(false), true),
    (
        "set_collision_groups",
        |s| s.box_collider().set_collision_groups(InteractionGroups::none()),
        true,
    ),
    ("set_solver_groups", |s| s.box_collider().set_solver_groups(InteractionGroups::none()), true),
    (
        "set_active_hooks",
        |s| s.box_collider().set_active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS),
        true,
    ),
    ("set_active_events", |s| s.box_collider().set_active_events(ActiveEvents::all()), false),
    ("user_data", |s| s.box_collider().user_data = 7, false),
    (
        "insert_with_parent",
        |s| {
            let _ = s.world.insert_collider(ColliderBuilder::ball(0.2), Some(s.body));
        },
        true,
    ),
    (
        "insert_with_parent, a sensor without mass",
        |s| {
            let sensor = ColliderBuilder::ball(5.0).density(0.0).sensor(true);
            s.world.insert_collider(sensor, Some(s.body));
        },
        false,
    ),
    ("ColliderSet::remove", |s| drop(s.world.remove_collider(s.collider)), true),
    (
        "set_parent(None)",
        |s| s.world.colliders.set_parent(s.collider, None, &mut s.world.bodies),
        true,
    ),
    (
        "copy_from",
        |s| {
            let mut copy = s.box_collider().clone();
            copy.set_density(3.0);
            s.box_collider().copy_from(&copy);
        },
        true,
    ),
    (
        "get_mut",
        |s| {
            let _ = s.box_collider();
        },
        false,
    ),
];

/// The edits of the body. `true` and `false` stand for their argument `wake_up`.
const OF_THE_BODY: [Row; 33] = [
    ("set_position(true)", |s| s.body().set_translation(vec(0.0, 3.0), true), true),
    ("set_linvel(true)", |s| s.body().set_linvel(vec(1.0, 0.0), true), true),
    ("set_linvel(false)", |s| s.body().set_linvel(vec(1.0, 0.0), false), false),
    ("set_angvel(true)", |s| s.body().set_angvel(about_z(1.0), true), true),
    ("set_angvel(false)", |s| s.body().set_angvel(about_z(1.0), false), false),
    ("set_gravity_scale(true)", |s| s.body().set_gravity_scale(0.5, true), true),
    ("set_gravity_scale(false)", |s| s.body().set_gravity_scale(0.5, false), false),
    ("add_force(true)", |s| s.body().add_force(vec(1.0, 0.0), true), true),
    ("add_force(false)", |s| s.body().add_force(vec(1.0, 0.0), false), false),
    ("add_torque(true)", |s| s.body().add_torque(about_z(1.0), true), true),
    ("apply_impulse(true)", |s| s.body().apply_impulse(vec(1.0, 0.0), true), true),
    ("apply_impulse(false)", |s| s.body().apply_impulse(vec(1.0, 0.0), false), false),
    ("set_additional_mass(true)", |s| s.body().set_additional_mass(5.0, true), true),
    ("set_additional_mass(false)", |s| s.body().set_additional_mass(5.0, false), false),
    (
        "set_additional_mass_properties(true)",
        |s| s.body().set_additional_mass_properties(slab(), true),
        true,
    ),
    (
        "set_additional_mass_properties(false)",
        |s| s.body().set_additional_mass_properties(slab(), false),
        false,
    ),
    (
        "set_locked_axes(true)",
        |s| s.body().set_locked_axes(LockedAxes::ROTATION_LOCKED, true),
        true,
    ),
    (
        "set_locked_axes(false)",
        |s| s.body().set_locked_axes(LockedAxes::ROTATION_LOCKED, false),
        false,
    ),
    (
        "set_body_type(true)",
        |s| s.body().set_body_type(RigidBodyType::KinematicVelocityBased, true),
        true,
    ),
    ("set_dominance_group", |s| s.body().set_dominance_group(3), true),
    (
        "set_enabled",
        |s| {
            s.body().set_enabled(false);
            s.world.step();
            s.body().set_enabled(true);
        },
        true,
    ),
    (
        "recompute_mass_properties_from_colliders",
        |s| {
            s.box_collider().set_density(3.0);
            let PhysicsWorld { colliders, bodies, .. } = &mut s.world;
            bodies[s.body].recompute_mass_properties_from_colliders(colliders);
        },
        true,
    ),
    ("wake_up", |s| s.body().wake_up(true), true),
    ("set_linear_damping", |s| s.body().set_linear_damping(0.5), false),
    ("set_angular_damping", |s| s.body().set_angular_damping(0.5), false),
    ("enable_ccd", |s| s.body().enable_ccd(true), false),
    ("set_soft_ccd_prediction", |s| s.body().set_soft_ccd_prediction(0.1), false),
    ("set_additional_solver_iterations", |s| s.body().set_additional_solver_iterations(4), false),
    ("user_data", |s| s.body().user_data = 7, false),
    ("activation_mut", |s| s.body().activation_mut().angular_threshold = 0.1, false),
    ("sleep", |s| s.body().sleep(), false),
    (
        "get_mut",
        |s| {
            let _ = s.body();
        },
        false,
    ),
    ("gravity", |s| s.world.gravity = vec(1.0, -9.0), false),
];

/// Each row of the table: a sleeping box is awake within two steps of the edit, or sleeps on. Another box
/// that the edit does not concern sleeps on.
#[test]
fn edits_wake_the_bodies_that_they_concern() {
    println!("| of | edit | wakes |\n|---|---|---|");
    let tables =
        [("the ground", &OF_THE_GROUND[..]), ("the box", &OF_THE_BOX), ("the body", &OF_THE_BODY)];
    let mut failures = Vec::new();
    for (of, rows) in tables {
        for &(name, edit, expected) in rows {
            let mut scene = Resting::asleep();
            let body = scene.body;
            let wakes = wakes_at(&mut scene, edit, body);
            println!("| {of} | {name} | {wakes} |");
            if wakes != expected {
                failures.push((of, name, wakes));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}

/// Returns whether a sleeping body is awake after one of the two steps after an edit.
fn wakes_at<S: AsMut<PhysicsWorld>>(
    scene: &mut S,
    edit: fn(&mut S),
    body: RigidBodyHandle,
) -> bool {
    edit(scene);
    (0..2).any(|_| {
        let world = scene.as_mut();
        world.step();
        !world.bodies[body].is_sleeping()
    })
}

/// Two sleeping boxes, joined.
struct Joined {
    world: PhysicsWorld,
    bodies: [RigidBodyHandle; 2],
    joint: ImpulseJointHandle,
    multibody: Option<MultibodyJointHandle>,
}

impl AsMut<PhysicsWorld> for Joined {
    fn as_mut(&mut self) -> &mut PhysicsWorld {
        &mut self.world
    }
}

impl Joined {
    fn asleep(is_multibody: bool) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::ZERO;
        let bodies = [0.0, 2.0].map(|x| {
            let body = RigidBodyBuilder::dynamic().translation(vec(x, 0.0));
            world.insert(body, cuboid(0.5, 0.5)).0
        });
        let joint: GenericJoint =
            hinge().local_anchor1(vec(1.0, 0.0)).local_anchor2(vec(-1.0, 0.0)).build().into();
        let mut scene =
            Self { world, bodies, joint: ImpulseJointHandle::invalid(), multibody: None };
        match is_multibody {
            true => {
                scene.multibody =
                    scene.world.multibody_joints.insert(bodies[0], bodies[1], joint, true)
            }
            false => {
                scene.joint = scene.world.impulse_joints.insert(bodies[0], bodies[1], joint, true)
            }
        }
        (0..150).for_each(|_| scene.world.step());
        assert!(scene.world.active_bodies().is_empty());
        scene
    }

    /// Edits the joint of either kind.
    fn data(&mut self) -> &mut GenericJoint {
        match self.multibody {
            Some(handle) => {
                let (multibody, link) =
                    self.world.multibody_joints.get_mut(handle).expect("it is there");
                &mut multibody.link_mut(link).expect("it is there").joint.data
            }
            None => &mut self.world.impulse_joints.get_mut(self.joint).expect("it is there").data,
        }
    }
}

/// Edits of joints, with whether they wake.
const OF_JOINTS: [JointRow; 9] = [
    (
        "motor",
        |s| {
            let _ = s.data().set_motor_velocity(JointAxis::AngX, 1.0, 1.0);
        },
        true,
    ),
    (
        "the same motor",
        |s| {
            let motor = s.data().motors[JointAxis::AngX as usize];
            s.data().motors[JointAxis::AngX as usize] = motor;
        },
        false,
    ),
    (
        "limits",
        |s| {
            let _ = s.data().set_limits(JointAxis::AngX, [0.5, 1.0]);
        },
        true,
    ),
    (
        "anchor",
        |s| {
            let _ = s.data().set_local_anchor1(vec(1.5, 0.0));
        },
        true,
    ),
    (
        "the same anchor",
        |s| {
            let _ = s.data().set_local_anchor1(vec(1.0, 0.0));
        },
        false,
    ),
    ("set_enabled", |s| s.data().set_enabled(false), true),
    (
        "set_enabled to and fro",
        |s| {
            s.data().set_enabled(false);
            s.data().set_enabled(true);
        },
        false,
    ),
    (
        "get_mut",
        |s| {
            let _ = s.data();
        },
        false,
    ),
    ("softness", |s| s.data().softness = Some(SpringCoefficients::new(5.0, 1.0)), true),
];

/// A joint that is borrowed and stays as it was wakes nothing; a change wakes both bodies.
#[test]
fn changes_of_joints_wake_both_bodies() {
    println!("| joint | edit | wakes |\n|---|---|---|");
    let mut failures = Vec::new();
    for is_multibody in [false, true] {
        for (name, edit, expected) in OF_JOINTS {
            let mut scene = Joined::asleep(is_multibody);
            let bodies = scene.bodies;
            let wakes = wakes_at(&mut scene, edit, bodies[1]);
            println!(
                "| {} | {name} | {wakes} |",
                if is_multibody { "multibody" } else { "impulse" }
            );
            if wakes != expected {
                failures.push((is_multibody, name, wakes));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:?}");
}
