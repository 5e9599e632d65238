//! Steps of a robot, to be counted: `robots NAME STEPS [SUBSTEPS]` with `ant`, `humanoid` or `arm`.
//!
//! The robots are multibodies as in `rapier.envs` of the Python package. Motors move all joints to and fro.
//! `crates/bench/instructions.sh` counts the instructions of a step.

use rapier3d::prelude::*;
use std::env::args;
use std::process::ExitCode;

/// Steps before the measurement.
const SETTLE: usize = 20;

/// Groups of colliders: the parts of a robot touch the ground alone.
const GROUND: Group = Group::GROUP_1;
const BODY: Group = Group::GROUP_2;

/// A robot in a world.
struct Robot {
    world: PhysicsWorld,
    /// Density of its parts (kg/m³).
    density: Real,
    /// Stiffness (1/s²) and damping (1/s) of its motors.
    servo: [Real; 2],
    joints: Vec<MultibodyJointHandle>,
    steps: usize,
}

impl Robot {
    fn new(dt: Real, density: Real, servo: [Real; 2]) -> Self {
        let mut world = PhysicsWorld::new();
        world.integration_parameters.dt = dt;
        Self { world, density, servo, joints: Vec::new(), steps: 0 }
    }

    fn add_ground(&mut self) {
        let ground = ColliderBuilder::halfspace(Vector::Y).friction(1.0);
        self.world
            .insert_collider(ground.collision_groups(InteractionGroups::new(GROUND, BODY)), None);
    }

    fn part(&mut self, at: Vector) -> RigidBodyHandle {
        self.world.insert_body(RigidBodyBuilder::dynamic().translation(at).can_sleep(false))
    }

    fn shape(&mut self, body: RigidBodyHandle, shape: ColliderBuilder) {
        let shape = shape.density(self.density).friction(1.0);
        let shape = shape.collision_groups(InteractionGroups::new(BODY, GROUND));
        self.world.insert_collider(shape, Some(body));
    }

    fn limb(&mut self, body: RigidBodyHandle, [from, to]: [Vector; 2], radius: Real) {
        self.shape(body, ColliderBuilder::capsule_from_endpoints(from, to, radius));
    }

    fn hinge(&mut self, bodies: [RigidBodyHandle; 2], at: Vector, axis: Vector, limits: [Real; 2]) {
        let [stiffness, damping] = self.servo;
        let joint = RevoluteJointBuilder::new(axis).local_anchor1(at).limits(limits);
        let joint = joint.contacts_enabled(false).motor_position(0.0, stiffness, damping);
        let inserted = self.world.insert_multibody_joint(bodies[0], bodies[1], joint);
        self.joints.push(inserted.expect("the joint fits"));
    }

    /// A torso with four legs of two links.
    fn ant() -> Self {
        let mut ant = Self::new(0.01, 200.0, [400.0, 40.0]);
        ant.add_ground();
        let (height, radius, bent) = (0.65 * Vector::Y, 0.25, 0.9);
        let torso = ant.part(height);
        ant.shape(torso, ColliderBuilder::ball(radius));
        for [x, z] in [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]] {
            let out = Vector::new(x, 0.0, z).normalize();
            let (hip, knee) = (radius * out, 0.28 * out);
            let foot = 0.57 * (Real::cos(bent) * out - Real::sin(bent) * Vector::Y);
            let [thigh, shin] = [hip, hip + knee].map(|at| ant.part(height + at));
            ant.limb(thigh, [Vector::ZERO, knee], 0.08);
            ant.limb(shin, [Vector::ZERO, foot], 0.08);
            ant.hinge([torso, thigh], hip, Vector::Y, [-0.6, 0.6]);
            ant.hinge([thigh, shin], knee, Vector::new(-out.z, 0.0, out.x), [-0.6, 0.6]);
        }
        ant
    }

    /// A pelvis and a chest, two legs of four links and two arms of three.
    fn humanoid() -> Self {
        let mut robot = Self::new(0.005, 1000.0, [900.0, 60.0]);
        robot.add_ground();
        let pelvis = robot.part(Vector::Y);
        robot.limb(pelvis, [0.08 * Vector::Z, -0.08 * Vector::Z], 0.1);
        let (waist, chest) = (0.1 * Vector::Y, robot.part(1.1 * Vector::Y));
        for (height, half, radius) in [(0.13, 0.09, 0.11), (0.28, 0.1, 0.09), (0.5, 0.01, 0.1)] {
            let [up, out] = [height * Vector::Y, half * Vector::Z];
            robot.limb(chest, [up + out, up - out], radius);
        }
        robot.hinge([pelvis, chest], waist, Vector::Z, [-0.6, 0.9]);
        for side in [1.0, -1.0] {
            for (root, origin, parts) in [(pelvis, Vector::ZERO, LEG), (chest, waist, ARM)] {
                let (mut last, mut from) = (root, origin);
                for part in parts {
                    (last, from) = robot.add_part(last, from, part, side);
                }
            }
        }
        robot
    }

    /// Adds a part of a limb to another one, whose joint is at `from`. Returns the body and the place of its
    /// joint.
    fn add_part(
        &mut self,
        parent: RigidBodyHandle,
        from: Vector,
        part: &Part,
        side: Real,
    ) -> (RigidBodyHandle, Vector) {
        let mirrored = |[x, y, z]: [Real; 3]| Vector::new(x, y, side * z);
        let at = mirrored(part.joint);
        let body = self.part(Vector::Y + at);
        for &(start, end) in part.segments {
            self.limb(body, [mirrored(start), mirrored(end)], part.radius);
        }
        let axis = if part.turns_out { -side * Vector::X } else { Vector::Z };
        self.hinge([parent, body], at - from, axis, part.limits);
        (body, at)
    }

    /// Seven hinges in a row on a fixed base.
    fn arm() -> Self {
        let mut arm = Self::new(0.01, 1000.0, [400.0, 40.0]);
        let (mut last, link) = (arm.world.insert_body(RigidBodyBuilder::fixed()), 0.3 * Vector::Y);
        for k in 0..7 {
            let body = arm.part(k as Real * link);
            arm.limb(body, [Vector::ZERO, link], 0.05);
            let axis = if k % 2 == 0 { Vector::Z } else { Vector::X };
            let at = if k == 0 { Vector::ZERO } else { link };
            arm.hinge([last, body], at, axis, [-2.5, 2.5]);
            last = body;
        }
        arm
    }

    /// Takes a step with new targets of the motors.
    fn step(&mut self) {
        let Self { world, joints, servo: [stiffness, damping], steps, .. } = self;
        *steps += 1;
        for (k, &handle) in joints.iter().enumerate() {
            let target = 0.4 * Real::sin(0.05 * *steps as Real + k as Real);
            let joint = world.multibody_joints.get_mut(handle);
            let link = joint.and_then(|(multibody, id)| multibody.link_mut(id));
            let data = &mut link.expect("the joint exists").joint.data;
            data.set_motor_position(JointAxis::AngX, target, *stiffness, *damping);
        }
        world.step();
    }
}

/// A part of a limb. Places are relative to the pelvis, for the left side.
struct Part {
    joint: [Real; 3],
    /// Whether it turns about x, outwards, and not about z.
    turns_out: bool,
    limits: [Real; 2],
    segments: &'static [([Real; 3], [Real; 3])],
    radius: Real,
}

const LEG: &[Part] = &[
    Part {
        joint: [0.0, -0.05, 0.1],
        turns_out: true,
        limits: [-0.4, 0.4],
        segments: &[([0.0, 0.02, 0.0], [0.0, -0.02, 0.0])],
        radius: 0.06,
    },
    Part {
        joint: [0.0, -0.05, 0.1],
        turns_out: false,
        limits: [-0.6, 1.6],
        segments: &[([0.0, 0.0, 0.0], [0.0, -0.4, 0.0])],
        radius: 0.065,
    },
    Part {
        joint: [0.0, -0.45, 0.1],
        turns_out: false,
        limits: [-2.0, 0.0],
        segments: &[([0.0, -0.02, 0.0], [0.0, -0.38, 0.0])],
        radius: 0.05,
    },
    Part {
        joint: [0.0, -0.87, 0.1],
        turns_out: false,
        limits: [-0.7, 0.5],
        segments: &[
            ([-0.07, -0.08, 0.03], [0.16, -0.08, 0.03]),
            ([-0.07, -0.08, -0.03], [0.16, -0.08, -0.03]),
        ],
        radius: 0.035,
    },
];

const ARM: &[Part] = &[
    Part {
        joint: [0.0, 0.42, 0.2],
        turns_out: true,
        limits: [-0.3, 1.5],
        segments: &[([0.0, 0.01, 0.0], [0.0, -0.01, 0.0])],
        radius: 0.05,
    },
    Part {
        joint: [0.0, 0.42, 0.2],
        turns_out: false,
        limits: [-1.2, 1.6],
        segments: &[([0.0, -0.02, 0.0], [0.0, -0.26, 0.0])],
        radius: 0.045,
    },
    Part {
        joint: [0.0, 0.14, 0.2],
        turns_out: false,
        limits: [0.0, 2.2],
        segments: &[([0.0, -0.03, 0.0], [0.0, -0.25, 0.0])],
        radius: 0.04,
    },
];

fn main() -> ExitCode {
    let arguments: Vec<String> = args().skip(1).collect();
    let number = |k: usize| arguments.get(k).and_then(|text| text.parse().ok());
    let robot = match arguments.first().map(String::as_str) {
        Some("ant") => Some(Robot::ant()),
        Some("humanoid") => Some(Robot::humanoid()),
        Some("arm") => Some(Robot::arm()),
        _ => None,
    };
    let (Some(mut robot), Some(steps)) = (robot, number(1)) else {
        eprintln!("robots ant|humanoid|arm STEPS [SUBSTEPS]");
        return ExitCode::FAILURE;
    };
    robot.world.integration_parameters.num_solver_iterations = number(2).unwrap_or(4);
    (0..SETTLE + steps).for_each(|_| robot.step());
    ExitCode::SUCCESS
}
