//! "My ragdoll's shoulder explodes when the arm goes over the head." Arms whose joints have limits or servos
//! about some axes fall through all swings, past the horizontal and past half a turn (3D).

use super::limbs::energy;
use crate::suite::physics::stage::{Dice, G, Sample, steps, world};
use rapier::prelude::*;

const AXES: [JointAxis; 3] = [JointAxis::AngX, JointAxis::AngY, JointAxis::AngZ];
/// Half the length of an arm.
const HALF: Real = 0.5;
/// Steps per second, and substeps.
const STEPS: [(u32, usize); 4] = [(30, 4), (60, 1), (60, 4), (240, 4)];
/// Sets of limits about X, Y and Z, to both sides: narrow, wide, beyond a right angle, and about several
/// axes.
const LIMITS: [[Option<Real>; 3]; 7] = [
    [None, Some(0.3), None],
    [None, None, Some(0.8)],
    [None, Some(1.66), None],
    [None, Some(0.5), Some(0.8)],
    [None, Some(1.2), Some(2.6)],
    [Some(0.5), Some(0.5), None],
    [Some(1.0), Some(0.4), Some(3.0)],
];

/// Locked rotations: of ball joints, and of the three kinds of joints with two free rotations.
const LOCKS: [JointAxesMask; 4] =
    [JointAxesMask::empty(), JointAxesMask::ANG_X, JointAxesMask::ANG_Y, JointAxesMask::ANG_Z];

/// An arm of one or two links on a fixed body.
struct Arm {
    world: PhysicsWorld,
    links: Vec<RigidBodyHandle>,
    joints: Vec<(RigidBodyHandle, RigidBodyHandle, GenericJoint)>,
}

impl Arm {
    /// Stretched in a random direction, with random spins, on joints with these locked rotations that `drive`
    /// completes.
    fn new(
        (rate, substeps): (u32, usize),
        length: usize,
        locked: JointAxesMask,
        dice: &mut Dice,
        drive: &impl Fn(&mut GenericJoint, JointAxis),
    ) -> Self {
        let mut vector = |size: Real| Vector::from_array([0; 3].map(|_| dice.within(-size, size)));
        let mut world = world(rate);
        world.integration_parameters.num_solver_iterations = substeps;
        let frame = Rotation::from_scaled_axis(vector(3.0));
        let mut last = world.insert_body(RigidBodyBuilder::fixed());
        let (mut links, mut joints) = (Vec::new(), Vec::new());
        for k in 0..length {
            let center = frame * Vector::X * (HALF * (2 * k + 1) as Real);
            let body = RigidBodyBuilder::dynamic()
                .translation(center)
                .rotation(frame.to_scaled_axis())
                .angvel(vector(2.0))
                .can_sleep(false);
            let board = ColliderBuilder::cuboid(HALF, 0.1, 0.15)
                .density(50.0)
                .collision_groups(InteractionGroups::none());
            let (link, _) = world.insert(body, board);
            let mut joint = GenericJoint::new(JointAxesMask::LIN_AXES | locked);
            for axis in AXES {
                if !locked.contains(JointAxesMask::from_bits_truncate(1 << axis as u8)) {
                    drive(&mut joint, axis);
                }
            }
            if k == 0 {
                joint.local_frame1.rotation = frame;
            } else {
                joint.local_frame1.translation = Vector::X * HALF;
            }
            joint.local_frame2.translation = Vector::NEG_X * HALF;
            world.insert_impulse_joint(last, link, joint);
            joints.push((last, link, joint));
            links.push(link);
            last = link;
        }
        // The first step removes the velocities along locked axes.
        world.step();
        Self { world, links, joints }
    }

    fn kinetic_energy(&self) -> Real {
        self.links.iter().map(|link| self.world.bodies[*link].kinetic_energy()).sum()
    }

    fn energy(&self) -> Real {
        energy(&self.world, &self.links, 0.0)
    }

    /// The energy that lifts the arm by its length.
    fn scale(&self) -> Real {
        let mass: Real = self.links.iter().map(|link| self.world.bodies[*link].mass()).sum();
        mass * G * 2.0 * HALF * self.links.len() as Real
    }

    /// The largest angle by which a limit is exceeded.
    fn exceeded(&self) -> Real {
        let mut most: Real = 0.0;
        for (first, second, joint) in &self.joints {
            let [first, second] = [first, second].map(|body| self.world.bodies[*body].rotation());
            for axis in AXES {
                if let (Some(limits), Some(angle)) =
                    (joint.limits(axis), joint.angle(axis, first, second))
                {
                    most = most.max(angle - limits.max).max(limits.min - angle);
                }
            }
        }
        most
    }
}

/// Calls a function for arms of one and two links on joints with these locked rotations.
fn for_each_arm(
    locked: JointAxesMask,
    sample: &mut Sample,
    drive: impl Fn(&mut GenericJoint, JointAxis),
    mut check: impl FnMut(Arm, String),
) {
    for length in [1, 2] {
        for rate in STEPS {
            for seed in 0..7 {
                if sample.has_next() {
                    let name = format!("{locked:?} locked, {length} links, {rate:?}, {seed}");
                    check(Arm::new(rate, length, locked, &mut Dice(seed), &drive), name);
                }
            }
        }
    }
}

/// Limits do no work, wherever an arm swings. Joints with two free rotations keep to them within 0.02 rad. A
/// ball joint does where its swing is not near half a turn, as with limits about both axes.
#[test]
fn limits_give_falling_arms_no_energy() {
    let mut sample = Sample::one_of(13);
    for limits in LIMITS {
        let drive = |joint: &mut GenericJoint, axis: JointAxis| {
            if let Some(angle) = limits[axis as usize - JointAxis::AngX as usize] {
                joint.set_limits(axis, [-angle, angle]);
            }
        };
        for locked in LOCKS {
            for_each_arm(locked, &mut sample, drive, |mut arm, name| {
                let (start, scale) = (arm.energy(), arm.scale());
                let is_near_end = locked.is_empty() && limits[1..].contains(&None);
                for _ in 0..steps(&arm.world, 6.0) {
                    arm.world.step();
                    let gain = (arm.energy() - start) / scale;
                    assert!(gain < 0.05, "{limits:?}, {name}: gains {gain} of its energy");
                    let exceeded = arm.exceeded();
                    assert!(
                        is_near_end || exceeded < 0.02,
                        "{limits:?}, {name}: exceeded by {exceeded}"
                    );
                }
            });
        }
    }
}

/// The kinetic energy is at most that of the fall and of the springs: `k φ²/2` about each axis with a servo,
/// for at most a whole turn `φ`, and a thousandth for the integrator. (Ball joints have servos about both
/// swings. One alone does work whenever the arm passes the end of its swing.)
#[test]
fn servos_throw_no_falling_arm() {
    let mut sample = Sample::one_of(45);
    for limits in LIMITS {
        let drives = |axis: JointAxis| limits[axis as usize - JointAxis::AngX as usize].is_some();
        let is_steered = drives(JointAxis::AngY) && drives(JointAxis::AngZ);
        for (stiffness, damping) in [(50.0, 0.0), (50.0, 5.0), (5000.0, 100.0), (1.0e6, 0.0)] {
            let drive = |joint: &mut GenericJoint, axis: JointAxis| {
                if drives(axis) {
                    joint.set_motor_model(axis, MotorModel::ForceBased);
                    joint.set_motor_position(axis, 0.4, stiffness, damping);
                }
            };
            for locked in LOCKS.into_iter().filter(|locked| is_steered || !locked.is_empty()) {
                for_each_arm(locked, &mut sample, drive, |mut arm, name| {
                    let joint = &arm.joints[0].2;
                    let servos =
                        (joint.motor_axes.bits().count_ones() as usize * arm.links.len()) as Real;
                    let turn = core::f64::consts::TAU as Real;
                    let springs = servos * 0.5 * stiffness * turn * turn;
                    let bound = 1.001 * (4.0 * arm.scale() + springs);
                    for _ in 0..steps(&arm.world, 6.0) {
                        arm.world.step();
                        let energy = arm.kinetic_energy();
                        assert!(
                            energy < bound,
                            "{limits:?}, {stiffness}, {damping}, {name}: {energy} J of {bound}"
                        );
                    }
                });
            }
        }
    }
}
