//! Sleeping bodies that lose their support: they wake, whatever took the support away, and fall.

use super::stage::{run, world};
use crate::dim::{cuboid, vec};
use rapier::prelude::*;

/// A platform with its top at height 2.25 above the ground, and sleeping boxes of half a metre on it.
struct Pile {
    world: PhysicsWorld,
    platform: RigidBodyHandle,
    collider: ColliderHandle,
    boxes: Vec<RigidBodyHandle>,
}

/// How far the lowest box falls to its next support (m).
#[derive(Copy, Clone)]
enum Fall {
    /// As far as the platform moves.
    By(Real),
    ToGround,
}

/// The loss of a support: its name, and the function that takes the support away.
type Loss = (&'static str, Fall, fn(&mut Pile));

const KINDS: [RigidBodyType; 3] = [
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::KinematicVelocityBased,
];

impl Pile {
    fn new(kind: RigidBodyType, count: usize) -> Self {
        let mut world = world(60);
        world.insert_collider(cuboid(100.0, 1.0).translation(vec(0.0, -1.0)), None);
        let platform = RigidBodyBuilder::new(kind).translation(vec(0.0, 2.0));
        let (platform, collider) = world.insert(platform, cuboid(2.0, 0.25));
        let boxes = (0..count).map(|k| {
            let body = RigidBodyBuilder::dynamic().translation(vec(0.0, 2.5 + 0.5 * k as Real));
            world.insert(body, cuboid(0.25, 0.25)).0
        });
        let boxes: Vec<_> = boxes.collect();
        run(&mut world, 4.0);
        assert!(world.active_bodies().is_empty(), "all sleep");
        Self { world, platform, collider, boxes }
    }

    fn heights(&self) -> Vec<Real> {
        self.boxes.iter().map(|&body| self.world.bodies[body].translation().y).collect()
    }

    fn platform(&mut self) -> &mut RigidBody {
        &mut self.world.bodies[self.platform]
    }

    fn shift(&mut self, shift: Vector, wake_up: bool) {
        let to = self.platform().translation() + shift;
        self.platform().set_translation(to, wake_up);
    }

    fn collider(&mut self) -> &mut Collider {
        &mut self.world.colliders[self.collider]
    }

    /// Asserts that the boxes come to rest where their new support is, and returns the fall of the lowest.
    fn fall(&mut self, name: &str, expected: Fall) -> Real {
        let before = self.heights();
        run(&mut self.world, 6.0);
        let falls: Vec<_> =
            before.iter().zip(self.heights()).map(|(before, now)| before - now).collect();
        let expected = match expected {
            Fall::By(distance) => distance,
            Fall::ToGround => 2.25,
        };
        // A centimetre: the depth of a contact at rest, and its slack.
        assert!((falls[0] - expected).abs() < 0.01, "{name}: fell by {falls:?}, not {expected}");
        // The higher ones may fall off the lowest.
        assert!(falls.iter().all(|fall| *fall > expected - 0.01), "{name}: fell by {falls:?}");
        let awake = self.world.active_bodies().len();
        assert_eq!(awake, 0, "{name}: all sleep again, and cost nothing");
        falls[0]
    }
}

/// A platform that moves away within one step leaves no sleeper in the air. Before, a position-based one did
/// if it moved down by 0.10 to 0.24 m.
#[test]
fn platforms_that_move_away_leave_no_sleeper_behind() {
    for (count, substeps) in [(1, 1), (3, 1), (1, 0)] {
        for drop in [0.02, 0.05, 0.1, 0.15, 0.2, 0.24, 0.3, 1.0] {
            let mut pile = Pile::new(RigidBodyType::KinematicPositionBased, count);
            pile.world.integration_parameters.max_ccd_substeps = substeps;
            let at = pile.platform().translation() - vec(0.0, drop);
            pile.platform().set_next_kinematic_translation(at);
            let by_position = pile.fall("next position", Fall::By(drop));

            let mut pile = Pile::new(RigidBodyType::KinematicVelocityBased, count);
            pile.world.integration_parameters.max_ccd_substeps = substeps;
            pile.platform().set_linvel(vec(0.0, -60.0 * drop), true);
            pile.world.step();
            pile.platform().set_linvel(Vector::ZERO, true);
            let fallen = pile.heights()[0];
            let by_velocity = pile.fall("velocity", Fall::By(drop + fallen - 2.5));
            println!(
                "{count} boxes, {substeps} substeps: {drop} m: {by_position:.4}, {by_velocity:.4}"
            );
        }
    }
}

/// The same for a platform that moves out from under its cargo. Friction gives the boxes next to no speed.
#[test]
fn platforms_that_move_aside_leave_no_sleeper_behind() {
    for (count, shift) in [(1, 3.0), (3, 3.0), (1, 9.0), (3, 9.0)] {
        let mut pile = Pile::new(RigidBodyType::KinematicPositionBased, count);
        let at = pile.platform().translation() + vec(shift, 0.0);
        pile.platform().set_next_kinematic_translation(at);
        pile.fall("next position", Fall::ToGround);

        let mut pile = Pile::new(RigidBodyType::KinematicVelocityBased, count);
        pile.platform().set_linvel(vec(60.0 * shift, 0.0), true);
        pile.world.step();
        pile.platform().set_linvel(Vector::ZERO, true);
        pile.fall("velocity", Fall::ToGround);
    }
}

/// A position-based platform that begins to move does so with its sleeping cargo, as with an awake one.
#[test]
fn cargo_moves_in_the_first_step() {
    for rise in [0.01, 0.05, 0.1] {
        let heights = [true, false].map(|is_asleep| {
            let mut pile = Pile::new(RigidBodyType::KinematicPositionBased, 1);
            if !is_asleep {
                pile.world.bodies[pile.boxes[0]].wake_up(true);
            }
            let at = pile.platform().translation() + vec(0.0, rise);
            pile.platform().set_next_kinematic_translation(at);
            pile.world.step();
            pile.heights()[0]
        });
        println!("{rise} m: {heights:?}");
        assert!((heights[0] - heights[1]).abs() < 1.0e-4, "{rise} m: {heights:?}");
        assert!(heights[0] > 2.5 + 0.5 * rise, "{rise} m: {heights:?}");
    }
}

/// Edits that take the support of a sleeping pile away.
const LOSSES: [Loss; 14] = [
    ("moved down", Fall::By(0.15), |pile| pile.shift(vec(0.0, -0.15), true)),
    ("moved down silently", Fall::By(0.15), |pile| pile.shift(vec(0.0, -0.15), false)),
    ("moved aside", Fall::ToGround, |pile| pile.shift(vec(9.0, 0.0), false)),
    ("body removed", Fall::ToGround, |pile| drop(pile.world.remove_body(pile.platform))),
    ("body disabled", Fall::ToGround, |pile| pile.platform().set_enabled(false)),
    ("body made dynamic", Fall::By(1.75), |pile| {
        pile.platform().set_body_type(RigidBodyType::Dynamic, false);
    }),
    ("collider removed", Fall::ToGround, |pile| drop(pile.world.remove_collider(pile.collider))),
    ("collider disabled", Fall::ToGround, |pile| pile.collider().set_enabled(false)),
    ("made a sensor", Fall::ToGround, |pile| pile.collider().set_sensor(true)),
    ("other groups", Fall::ToGround, |pile| {
        pile.collider().set_collision_groups(InteractionGroups::none());
    }),
    ("other solver groups", Fall::ToGround, |pile| {
        pile.collider().set_solver_groups(InteractionGroups::none());
    }),
    ("flatter shape", Fall::By(0.2), |pile| {
        let flat = cuboid(2.0, 0.05).build().shared_shape().clone();
        pile.collider().set_shape(flat);
    }),
    ("collider moved down", Fall::By(0.15), |pile| {
        pile.collider().set_translation_wrt_parent(vec(0.0, -0.15));
    }),
    ("collider moved aside", Fall::ToGround, |pile| {
        pile.collider().set_translation_wrt_parent(vec(9.0, 0.0));
    }),
];

/// Whatever takes the support of a sleeping pile away wakes the pile.
#[test]
fn no_edit_of_a_support_leaves_sleepers_in_the_air() {
    for kind in KINDS {
        for count in [1, 3] {
            for (name, fall, lose) in LOSSES {
                let mut pile = Pile::new(kind, count);
                lose(&mut pile);
                pile.fall(&format!("{kind:?}, {count} boxes, {name}"), fall);
            }
        }
    }
}

/// A body that hangs on a kinematic one by a joint follows its first motion out of its sleep.
#[test]
fn joined_sleepers_follow_kinematic_bodies() {
    for shift in [0.05, 0.15, 0.5, 3.0] {
        let mut world = world(60);
        let post = world.insert_body(RigidBodyBuilder::kinematic_position_based());
        let body = RigidBodyBuilder::dynamic().translation(vec(0.0, -1.0));
        let (load, _) = world.insert(body, cuboid(0.2, 0.2));
        let weld = FixedJointBuilder::new().local_anchor2(vec(0.0, 1.0));
        world.insert_impulse_joint(post, load, weld);
        run(&mut world, 3.0);
        assert!(world.active_bodies().is_empty(), "all sleep");
        world.bodies[post].set_next_kinematic_translation(vec(shift, 0.0));
        run(&mut world, 4.0);
        let error = world.bodies[load].translation() - vec(shift, -1.0);
        assert!(error.length() < 0.01, "{shift} m: {error} away");
    }
}
