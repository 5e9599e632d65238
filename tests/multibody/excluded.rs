//! Contacts that a joint or a multibody disables: no pair, no event, no stop of fast links.

use crate::dim::{angle, cuboid, hinge, vec};
use crate::suite::api::stage::Protocol;
use crate::suite::physics::stage::{G, run, weightless, world};
use rapier::prelude::*;

/// What holds a body at its parent, and disables their contacts.
#[derive(Copy, Clone, Debug)]
enum Holder {
    ImpulseJoint(ImpulseJointHandle),
    MultibodyJoint(MultibodyJointHandle),
    /// The setting of the whole multibody.
    SelfContacts(MultibodyJointHandle),
}

impl Holder {
    /// One of each kind between two bodies.
    fn all(
        scene: &PhysicsWorld,
        [parent, child]: [RigidBodyHandle; 2],
        joint: impl Into<GenericJoint>,
    ) -> [(PhysicsWorld, Self); 3] {
        let joint = joint.into();
        let mut worlds = [(); 3].map(|()| scene.clone());
        let impulse = worlds[0].insert_impulse_joint(parent, child, joint);
        let [one, two] =
            [1, 2].map(|k| worlds[k].insert_multibody_joint(parent, child, joint).expect("a tree"));
        let holders =
            [Self::ImpulseJoint(impulse), Self::MultibodyJoint(one), Self::SelfContacts(two)];
        let mut worlds = worlds.into_iter();
        holders.map(|holder| (worlds.next().expect("three"), holder))
    }

    fn name(self) -> &'static str {
        match self {
            Self::ImpulseJoint(_) => "impulse joint",
            Self::MultibodyJoint(_) => "multibody joint",
            Self::SelfContacts(_) => "self-contacts",
        }
    }

    fn enable_contacts(self, world: &mut PhysicsWorld, enabled: bool) {
        match self {
            Self::ImpulseJoint(joint) => {
                world.impulse_joints[joint].data.set_contacts_enabled(enabled);
            }
            Self::MultibodyJoint(joint) => {
                let (multibody, link) = world.multibody_joints.get_mut(joint).expect("a joint");
                let link = multibody.link_mut(link).expect("a link");
                link.joint.data.set_contacts_enabled(enabled);
            }
            Self::SelfContacts(joint) => {
                let (multibody, _) = world.multibody_joints.get_mut(joint).expect("a joint");
                multibody.set_self_contacts_enabled(enabled);
            }
        }
    }
}

/// An arm without forces rotates uniformly about a post inside it: `ω t`. Before, the search for fast motion
/// stopped links of multibodies at the post, for ever.
#[test]
fn fast_arms_rotate_through_their_post() {
    for (speed, is_bullet, is_kinematic) in [1.0, 5.0, 10.0, 20.0, 40.0]
        .into_iter()
        .flat_map(|speed| [(speed, false, false), (speed, true, false), (speed, false, true)])
    {
        let mut scene = weightless(60);
        let kind =
            if is_kinematic { RigidBodyType::KinematicPositionBased } else { RigidBodyType::Fixed };
        let (post, _) = scene.insert(RigidBodyBuilder::new(kind), cuboid(0.3, 0.3));
        let body = RigidBodyBuilder::dynamic().translation(vec(0.5, 0.0)).can_sleep(false);
        let (arm, _) = scene.insert(body.ccd_enabled(is_bullet), cuboid(0.4, 0.1));
        scene.bodies[arm].set_angvel(crate::dim::about_z(speed), true);
        scene.bodies[arm].set_linvel(vec(0.0, 0.5 * speed), true);
        let joint = hinge().local_anchor2(vec(-0.5, 0.0)).build();
        for (mut world, holder) in Holder::all(&scene, [post, arm], joint) {
            holder.enable_contacts(&mut world, false);
            let (mut turned, mut last) = (0.0, 0.0);
            for _ in 0..60 {
                world.step();
                let now = angle(world.bodies[arm].rotation());
                let full = 2.0 * std::f64::consts::PI as Real;
                turned += (now - last + 1.5 * full).rem_euclid(full) - 0.5 * full;
                last = now;
            }
            println!(
                "{speed:4} rad/s, bullet {is_bullet}, kinematic {is_kinematic}, {}: {turned:.4}",
                holder.name()
            );
            // Impulse joints lose speed beyond a tenth of a radian in a substep: a tenth at 40 rad/s.
            let error_max = if matches!(holder, Holder::ImpulseJoint(_)) { 0.12 } else { 1.0e-4 };
            assert!(
                (turned / speed - 1.0).abs() < error_max,
                "{turned} rad of {speed}, {}",
                holder.name()
            );
        }
    }
}

/// Contacts with the parent are switched off and on at run time. Off: the pair is gone, its end is reported
/// once, no force is reported, and the load falls, asleep or not. On: the begin is reported once, and the
/// parent carries the load.
#[test]
fn contacts_are_switched_at_run_time() {
    for (rest, is_asleep) in [(0.5, false), (3.0, true)] {
        let mut scene = world(60);
        let events = |collider: ColliderBuilder| collider.active_events(ActiveEvents::all());
        let (post, _) = scene.insert(RigidBodyBuilder::fixed(), cuboid(0.5, 0.5));
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 1.0));
        let (load, _) =
            scene.insert(body, events(cuboid(0.5, 0.5)).contact_force_event_threshold(0.0));
        let rail = PrismaticJointBuilder::new(vec(0.0, 1.0)).build();
        for (mut world, holder) in Holder::all(&scene, [post, load], rail) {
            let protocol = Protocol::default();
            run(&mut world, rest);
            assert_eq!(world.bodies[load].is_sleeping(), is_asleep, "{}", holder.name());
            let run = |world: &mut PhysicsWorld, steps: usize| {
                (protocol.of_steps(world, steps), protocol.forces())
            };
            holder.enable_contacts(&mut world, false);
            let (collisions, forces) = run(&mut world, 1);
            assert!(matches!(collisions[..], [CollisionEvent::Stopped(..)]), "{}", holder.name());
            assert_eq!((forces.len(), world.contact_pairs().count()), (0, 0), "{}", holder.name());
            let (collisions, forces) = run(&mut world, 17);
            assert_eq!((collisions.len(), forces.len()), (0, 0), "{}", holder.name());
            let fallen = 1.0 - world.bodies[load].translation().y;
            let t: Real = 18.0 / 60.0;
            // The step of the switch counts as one of the fall.
            let expected = 0.5 * G * t * t;
            assert!(
                (fallen / expected - 1.0).abs() < 0.03,
                "{}: {fallen}, not {expected}",
                holder.name()
            );

            world.bodies[load].set_translation(vec(0.0, 1.0), true);
            world.bodies[load].set_linvel(Vector::ZERO, true);
            holder.enable_contacts(&mut world, true);
            let (collisions, _) = run(&mut world, 30);
            assert!(matches!(collisions[..], [CollisionEvent::Started(..)]), "{}", holder.name());
            let (collisions, forces) = run(&mut world, 1);
            assert_eq!((collisions.len(), forces.len()), (0, 1), "{}", holder.name());
            let (force, weight) = (forces[0].total_force_magnitude, G * world.bodies[load].mass());
            assert!(
                (force / weight - 1.0).abs() < 0.01,
                "{}: {force}, not {weight}",
                holder.name()
            );
        }
    }
}

/// Three overlapping bodies that exert no forces, so that nothing moves. The first is fixed.
struct Overlapping {
    world: PhysicsWorld,
    bodies: [RigidBodyHandle; 3],
    colliders: [ColliderHandle; 3],
    /// Applies edits.
    update: fn(&mut PhysicsWorld),
}

/// By number, the bodies of a pair.
type Pairs = Vec<[usize; 2]>;

impl Overlapping {
    /// One world whose edits are applied by a detection, and one with steps.
    fn both() -> [Self; 2] {
        let detect = |world: &mut PhysicsWorld| world.detect_collisions(&(), &());
        let updates: [fn(&mut PhysicsWorld); 2] = [detect, PhysicsWorld::step];
        updates.map(|update| {
            let mut world = weightless(60);
            let inserted = [0, 1, 2].map(|k| {
                let is_fixed = k == 0;
                let kind = if is_fixed { RigidBodyType::Fixed } else { RigidBodyType::Dynamic };
                let body = RigidBodyBuilder::new(kind).translation(vec(0.1 * k as Real, 0.0));
                world.insert(body, cuboid(0.5, 0.5).solver_groups(InteractionGroups::none()))
            });
            let (bodies, colliders) = (inserted.map(|pair| pair.0), inserted.map(|pair| pair.1));
            Self { world, bodies, colliders, update }
        })
    }

    /// Joins a body to the one before.
    fn weld(&mut self, body: usize, contacts_enabled: bool) -> MultibodyJointHandle {
        let joint = FixedJointBuilder::new().local_anchor1(vec(0.1, 0.0));
        let joint = joint.contacts_enabled(contacts_enabled);
        let [parent, child] = [self.bodies[body - 1], self.bodies[body]];
        self.world.insert_multibody_joint(parent, child, joint).expect("a tree")
    }

    /// Applies edits, and returns the pairs that touch.
    fn touching(&mut self) -> Pairs {
        (self.update)(&mut self.world);
        let place = |collider| {
            let position = self.colliders.iter().position(|&other| other == collider);
            position.expect("there are no others")
        };
        let pairs = self.world.contact_pairs().filter(|(.., pair)| pair.has_any_active_contact);
        let mut pairs: Pairs =
            pairs.map(|(.., pair)| [pair.collider1, pair.collider2].map(place)).collect();
        pairs.sort_unstable();
        pairs
    }
}

/// The pairs that touch after each switch of joints and multibodies, with and without a step.
#[test]
fn pairs_follow_settings_of_multibodies() {
    for mut scene in Overlapping::both() {
        let first = scene.weld(1, false);
        let whole = |world: &mut PhysicsWorld, enabled: bool| {
            Holder::SelfContacts(first).enable_contacts(world, enabled);
        };
        assert_eq!(scene.touching(), [[0, 2], [1, 2]]);
        let second = scene.weld(2, true);
        assert_eq!(scene.touching(), [[0, 2], [1, 2]]);
        whole(&mut scene.world, false);
        assert!(scene.touching().is_empty());
        whole(&mut scene.world, true);
        assert_eq!(scene.touching(), [[0, 2], [1, 2]]);
        Holder::MultibodyJoint(second).enable_contacts(&mut scene.world, false);
        assert_eq!(scene.touching(), [[0, 2]]);
        let switch = |world: &mut PhysicsWorld, enabled: bool| {
            let (multibody, link) = world.multibody_joints.get_mut(first).expect("a joint");
            multibody.link_mut(link).expect("a link").joint.data.set_enabled(enabled);
        };
        switch(&mut scene.world, false);
        assert_eq!(scene.touching(), [[0, 1], [0, 2]], "a disabled joint disables no contacts");
        switch(&mut scene.world, true);
        assert_eq!(scene.touching(), [[0, 2]]);
    }
}

/// The pairs that touch after each insertion and removal of joints and links, with and without a step.
#[test]
fn pairs_follow_insertions_and_removals_of_links() {
    for mut scene in Overlapping::both() {
        assert_eq!(scene.touching(), [[0, 1], [0, 2], [1, 2]]);
        let (first, second) = (scene.weld(1, false), scene.weld(2, true));
        Holder::SelfContacts(first).enable_contacts(&mut scene.world, false);
        assert!(scene.touching().is_empty());
        scene.world.remove_multibody_joint(second);
        assert_eq!(scene.touching(), [[0, 2], [1, 2]], "the third body is no link");
        scene.world.remove_multibody_joint(first);
        assert_eq!(scene.touching(), [[0, 1], [0, 2], [1, 2]]);

        // The middle link goes, and another body gets its slot.
        scene.weld(1, false);
        scene.weld(2, false);
        assert_eq!(scene.touching(), [[0, 2]]);
        let Overlapping { world, bodies, colliders, update } = &mut scene;
        world.remove_body(bodies[1]);
        let (_, other) = world.insert(RigidBodyBuilder::dynamic(), cuboid(0.5, 0.5));
        update(world);
        assert!(world.contact_pair(other, colliders[0]).is_some());
        assert!(world.contact_pair(other, colliders[2]).is_some());
    }
}

/// Sensors detect bodies with which the contacts are disabled: they need no contact.
#[test]
fn sensors_detect_excluded_bodies() {
    let mut scene = weightless(60);
    let (post, sensor) = scene.insert(RigidBodyBuilder::fixed(), cuboid(0.5, 0.5).sensor(true));
    let (body, collider) = scene.insert(RigidBodyBuilder::dynamic(), cuboid(0.5, 0.5));
    let weld = FixedJointBuilder::new().contacts_enabled(false).build();
    for (mut world, holder) in Holder::all(&scene, [post, body], weld) {
        holder.enable_contacts(&mut world, false);
        world.step();
        assert_eq!(world.intersection_pair(sensor, collider), Some(true), "{}", holder.name());
    }
}

/// Links that do not collide with each other take no places of other partners
/// (`max_neighbors_per_collider`): a box lies on the highest of 300 links at one place. Before, the link
/// had its 128 neighbours among the links, and the box sank in by half a metre.
#[test]
fn excluded_bodies_are_no_neighbors() {
    let mut world = world(60);
    let (load, _) =
        world.insert(RigidBodyBuilder::dynamic().translation(vec(0.0, 2.01)), cuboid(1.0, 1.0));
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let (count, mut joint) = (300, None);
    for k in 1..=count {
        let at = vec(0.0, 0.9 * (k as Real / count as Real - 1.0));
        let (link, _) = world.insert(RigidBodyBuilder::dynamic().translation(at), cuboid(1.0, 1.0));
        let weld = FixedJointBuilder::new().local_anchor1(at);
        joint = world.insert_multibody_joint(post, link, weld);
    }
    let (multibody, _) =
        world.multibody_joints.get_mut(joint.expect("a tree")).expect("a multibody");
    multibody.set_self_contacts_enabled(false);
    run(&mut world, 1.0);
    let crowded = world.physics_pipeline.counters.cd.ncrowded;
    let height = world.bodies[load].translation().y;
    println!("{crowded} of {count} links are crowded, the box is at {height:.4}");
    assert!(crowded == 0 && (height - 2.0).abs() < 0.005, "{crowded} links, {height}");
}

/// A loaded world has the same exclusions.
#[cfg(feature = "serde-serialize")]
#[test]
fn exclusions_are_saved() {
    let mut scene = weightless(60);
    let (post, _) = scene.insert(RigidBodyBuilder::fixed(), cuboid(0.3, 0.3));
    let body =
        RigidBodyBuilder::dynamic().translation(vec(0.5, 0.0)).angvel(crate::dim::about_z(9.0));
    let (arm, _) = scene.insert(body, cuboid(0.4, 0.1));
    let joint = hinge().local_anchor2(vec(-0.5, 0.0)).build();
    for (mut world, holder) in Holder::all(&scene, [post, arm], joint) {
        holder.enable_contacts(&mut world, false);
        run(&mut world, 0.1);
        let bytes = world.to_snapshot().expect("it can be saved");
        let mut loaded = PhysicsWorld::from_snapshot(&bytes).expect("it can be loaded");
        for world in [&mut world, &mut loaded] {
            run(world, 0.5);
            assert_eq!(world.contact_pairs().count(), 0, "{}", holder.name());
        }
        assert_eq!(world.hash(), loaded.hash(), "{}", holder.name());
    }
}
