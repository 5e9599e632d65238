//! Stiff joints: forces that act on light bodies like stiff springs.
//!
//! A force `F` with the moment arm `r` on a body of mass `m` and inertia `I` acts like a spring on the body's
//! direction. A deflected body swings about its anchor with `ω² = F r / (I + m r²)`. A method with a constant
//! force direction within a substep, such as the symplectic one, is stable only for `h ω < 2`. Near that
//! limit, its small errors grow to vibrations of light bodies. The links of a chain under a weight a thousand
//! times as heavy are near that, and those under more are beyond. (In the fastest mode of a chain, neighbours
//! rotate in opposite directions. Its `ω²` is four times the sum over the two bodies of a joint.)
//!
//! If `(h ω)²`, summed over the two bodies of a joint, exceeds [`STIFFNESS_MAX`], a dissipative method solves
//! its whole component. It is position-based (Müller et al., "Detailed rigid body simulation with extended
//! position based dynamics", 2020; with all joints at once: Deul et al., "Direct position-based solver for
//! stiff rods", 2018). Starting without impulses, the bodies move freely, and are then projected on the
//! joints, along the rows at the *predicted* poses. A projection never adds energy, however stiff. It removes
//! about the fraction `(h ω)²` of the motion across the force in each substep, and of the angular momentum.
//! It removes vibrations completely, and hardly affects a heavy weight that swings slowly. A fast rotor loses
//! its spin within a second.
//!
//! The force of a rope or a spring between two points has no arm, but its direction rotates with the distance
//! `L` of the points: `ω² = F / (m L)`.
//!
//! ## Common rotation
//! A centripetal force causes no stiffness: it rotates with the bodies, and the symplectic method follows it
//! exactly. If the bodies rotate as a whole at the rate `Ω`, each centripetal force has about `ω² = Ω²`. That
//! amount, twice for each of two bodies, is subtracted. `Ω` is that of the component's angular momentum about
//! its centre of mass: light links that vibrate have little of it.
//!
//! One case of common rotation is damped nevertheless: thin bodies on hinges, faster than
//! [`GYROSCOPIC_ANGLE_MAX`] (36 rad/s at 240 substeps per second). Impulses use their inertias at the start
//! of a substep, and free motion those in its middle. The error of a hinge between the two grows slowly: at
//! 60 rad/s the axis of two rods would tumble after four seconds.
//!
//! ## Large unconstrained displacements
//! Joints must recover from the unconstrained poses of the bodies. When only gravity and their own speed lead
//! them, that is near. But contacts, limits and motors start with their impulses of the last substep. Without
//! the opposing joint impulses, they accelerate light bodies. A board of 1.4 kg between the ground and a load
//! of 140 kg would rotate by 2 rad in a substep. The rows there do not predict its final pose, Newton's steps
//! from there diverge, and a chain gained 10⁹ times its energy. A component with a body whose unconstrained
//! rotation exceeds [`UNCONSTRAINED_ANGLE_MAX`] is therefore projected at the current poses, in one step
//! without prediction. With constant rows, one projection is exact. It finds the nearest admissible velocity
//! (Gauss's principle of least constraint), and never adds energy. The next substep corrects the remaining
//! curvature error.
//!
//! ## Selection of the method
//! The forces of the last substep show whether a component is stiff; then it is projected from the beginning.
//! The forces of the symplectic solution may also make a component stiff, as when a weight tightens a slack
//! chain. Newton's steps may diverge. In both cases the impulses are rolled back, and the component is
//! projected.

use super::block::JointBlock;
use super::direct::DirectJoint;
use crate::dim::joint::inertia_about;
use crate::dim::joint_axes::JointAxesMask;
use crate::dim::math::{
    ANG_DIM, ANG_ZERO, AngularInertia, DIM, Real, Vector, ang_length_squared, cross, torque,
    zero_inertia,
};
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};

/// The `(h ω)²` above which a joint is stiff: a quarter of the stability limit of a chain. Pendulums of 2 cm
/// and double pendulums of 10 cm are below at 240 substeps per second.
const STIFFNESS_MAX: Real = 0.25;
/// Contribution of common rotation to `(h ω)²`, as a multiple of `(h Ω)²`.
const COMMON_ROTATION_FACTOR: Real = 4.0;
/// Largest common rotation (rad) of a component in a substep: Newton's steps do not converge from farther
/// away.
const COMMON_ANGLE_MAX: Real = 0.85;

/// If no joint exceeds this value, no other test is made.
const STIFFNESS_TESTED_MIN: Real = 0.01;
/// Largest common rotation (rad) of a component with thin bodies on hinges in a substep.
const GYROSCOPIC_ANGLE_MAX: Real = 0.15;
/// Largest additional rotation (rad) of a body in a substep without its joint impulses. Chains of boards of
/// 1:10:100 that fall on the ground keep to their energy with 0.05 to 1; with 2 they do not.
const UNCONSTRAINED_ANGLE_MAX: Real = 0.25;

/// Returns whether a joint has both free and locked rotations, between bodies whose world-space inertia
/// changes with their rotation.
fn is_gyroscopic(member: &DirectJoint, blocks: &[JointBlock]) -> bool {
    let locked = (member.form.locked >> DIM).count_ones() as usize;
    let inertias = &blocks[member.block as usize].inertias;
    (1..ANG_DIM).contains(&locked) && inertias.is_gyroscopic(member.lane as usize)
}

/// Returns whether a body has a large unconstrained displacement after the impulses of its joints were reset.
/// The test uses the motion without any impulse, so a body's own spin has no effect.
pub(super) fn have_large_displacement(
    members: &[DirectJoint],
    Moving { states, before, .. }: Moving<'_>,
    h: Real,
) -> bool {
    members.iter().flat_map(DirectJoint::movable).any(|(_, body)| {
        let [(_, now), (_, free)] = [states, before].map(|of| of[body as usize].velocity());
        ang_length_squared(now - free) * (h * h) > UNCONSTRAINED_ANGLE_MAX * UNCONSTRAINED_ANGLE_MAX
    })
}

/// Marks whether the joints of a component are stiff.
pub(super) fn note_stiff(members: &[DirectJoint], blocks: &mut [JointBlock], is_stiff: bool) {
    for member in members {
        let lanes = &mut blocks[member.block as usize].is_stiff;
        lanes.0[member.lane as usize] = if is_stiff { 1.0 } else { 0.0 };
    }
}

/// The bodies that joints hold: by solver index.
#[derive(Default)]
pub(super) struct GeometricStiffness {
    bodies: Vec<JointedBody>,
    /// Number of calls of [`Self::for_each`].
    evaluations: u32,
}

/// Poses and states of all bodies, by solver index, and their motion before any impulse of the substep. (The
/// impulses of the last substep act along its axes, and would count as rotation of the component.)
#[derive(Copy, Clone)]
pub(super) struct Moving<'a> {
    pub poses: &'a [BodyPose],
    pub states: &'a [BodyState],
    pub before: &'a [BodyState],
}

/// A body that joints hold.
#[derive(Copy, Clone)]
struct JointedBody {
    inv_mass: Real,
    inv_inertia: AngularInertia,
    /// Value of `evaluations` at the last visit of the body.
    counted: u32,
}

impl GeometricStiffness {
    /// Removes all bodies.
    pub fn clear(&mut self, body_count: usize) {
        let none = JointedBody { inv_mass: 0.0, inv_inertia: zero_inertia(), counted: 0 };
        self.evaluations = 0;
        self.bodies.clear();
        self.bodies.resize(body_count, none);
    }

    /// Notes the body on one side of a lane, which a joint holds.
    pub fn note(&mut self, block: &JointBlock, side: usize, lane: usize) {
        let body = block.bodies[side][lane];
        if body & READ_ONLY == 0 {
            let body = &mut self.bodies[body as usize];
            body.inv_mass = block.inv_mass[side].lane(lane).max_element();
            body.inv_inertia = block.inertias.lane(side, lane);
        }
    }

    /// Returns whether the joint forces make a component stiff.
    pub fn is_stiff(
        &mut self,
        members: &[DirectJoint],
        blocks: &[JointBlock],
        moving: Moving<'_>,
        h: Real,
    ) -> bool {
        let stiffnesses =
            members.iter().map(|member| self.stiffness(member, &blocks[member.block as usize]) * h);
        let stiffness = stiffnesses.fold(0.0, Real::max);
        if stiffness <= STIFFNESS_TESTED_MIN {
            return false;
        }
        let angle = self.turning(members, moving) * h;
        let excess = stiffness - COMMON_ROTATION_FACTOR * angle * angle;
        excess > STIFFNESS_MAX
            || angle > COMMON_ANGLE_MAX
            || (angle > GYROSCOPIC_ANGLE_MAX
                && members.iter().any(|member| is_gyroscopic(member, blocks)))
    }

    /// `ω² h` by the pull of a joint's last substep, summed over its bodies.
    fn stiffness(&self, member: &DirectJoint, block: &JointBlock) -> Real {
        let lane = member.lane as usize;
        let pull = block.applied.linear.lane(lane).length();
        let length = block.separation.lane(lane).length();
        let is_distance = member.form.locked & JointAxesMask::LIN_AXES.bits() == 0;
        let of_distance = if is_distance && length > 0.0 { pull / length } else { 0.0 };
        let stiffnesses = member.movable().map(|(side, body)| {
            let arm = block.arms[side].lane(lane).length();
            let JointedBody { inv_mass, inv_inertia, .. } = &self.bodies[body as usize];
            let of_arm = match inertia_about(inv_inertia) {
                Some(inertia) if *inv_mass > 0.0 => pull * arm / (inertia + arm * arm / inv_mass),
                _ => 0.0,
            };
            of_arm + of_distance * *inv_mass
        });
        stiffnesses.sum()
    }

    /// The common angular velocity of a component about its centre of mass (rad/s). It is the angular
    /// momentum divided by the moment of inertia about the axis of the momentum.
    fn turning(&mut self, members: &[DirectJoint], moving: Moving<'_>) -> Real {
        let Moving { poses, states, before } = moving;
        let (mut mass, mut moved, mut push) = (0.0, Vector::ZERO, Vector::ZERO);
        self.for_each(members, |index, body| {
            let m = 1.0 / body.inv_mass;
            let (shift, _) = states[index].displacement();
            mass += m;
            moved += (poses[index].center() + shift) * m;
            push += before[index].velocity().0 * m;
        });
        if mass <= 0.0 {
            return 0.0;
        }
        let (center, velocity) = (moved / mass, push / mass);
        let mut spin = ANG_ZERO;
        self.for_each(members, |index, body| {
            let ((v, w), (shift, _)) = (before[index].velocity(), states[index].displacement());
            let place = poses[index].center() + shift - center;
            spin += torque(place, (v - velocity) / body.inv_mass);
            spin += w * inertia_about(&body.inv_inertia).unwrap_or(0.0);
        });
        let size = ang_length_squared(spin).sqrt();
        if size <= 0.0 {
            return 0.0;
        }
        let (axis, mut inertia) = (spin / size, 0.0);
        self.for_each(members, |index, body| {
            let (shift, _) = states[index].displacement();
            let place = poses[index].center() + shift - center;
            inertia += cross(axis, place).length_squared() / body.inv_mass;
            inertia += inertia_about(&body.inv_inertia).unwrap_or(0.0);
        });
        size / inertia
    }

    /// Visits the bodies with a mass that these joints hold, each once.
    fn for_each(&mut self, members: &[DirectJoint], mut visit: impl FnMut(usize, &JointedBody)) {
        self.evaluations += 1;
        for index in members.iter().flat_map(DirectJoint::movable).map(|(_, body)| body as usize) {
            let body = &mut self.bodies[index];
            if body.counted != self.evaluations && body.inv_mass > 0.0 {
                body.counted = self.evaluations;
                visit(index, body);
            }
        }
    }
}
