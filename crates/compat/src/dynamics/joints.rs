//! The sets of joints.

use crate::wrapper::wrapper;
use engine::dynamics::{ImpulseJoint, ImpulseJointHandle};

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
}

wrapper! {
    /// All joints of multibodies.
    MultibodyJointSet, engine::dynamics::MultibodyJointSet
}
