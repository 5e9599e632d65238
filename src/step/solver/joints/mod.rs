//! Joint constraints: from joints to lane-wide blocks, through the passes, and back.
//!
//! One constraint is one joint. Its *locked* axes are equations that are solved together; each *free* axis
//! with limits or a motor is an [`AxisRow`]. All rows act at the second body's anchor `p`, which keeps the
//! angular momentum whether or not the anchors coincide. With `d = p - p1` from anchor to anchor, the moment
//! arms `L2 = p - x2`, `L1 = p - x1` and a direction `e` that rotates with the first body,
//!
//! ```text
//! C = e·d        Ċ = e·(v2 + ω2 × L2 - v1 - ω1 × L1)
//! ```
//!
//! Rows of rotations are in `dimN/joint/`.
//!
//! ## Curvature
//! A joint's directions rotate with its bodies, and considerably within a step. Each pass therefore computes
//! moment arms, axes and errors at the current poses. That alone is insufficient. A velocity with `Ċ = 0`
//! moves along a tangent and leaves the circle. The correction costs energy, a fraction `ω² h` of it per
//! second. The solve pass therefore solves for the velocity that leads to `C = 0` at the *end* of the
//! substep. With the present velocities the substep would end at `C' = C(x + h v)`. Of that, `h Ċ` changes
//! with the velocity, and the rest, `C' - C - h Ċ`, is the curvature of the constraint.
//!
//! ```text
//! Δλ = -K⁻¹ m (Ċ + (C' - C - h Ċ)/h + b C) - i λ         (softness: bias rate b, scales m and i)
//! ```
//!
//! The relax pass then projects the velocity where the bodies are by now. Both together are the RATTLE method
//! (Andersen, "Rattle: a velocity version of the Shake algorithm", 1983): symplectic, so a pendulum keeps its
//! energy. Directly solved joints include the curvature, and they repeat the solution from the new
//! velocity until it converges. A second round suffices for rotations of a tenth of a radian in a substep,
//! and half a radian needs five. (Half-solved ones would feed their errors back.) Components for which this
//! is unstable are treated differently: see `geometric_stiffness.rs`. Limits include the curvature, too, with
//! a bound: see `motors_and_limits.rs`.
//!
//! ## Rotating inertias
//! A thin body has unequal principal inertias, and their axes rotate with it. An angular impulse `τ` changes
//! the angular momentum by `τ`, and the angular velocity by `I⁻¹ τ` with the current inertia. With the
//! inertia of the start of the step, the work of a joint's impulses differs from the energy change of the
//! bodies. Two thin limbs on a post gained so much that they flew apart. The relax pass therefore rotates the
//! inverse inertias of gyroscopic bodies, `R I⁻¹ Rᵀ`. The next solve pass begins at the same poses and uses
//! the same ones. (Impulses act there for the gyroscope, too: see `dimN/motion.rs`.) The subtracted impulse
//! of the last substep is therefore the velocity change that it caused, and not a moment times the current
//! inertia.
//!
//! ## Warm starting
//! Bodies start a substep with the effect of the last one's impulses. A joint's rows have rotated since. Each
//! block stores the impulse and the moments that it applied (`applied`), and the solve pass begins with the
//! same impulses along the rotated rows. The relax pass must not do so. The impulses that moved the bodies
//! onto their chord stay unchanged, and only its own changes act along the current rows. (Rotated there too,
//! impulses would only project the old velocity: that is the method with a loss of `ω² h`.)
//!
//! ## Direct or iterative
//! All axes of connected joints are solved directly (`direct/`): locked ones, motors and limits. Nets with
//! too many loops, unattached components such as passive ragdolls, and single ropes and springs are solved
//! iteratively over the colours, with some compliance. The plain ones among these have passes of their own
//! (`point_to_point/`).
//!
//! ## Order
//! All joints are solved before all contacts, colour by colour. The constraint that is solved last has the
//! smallest error. Overlaps are worse than joint errors, because a violated contact may vanish, and a joint
//! recovers. Within an iterated joint, limits have priority over motors, and locked axes over limits.
//!
//! Sources: Catto, "Solver2D" (box2d.org, 2024) for the soft step; Catto, "Soft Constraints" (GDC 2011).

mod substep_end;
mod block;
mod direct;
mod energy;
mod motors_and_limits;
mod geometry;
mod load;
mod passes;
mod point_to_point;
mod rows;
mod store;
mod geometric_stiffness;
mod transmissions;

use super::blocks::{Layout, block_kernel, for_each_color};
use super::bodies::SolverBodies;
use super::context::SolverPass;
use super::impact_time::ImpactTime;
use crate::base::disjoint::DisjointMut;
use crate::base::tasks::Tasks;
use crate::base::wide::{Lane, Simd};
use crate::dim::math::Real;
use crate::dim::state::{BodyPose, BodyState, READ_ONLY};
use crate::model::params::JointPass;
use block::{AxisRow, JointBlock};
use direct::{
    Direct, DirectJoint, ImpactImpulse, JacobianBlock, Jacobians, Rows, SharedJacobians,
    StiffnessTest,
};
use geometric_stiffness::{GeometricStiffness, Moving, have_large_displacement, note_stiff};
pub(super) use load::JointLoadContext;
use point_to_point::PointToPointJoints;
use transmissions::Transmissions;

/// All joint constraints of a step.
#[derive(Default)]
pub(super) struct SolverJoints {
    /// Blocks of one colour are contiguous.
    blocks: Vec<JointBlock>,
    /// The rows of free axes, those of one block together.
    rows: Vec<AxisRow>,
    /// The joints of each block.
    layout: Layout<LaneSlot>,
    /// Joints that are solved exactly, and their rows by block.
    direct: Direct,
    jacobians: Jacobians,
    /// By block, while a round of an impact lasts.
    impact_impulses: Vec<ImpactImpulse>,
    /// The point-to-point joints, which have their own blocks.
    point_to_point: PointToPointJoints,
    /// The transmissions. Their blocks are behind those of the other joints.
    transmissions: Transmissions,
    /// All joints in the order of their colours, and the number of joints per colour.
    members: Vec<DirectJoint>,
    colors: Vec<(u32, usize)>,
    /// Slots of all joints that have a colour, in that order.
    slots: Vec<u32>,
    /// By block: where its rows begin; then where the last ones end.
    first_rows: Vec<usize>,
    geometric_stiffness: GeometricStiffness,
}

/// A joint in a block.
#[derive(Copy, Clone, Debug)]
struct LaneSlot {
    /// Its slot in the islands' list.
    slot: u32,
    /// Number of its rows of free axes.
    driven: u8,
}

/// Number of blocks per parallel task.
const BLOCKS_PER_TASK: usize = 8;

/// Velocity changes of a round of an impact.
pub(super) struct Changes<'a> {
    /// The [bodies](SolverJoints::held) that joints can change, each once.
    pub held: &'a [u32],
    /// Velocities when the round began, and now.
    pub start: &'a [BodyState],
    pub states: &'a mut [BodyState],
    pub poses: &'a [BodyPose],
}

impl Changes<'_> {
    /// Adds a multiple of the initial velocities to the velocities of the `selected` bodies. The others keep
    /// theirs. Subtraction and addition leave rounding errors each time that other islands need another
    /// iteration.
    fn add_start(&mut self, times: Real, selected: impl Fn(u32) -> bool) {
        for &body in self.held.iter().filter(|body| selected(**body)) {
            let state = &mut self.states[body as usize];
            let ((v, w), (start_v, start_w)) =
                (state.velocity(), self.start[body as usize].velocity());
            state.set_velocity(v + start_v * times, w + start_w * times);
        }
    }
}

impl SolverJoints {
    /// Number of joints.
    pub fn len(&self) -> usize {
        self.layout.len() + self.point_to_point.len() + self.transmissions.len()
    }

    /// Gives the bodies the impulses with which the step starts.
    pub fn warm_start(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        let (simd, tasks) = (pass.simd, pass.tasks);
        self.transmissions.begin(&mut self.rows, &self.blocks, &bodies.states, pass.substep);
        let (_, states) = bodies.shared();
        let parts = Parts::new(&mut self.blocks, &mut self.rows);
        tasks.par_for(self.layout.block_count(), BLOCKS_PER_TASK, |range| {
            simd.run(BeginFreeAxes { range, parts, states });
        });
        for_each_color(self.layout.colors(), tasks, BLOCKS_PER_TASK, |range| {
            simd.run(WarmStart { range, parts, states });
        });
        self.point_to_point.warm_start(states, simd, tasks);
        self.transmissions.warm_start(&self.rows, &self.blocks, &mut bodies.states);
    }

    /// Begins a substep: finds the stiff components, and scales the warm-start impulses as those of bodies.
    pub fn begin_substep(&mut self, bodies: &SolverBodies, pass: &SolverPass<'_>) {
        let Self { blocks, direct, geometric_stiffness, .. } = self;
        let moving = moving(bodies);
        direct.select_method(|members| {
            let is_stiff = geometric_stiffness.is_stiff(members, blocks, moving, pass.substep);
            note_stiff(members, blocks, is_stiff);
            is_stiff
        });
        let factor = pass.params.warmstart_coefficient;
        if factor != 1.0 {
            self.scale_impulses(|_| Some(Lane::splat(factor)), false);
        }
    }

    /// Solves all joints once at the end-of-substep positions.
    pub fn solve(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        self.iterate(bodies, pass, true);
    }

    /// Solves all joints once at the current positions.
    pub fn relax(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>) {
        self.iterate(bodies, pass, false);
    }

    fn iterate(&mut self, bodies: &mut SolverBodies, pass: &SolverPass<'_>, is_biased: bool) {
        if self.len() == 0 {
            return;
        }
        let &SolverPass { joints, simd, tasks, .. } = pass;
        let pass = &JointPass { is_biased, ..joints };
        let (_, states) = bodies.shared();
        let parts = Parts::new(&mut self.blocks, &mut self.rows);
        for_each_color(self.layout.colors(), tasks, BLOCKS_PER_TASK, |range| {
            simd.run(Iterate { range, parts, states, pass });
        });
        self.point_to_point.iterate(states, pass, simd, tasks);
        let Self { transmissions, blocks, rows, .. } = self;
        if is_biased {
            transmissions.begin_solve(rows, blocks, &mut bodies.states);
        } else {
            transmissions.begin_relax((blocks, rows), &mut bodies.states, simd);
            self.direct.invalidate_matrices();
        }
        if self.direct.is_empty() {
            return;
        }
        self.direct.begin();
        if is_biased {
            let Self { jacobians, direct, geometric_stiffness, blocks, .. } = self;
            let test = stiffness_tests(geometric_stiffness, blocks, bodies, pass);
            direct.find_large_displacements(&mut jacobians.blocks, test);
        }
        self.solve_exactly(bodies, pass, simd, tasks);
        while is_biased && self.needs_another_round(bodies, pass) {
            self.solve_exactly(bodies, pass, simd, tasks);
        }
    }

    /// Moves the bodies by what corrects large errors: see [`Direct::correct_poses`].
    pub fn correct_poses(&mut self, bodies: &mut SolverBodies, substep: Real) {
        self.direct
            .correct_poses(&self.jacobians, substep, |body, change| bodies.displace(body, change));
    }

    /// Returns whether the direct solver needs another round.
    fn needs_another_round(&mut self, bodies: &SolverBodies, pass: &JointPass) -> bool {
        let Self { blocks, jacobians, direct, geometric_stiffness, .. } = self;
        let test = stiffness_tests(geometric_stiffness, blocks, bodies, pass);
        direct.needs_another_round(jacobians, pass.inv_substep, test)
    }

    /// The bodies of directly solved joints, including immovable ones; some more than once.
    pub fn held(&self) -> impl Iterator<Item = u32> {
        let exact = self.members.iter().filter(|member| self.direct.contains(member.slot));
        exact.flat_map(|member| member.bodies).map(|body| body & !READ_ONLY)
    }

    /// Projects the velocity changes since the start of a round of impacts on the directly solved joints, in
    /// components with a `selected` body, with the current poses and the inertias of contacts. The impulses
    /// are stored separately until [`Self::commit_impact_impulses`], and do not start the next step.
    /// `add_work` receives one body of each joint, and the work of its impulses at the `start` velocities.
    pub fn project(
        &mut self,
        mut changes: Changes<'_>,
        selected: impl Fn(u32) -> bool + Sync,
        mut add_work: impl FnMut(u32, Real),
        pass: &SolverPass<'_>,
    ) {
        let &SolverPass { joints, simd, tasks, .. } = pass;
        let pass = &JointPass { is_biased: false, ..joints };
        if self.direct.is_empty() {
            return;
        }
        changes.add_start(-1.0, &selected);
        self.direct.begin();
        let (count, states) = (self.blocks.len(), DisjointMut::new(&mut *changes.states));
        let parts = Parts::new(&mut self.blocks, &mut self.rows);
        let jacobians = self.jacobians.share();
        tasks.par_for(count, BLOCKS_PER_TASK, |range| {
            simd.run(WriteRows { range, parts, jacobians, states, pass });
        });
        for (block, jacobians) in self.blocks.iter().zip(&mut self.jacobians.blocks) {
            jacobians.take_inertias(block, changes.poses);
        }
        let is_selected = |members: &[DirectJoint]| {
            members.iter().flat_map(DirectJoint::movable).any(|(_, body)| selected(body))
        };
        self.direct.solve(Rows::Locked, &mut self.jacobians, states, is_selected, simd, tasks);
        let (blocks, memory) = (&self.blocks, self.jacobians.blocks.as_slice());
        debug_assert_eq!(self.impact_impulses.len(), count, "a round has begun");
        let impact_impulses = DisjointMut::new(&mut self.impact_impulses);
        tasks.par_for(count, BLOCKS_PER_TASK, |range| {
            simd.run(Count { range, blocks, memory, impact_impulses });
        });
        for (index, block) in self.blocks.iter().enumerate().filter(|(_, block)| block.is_exact) {
            for lane in 0..self.layout.block(index).len() {
                let bodies = block.bodies.map(|bodies| bodies[lane] & !READ_ONLY);
                let velocities = bodies.map(|body| changes.start[body as usize].velocity());
                add_work(block.movable(lane), self.jacobians.blocks[index].work(lane, velocities));
            }
        }
        changes.add_start(1.0, &selected);
    }

    /// Begins a round of an impact, in which joints have given nothing yet.
    pub fn begin_impact_impulses(&mut self) {
        self.impact_impulses.clear();
        if !self.direct.is_empty() {
            self.impact_impulses.resize(self.blocks.len(), ImpactImpulse::NONE);
        }
    }

    /// Ends the round: adds the joint impulses to those of the step, scaled by the `fraction` of the island
    /// of each body.
    pub fn commit_impact_impulses(&mut self, fraction: impl Fn(u32) -> Real) {
        for (index, (block, impact_impulse)) in
            self.blocks.iter_mut().zip(&self.impact_impulses).enumerate()
        {
            if block.is_exact {
                for lane in 0..self.layout.block(index).len() {
                    impact_impulse.commit(block, lane, fraction(block.movable(lane)));
                }
            }
        }
    }

    /// Bodies that an impact has hit are moved by their motion since then. That must not violate joints.
    /// Bodies of directly solved joints get the mean time of all their impacts: they were hit as one. Bodies
    /// of iterated joints get none, because the impact has moved them apart.
    pub fn merge_impact_times(&self, times: &mut [ImpactTime]) {
        self.direct.merge_impact_times(times);
        let iterated = self.members.iter().filter(|member| !self.direct.contains(member.slot));
        for member in iterated.filter(|member| member.form.locked != 0) {
            member.movable().for_each(|(_, body)| times[body as usize] = ImpactTime::default());
        }
    }

    /// Marks the poses of the bodies as changed.
    pub fn invalidate_poses(&mut self) {
        self.direct.invalidate_matrices();
    }

    /// Solves the axes of connected joints together.
    fn solve_exactly(
        &mut self,
        bodies: &mut SolverBodies,
        pass: &JointPass,
        simd: Simd,
        tasks: Tasks<'_>,
    ) {
        let parts = Parts::new(&mut self.blocks, &mut self.rows);
        let Self { transmissions, jacobians, .. } = self;
        transmissions.write_rows(parts, jacobians, &bodies.states, pass, simd);
        let ((_, states), jacobians) = (bodies.shared(), jacobians.share());
        tasks.par_for(parts.blocks.len(), BLOCKS_PER_TASK, |range| {
            simd.run(WriteRows { range, parts, jacobians, states, pass });
        });
        self.direct.solve(Rows::All, &mut self.jacobians, states, |_| true, simd, tasks);
        let is_last = !pass.is_biased && pass.is_last_iteration;
        self.finish_exactly(is_last, simd, tasks);
        let Self { transmissions, blocks, rows, jacobians, .. } = self;
        let last = is_last.then_some((bodies.states.as_slice(), pass.substep));
        transmissions.finish_round((blocks, rows), jacobians, last);
    }

    /// Takes the changes of impulses by the direct solver into the blocks.
    fn finish_exactly(&mut self, is_last: bool, simd: Simd, tasks: Tasks<'_>) {
        let (count, jacobians) = (self.blocks.len(), &self.jacobians);
        let parts = Parts::new(&mut self.blocks, &mut self.rows);
        tasks.par_for(count, BLOCKS_PER_TASK, |range| {
            simd.run(Finish { range, parts, jacobians, is_last });
        });
    }
}

fn moving(bodies: &SolverBodies) -> Moving<'_> {
    Moving { poses: &bodies.poses, states: &bodies.states, before: &bodies.before }
}

/// The stiffness tests of a component's joints.
fn stiffness_tests(
    geometric_stiffness: &mut GeometricStiffness,
    blocks: &mut [JointBlock],
    bodies: &SolverBodies,
    pass: &JointPass,
) -> impl FnMut(&[DirectJoint], StiffnessTest) -> bool {
    let moving = moving(bodies);
    move |members, test| match test {
        StiffnessTest::IsStiff => {
            geometric_stiffness.is_stiff(members, blocks, moving, pass.substep)
        }
        StiffnessTest::HasLargeDisplacement => {
            note_stiff(members, blocks, true);
            have_large_displacement(members, moving, pass.substep)
        }
    }
}

/// All blocks and their rows, to be shared out.
#[derive(Clone, Copy)]
struct Parts<'a> {
    blocks: DisjointMut<'a, JointBlock>,
    rows: DisjointMut<'a, AxisRow>,
}

impl<'a> Parts<'a> {
    fn new(blocks: &'a mut [JointBlock], rows: &'a mut [AxisRow]) -> Self {
        Self { blocks: DisjointMut::new(blocks), rows: DisjointMut::new(rows) }
    }
}

block_kernel! {
    /// See [`passes::begin_free_axes`].
    struct BeginFreeAxes<'a> {
        parts: Parts<'a>,
        states: DisjointMut<'a, BodyState>,
    }
    |index| passes::begin_free_axes::<W>(parts.blocks.get_mut(index), &parts.rows, &states)
}

block_kernel! {
    /// See [`passes::warm_start`].
    struct WarmStart<'a> {
        parts: Parts<'a>,
        states: DisjointMut<'a, BodyState>,
    }
    |index| passes::warm_start::<W>(parts.blocks.get_mut(index), &parts.rows, &states)
}

block_kernel! {
    /// See [`passes::iterate`].
    struct Iterate<'a> {
        parts: Parts<'a>,
        states: DisjointMut<'a, BodyState>,
        pass: &'a JointPass,
    }
    |index| passes::iterate::<W>(parts.blocks.get_mut(index), &parts.rows, &states, pass)
}

block_kernel! {
    /// See [`direct::write_rows`].
    struct WriteRows<'a> {
        parts: Parts<'a>,
        jacobians: SharedJacobians<'a>,
        states: DisjointMut<'a, BodyState>,
        pass: &'a JointPass,
    }
    |index| {
        let block = parts.blocks.get_mut(index);
        if block.is_exact {
            let rows = block.axis_rows();
            let (rows, driven) =
                (parts.rows.range_mut(rows.clone()), jacobians.driven.range_mut(rows));
            let to = jacobians.blocks.get_mut(index);
            direct::write_rows::<W>(block, rows, to, driven, &states, pass);
        }
    }
}

block_kernel! {
    /// See [`direct::finish`].
    struct Finish<'a> {
        parts: Parts<'a>,
        jacobians: &'a Jacobians,
        is_last: bool,
    }
    |index| {
        let block = parts.blocks.get_mut(index);
        if block.is_exact {
            let rows = block.axis_rows();
            let (from, driven) = (&jacobians.blocks[index], &jacobians.driven[rows.clone()]);
            direct::finish::<W>(block, parts.rows.range_mut(rows), from, driven, is_last);
        }
    }
}

block_kernel! {
    /// See [`direct::count`].
    struct Count<'a> {
        blocks: &'a [JointBlock],
        memory: &'a [JacobianBlock],
        impact_impulses: DisjointMut<'a, ImpactImpulse>,
    }
    |index| if blocks[index].is_exact {
        let impact_impulse = impact_impulses.get_mut(index);
        direct::count::<W>(impact_impulse, &memory[index], blocks[index].locks_rotations);
    }
}
