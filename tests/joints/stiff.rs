//! Motors, springs and limits of any stiffness put in no energy.
//!
//! Each test runs over a family: kinds of joints, stiffness over twelve decades, mass ratios, rates and
//! numbers of substeps. The bound of the energy is that of the start, and the bound of a limit is half a
//! degree.

use super::stage::{bob, post};
use crate::dim::{about_z, ang_length, angle, cuboid, hinge, vec, z_of};
use crate::suite::physics::stage::{RATES, Sample, steps, substep, weightless, world};
use rapier::prelude::*;

/// Half a degree: the tolerance of limits.
const TOLERANCE: Real = 0.5 * core::f64::consts::PI as Real / 180.0;
/// Rounding and the discretisation of the period, as a fraction of the energy.
const ENERGY_ROOM: Real = 0.01;
/// Springs up to this angle (rad) per substep keep their energy. Faster ones are damped.
const FAST_ANGLE: Real = 0.4;

/// A kind of spring between a post and a body.
#[derive(Copy, Clone, Debug)]
enum Spring {
    Joint,
    Hinge,
    Slider,
}

/// A body on a spring, pulled off its rest.
struct Pulled {
    world: PhysicsWorld,
    body: RigidBodyHandle,
    spring: Spring,
    stiffness: Real,
}

const REST: Real = 1.0;
const PULL: Real = 0.4;
const RADIUS: Real = 0.5;

impl Pulled {
    fn new(rate: u32, substeps: usize, spring: Spring, mass: Real, stiffness: Real) -> Self {
        let mut world = weightless(rate);
        world.integration_parameters.num_solver_iterations = substeps;
        let post = post(&mut world, Vector::ZERO);
        let at = match spring {
            Spring::Joint => vec(REST + PULL, 0.0),
            Spring::Hinge => Vector::ZERO,
            Spring::Slider => vec(PULL, 0.0),
        };
        let body = world.insert_body(bob(mass, RADIUS).translation(at));
        let joint: GenericJoint = match spring {
            Spring::Joint => {
                SpringJointBuilder::new(Vector::ZERO, Vector::ZERO, REST, stiffness).build().into()
            }
            Spring::Hinge => hinge()
                .motor_position(PULL, stiffness, 0.0)
                .motor_model(MotorModel::ForceBased)
                .build()
                .into(),
            Spring::Slider => PrismaticJointBuilder::new(Vector::X)
                .motor_position(0.0, stiffness, 0.0)
                .motor_model(MotorModel::ForceBased)
                .build()
                .into(),
        };
        world.insert_impulse_joint(post, body, joint);
        Self { world, body, spring, stiffness }
    }

    /// Deflection of the spring.
    fn deflection(&self) -> Real {
        let body = &self.world.bodies[self.body];
        match self.spring {
            Spring::Joint => body.translation().length() - REST,
            Spring::Hinge => within_half_turn(angle(body.rotation()) - PULL),
            Spring::Slider => body.translation().x,
        }
    }

    /// The energy as a fraction of that at the start.
    fn energy(&self) -> Real {
        let (x, kinetic) =
            (self.deflection() / PULL, self.world.bodies[self.body].kinetic_energy());
        x * x + kinetic / (0.5 * self.stiffness * PULL * PULL)
    }

    /// Angle of the oscillation in a substep (rad).
    fn angle_per_substep(&self) -> Real {
        let body = &self.world.bodies[self.body];
        let inertia = match self.spring {
            Spring::Hinge => super::stage::inertia(body.mass(), RADIUS),
            Spring::Joint | Spring::Slider => body.mass(),
        };
        (self.stiffness / inertia).sqrt() * substep(&self.world)
    }
}

#[test]
fn springs_of_any_stiffness_gain_no_energy() {
    let (mut runs, mut most, mut least) = (0, 0.0, Real::INFINITY);
    let mut sample = Sample::one_of(5);
    for rate in RATES {
        for substeps in [1, 4, 16] {
            for spring in [Spring::Joint, Spring::Hinge, Spring::Slider] {
                for mass in [1.0e-3, 1.0, 1.0e3] {
                    for decade in 0..=12 {
                        if !sample.has_next() {
                            continue;
                        }
                        let stiffness = Real::powi(10.0, decade);
                        let mut pulled = Pulled::new(rate, substeps, spring, mass, stiffness);
                        let (mut largest, mut last) = (0.0, 1.0);
                        for _ in 0..rate {
                            pulled.world.step();
                            last = pulled.energy();
                            largest = Real::max(largest, last);
                        }
                        let angle = pulled.angle_per_substep();
                        let case = format!(
                            "{spring:?}, {mass} kg, {stiffness:e}, {rate} Hz, {substeps} substeps, {angle} rad"
                        );
                        assert!(largest < 1.0 + ENERGY_ROOM, "{case}: energy × {largest}");
                        (runs, most) = (runs + 1, Real::max(most, largest));
                        if angle < FAST_ANGLE {
                            assert!(last > 1.0 - ENERGY_ROOM, "{case}: energy × {last}");
                            least = least.min(last);
                        }
                    }
                }
            }
        }
    }
    println!("{runs} springs: energy × {most} at most, × {least} at least after a second if soft");
}

/// A chain of hinges with these limits from a post along x, and their bodies, which do not collide.
fn chain(
    world: &mut PhysicsWorld,
    masses: &[Real],
    joint: impl Fn() -> RevoluteJointBuilder,
) -> Vec<RigidBodyHandle> {
    let mut bodies = vec![post(world, vec(-0.5, 0.0))];
    for (k, &mass) in masses.iter().enumerate() {
        let body = RigidBodyBuilder::dynamic().translation(vec(k as Real, 0.0)).can_sleep(false);
        let shape = cuboid(0.5, 0.5).mass(mass).collision_groups(InteractionGroups::none());
        let (body, _) = world.insert(body, shape);
        let first = vec(if k == 0 { 0.0 } else { 0.5 }, 0.0);
        let joint = joint().local_anchor1(first).local_anchor2(vec(-0.5, 0.0));
        world.insert_impulse_joint(bodies[k], body, joint);
        bodies.push(body);
    }
    bodies
}

/// The angle without whole turns.
fn within_half_turn(angle: Real) -> Real {
    let turn = core::f64::consts::TAU as Real;
    angle - (angle / turn).round() * turn
}

/// The angles of a chain's hinges.
fn bends(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> impl Iterator<Item = Real> {
    bodies.windows(2).map(|pair| {
        let [first, second] = [pair[0], pair[1]].map(|body| angle(world.bodies[body].rotation()));
        within_half_turn(second - first)
    })
}

/// The largest excess over limits of `bound` on both sides.
fn excess(world: &PhysicsWorld, bodies: &[RigidBodyHandle], bound: Real) -> Real {
    bends(world, bodies).map(|bend| bend.abs() - bound).fold(-bound, Real::max)
}

fn fastest(world: &PhysicsWorld) -> Real {
    let speeds = world
        .bodies
        .iter()
        .map(|(_, body)| Real::max(body.linvel().length(), ang_length(body.angvel())));
    speeds.fold(0.0, Real::max)
}

#[test]
fn limits_hold_against_motors_of_any_strength() {
    const BOUND: Real = 0.5;
    let (mut worst, mut sample) = (Real::NEG_INFINITY, Sample::one_of(5));
    for rate in RATES {
        for substeps in [1, 4, 16] {
            for count in [1, 2, 5] {
                // The last link of a longer or slower one would rotate by more than half a turn in a substep.
                if count as Real * 100.0 > 3.0 * rate as Real * substeps as Real {
                    continue;
                }
                for ratio in [1.0e-3, 1.0, 1.0e3] {
                    for decade in [0, 2, 3, 4, 6, 9, 12] {
                        if !sample.has_next() {
                            continue;
                        }
                        let mut world = weightless(rate);
                        world.integration_parameters.num_solver_iterations = substeps;
                        let masses: Vec<Real> =
                            (0..count).map(|k| if k % 2 == 0 { 1.0 } else { ratio }).collect();
                        let factor = Real::powi(10.0, decade);
                        let bodies = chain(&mut world, &masses, || {
                            hinge().limits([-BOUND, BOUND]).motor_velocity(100.0, factor)
                        });
                        let mut beyond = 0.0;
                        for _ in 0..steps(&world, 2.0) {
                            world.step();
                            beyond = Real::max(beyond, excess(&world, &bodies, BOUND));
                        }
                        let case = format!(
                            "{count} hinges 1:{ratio}, factor {factor:e}, {rate} Hz, {substeps} substeps"
                        );
                        assert!(beyond < TOLERANCE, "{case}: {beyond} rad beyond");
                        worst = worst.max(beyond);
                        let speed = fastest(&world);
                        assert!(decade < 4 || speed < 0.05, "{case}: still moves by {speed}");
                    }
                }
            }
        }
    }
    println!("limits exceeded by {worst} rad at most");
}

/// Hinges whose limits are equal are welds: a beam of cubes stays straight under its weight.
#[test]
fn equal_limits_make_a_rigid_beam() {
    let mut sample = Sample::one_of(5);
    for rate in RATES {
        for substeps in [1, 4, 32] {
            for ratio in [1.0, 100.0] {
                if !sample.has_next() {
                    continue;
                }
                let mut world = world(rate);
                world.integration_parameters.num_solver_iterations = substeps;
                let masses: Vec<Real> = (0..6).map(|k| if k == 5 { ratio } else { 1.0 }).collect();
                let bodies = chain(&mut world, &masses, || hinge().limits([0.0, 0.0]));
                let mut speed = 0.0;
                for _ in 0..steps(&world, 5.0) {
                    world.step();
                    speed = Real::max(speed, fastest(&world));
                }
                let tip = world.bodies[bodies[6]].translation().y;
                let case = format!("{rate} Hz, {substeps} substeps, 1:{ratio}");
                assert!(speed < 0.02, "{case}: {speed} m/s");
                assert!(tip.abs() < 1.0e-3, "{case}: the tip is at {tip}");
            }
        }
    }
}

/// An arm of rigid servos takes its pose and stays there.
#[test]
fn arms_of_stiff_servos_reach_their_pose() {
    for rate in RATES {
        for ratio in [1.0e-2, 1.0, 1.0e2] {
            for decade in [10, 11, 12] {
                let stiffness = Real::powi(10.0, decade);
                let mut world = weightless(rate);
                let masses: Vec<Real> =
                    (0..5).map(|k| if k % 2 == 0 { 1.0 } else { ratio }).collect();
                let bodies = chain(&mut world, &masses, || {
                    // Damped by a fifth of the critical damping of one link.
                    let damping = 0.2 * stiffness.sqrt();
                    hinge()
                        .motor_position(0.3, stiffness, damping)
                        .motor_model(MotorModel::ForceBased)
                });
                crate::suite::physics::stage::run(&mut world, 2.0);
                let case = format!("{stiffness:e} N·m/rad, 1:{ratio}, {rate} Hz");
                let off = bends(&world, &bodies).map(|bend| within_half_turn(bend - 0.3).abs());
                let off = off.fold(0.0, Real::max);
                let speed = fastest(&world);
                assert!(off < 1.0e-2 && speed < 0.1, "{case}: {off} rad off, {speed} m/s");
            }
        }
    }
}

/// Two bodies whose fixed joint is made by any angle off come together, and keep none of the energy.
#[test]
fn joints_made_far_off_leave_no_energy() {
    for rate in RATES {
        for degrees in [10.0, 90.0, 135.0, 170.0, 178.0, 179.9, 180.0] {
            for distance in [0.0, 1.0] {
                let mut world = weightless(rate);
                let one = world.insert_body(bob(1.0, 0.5));
                let turned = bob(1.0, 0.5).rotation(about_z(Real::to_radians(degrees)));
                let two = world.insert_body(turned.translation(vec(distance, 0.3 * distance)));
                world.insert_impulse_joint(one, two, FixedJointBuilder::new());
                let mut most = 0.0;
                for _ in 0..steps(&world, 2.0) {
                    world.step();
                    most = Real::max(most, fastest(&world));
                }
                let case = format!("{degrees}° and {distance} m off at {rate} Hz");
                assert!(most < 1.0e-3, "{case}: {most} m/s");
                let [a, b] = [one, two].map(|body| &world.bodies[body]);
                let off = within_half_turn(angle(b.rotation()) - angle(a.rotation())).abs();
                let apart = (b.translation() - a.translation()).length();
                assert!(off < 1.0e-3 && apart < 1.0e-3, "{case}: {off} rad, {apart} m");
            }
        }
    }
}

/// An anchor that is moved by a user takes its body along. What is left of the motion is no energy.
#[test]
fn moved_anchors_leave_no_energy() {
    let joints: [(&str, GenericJoint); 3] = [
        ("hinge", hinge().local_anchor2(vec(-0.5, 0.0)).build().into()),
        ("weld", FixedJointBuilder::new().local_anchor2(vec(-0.5, 0.0)).build().into()),
        ("rope", RopeJointBuilder::new(0.5).build().into()),
    ];
    for rate in RATES {
        for (name, joint) in joints {
            for distance in [0.1, 2.0, 10.0] {
                let mut world = weightless(rate);
                let anchor = post(&mut world, Vector::ZERO);
                let body = world.insert_body(bob(1.0, 0.2).translation(vec(0.5, 0.0)));
                world.insert_impulse_joint(anchor, body, joint);
                crate::suite::physics::stage::run(&mut world, 0.2);
                world.bodies[anchor].set_translation(vec(0.0, distance), true);
                crate::suite::physics::stage::run(&mut world, 2.0);
                let body = &world.bodies[body];
                let energy = body.kinetic_energy();
                assert!(energy < 1.0e-3, "{name} by {distance} m at {rate} Hz: {energy} J");
                let length = (body.translation() - vec(0.0, distance)).length();
                assert!(length < 0.51, "{name} by {distance} m at {rate} Hz: {length} m");
                assert!(z_of(body.angvel()).abs() < 0.05);
            }
        }
    }
}

/// A bridge of ropes with planks carries a heavy box that is laid on it, and throws nothing.
#[test]
fn ropes_carry_heavy_loads() {
    for rate in RATES {
        for load in [10.0, 1000.0, 100_000.0] {
            let mut world = world(rate);
            let (count, length) = (20, 0.5);
            let mut last = post(&mut world, Vector::ZERO);
            for k in 1..count {
                let at = vec(k as Real * length, 0.0);
                let plank = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
                let (plank, _) = world.insert(plank, cuboid(0.2, 0.05).mass(20.0));
                world.insert_impulse_joint(last, plank, RopeJointBuilder::new(length));
                last = plank;
            }
            let end = post(&mut world, vec(count as Real * length, 0.0));
            world.insert_impulse_joint(last, end, RopeJointBuilder::new(length));
            let at = vec(0.5 * count as Real * length, 0.56);
            let body = RigidBodyBuilder::dynamic().translation(at).can_sleep(false);
            world.insert(body, cuboid(0.5, 0.5).mass(load));
            let energy = |world: &PhysicsWorld| -> Real {
                let moving = world.bodies.iter().filter(|(_, body)| body.is_dynamic());
                let of_each = moving.map(|(_, body)| {
                    body.kinetic_energy() - body.mass() * world.gravity.dot(body.center_of_mass())
                });
                of_each.sum()
            };
            let start = energy(&world);
            let mut gain = Real::NEG_INFINITY;
            for _ in 0..steps(&world, 4.0) {
                world.step();
                gain = gain.max(energy(&world) - start);
            }
            // A load of fifty times the planks wedges itself between them, and hops: by up to 70 cm in 2D,
            // and 11 cm in 3D (guide/joints.md).
            let most = if load == 1000.0 { 7.0 } else { 1.0 };
            assert!(gain < most * load, "{load} kg at {rate} Hz: {gain} J");
        }
    }
}
