//! Synchronisation of a multibody with its bodies, in both directions.

use crate::dim::joint_axes::JointAxesMask;
use crate::dim::math::SpatialVector;
use crate::dim::math::{Pose, Real, Rotation, Vector, integrate_rotation};
use crate::dim::spatial::{angular, linear};
use crate::model::body::{RigidBody, RigidBodySet};
use crate::model::check::checked_pose;
use crate::model::multibody::{Multibody, MultibodyLink};

impl Multibody {
    /// Updates the poses of the links by the joints' coordinates and by edits of the bodies since the last
    /// call, and degrees of freedom and masses by the bodies. A moved body gives its joint new coordinates,
    /// as far as its free axes allow. Displacements of the coordinates stay, and act on the new ones. It does
    /// not change bodies: call [`Self::update_rigid_bodies`].
    ///
    /// The root keeps its pose, unless `read_root_pose_from_rigid_body` is `true` or its body was moved. A
    /// missing body of a link makes the call have no effect.
    pub fn forward_kinematics(
        &mut self,
        bodies: &RigidBodySet,
        read_root_pose_from_rigid_body: bool,
    ) {
        let Some(root) = self.known_root(bodies) else { return };
        self.follow_axes(root);
        if read_root_pose_from_rigid_body || !root.is_dynamic() {
            self.links[0].pose = root.pose;
            self.links[0].seen_pose = Some(root.pose);
        }
        let mut undisplaced = self.pose_buffer();
        for id in 0..self.links.len() {
            self.load(id, bodies, &undisplaced);
            self.note_undisplaced(id, &mut undisplaced);
        }
    }

    /// The body of the root; `None` if links were replaced, or a body is missing.
    fn known_root<'a>(&self, bodies: &'a RigidBodySet) -> Option<&'a RigidBody> {
        let are_there = self.links.iter().all(|link| bodies.contains(link.body));
        let root = self.links.first().filter(|_| are_there && self.is_whole())?;
        bodies.get(root.body)
    }

    /// Reads the bodies of new links from a position on, before their first step. Everything about the
    /// multibody is then up to date. The step reads them again: bodies and limits may be edited until then.
    pub(crate) fn preview(&mut self, first: usize, bodies: &RigidBodySet) {
        let Some(root) = self.known_root(bodies) else { return };
        self.follow_axes(root);
        let mut undisplaced = self.pose_buffer();
        for id in 0..self.links.len() {
            let MultibodyLink { seen_pose, is_preview, .. } = self.links[id];
            if seen_pose.is_none() || is_preview && (id == 0 || id >= first) {
                self.load(id, bodies, &undisplaced);
                self.links[id].is_preview = true;
            }
            self.note_undisplaced(id, &mut undisplaced);
        }
    }

    /// A buffer for the poses of links without displacements by the user; empty if there are none.
    fn pose_buffer(&self) -> Vec<Pose> {
        let is_displaced = self.links.iter().any(|link| link.joint.is_displaced())
            || self.links.first().is_some_and(MultibodyLink::is_displaced_root);
        let count = if is_displaced { self.links.len() } else { 0 };
        vec![Pose::IDENTITY; count]
    }

    /// Notes the pose of a link without displacements, if there are any.
    fn note_undisplaced(&self, id: usize, undisplaced: &mut [Pose]) {
        if undisplaced.is_empty() {
            return;
        }
        let link = &self.links[id];
        undisplaced[id] = match link.parent {
            None => link.seen_pose.unwrap_or(link.pose),
            Some(parent) => undisplaced[parent] * link.joint.undisplaced_body_to_parent(),
        };
    }

    /// Position of a link by its body and its joint. `undisplaced` has the poses of links before it without
    /// displacements, if there are any.
    fn load(&mut self, id: usize, bodies: &RigidBodySet, undisplaced: &[Pose]) {
        let parent = self.links[id].parent.map(|parent| {
            let pose = self.links[parent].pose;
            (pose, undisplaced.get(parent).copied().unwrap_or(pose))
        });
        let link = &mut self.links[id];
        let Some(body) = bodies.get(link.body) else { return };
        link.mass = *body.mass_properties().local_mprops();
        // Coordinates that are not finite are recomputed from the body.
        let is_sound = link.joint.is_sound() && checked_pose(link.pose).is_some();
        let is_first = link.seen_pose.is_none() || link.is_preview;
        let was_moved = is_first || link.seen_pose != Some(body.pose) || !is_sound;
        match parent {
            None if was_moved => link.pose = link.root_pose(body),
            None => {}
            Some((parent, undisplaced)) => {
                if is_first {
                    link.joint.discard_reading();
                }
                if was_moved {
                    link.joint.read_pose(&(undisplaced.inverse() * body.pose));
                }
                link.pose = parent * link.joint.body_to_parent();
            }
        }
        (link.seen_pose, link.is_preview) = (Some(body.pose), false);
    }

    /// Moves the bodies to the poses of their links, and wakes them. Edits of the bodies since the last
    /// [`Self::forward_kinematics`] are read before. A root that is not dynamic stays.
    ///
    /// `update_mass_properties` is accepted for compatibility and has no effect: centres of mass are always
    /// up to date.
    pub fn update_rigid_bodies(&mut self, bodies: &mut RigidBodySet, update_mass_properties: bool) {
        let _ = update_mass_properties;
        self.forward_kinematics(bodies, false);
        for link in &mut self.links {
            let Some(body) = bodies.get_mut(link.body).filter(|body| body.is_dynamic()) else {
                continue;
            };
            body.set_position(link.pose, true);
            link.match_body(body);
        }
    }

    /// Updates only the branch from the root to one link, as [`Self::forward_kinematics`] does for all links.
    pub fn forward_kinematics_single_branch(&mut self, bodies: &RigidBodySet, link_id: usize) {
        let mut undisplaced = self.pose_buffer();
        for id in self.kinematic_branch(link_id) {
            self.load(id, bodies, &undisplaced);
            self.note_undisplaced(id, &mut undisplaced);
        }
    }

    /// Moves the coordinates by a displacement per degree of freedom (length units, radians). Missing
    /// displacements are 0. [`Self::update_rigid_bodies`] or the next step then moves the bodies. If bodies
    /// are moved before that, the displacement starts at their new poses.
    pub fn apply_displacements(&mut self, displacements: &[Real]) {
        // Poses that are computed again have other rounding, and would count as moved.
        if !self.is_whole() || displacements.iter().all(|&number| number == 0.0) {
            return;
        }
        for link in &mut self.links {
            let own = displacements.get(link.dofs()).unwrap_or_default();
            if link.parent.is_some() {
                link.joint.apply_displacement(own);
            } else if own.iter().any(|&number| number != 0.0) {
                let mut all = [0.0; crate::dim::math::SPATIAL_DIM];
                spread(own, link.free, &mut all);
                let change = crate::dim::math::rotation_from_angle(angular(&all));
                link.pose = link.displaced_pose(&link.pose, linear(&all), change);
            }
        }
        self.place_links();
    }

    /// Moves the links to the poses of the coordinates.
    pub(super) fn place_links(&mut self) {
        for id in 1..self.links.len() {
            let Some(parent) = self.links[id].parent else { continue };
            let parent = self.links[parent].pose;
            self.links[id].pose = parent * self.links[id].joint.body_to_parent();
        }
    }

    /// Moves coordinates and root for `h` seconds. `root` is the velocity of a root without degrees of
    /// freedom.
    pub(super) fn integrate(&mut self, h: Real, rates: &[Real], root: &SpatialVector) {
        for link in &mut self.links {
            let own = &rates[link.dofs()];
            if link.parent.is_some() {
                link.joint.integrate(h, own);
                continue;
            }
            let mut velocity = *root;
            spread(own, link.free, &mut velocity);
            let center = link.pose * link.mass.local_com + linear(&velocity) * h;
            let rotation = integrate_rotation(link.pose.rotation, angular(&velocity) * h);
            link.pose = Pose::from_parts(center - rotation * link.mass.local_com, rotation);
        }
    }
}

impl MultibodyLink {
    /// Returns whether the user moved a root, and its body has not followed yet.
    fn is_displaced_root(&self) -> bool {
        self.seen_pose.is_some_and(|seen| seen != self.pose)
    }

    /// The pose of a root whose body was moved: displaced from the body as it was before.
    fn root_pose(&self, body: &RigidBody) -> Pose {
        let Some(seen) = self.seen_pose else { return body.pose };
        if seen == self.pose || checked_pose(self.pose).is_none() {
            return body.pose;
        }
        if seen == body.pose {
            return self.pose;
        }
        let center = self.mass.local_com;
        let shift = self.pose * center - seen * center;
        self.displaced_pose(&body.pose, shift, self.pose.rotation * seen.rotation.inverse())
    }

    /// A pose moved by this shift, and rotated about the centre of mass.
    fn displaced_pose(&self, from: &Pose, shift: Vector, rotation: Rotation) -> Pose {
        let center = *from * self.mass.local_com + shift;
        let rotation = (rotation * from.rotation).normalize();
        Pose::from_parts(center - rotation * self.mass.local_com, rotation)
    }
}

/// Numbers of degrees of freedom to the places of their axes.
fn spread(own: &[Real], free: JointAxesMask, all: &mut SpatialVector) {
    let places = all.iter_mut().enumerate().filter(|(axis, _)| free.bits() & (1 << axis) != 0);
    for ((_, place), number) in places.zip(own) {
        *place = *number;
    }
}
