//! The set of joints that the solver handles by impulses.

use crate::wrapper::wrapper;
use engine::dynamics::{ImpulseJoint, ImpulseJointHandle, RigidBodyHandle};

wrapper! {
    /// All joints that the solver handles by impulses.
    ImpulseJointSet, engine::dynamics::ImpulseJointSet
}

impl ImpulseJointSet {
    /// Mutable access to a joint; `None` if the handle is stale. Its bodies wake if `wake_up` is `true`.
    pub fn get_mut(
        &mut self,
        handle: ImpulseJointHandle,
        wake_up: bool,
    ) -> Option<&mut ImpulseJoint> {
        if wake_up { self.0.get_mut(handle) } else { self.0.get_mut_without_waking(handle) }
    }

    /// Changes the bodies of a joint, and returns it. `None` if the handle is stale or both bodies are equal.
    /// The bodies wake if `wake_up` is `true`.
    #[cfg(rapier036)]
    pub fn set_bodies(
        &mut self,
        handle: ImpulseJointHandle,
        new_body1: RigidBodyHandle,
        new_body2: RigidBodyHandle,
        wake_up: bool,
    ) -> Option<&mut ImpulseJoint> {
        if new_body1 == new_body2 {
            return None;
        }
        if wake_up {
            self.0.set_bodies(handle, new_body1, new_body2);
            return self.0.get_mut(handle);
        }
        let joint = self.0.get_mut_without_waking(handle)?;
        (joint.body1, joint.body2) = (new_body1, new_body2);
        Some(joint)
    }

    /// Mutable access to all joints with their handles, in the order of their slots. No body wakes.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (ImpulseJointHandle, &mut ImpulseJoint)> {
        self.0.iter_mut_without_waking()
    }

    /// Mutable access to the joint in a slot (the first number of a handle), with its handle. No body wakes.
    pub fn get_unknown_gen_mut(
        &mut self,
        slot: u32,
    ) -> Option<(&mut ImpulseJoint, ImpulseJointHandle)> {
        let (_, handle) = self.0.get_unknown_gen(slot)?;
        Some((self.0.get_mut_without_waking(handle)?, handle))
    }

    /// Calls a function with mutable access to each joint of a body, in the order of insertion. No body
    /// wakes.
    pub fn map_attached_joints_mut(
        &mut self,
        body: RigidBodyHandle,
        mut change: impl FnMut(RigidBodyHandle, RigidBodyHandle, ImpulseJointHandle, &mut ImpulseJoint),
    ) {
        let joints = self.0.attached_joints(body);
        let handles: Vec<_> = joints.map(|(_, _, handle, _)| handle).collect();
        for handle in handles {
            if let Some(joint) = self.0.get_mut_without_waking(handle) {
                change(joint.body1, joint.body2, handle, joint);
            }
        }
    }
}
