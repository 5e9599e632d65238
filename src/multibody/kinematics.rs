//! Forward kinematics: poses and velocities of the links.

use super::spatial::{AngularMatrix, ZERO, add_scaled, angular_momentum, carry, carry_back, dot};
use crate::dim::joint_axes::{JointAxesMask, JointAxis};
use crate::dim::math::{
    ANG_ZERO, DIM, Pose, Real, Rotation, SPATIAL_DIM, SpatialVector, Vector, ang_length_squared,
    cross,
};
use crate::dim::spatial::{angular, join, linear, turn_axis, world_inertia};
use crate::model::joint::mask_of;
use crate::model::multibody::{Multibody, MultibodyLink};
use arrayvec::ArrayVec;
use core::ops::Range;

/// A link at one configuration. All vectors are in world axes.
#[derive(Clone, Debug)]
pub struct LinkFrame {
    pub parent: Option<usize>,
    pub dofs: Range<usize>,
    /// Number of translations among them, which come first.
    pub slides: usize,
    pub rotation: Rotation,
    /// The centre of mass.
    pub center: Vector,
    /// From the parent's centre of mass to the joint's origin on the link, that is, with its translation.
    pub reach: Vector,
    /// From the joint's origin on the link to the link's centre of mass.
    pub arm: Vector,
    /// From the parent's centre of mass to the link's: the sum of both.
    pub offset: Vector,
    pub mass: Real,
    pub inertia: AngularMatrix,
}

impl LinkFrame {
    /// The momentum that it has at a velocity.
    pub fn momentum(&self, velocity: &SpatialVector) -> SpatialVector {
        join(linear(velocity) * self.mass, angular_momentum(&self.inertia, angular(velocity)))
    }
}

/// All links at one configuration, and the axes of all degrees of freedom.
#[derive(Clone, Debug, Default)]
pub struct Kinematics {
    pub links: Vec<LinkFrame>,
    /// By degree of freedom: the spatial velocity that it gives its link at the rate 1.
    pub axes: Vec<SpatialVector>,
    /// The components of the spatial velocity that the degrees of freedom of the root are.
    pub root_axes: ArrayVec<usize, SPATIAL_DIM>,
}

impl Kinematics {
    /// The links at the coordinates, from the root at its current pose on. Empty for a multibody with
    /// replaced links.
    pub fn of(multibody: &Multibody) -> Self {
        let mut kinematics = Self::default();
        if multibody.is_whole() {
            kinematics.update(multibody);
        }
        kinematics
    }

    /// The same, in the buffers that there are.
    pub fn update(&mut self, multibody: &Multibody) {
        self.links.clear();
        self.axes.clear();
        self.root_axes.clear();
        for link in &multibody.links {
            match link.parent {
                None => self.push_root(link),
                Some(parent) => self.push_child(link, parent, &multibody.links[parent]),
            }
        }
        debug_assert_eq!(self.axes.len(), multibody.ndofs());
    }

    fn push_root(&mut self, link: &MultibodyLink) {
        let (pose, mass) = (&link.pose, &link.mass);
        self.links.push(LinkFrame {
            parent: None,
            dofs: link.dofs(),
            slides: 0,
            rotation: pose.rotation,
            center: *pose * mass.local_com,
            reach: Vector::ZERO,
            arm: Vector::ZERO,
            offset: Vector::ZERO,
            mass: mass.mass(),
            inertia: world_inertia(mass, pose.rotation),
        });
        for axis in JointAxis::ALL.into_iter().filter(|axis| link.free.contains(mask_of(*axis))) {
            let mut motion = ZERO;
            motion[axis as usize] = 1.0;
            self.axes.push(motion);
            self.root_axes.push(axis as usize);
        }
    }

    fn push_child(&mut self, link: &MultibodyLink, parent: usize, parent_link: &MultibodyLink) {
        let before = &self.links[parent];
        let (data, mass) = (&link.joint.data, &link.mass);
        let (frame1, frame2) = (&data.local_frame1, &data.local_frame2);
        let base = before.rotation * frame1.rotation;
        let anchor = before.rotation * (frame1.translation - parent_link.mass.local_com);
        let reach = anchor + base * link.joint.slide();
        let rotation = (base * link.joint.joint_rot() * frame2.rotation.inverse()).normalize();
        let arm = rotation * (mass.local_com - frame2.translation);
        let offset = reach + arm;
        let center = before.center + offset;
        for axis in JointAxis::ALL.into_iter().take(DIM) {
            if link.free.contains(mask_of(axis)) {
                let along = base * Vector::AXES[axis as usize];
                self.axes.push(join(along, ANG_ZERO));
            }
        }
        for axis in link.joint.rotation_axes(link.free) {
            let axis = turn_axis(base, axis);
            self.axes.push(join(cross(axis, arm), axis));
        }
        self.links.push(LinkFrame {
            parent: Some(parent),
            dofs: link.dofs(),
            slides: (link.free & JointAxesMask::LIN_AXES).bits().count_ones() as usize,
            rotation,
            center,
            reach,
            arm,
            offset,
            mass: mass.mass(),
            inertia: world_inertia(mass, rotation),
        });
    }

    /// The pose of a link's body.
    pub fn pose(&self, id: usize, multibody: &Multibody) -> Pose {
        let LinkFrame { rotation, center, .. } = self.links[id];
        Pose::from_parts(center - rotation * multibody.links[id].mass.local_com, rotation)
    }

    /// The velocities of all links. `root` is that of a root without degrees of freedom.
    pub fn velocities(&self, rates: &[Real], root: &SpatialVector, out: &mut Vec<SpatialVector>) {
        out.clear();
        if self.links.is_empty() {
            return;
        }
        let mut of_root = *root;
        for (&axis, rate) in self.root_axes.iter().zip(rates) {
            of_root[axis] += rate;
        }
        out.push(of_root);
        for link in &self.links {
            let Some(parent) = link.parent else { continue };
            let mut velocity = carry(&out[parent], link.offset);
            for dof in link.dofs.clone() {
                add_scaled(&mut velocity, &self.axes[dof], rates[dof]);
            }
            out.push(velocity);
        }
    }

    /// `Jᵀ f` for a wrench on one link: the force on each degree of freedom, added to `out`.
    pub fn add_generalized_force(&self, id: usize, wrench: &SpatialVector, out: &mut [Real]) {
        let mut wrench = *wrench;
        let mut next = Some(id);
        while let Some(link) = next.map(|id| &self.links[id]) {
            for dof in link.dofs.clone() {
                out[dof] += dot(&self.axes[dof], &wrench);
            }
            wrench = carry_back(&wrench, link.offset);
            next = link.parent;
        }
    }

    /// The same, and adds to `sizes` the largest possible force on each degree of freedom: the product of
    /// lengths whose vectors may be perpendicular. Values far below that are rounding.
    pub fn add_measured_force(
        &self,
        id: usize,
        wrench: &SpatialVector,
        out: &mut [Real],
        sizes: &mut [Real],
    ) {
        let mut wrench = *wrench;
        let mut next = Some(id);
        while let Some(link) = next.map(|id| &self.links[id]) {
            let (force, couple) =
                (linear(&wrench).length(), ang_length_squared(angular(&wrench)).sqrt());
            for dof in link.dofs.clone() {
                let axis = &self.axes[dof];
                out[dof] += dot(axis, &wrench);
                sizes[dof] += linear(axis).length() * force
                    + ang_length_squared(angular(axis)).sqrt() * couple;
            }
            wrench = carry_back(&wrench, link.offset);
            next = link.parent;
        }
    }

    /// `J` of a link: for each degree of freedom the spatial velocity that it gives the link at the rate 1.
    pub fn jacobian(&self, id: usize) -> Vec<SpatialVector> {
        let mut columns = vec![ZERO; self.axes.len()];
        let mut offset = Vector::ZERO;
        let mut next = Some(id);
        while let Some(link) = next.map(|id| &self.links[id]) {
            for dof in link.dofs.clone() {
                columns[dof] = carry(&self.axes[dof], offset);
            }
            offset += link.offset;
            next = link.parent;
        }
        columns
    }
}

impl Multibody {
    /// The Jacobian of a link: the world-space velocity of its body (centre of mass and angular) at the rate
    /// 1 of each degree of freedom. Empty for a missing link.
    ///
    /// It refers to the poses of the current coordinates, with the root at its pose of the last step.
    pub fn body_jacobian(&self, link_id: usize) -> Vec<SpatialVector> {
        let kinematics = Kinematics::of(self);
        if link_id < kinematics.links.len() { kinematics.jacobian(link_id) } else { Vec::new() }
    }
}
