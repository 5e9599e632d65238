//! Stores the solver's results in multibodies and their bodies.

use super::{Moving, SolverMultibodies};
use crate::base::measure::{COORDINATE_MODERATE_MAX, MODERATE_MAX, is_coordinate};
use crate::dim::math::{ANG_ZERO, Pose, Real, SPATIAL_DIM, SpatialVector, ang_length_squared};
use crate::dim::spatial::{angular, linear};
use crate::model::body::{RigidBodySet, RigidBodyVelocity};
use crate::model::check::checked_pose;
use crate::model::frozen::Frozen;
use crate::model::island::BodyMotion;
use crate::model::multibody::{LinkTrajectory, LinkTravel, MultibodyJointSet};
use crate::step::notes::{Diverged, FastMotion, MotionPart};
use crate::step::solver::context::{ImpulseOutput, MotionOutput};

impl SolverMultibodies {
    /// Writes impulses to manifolds and joints, and breaks overloaded joints.
    pub fn store_impulses(&mut self, output: &mut ImpulseOutput<'_>) {
        let ImpulseOutput { settings, narrow_phase, joints, broken, .. } = output;
        let inv_dt = settings.params.inv_dt();
        self.contacts.store(narrow_phase);
        self.joints.store(&mut self.moving, joints);
        self.gears.store(&mut self.moving);
        self.loops.store(joints, inv_dt);
        self.loops.store_counts(joints);
        self.joints.add_forces(joints, inv_dt);
        self.loops.break_overloaded(joints, broken);
    }

    /// Ends a step with substeps of `h` seconds. Lists the multibodies that cannot be stored, and returns
    /// whether all others are moderate.
    ///
    /// The limit is lower than for other bodies: after a rotation of more than a radian within a substep, the
    /// coordinates of joints are ambiguous.
    pub fn finish(&mut self, diverged: &mut Vec<Diverged>, h: Real) -> bool {
        let mut is_moderate = true;
        for moving in &mut self.moving {
            moving.motion.finish(moving.touches);
            if !moving.is_sound() {
                diverged.extend(moving.first_diverged());
            }
            let near = moving.multibody.links[0].pose.translation.abs().max_element()
                <= COORDINATE_MODERATE_MAX;
            is_moderate &= near
                && moving
                    .motion
                    .link_velocities()
                    .iter()
                    .all(|velocity| link_is_moderate(velocity, h));
        }
        is_moderate
    }

    /// Returns the multibodies to their set in their state at the start of the step, except impulses that
    /// were scaled to its substeps.
    pub fn give_back(&mut self, set: &mut Frozen<'_, MultibodyJointSet>) {
        for mut moving in self.moving.drain(..) {
            moving.undo();
            if let Some(place) = set.get_unnoted_mut(moving.index) {
                *place = core::mem::take(&mut moving.multibody);
            }
            self.spare.push(moving);
        }
    }

    /// Writes poses and velocities to bodies. Stores the motion of each body, and the trajectories of fast
    /// multibodies. The multibodies return to their set. Returns the number of multibodies that were limited
    /// to the largest speed.
    pub fn store(&mut self, output: &mut MotionOutput<'_>) -> usize {
        let mut limited = 0;
        for mut moving in self.moving.drain(..) {
            limited += usize::from(moving.motion.is_limited);
            moving.store(output);
            if let Some(place) = output.multibodies.get_unnoted_mut(moving.index) {
                *place = core::mem::take(&mut moving.multibody);
            }
            self.spare.push(moving);
        }
        limited
    }
}

fn link_is_moderate(velocity: &SpatialVector, h: Real) -> bool {
    let turn_squared = ang_length_squared(angular(velocity)) * h * h;
    linear(velocity).abs().max_element() <= MODERATE_MAX && turn_squared <= 1.0
}

/// Adds the motion of `h` seconds to the path lengths and angles of links.
pub(super) fn note_travel(travels: &mut [LinkTravel], velocities: &[SpatialVector], h: Real) {
    for (travel, velocity) in travels.iter_mut().zip(velocities) {
        travel.path_length += linear(velocity).length() * h;
        travel.angle += ang_length_squared(angular(velocity)).sqrt() * h;
    }
}

impl Moving {
    /// Stores the displacements of the links in `h` seconds at these rates.
    pub(super) fn note_travel_at(&mut self, rates: &[Real], h: Real) {
        note_travel(&mut self.travel, self.motion.link_velocities_at(rates), h);
    }

    fn store(&mut self, output: &mut MotionOutput<'_>) {
        let MotionOutput { settings, bodies, motions, fast, trajectories, .. } = output;
        let params = settings.params;
        self.multibody.lists.store_velocities(&self.motion.rates);
        let (first, mut is_fast) = (fast.len(), false);
        for id in 0..self.multibody.links.len() {
            let Some((bound, motion)) = self.store_link(id, motions, bodies) else { continue };
            let Some(body) = bodies.get_unnoted_mut(motion.body) else { continue };
            body.ccd_active = FastMotion::is_fast(body, bound, params);
            is_fast |= body.ccd_active;
            fast.push(FastMotion { link: Some((trajectories.len(), id)), ..motion });
        }
        if is_fast {
            trajectories.push(self.trajectory(params.dt));
        } else {
            fast.truncate(first);
        }
    }

    /// The trajectory of the step.
    fn trajectory(&mut self, dt: Real) -> LinkTrajectory {
        let mut root = [0.0; SPATIAL_DIM];
        if self.motion.root_dofs() == 0 {
            root = self.motion.link_velocities()[0].map(|rate| rate * dt);
        }
        LinkTrajectory {
            index: self.index,
            start: core::mem::take(&mut self.start),
            shift: core::mem::take(&mut self.shift),
            root,
            travel: self.travel.iter().fold(LinkTravel::default(), LinkTravel::max),
        }
    }

    /// Writes the pose and velocity of a link to its body. Returns its displacement and a bound on it, if it
    /// moved.
    fn store_link(
        &mut self,
        id: usize,
        motions: &mut [BodyMotion],
        bodies: &mut Frozen<'_, RigidBodySet>,
    ) -> Option<(Real, FastMotion)> {
        let velocity = self.motion.link_velocities()[id];
        let pose = self.pose(id);
        let link = &mut self.multibody.links[id];
        let body = bodies.get_unnoted_mut(link.body)?;
        let mut moved = None;
        if body.is_dynamic() {
            body.use_up_push();
            let start = body.pose;
            (body.vels.linvel, body.vels.angvel) = (linear(&velocity), angular(&velocity));
            body.pose = pose;
            let old_center = body.mprops.world_com;
            body.update_world_mass_properties();
            // As for other bodies: far from the origin a position moves by whole steps of rounding or not at
            // all.
            let rounded = (body.mprops.world_com - old_center).length();
            let LinkTravel { path_length, angle } = self.travel[id];
            let bound = rounded.max(path_length) + angle * body.extent;
            motions[link.body.into_raw_parts().0 as usize] = BodyMotion::within(bound);
            let (shift, rotvec) = (body.mprops.world_com - old_center, ANG_ZERO);
            let force = linear(&self.motion.forces[id].wrench);
            let acceleration = force * body.mprops.local_mprops.inv_mass;
            let motion = FastMotion {
                body: link.body,
                start,
                center: old_center,
                shift,
                rotvec,
                acceleration,
                link: None,
                part: MotionPart::Whole,
            };
            moved = Some((bound, motion));
            link.pose = pose;
            if link.joint.kinematic && body.is_moving() {
                body.activation.time_since_can_sleep = 0.0;
            }
        }
        link.match_body(body);
        link.seen_velocity = Some(body.vels);
        moved
    }

    /// The pose of a link's body.
    fn pose(&self, id: usize) -> Pose {
        let pose = match id {
            0 => self.multibody.links[0].pose,
            _ => self.motion.kinematics.pose(id, &self.multibody),
        };
        checked_pose(pose).unwrap_or(self.multibody.links[id].pose)
    }

    /// Returns whether all numbers are usable.
    fn is_sound(&mut self) -> bool {
        let links = &self.multibody.links;
        let joints_are = links.iter().all(|link| link.joint.is_sound());
        let poses_are = (1..links.len())
            .all(|id| checked_pose(self.motion.kinematics.pose(id, &self.multibody)).is_some());
        joints_are
            && poses_are
            && checked_pose(links[0].pose).is_some()
            && self.motion.rates.iter().all(|&rate| is_coordinate(rate))
            && self.motion.link_velocities().iter().all(|velocity| {
                RigidBodyVelocity::new(linear(velocity), angular(velocity)).is_usable()
            })
    }

    /// The first link that cannot be stored. If none is invalid on its own, the one behind the root, which
    /// may be immovable.
    fn first_diverged(&mut self) -> Option<Diverged> {
        let velocities = self.motion.link_velocities();
        let velocity =
            |id: usize| RigidBodyVelocity::new(linear(&velocities[id]), angular(&velocities[id]));
        let has_diverged = |id: &usize| !velocity(*id).is_usable();
        let id = (0..velocities.len()).find(has_diverged).unwrap_or(1.min(velocities.len() - 1));
        let (body, velocity) = (self.multibody.links.get(id)?.body, velocity(id));
        Some(Diverged { body, velocity, is_link: true })
    }

    /// Puts the links back to where the step began.
    fn undo(&mut self) {
        let (joints, root) = &self.start;
        for (link, joint) in self.multibody.links.iter_mut().zip(joints) {
            link.joint = joint.clone();
        }
        self.multibody.links[0].pose = *root;
    }
}
