//! Synchronisation of a multibody with its bodies, in both directions.

use crate::dim::joint_axes::JointAxesMask;
use crate::dim::math::SpatialVector;
use crate::dim::math::{Pose, Real, integrate_rotation};
use crate::dim::spatial::{angular, linear};
use crate::model::body::RigidBodySet;
use crate::model::check::checked_pose;
use crate::model::multibody::Multibody;

impl Multibody {
    /// Updates the poses of the links by the joints' coordinates and by edits of the bodies since the last
    /// call. A moved body gives its joint new coordinates, as far as its free axes allow. It does not change
    /// bodies: call [`Self::update_rigid_bodies`].
    ///
    /// The root keeps its pose, unless `read_root_pose_from_rigid_body` is `true` or its body was moved. A
    /// missing body of a link makes the call have no effect.
    pub fn forward_kinematics(
        &mut self,
        bodies: &RigidBodySet,
        read_root_pose_from_rigid_body: bool,
    ) {
        let Some(root) = self.links.first().and_then(|root| bodies.get(root.body)) else { return };
        if !self.is_whole() || self.links.iter().any(|link| !bodies.contains(link.body)) {
            return;
        }
        self.follow_axes(root);
        if read_root_pose_from_rigid_body || !root.is_dynamic() {
            self.links[0].pose = root.pose;
        }
        for id in 0..self.links.len() {
            self.load(id, bodies);
        }
    }

    /// Position of a link by its body and its joint.
    fn load(&mut self, id: usize, bodies: &RigidBodySet) {
        let parent = self.links[id].parent.map(|parent| self.links[parent].pose);
        let link = &mut self.links[id];
        let Some(body) = bodies.get(link.body) else { return };
        link.mass = *body.mass_properties().local_mprops();
        // Coordinates that are not finite are recomputed from the body.
        let is_sound = link.joint.is_sound() && checked_pose(link.pose).is_some();
        let was_moved = link.seen_pose != Some(body.pose) || !is_sound;
        link.seen_pose = Some(body.pose);
        match parent {
            None if was_moved => link.pose = body.pose,
            None => {}
            Some(parent) => {
                if was_moved {
                    link.joint.read_pose(&(parent.inverse() * body.pose));
                }
                link.pose = parent * link.joint.body_to_parent();
            }
        }
    }

    /// Moves the bodies to the poses of their links, and wakes them. A root that is not dynamic stays.
    ///
    /// `update_mass_properties` is accepted for compatibility and has no effect: centres of mass are always
    /// up to date.
    pub fn update_rigid_bodies(&mut self, bodies: &mut RigidBodySet, update_mass_properties: bool) {
        let _ = update_mass_properties;
        for link in &mut self.links {
            let Some(body) = bodies.get_mut(link.body).filter(|body| body.is_dynamic()) else {
                continue;
            };
            body.set_position(link.pose, true);
            link.seen_pose = Some(*body.position());
        }
    }

    /// Updates only the branch from the root to one link, as [`Self::forward_kinematics`] does for all links.
    pub fn forward_kinematics_single_branch(&mut self, bodies: &RigidBodySet, link_id: usize) {
        for id in self.kinematic_branch(link_id) {
            self.load(id, bodies);
        }
    }

    /// Moves the coordinates by a displacement per degree of freedom (length units, radians). Missing
    /// displacements are 0. [`Self::forward_kinematics`] or the next step then moves the links.
    pub fn apply_displacements(&mut self, displacements: &[Real]) {
        if !self.is_whole() {
            return;
        }
        for link in &mut self.links {
            let own = displacements.get(link.dofs()).unwrap_or_default();
            if link.parent.is_some() {
                link.joint.apply_displacement(own);
            } else {
                let mut all = [0.0; crate::dim::math::SPATIAL_DIM];
                spread(own, link.free, &mut all);
                let change = crate::dim::math::rotation_from_angle(angular(&all));
                let center = link.pose * link.mass.local_com + linear(&all);
                let rotation = (change * link.pose.rotation).normalize();
                link.pose = Pose::from_parts(center - rotation * link.mass.local_com, rotation);
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

/// Numbers of degrees of freedom to the places of their axes.
fn spread(own: &[Real], free: JointAxesMask, all: &mut SpatialVector) {
    let places = all.iter_mut().enumerate().filter(|(axis, _)| free.bits() & (1 << axis) != 0);
    for ((_, place), number) in places.zip(own) {
        *place = *number;
    }
}
