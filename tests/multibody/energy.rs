//! Energy of random trees never grows, with and without gravity, in flight, on a floor and in a cage.

use super::stage::{angular_momentum, momentum};
use crate::dim::{ang_length, close_cage, cuboid, loose_joint, moment, tumble, vec};
use crate::suite::physics::stage::{Dice, Sample, add_ground, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Obstacles of the trees.
#[derive(Copy, Clone, Debug, PartialEq)]
pub enum Place {
    Space,
    Floor,
    Cage,
}

/// What connects the links of a tree.
#[derive(Copy, Clone, Debug, PartialEq)]
pub enum Joints {
    Multibody,
    Impulse,
    /// Impulse joints with one free axis and a servo, of any stiffness, that keeps the initial pose.
    Servos,
}

/// A random tree, and its scene.
#[derive(Copy, Clone, Debug)]
pub struct Case {
    pub seed: u64,
    pub joints: Joints,
    pub links: usize,
    pub hangs: bool,
    pub is_chain: bool,
    /// Decadic logarithm of the largest mass ratio.
    pub mass_decades: Real,
    pub has_limits: bool,
    pub speed: Real,
    pub restitution: Real,
    pub has_gravity: bool,
    pub place: Place,
    /// Velocity (m/s) of the post or the floor along x.
    pub drift: Real,
}

impl Case {
    /// Creates the tree with this seed.
    pub fn new(seed: u64) -> Self {
        let mut dice = Dice(seed.wrapping_mul(0x1234_5679));
        let mut pick = |list: &[Real]| {
            list[(dice.within(0.0, list.len() as Real) as usize).min(list.len() - 1)]
        };
        let place = [Place::Space, Place::Floor, Place::Cage][pick(&[0.0, 1.0, 2.0]) as usize];
        Self {
            seed,
            joints: Joints::Multibody,
            links: pick(&[2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0]) as usize,
            hangs: pick(&[0.0, 0.0, 1.0]) > 0.5 && place == Place::Space,
            is_chain: pick(&[0.0, 1.0]) > 0.5,
            mass_decades: pick(&[0.0, 1.0, 2.0, 4.0]),
            has_limits: pick(&[0.0, 0.0, 1.0]) > 0.5,
            speed: pick(&[0.0, 3.0, 30.0, 150.0]),
            restitution: pick(&[0.0, 0.3, 0.6, 1.0]),
            has_gravity: pick(&[0.0, 1.0]) > 0.5,
            place,
            drift: 0.0,
        }
    }

    /// Builds the world of the case. Returns the world and the links.
    pub fn build(&self) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
        let mut world = world(60);
        let mut dice = Dice(self.seed);
        if !self.has_gravity {
            world.gravity = Vector::ZERO;
        }
        match self.place {
            Place::Space => {}
            Place::Floor if self.drift == 0.0 => drop(add_ground(&mut world, 0.5)),
            Place::Floor => {
                let slab = cuboid(100.0, 1.0).translation(vec(0.0, -1.0)).friction(0.5);
                world.insert(self.carrier(), slab);
            }
            Place::Cage => add_cage(&mut world, 5.0),
        }
        let throw = vec(dice.within(-1.0, 1.0), dice.within(-1.0, 0.2)).normalize() * self.speed;
        let mut places: Vec<Vector> = Vec::new();
        let mut bodies = Vec::new();
        let post =
            self.hangs.then(|| world.insert_body(self.carrier().translation(vec(-1.0, 2.0))));
        for k in 0..self.links {
            let at = vec(0.4 * k as Real - 0.2 * self.links as Real, 2.0 + dice.within(-0.2, 0.2));
            let spin =
                tumble(dice.within(-1.0, 1.0) * self.speed, dice.within(-0.5, 0.5) * self.speed);
            let body = RigidBodyBuilder::dynamic().translation(at).linvel(throw).angvel(spin);
            let (mass, shape) = self.shape(&mut dice);
            let (body, _) = world.insert(body.can_sleep(false), shape);
            let back =
                if self.is_chain { 1 } else { 1 + dice.within(0.0, k as Real * 0.999) as usize };
            let parent = if k == 0 {
                post.map(|post| (post, vec(-1.0, 2.0)))
            } else {
                Some((bodies[k - back.min(k)], places[k - back.min(k)]))
            };
            if let Some((parent, from)) = parent {
                let middle = (at + from) * 0.5;
                let kind = dice.within(0.0, 5.99) as usize;
                let mut joint = match self.joints {
                    Joints::Servos => servo(kind, mass, &mut dice, middle - from, middle - at),
                    _ => joint(kind, middle - from, middle - at),
                };
                if self.has_limits {
                    joint.set_limits(JointAxis::AngX, [-0.5, 0.5]);
                }
                joint.set_contacts_enabled(false);
                match self.joints {
                    Joints::Multibody => {
                        world.multibody_joints.insert(parent, body, joint, true).expect("it fits");
                    }
                    Joints::Impulse | Joints::Servos => {
                        world.insert_impulse_joint(parent, body, joint);
                    }
                }
            }
            places.push(at);
            bodies.push(body);
        }
        (world, bodies)
    }

    /// The mass and the shape of a link.
    fn shape(&self, dice: &mut Dice) -> (Real, ColliderBuilder) {
        let mass = Real::powf(10.0, dice.within(0.0, self.mass_decades));
        let size = dice.within(0.05, 0.15);
        let shape = match dice.within(0.0, 2.99) as usize {
            0 => ColliderBuilder::ball(size),
            1 => cuboid(size, 0.5 * size),
            _ => ColliderBuilder::capsule_x(0.5 * size, 0.5 * size),
        };
        let friction = dice.within(0.0, 1.0);
        (mass, shape.mass(mass).restitution(self.restitution).friction(friction))
    }

    /// The post or the floor.
    fn carrier(&self) -> RigidBodyBuilder {
        match self.drift {
            0.0 => RigidBodyBuilder::fixed(),
            drift => RigidBodyBuilder::kinematic_velocity_based().linvel(vec(drift, 0.0)),
        }
    }

    /// The energy of the links in the frame of the post or the floor.
    fn energy(&self, world: &PhysicsWorld, links: &[RigidBodyHandle]) -> [Real; 2] {
        let [kinetic, potential] = energy(world, links);
        let shift = |&link: &RigidBodyHandle| {
            let body = &world.bodies[link];
            body.mass() * self.drift * (0.5 * self.drift - body.linvel().x)
        };
        [kinetic + links.iter().map(shift).sum::<Real>(), potential]
    }
}

fn joint(kind: usize, anchor1: Vector, anchor2: Vector) -> GenericJoint {
    if kind < 4 {
        return loose_joint(kind, anchor1, anchor2);
    }
    if kind == 4 {
        return FixedJointBuilder::new()
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .build()
            .into();
    }
    let slide =
        PrismaticJointBuilder::new(vec(0.6, 0.8)).local_anchor1(anchor1).local_anchor2(anchor2);
    slide.limits([-0.1, 0.1]).build().into()
}

/// A hinge or slider with a servo: from 0.1 to 10⁵ N/m or N·m/rad per kilogram, damped in 0.1 s.
fn servo(
    kind: usize,
    mass: Real,
    dice: &mut Dice,
    anchor1: Vector,
    anchor2: Vector,
) -> GenericJoint {
    // Among the loose joints, the kinds 1 and 2 are hinges.
    let kind = [1, 2, 5][kind % 3];
    let axis = if kind == 5 { JointAxis::LinX } else { JointAxis::AngX };
    let stiffness = Real::powf(10.0, dice.within(-1.0, 5.0)) * mass;
    let mut joint = joint(kind, anchor1, anchor2);
    joint.set_motor_position(axis, 0.0, stiffness, 0.1 * stiffness);
    joint.set_motor_model(axis, MotorModel::ForceBased);
    joint
}

fn add_cage(world: &mut PhysicsWorld, half: Real) {
    for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        let center = vec(x, y) * (half + 1.0) + vec(0.0, 2.0);
        let wall = ColliderBuilder::halfspace(-vec(x, y)).translation(center - vec(x, y));
        world.insert_collider(wall.friction(0.5), None);
    }
    close_cage(world, half);
}

/// Returns the kinetic and potential energy of the links, with heights at the middle of the last substep, in
/// agreement with the velocities.
pub fn energy(world: &PhysicsWorld, links: &[RigidBodyHandle]) -> [Real; 2] {
    let half = 0.5 * world.integration_parameters.substep();
    let mut sum = [0.0; 2];
    for &link in links {
        let body = &world.bodies[link];
        let height = body.center_of_mass().y - half * body.linvel().y;
        sum[0] += body.kinetic_energy();
        sum[1] += body.mass() * world.gravity.length() * height;
    }
    sum
}

/// Result of a case.
pub struct Outcome {
    /// Largest energy above an earlier minimum, or above the initial energy of servos (J).
    pub gain: Real,
    /// Reference energy (J).
    pub scale: Real,
    pub fastest: Real,
}

/// Runs a case.
pub fn run_case(case: &Case, steps: usize) -> Outcome {
    let (mut world, links) = case.build();
    // The energy of trees without springs is that of velocities which their joints allow. Bodies at rest on a
    // moving one have some in its frame.
    let has_springs = case.joints == Joints::Servos;
    if !has_springs && case.drift == 0.0 {
        world.step();
    }
    let [kinetic, _] = case.energy(&world, &links);
    let mass: Real = links.iter().map(|&link| world.bodies[link].mass()).sum();
    let scale = kinetic + mass * world.gravity.length() * 0.4 * case.links as Real;
    let mut least = case.energy(&world, &links).iter().sum::<Real>();
    let (mut gain, mut fastest): (Real, Real) = (0.0, 0.0);
    for _ in 0..steps {
        world.step();
        let now = case.energy(&world, &links).iter().sum::<Real>();
        gain = gain.max(now - least);
        if !has_springs {
            least = least.min(now);
        }
        for &link in &links {
            fastest = fastest.max(world.bodies[link].linvel().length());
        }
    }
    Outcome { gain, scale, fastest }
}

/// Runs trees and checks the largest energy gains of each place.
fn check_trees(
    joints: Joints,
    fastest: Real,
    select: impl Fn(Case) -> Option<Case>,
    mut sample: Sample,
    steps: usize,
) {
    let columns = ["place", "trees", "worst gain (%)", "of tree", "fastest (m/s)"];
    let mut table = Table::new("largest gain of energy of random trees", &columns);
    let seeds: Vec<u64> = (0..1000).filter(|_| sample.has_next()).collect();
    for place in [Place::Space, Place::Floor, Place::Cage] {
        let cases = seeds.iter().map(|&seed| Case { joints, ..Case::new(seed) });
        let cases = cases.filter(|case| case.place == place && case.speed <= fastest);
        let cases = cases.filter_map(&select);
        let judged = cases.map(|case| {
            let outcome = run_case(&case, steps);
            (outcome.gain / outcome.scale.max(Real::MIN_POSITIVE), case, outcome)
        });
        let mut judged: Vec<_> = judged.collect();
        judged.sort_by(|a, b| b.0.total_cmp(&a.0));
        for (gain, case, outcome) in judged.iter().take(4) {
            table.row([
                format!("{place:?}"),
                judged.len().to_string(),
                format!("{:.3}", gain * 100.0),
                case.seed.to_string(),
                format!("{:.1}", outcome.fastest),
            ]);
            table.require(*gain < WORST_GAIN_MAX, &format!("energy came from nowhere: {case:?}"));
        }
        let beyond = judged.iter().filter(|(gain, ..)| *gain >= GAIN_MAX).count();
        table.require(beyond <= 1, &format!("{beyond} trees gain energy"));
    }
}

/// Largest energy gain, as a fraction of the initial kinetic energy plus `m g L`. The ledger of energy bounds
/// the error by 2.5 % in either direction. The correction of penetration does work against gravity, and
/// heights at a substep's middle are accurate to second order.
const GAIN_MAX: Real = 0.06;
/// One of 1,000 trees, in 2D and double precision, gains 18 % in a cage at 150 m/s and mass ratios of 1:10⁴.
const WORST_GAIN_MAX: Real = 0.2;

/// Random trees have chains and branches of all joints, limits, and restitutions up to 1. Mass ratios are up
/// to 1:10⁴, and speeds up to 150 m/s. There are no motors, so the energy never increases.
#[test]
fn energy_of_random_trees_never_grows() {
    check_trees(Joints::Multibody, 150.0, Some, Sample::one_of(1), 120);
}

/// The same trees of impulse joints.
#[test]
fn energy_of_random_trees_of_impulse_joints_never_grows() {
    check_trees(Joints::Impulse, 150.0, Some, Sample::one_of(4), 120);
}

/// A post or a floor that moves does work. In its frame, impulses give no energy.
#[test]
fn trees_on_moving_bodies_gain_no_energy_in_their_frame() {
    let select = |case: Case| match case.place {
        Place::Space => Some(Case { hangs: true, drift: 5.0, ..case }),
        Place::Floor => Some(Case { drift: 5.0, ..case }),
        Place::Cage => None,
    };
    check_trees(Joints::Impulse, 150.0, select, Sample::one_of(4), 120);
}

/// Trees of hinges and sliders with servos that keep the initial pose, at up to 30 m/s. Springs return no
/// more than they took.
#[test]
fn servos_give_random_trees_no_energy() {
    check_trees(Joints::Servos, 30.0, Some, Sample::one_of(4), 120);
}

/// Trees without external forces have constant linear and angular momentum.
#[test]
fn free_trees_keep_their_momentum() {
    let columns = ["tree", "of P (%)", "of L (%)"];
    let mut table = Table::new("momentum of free trees, 1 s", &columns);
    for seed in 0..200 {
        let case =
            Case { hangs: false, has_gravity: false, place: Place::Space, ..Case::new(seed) };
        let (mut world, links) = case.build();
        let index = world.multibody_joints.rigid_body_link(links[1]).expect("a link").multibody;
        let multibody = world.multibody_joints.get_multibody_mut(index).expect("a multibody");
        multibody.set_self_contacts_enabled(false);
        world.step();
        let mass: Real = links.iter().map(|&link| world.bodies[link].mass()).sum();
        let spin = |world: &PhysicsWorld| {
            let at = |&link: &RigidBodyHandle| {
                world.bodies[link].center_of_mass() * world.bodies[link].mass()
            };
            let center = links.iter().map(at).sum::<Vector>() / mass;
            angular_momentum(world, &links) - moment(center, momentum(world, &links))
        };
        let [kinetic, _] = energy(&world, &links);
        let (linear, angular) = (momentum(&world, &links), spin(&world));
        for _ in 0..60 {
            world.step();
        }
        // The scale is the momentum of the kinetic energy, with moment arms of a metre.
        let scale = (2.0 * mass * kinetic).sqrt().max(Real::MIN_POSITIVE);
        let lost = (momentum(&world, &links) - linear).length() / scale;
        let turned = ang_length(spin(&world) - angular) / scale;
        table.row([
            seed.to_string(),
            format!("{:.5}", lost * 100.0),
            format!("{:.5}", turned * 100.0),
        ]);
        table.require(lost < 1.0e-3 && turned < 1.0e-2, "momentum is not kept");
    }
}
