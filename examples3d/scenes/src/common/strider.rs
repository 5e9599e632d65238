//! Machine that walks on Theo Jansen's legs: bars, hinges and one motor, in closed loops.

use super::jansen::{Leg, Point};
use crate::kit::{HALF_TURN, brick, flat, hinge, near};
use crate::rapier::prelude::*;

/// Length units per unit of the legs.
const SCALE: Real = 2.0;
/// Half thickness of bars, and of the crank.
const BAR: Real = 0.05;
const AXLE: Real = 0.1;
/// Half extents of the body.
const BODY: [Real; 2] = [1.0, 0.15];
/// Density of the bars relative to the body, small so that the legs' inertia does not shake it.
const BAR_DENSITY: Real = 0.3;
/// Largest torque of the motor.
const TORQUE: Real = 400.0;
/// Largest distance of a foot below the crank.
const HEIGHT: Real = 0.92 * SCALE;

/// A walking machine.
pub struct Strider {
    /// Body on the legs.
    pub body: RigidBodyHandle,
    /// The joint with the motor.
    pub motor: ImpulseJointHandle,
}

/// Bar or triangle of bars, and its middle relative to the crank.
struct Part {
    body: RigidBodyHandle,
    middle: Point,
}

/// Machine under construction.
struct Workshop<'a> {
    world: &'a mut PhysicsWorld,
    /// Position of the crank.
    crank: Vector,
}

impl Strider {
    /// Builds a machine with its feet at `foot`. Each of the `pairs` is one leg in front of and one behind
    /// the crank. Its numbers are the depth of the pair and its angle of the crank (rad). The crank rotates
    /// at `speed` (rad/s); a positive speed moves the machine to the left.
    pub fn new(
        world: &mut PhysicsWorld,
        foot: Vector,
        pairs: &[(Real, Real)],
        half_width: Real,
        speed: Real,
    ) -> Self {
        let crank = foot + Vector::Y * (HEIGHT + BAR);
        let mut workshop = Workshop { world, crank };
        let body = workshop.add_body(half_width);
        let axle = workshop.add_crank(pairs, half_width);
        for &(z, angle) in pairs {
            for side in [-1.0, 1.0] {
                workshop.add_leg(&body, &axle, z, &Leg::new(angle, side));
            }
        }
        let drive = hinge()
            .motor_model(MotorModel::ForceBased)
            .motor_velocity(speed, TORQUE)
            .motor_max_force(TORQUE);
        let motor = workshop.world.insert_impulse_joint(body.body, axle.body, drive);
        Self { body: body.body, motor }
    }
}

impl Workshop<'_> {
    fn add_body(&mut self, half_width: Real) -> Part {
        let shape = part(brick(BODY[0], BODY[1], half_width));
        let body = RigidBodyBuilder::dynamic().translation(self.crank).can_sleep(false);
        Part { body: self.world.insert(body, shape).0, middle: [0.0; 2] }
    }

    /// Adds an axle with an arm for each pair of legs.
    fn add_crank(&mut self, pairs: &[(Real, Real)], half_width: Real) -> Part {
        let body = RigidBodyBuilder::dynamic().translation(self.crank).can_sleep(false);
        let ends = [near(-half_width), near(half_width)];
        let (body, _) = self.world.insert(body, bar(ends, AXLE));
        for &(z, angle) in pairs {
            let arm = [near(z), place(Leg::new(angle, 1.0).pin) + near(z)];
            let arm = bar(arm, BAR);
            self.world.insert_collider(arm, Some(body));
        }
        Part { body, middle: [0.0; 2] }
    }

    /// Adds bars between these points, as one body.
    fn add_part(&mut self, z: Real, corners: &[Point]) -> Part {
        let share = 1.0 / corners.len() as Real;
        let sum = |axis: usize| corners.iter().map(|corner| corner[axis]).sum::<Real>();
        let middle = [sum(0) * share, sum(1) * share];
        let at = self.crank + place(middle) + near(z);
        let body =
            self.world.insert_body(RigidBodyBuilder::dynamic().translation(at).can_sleep(false));
        // A triangle has three sides, a bar has one.
        let sides = if corners.len() == 2 { 1 } else { corners.len() };
        for side in 0..sides {
            let ends = [corners[side], corners[(side + 1) % corners.len()]];
            let ends = ends.map(|end| place(end) - place(middle));
            let bar = bar(ends, BAR).density(BAR_DENSITY);
            self.world.insert_collider(bar, Some(body));
        }
        Part { body, middle }
    }

    fn add_leg(&mut self, body: &Part, axle: &Part, z: Real, leg: &Leg) {
        let push = self.add_part(z, &[leg.pin, leg.upper]);
        let pull = self.add_part(z, &[leg.pin, leg.lower]);
        let top = self.add_part(z, &[leg.pivot, leg.upper, leg.hip]);
        let rod = self.add_part(z, &[leg.pivot, leg.lower]);
        let link = self.add_part(z, &[leg.hip, leg.heel]);
        let shin = self.add_part(z, &[leg.lower, leg.heel, leg.foot]);
        for (first, second, point, from) in [
            (axle, &push, leg.pin, z),
            (axle, &pull, leg.pin, z),
            (body, &top, leg.pivot, z),
            (body, &rod, leg.pivot, z),
            (&top, &link, leg.hip, 0.0),
            (&rod, &shin, leg.lower, 0.0),
        ] {
            self.join(hinge().into(), [first, second], point, from);
        }
        // These joints close loops. The other joints already keep all parts in their planes, so these leave
        // the depth free.
        let pin = GenericJoint::new(JointAxesMask::LIN_X | JointAxesMask::LIN_Y);
        for (first, second, point) in
            [(&push, &top, leg.upper), (&pull, &rod, leg.lower), (&link, &shin, leg.heel)]
        {
            self.join(pin, [first, second], point, 0.0);
        }
    }

    /// Joins two parts at a point. The plane of the first part is `z` behind that of the second.
    fn join(&mut self, mut joint: GenericJoint, parts: [&Part; 2], point: Point, z: Real) {
        let [anchor1, anchor2] = parts.map(|part| place(point) - place(part.middle));
        joint.set_local_anchor1(anchor1 + near(z)).set_local_anchor2(anchor2);
        self.world.insert_impulse_joint(parts[0].body, parts[1].body, joint);
    }
}

/// Returns a bar from one point to another.
fn bar([from, to]: [Vector; 2], radius: Real) -> ColliderBuilder {
    part(SharedShape::capsule(from, to, radius))
}

/// Returns a collider that touches the world, but no other part of the machine.
fn part(shape: SharedShape) -> ColliderBuilder {
    let groups = InteractionGroups::new(Group::GROUP_2, !Group::GROUP_2);
    ColliderBuilder::new(shape).friction(1.0).collision_groups(groups)
}

/// Converts a point of a leg to length units, relative to the crank.
fn place([x, y]: Point) -> Vector {
    flat(x, y) * SCALE
}

/// Returns angles of the crank (rad) for a number of pairs of legs, evenly distributed over a revolution.
pub fn turns(pairs: usize, first: Real) -> impl Iterator<Item = Real> {
    (0..pairs).map(move |k| first + 2.0 * HALF_TURN * k as Real / pairs as Real)
}
