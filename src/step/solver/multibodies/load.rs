//! Loads multibodies and their bodies into the solver.

use super::{LinkPlace, Moving, SolverMultibodies};
use crate::dim::math::{Real, Vector};
use crate::dim::spatial::join;
use crate::model::body::{RigidBodyHandle, RigidBodySet};
use crate::model::frozen::Frozen;
use crate::model::island::NONE;
use crate::model::joint::{GenericJoint, MotorModel};
use crate::model::multibody::{LinkTravel, Multibody, MultibodyJointSet};
use crate::multibody::{JointLoad, LinkForce, usable};
use crate::step::solver::links::Links;

impl SolverMultibodies {
    /// Takes the multibodies of these bodies, which are solved now, out of their set.
    pub fn load(
        &mut self,
        members: &[RigidBodyHandle],
        links: &Links,
        set: &mut Frozen<'_, MultibodyJointSet>,
        bodies: &RigidBodySet,
    ) {
        for slot in self.listed.drain(..) {
            self.places[slot as usize] = None;
        }
        if links.is_empty() {
            return;
        }
        for member in members {
            let slot = member.into_raw_parts().0;
            let Some(owner) = links.owner(slot) else { continue };
            if self.place(slot).is_some() {
                continue;
            }
            let Some(index) = set.index_at(owner) else { continue };
            let Some(multibody) = set.get_unnoted_mut(index) else { continue };
            self.list_links(multibody, bodies);
            debug_assert!(multibody.is_whole() && !multibody.links.is_empty());
            let mut moving = self.spare.pop().unwrap_or_default();
            (moving.index, moving.multibody) = (index, core::mem::take(multibody));
            moving.island = bodies.get(*member).map_or(NONE, |body| body.link.island);
            moving.multibody.forward_kinematics(bodies, false);
            self.moving.push(moving);
        }
    }

    /// Lists the links of the next multibody.
    fn list_links(&mut self, multibody: &Multibody, bodies: &RigidBodySet) {
        for link in &multibody.links {
            let slot = link.body.into_raw_parts().0;
            if slot as usize >= self.places.len() {
                self.places.resize(slot as usize + 1, None);
            }
            let is_moved = bodies.get(link.body).is_some_and(|body| body.is_dynamic());
            self.places[slot as usize] =
                Some(LinkPlace { multibody: self.moving.len(), link: link.id, is_moved });
            self.listed.push(slot);
        }
    }

    /// Notes the loads of the multibodies, and their start. Ordinary bodies must have been loaded.
    ///
    /// Substeps take `h` seconds.
    pub fn begin(&mut self, bodies: &mut Frozen<'_, RigidBodySet>, gravity: Vector, h: Real) {
        for moving in &mut self.moving {
            moving.fit_impulses(bodies, h);
            moving.read_forces(bodies, gravity);
            moving.read_joint_loads();
            moving.motion.begin(&moving.multibody, bodies);
            moving.add_motors();
            moving.motion.resist(h);
            let ndofs = moving.motion.rates.len();
            debug_assert_eq!(ndofs, moving.multibody.ndofs());
            for list in [&mut moving.pushed, &mut moving.shift] {
                list.clear();
                list.resize(ndofs, 0.0);
            }
            moving.root_pushed.clear();
            moving.root_pushed.resize(moving.motion.root_dofs(), 0.0);
            let links = &moving.multibody.links;
            moving.travel.clear();
            moving.travel.resize(links.len(), LinkTravel::default());
            moving.start.0.clear();
            moving.start.0.extend(links.iter().map(|link| link.joint.clone()));
            moving.start.1 = links[0].pose;
        }
    }
}

/// Scales the last impulses of a joint's limits and motors.
pub(super) fn scale_impulses(joint: &mut GenericJoint, fraction: Real) {
    joint.limits.iter_mut().for_each(|limits| limits.impulse *= fraction);
    joint.motors.iter_mut().for_each(|motor| motor.impulse *= fraction);
}

impl Moving {
    /// Scales the last impulses for substeps of `h` seconds
    /// ([`ImpulseFractions`](crate::step::solver::bodies::ImpulseFractions)).
    fn fit_impulses(&mut self, bodies: &mut Frozen<'_, RigidBodySet>, h: Real) {
        self.fraction = 1.0;
        for link in &self.multibody.links {
            let body = bodies.get_unnoted_mut(link.body).filter(|body| body.is_dynamic());
            let Some(body) = body else { continue };
            if body.substep > h {
                self.fraction = self.fraction.min(h / body.substep);
            }
            body.substep = h;
        }
        debug_assert!((0.0..=1.0).contains(&self.fraction));
        if self.fraction < 1.0 {
            let Multibody { links, lists, couplings, .. } = &mut self.multibody;
            for link in links {
                scale_impulses(&mut link.joint.data, self.fraction);
            }
            lists.friction_impulses.iter_mut().for_each(|impulse| *impulse *= self.fraction);
            couplings.iter_mut().for_each(|coupling| coupling.impulse *= self.fraction);
        }
    }

    fn read_forces(&mut self, bodies: &RigidBodySet, gravity: Vector) {
        self.motion.forces.clear();
        for link in &self.multibody.links {
            let body = bodies.get(link.body).filter(|body| body.is_dynamic());
            let none = LinkForce { wrench: [0.0; _], damping: [0.0; 2] };
            self.motion.forces.push(body.map_or(none, |body| {
                let (force, torque) = body.forces();
                let weight = gravity * (body.gravity_scale * body.mprops.local_mprops.mass());
                let damping = [body.linear_damping, body.angular_damping];
                LinkForce { wrench: join(force + weight, torque), damping }
            }));
        }
    }

    /// Armature, springs and dampers of the joints.
    fn read_joint_loads(&mut self) {
        let Multibody { links, dofs, lists, .. } = &self.multibody;
        self.motion.joint_loads.clear();
        for (position, dof) in dofs.iter().enumerate() {
            let joint = &links[dof.link].joint;
            let (stiffness, rest) =
                if dof.link == 0 { (0.0, 0.0) } else { joint.spring_at(dof.axis as usize) };
            self.motion.joint_loads.push(JointLoad {
                armature: if joint.kinematic {
                    Real::INFINITY
                } else {
                    usable(lists.armature[position])
                },
                stiffness,
                damping: usable(lists.damping[position]),
                pull: stiffness * rest,
            });
        }
    }

    /// Motors without a largest force are dampers and springs like others. Those of the acceleration-based
    /// model act against the inertia that they move if all other joints are free.
    fn add_motors(&mut self) {
        let Self { multibody, motion, pushed: inverses, .. } = self;
        // No impulse has been applied yet, so their list is free.
        inverses.clear();
        for (position, dof) in multibody.dofs.iter().enumerate() {
            let joint = &multibody.links[dof.link].joint;
            let motor = joint.data.motor(dof.axis).filter(|motor| motor.max_force >= Real::MAX);
            let Some(&motor) = motor.filter(|_| dof.link != 0 && !joint.kinematic) else {
                continue;
            };
            let inertia = match motor.model {
                MotorModel::ForceBased => 1.0,
                MotorModel::AccelerationBased => {
                    if inverses.is_empty() {
                        motion.inverse_inertias(inverses);
                    }
                    if inverses[position] > 0.0 { 1.0 / inverses[position] } else { 0.0 }
                }
            };
            let (stiffness, damping) = (motor.stiffness * inertia, motor.damping * inertia);
            let load = &mut motion.joint_loads[position];
            load.stiffness += stiffness;
            load.damping += damping;
            load.pull += stiffness * motor.target_pos + damping * motor.target_vel;
        }
    }
}
