//! Impulse joints on links: between links of one multibody, where they close a loop, of two, or with an
//! ordinary body.
//!
//! A locked axis is a row with `C = 0` and an impulse of either sign, softened like other joints
//! (`model/params/softness.rs`). The rows are translations along the axes of the first frame at the second
//! anchor, and rotations about them ([`locked_angles`]). Limits and motors of free axes are rows like
//! those of multibody joints (`limits.rs`).
//!
//! Contacts may be frozen during a step, but rows of a swinging loop must follow its links, or they would
//! brake it. They are made in each substep ([`SolverMultibodies::follow_loops`]).
//!
//! In the solve pass, the rows are solved with those of the multibody's own joints (`system.rs`), up to a
//! number of rows; in the relax pass each joint alone. Redundant axes (a hinge
//! across a plane in which everything moves anyway) have no pivot there and get no impulse.

use super::SolverMultibodies;
use super::limits::Owner;
use super::load::scale_impulses;
use super::rows::{ConstrainedStates, JacobianPool, Row};
use super::sides::Side;
use super::system::{RowSystem, SystemRow, equation};
use crate::dim::joint::{FreeRotations, angle_about};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{
    ANG_ZERO, AngVector, DIM, Pose, Real, Rotation, SPATIAL_DIM, SpatialVector, Vector,
    integrate_rotation,
};
use crate::dim::spatial::{angular, join, linear, locked_angles, turn_axis};
use crate::dim::state::READ_ONLY;
use crate::model::body::RigidBodySet;
use crate::model::event::JointBreakEvent;
use crate::model::frozen::Frozen;
use crate::model::joint::{
    GenericJoint, ImpulseJointHandle, ImpulseJointSet, Transmission, TransmissionCount, mask_of,
    relative_rotation,
};
use crate::model::params::{JointPass, Softness};
use crate::step::solver::axis_law::AxisLaw;
use crate::step::solver::bodies::SolverBodies;
use crate::step::solver::context::SolverInput;
use crate::step::solver::joint_rules::break_if_overloaded;
use crate::step::solver::transmission_end::{End, EndNow, Moved};
use arrayvec::ArrayVec;

/// A locked axis.
#[derive(Copy, Clone, Debug)]
struct Locked {
    axis: JointAxis,
    row: Row,
    /// Effect of a unit impulse on the second body, at its anchor, in world space.
    wrench: SpatialVector,
    error: Real,
    /// The velocity that corrects the error.
    bias: Real,
    impulse: Real,
    /// Sum of the impulses of the substeps.
    total: Real,
}

/// One joint.
#[derive(Clone, Debug)]
struct Loop {
    handle: ImpulseJointHandle,
    slots: [u32; 2],
    /// The fraction of the last impulses with which it begins.
    fraction: Real,
    joint: GenericJoint,
    softness: Softness,
    /// A multibody with whose rows it is solved.
    solved_with: Option<usize>,
    locked: ArrayVec<Locked, SPATIAL_DIM>,
}

/// All impulse joints on links.
#[derive(Debug, Default)]
pub struct Loops {
    loops: Vec<Loop>,
    /// What their transmissions have counted.
    counts: Vec<(ImpulseJointHandle, TransmissionCount)>,
    /// First Jacobian of their locked axes.
    first_number: usize,
}

/// The frames of a joint in world space.
struct Frames {
    first: Rotation,
    /// The second, seen from the first.
    between: Rotation,
    /// From anchor to anchor.
    separation: Vector,
    anchors: [Vector; 2],
    rotations: [Rotation; 2],
    /// What a transmission has counted.
    counted: Real,
}

/// The body slots of a joint, and its index.
type Joined = ([u32; 2], ImpulseJointHandle);

impl SolverMultibodies {
    /// Makes constraints of the joints that were left out of the lanes.
    pub(super) fn prepare_loops(
        &mut self,
        input: SolverInput<'_>,
        bodies: &SolverBodies,
        pass: &JointPass,
    ) {
        let SolverInput { world, joints, islands, .. } = input;
        self.loops.loops.clear();
        self.loops.counts.clear();
        if self.moving.is_empty() {
            return;
        }
        let slots = islands.joint_graph.in_solving_order().flat_map(|(_, list)| list);
        let links = slots.filter_map(|&slot| islands.joints.get(slot));
        let links = links.filter(|link| self.solves_one_of(link.body_slots()));
        let mut joined: Vec<Joined> = links.map(|link| (link.body_slots(), link.handle)).collect();
        // They are solved one after the other, and their order in the colours depends on the rest of the
        // world.
        joined.sort_unstable_by_key(|(_, handle)| handle.into_raw_parts());
        for (slots, handle) in joined {
            let Some(joint) = joints.get(handle) else { continue };
            let sides = slots.map(|slot| self.side(slot, true, world, bodies));
            let Some(mut frames) = Frames::of(&joint.data, &sides, world, slots) else { continue };
            let fraction = self.fraction_of(&sides);
            let mut data = joint.data;
            scale_impulses(&mut data, fraction);
            let solved_with = self.connect(&sides, &data);
            let count = data.transmission.map(|of| of.count(joint.count, frames.poses()));
            self.loops.counts.extend(count.map(|count| (handle, count)));
            frames.counted = count.map_or(0.0, |count| count.sum);
            self.add_driven((handle, solved_with), &data, &sides, &frames, pass.substep);
            let softness = data.spring().map_or(pass.softness, |spring| {
                Softness::spring(spring.angular_frequency(), spring.damping_ratio, pass.substep)
            });
            let locked = ArrayVec::new();
            let joint =
                Loop { handle, slots, fraction, joint: data, softness, solved_with, locked };
            self.loops.loops.push(joint);
        }
    }

    /// Makes the rows of the locked axes. They must be the last ones.
    pub(super) fn lock_loops(
        &mut self,
        SolverInput { world, joints, .. }: SolverInput<'_>,
        bodies: &mut SolverBodies,
    ) {
        self.loops.first_number = self.jacobians.len();
        for position in 0..self.loops.loops.len() {
            let Loop { handle, fraction, .. } = self.loops.loops[position];
            let impulses = joints.get(handle).map_or([0.0; SPATIAL_DIM], |joint| joint.impulses);
            self.lock(position, world, bodies, |axis| (impulses[axis as usize] * fraction, 0.0));
        }
    }

    /// Recomputes the rows of the locked axes at the current poses.
    pub fn follow_loops(&mut self, world: &RigidBodySet, bodies: &mut SolverBodies) {
        self.warm_loops(bodies, -1.0);
        self.jacobians.truncate(self.loops.first_number);
        for position in 0..self.loops.loops.len() {
            let old = self.loops.loops[position].locked.clone();
            self.lock(position, world, bodies, |axis| {
                let same = old.iter().find(|locked| locked.axis == axis);
                same.map_or((0.0, 0.0), |locked| (locked.impulse, locked.total))
            });
        }
        self.warm_loops(bodies, 1.0);
    }

    /// Adds this fraction of the impulses so far to the warm start of the substep.
    pub(super) fn warm_loops(&mut self, bodies: &mut SolverBodies, fraction: Real) {
        let Self { jacobians, loops, moving, .. } = self;
        let mut states = ConstrainedStates { multibodies: moving, states: &mut bodies.states };
        for locked in loops.locked() {
            jacobians.push_early(&locked.row, locked.impulse * fraction, &mut states);
        }
    }

    /// Makes the rows of one joint's locked axes. `known` returns the impulse and the total of each.
    fn lock(
        &mut self,
        position: usize,
        world: &RigidBodySet,
        bodies: &mut SolverBodies,
        known: impl Fn(JointAxis) -> (Real, Real),
    ) {
        let Loop { slots, joint, locked, .. } = &mut self.loops.loops[position];
        let (slots, joint) = (*slots, *joint);
        locked.clear();
        let sides = slots.map(|slot| self.side_now(slot, true, world, bodies));
        let Some(frames) = Frames::of(&joint, &sides, world, slots) else { return };
        let along = frames.first.inverse() * frames.separation;
        let about = locked_angles(frames.between);
        let mut locked = ArrayVec::new();
        let axes = JointAxis::ALL.into_iter();
        for axis in axes.filter(|axis| joint.locked_axes.contains(mask_of(*axis))) {
            let k = axis as usize;
            let (wrench, error) = if k < DIM {
                (join(frames.first * Vector::AXES[k], ANG_ZERO), along[k])
            } else {
                let (error, direction) = about[k - DIM];
                (join(Vector::ZERO, turn_axis(frames.first, direction)), error)
            };
            let row = self.row_at(&sides, &frames, &wrench);
            let states =
                ConstrainedStates { multibodies: &mut self.moving, states: &mut bodies.states };
            let error = error - self.jacobians.displacement(&row, &states);
            let (impulse, total) = known(axis);
            locked.push(Locked { axis, row, wrench, error, bias: 0.0, impulse, total });
        }
        self.loops.loops[position].locked = locked;
    }

    /// A side of a joint or a contact where it is now.
    pub(super) fn side_now<'a>(
        &self,
        slot: u32,
        is_movable: bool,
        world: &'a RigidBodySet,
        bodies: &SolverBodies,
    ) -> Side<'a> {
        let mut side = self.side(slot, is_movable, world, bodies);
        if let Some((_, index)) = side.body {
            let (shift, rotvec) = bodies.states[(index & !READ_ONLY) as usize].displacement();
            side.center = side.center.map(|center| center + shift);
            side.rotation = integrate_rotation(side.rotation, rotvec);
        }
        side
    }

    /// A multibody with whose rows a joint is solved.
    fn connect(&mut self, sides: &[Side<'_>; 2], joint: &GenericJoint) -> Option<usize> {
        let places = sides.iter().filter_map(Side::place);
        let mut multibodies = places.map(|place| place.multibody);
        let first = multibodies.next()?;
        let row_count = joint.locked_axes.bits().count_ones() as usize;
        self.system.connect([first, multibodies.next().unwrap_or(first)], row_count)
    }

    fn add_driven(
        &mut self,
        (handle, solved_with): (ImpulseJointHandle, Option<usize>),
        joint: &GenericJoint,
        sides: &[Side<'_>; 2],
        frames: &Frames,
        h: Real,
    ) {
        let position = self.loops.loops.len();
        for axis in joint.driven_axes() {
            let (row, wrench, q, is_distance) = match &joint.transmission {
                Some(transmission) => {
                    let (row, wrench, q) = self.add_transmission(transmission, sides, frames);
                    (row, wrench, q, false)
                }
                None => {
                    let (wrench, q, is_distance) = frames.free_axis(joint, axis);
                    (self.row_at(sides, frames, &wrench), wrench, q, is_distance)
                }
            };
            let owner = Owner::Loop { joint: handle, position, solved_with, wrench };
            if let Some(limits) = joint.limits(axis) {
                let mut limits = *limits;
                if is_distance && limits.min <= 0.0 {
                    limits.min = -Real::MAX;
                }
                self.joints.add_limits(owner, axis, row, q, &limits);
            }
            if let Some(motor) = joint.motor(axis) {
                self.joints.add_motor(owner, axis, row, q, motor, h);
            }
        }
    }

    /// The row of a transmission, its wrench on the second body, and its sum.
    fn add_transmission(
        &mut self,
        transmission: &Transmission,
        sides: &[Side<'_>; 2],
        frames: &Frames,
    ) -> (Row, SpatialVector, Real) {
        let now: [EndNow; 2] = core::array::from_fn(|side| {
            let (anchor, frame) = (frames.anchors[side], frames.rotations[side]);
            let center = sides[side].center.unwrap_or(anchor);
            End::new(transmission, side, center, anchor - center, frame).after(&Moved::NONE)
        });
        let row = self.row_of_wrenches(sides, now.map(|end| end.row()));
        let [first, second] = now;
        let sum = frames.counted + first.coordinate + second.coordinate;
        (row, join(second.force, second.couple), sum)
    }

    /// The row of a wrench on the second body, at its anchor.
    fn row_at(&mut self, sides: &[Side<'_>; 2], frames: &Frames, wrench: &SpatialVector) -> Row {
        let (force, couple) = (linear(wrench), angular(wrench));
        let one = sides[0].wrench(frames.anchors[1], -force);
        let two = sides[1].wrench(frames.anchors[1], force);
        let turned =
            |of: SpatialVector, couple: AngVector| join(linear(&of), angular(&of) + couple);
        self.row_of_wrenches(sides, [turned(one, -couple), turned(two, couple)])
    }
}

impl Frames {
    /// Both frames as poses.
    fn poses(&self) -> [Pose; 2] {
        core::array::from_fn(|side| Pose::from_parts(self.anchors[side], self.rotations[side]))
    }

    fn of(
        joint: &GenericJoint,
        sides: &[Side<'_>; 2],
        world: &RigidBodySet,
        slots: [u32; 2],
    ) -> Option<Self> {
        let locals = [joint.local_frame1, joint.local_frame2];
        let mut rotations = [Rotation::IDENTITY; 2];
        let mut anchors = [Vector::ZERO; 2];
        for k in 0..2 {
            let (_, body) = world.at_slot(slots[k])?;
            // The pose of a link follows from its coordinates; an immovable body has no centre.
            let (rotation, center) = match sides[k].center {
                Some(center) => (sides[k].rotation, center),
                None => (body.pose.rotation, body.center_of_mass()),
            };
            rotations[k] = rotation * locals[k].rotation;
            anchors[k] = center + rotation * (locals[k].translation - body.local_center_of_mass());
        }
        Some(Self {
            first: rotations[0],
            between: relative_rotation(&rotations[0], &rotations[1]),
            separation: anchors[1] - anchors[0],
            anchors,
            rotations,
            counted: 0.0,
        })
    }

    /// The direction of the second body along a free axis, the coordinate, and whether that is a distance.
    fn free_axis(&self, joint: &GenericJoint, axis: JointAxis) -> (SpatialVector, Real, bool) {
        let coupled = joint.coupled_axes & !joint.locked_axes;
        if axis as usize >= DIM {
            let rotations = FreeRotations::new(!joint.locked_axes, joint.coupled_axes);
            let (angle, direction) = angle_about(axis, rotations, &self.between);
            let about = turn_axis(self.first, direction);
            return (join(Vector::ZERO, about), angle, false);
        }
        let own = self.first * Vector::AXES[axis as usize];
        let linear_axes = coupled & JointAxesMask::LIN_AXES;
        if linear_axes.bits().count_ones() < 2 || !linear_axes.contains(mask_of(axis)) {
            return (join(own, ANG_ZERO), own.dot(self.separation), false);
        }
        let mut towards = Vector::ZERO;
        for other in JointAxis::ALL.into_iter().take(DIM) {
            if linear_axes.contains(mask_of(other)) {
                let along = self.first * Vector::AXES[other as usize];
                towards += along * along.dot(self.separation);
            }
        }
        let length = towards.length();
        let direction = if length > 0.0 { towards / length } else { own };
        (join(direction, ANG_ZERO), length, true)
    }
}

impl Loops {
    fn locked(&mut self) -> impl Iterator<Item = &mut Locked> {
        self.loops.iter_mut().flat_map(|joint| &mut joint.locked)
    }

    /// Scales the impulses with which the next substep starts, by a factor for each row.
    pub fn scale_impulses(&mut self, factor: impl Fn(&Row) -> Real) {
        self.locked().for_each(|locked| locked.impulse *= factor(&locked.row));
    }

    /// All rows, and the impulses that they have given in this substep.
    pub fn rows(&self) -> impl Iterator<Item = (&Row, Real)> {
        let locked = self.loops.iter().flat_map(|joint| &joint.locked);
        locked.map(|axis| (&axis.row, axis.impulse))
    }

    /// Adds the laws of all locked axes to a system; with `bias`, position errors are corrected. Springs pull
    /// in the relax pass as they did in the solve pass.
    pub fn add_to(
        &mut self,
        system: &mut RowSystem,
        jacobians: &JacobianPool,
        states: &ConstrainedStates<'_>,
        bias: bool,
    ) {
        for (position, joint) in self.loops.iter_mut().enumerate() {
            let group = system.group_of_loop(position, joint.solved_with);
            let is_spring = joint.joint.spring().is_some();
            for locked in &mut joint.locked {
                if bias {
                    let error = locked.error + jacobians.displacement(&locked.row, states);
                    locked.bias = error * joint.softness.bias_rate;
                } else if !is_spring {
                    locked.bias = 0.0;
                }
            }
            for locked in &joint.locked {
                let law = joint.law(locked, bias || is_spring);
                let impulses = [locked.impulse, 0.0, 0.0];
                system.rows.push(SystemRow::new(group, locked.row, law, impulses));
            }
        }
    }

    /// Takes the impulses of the rows, in the order of [`Self::add_to`].
    pub fn take_from<'a>(&mut self, solved: &mut impl Iterator<Item = &'a SystemRow>) {
        for (locked, solved) in self.locked().zip(solved) {
            locked.impulse = solved.impulse as Real;
        }
    }

    /// Counts the impulses of the substep into those of the step.
    pub fn count(&mut self) {
        self.locked().for_each(|locked| locked.total += locked.impulse);
    }

    /// Writes impulses and the mean forces of locked axes to the joints.
    pub fn store(&self, joints: &mut Frozen<'_, ImpulseJointSet>, inv_dt: Real) {
        for Loop { handle, locked, .. } in &self.loops {
            let Some(joint) = joints.get_unnoted_mut(*handle) else { continue };
            (joint.force, joint.torque) = (Vector::ZERO, ANG_ZERO);
            for Locked { axis, wrench, impulse, total, .. } in locked {
                joint.impulses[*axis as usize] = *impulse;
                joint.force += linear(wrench) * (total * inv_dt);
                joint.torque += angular(wrench) * (total * inv_dt);
            }
        }
    }

    /// Writes what transmissions have counted to the joints.
    pub fn store_counts(&self, joints: &mut Frozen<'_, ImpulseJointSet>) {
        for (handle, count) in &self.counts {
            if let Some(joint) = joints.get_unnoted_mut(*handle) {
                joint.count = Some(*count);
            }
        }
    }

    /// Breaks the overloaded joints. All their forces must have been written.
    pub fn break_overloaded(
        &self,
        joints: &mut Frozen<'_, ImpulseJointSet>,
        broken: &mut Vec<JointBreakEvent>,
    ) {
        for Loop { handle, .. } in &self.loops {
            let Some(joint) = joints.get_unnoted_mut(*handle) else { continue };
            if !joint.is_sound() {
                joint.clear_impulses();
            }
            if let Some(event) = break_if_overloaded(*handle, joint) {
                broken.push(event);
                joints.note_broken(*handle);
            }
        }
    }
}

impl Loop {
    /// The law of a locked axis: an equation, with the compliance of a spring.
    fn law(&self, locked: &Locked, with_compliance: bool) -> AxisLaw {
        let compliance = if with_compliance { f64::from(self.softness.compliance()) } else { 0.0 };
        equation(&locked.row, -locked.bias, compliance)
    }
}
