//! Changes that a hook may make to a manifold before it is solved.

use crate::dim::math::{Real, Vector};
use crate::model::body::{RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderHandle, ColliderSet};
use crate::model::contact::{Contact, ContactManifold, SolverFlags};

/// Mutable access to one manifold before it is solved.
///
/// The narrow phase computes friction, restitution, tangent velocity and points in each step, so changes
/// apply to this step. Only [`Self::user_data`] persists, while the two shapes keep touching and the hook
/// keeps at least one point.
pub struct ContactModificationContext<'a> {
    /// All bodies.
    pub bodies: &'a RigidBodySet,
    /// All colliders.
    pub colliders: &'a ColliderSet,
    /// Body of the first collider; `None` without a body.
    pub rigid_body1: Option<RigidBodyHandle>,
    /// Body of the second collider; `None` without a body.
    pub rigid_body2: Option<RigidBodyHandle>,
    /// The first collider.
    pub collider1: ColliderHandle,
    /// The second collider.
    pub collider2: ColliderHandle,
    pub(crate) manifold: &'a mut ContactManifold,
}

/// User data of [`ContactModificationContext::update_as_oneway_platform`]. A new manifold has the value 0:
/// undecided.
mod oneway {
    pub const STATE_SOLID: u32 = 1;
    pub const STATE_PASSING: u32 = 2;
}

impl ContactModificationContext<'_> {
    /// The manifold in its current state.
    pub fn manifold(&self) -> &ContactManifold {
        self.manifold
    }

    /// Unit normal in world space, from the first collider to the second.
    pub fn normal(&self) -> Vector {
        self.manifold.data.normal
    }

    /// The contact points.
    pub fn contacts(&self) -> &[Contact] {
        self.manifold.contacts()
    }

    /// Keeps only the points for which `keep` returns `true`. The others are not solved in this step.
    pub fn retain_contacts(&mut self, mut keep: impl FnMut(&Contact) -> bool) {
        self.manifold.data.points.retain(|contact| keep(contact));
    }

    /// Removes all points: the two shapes pass through each other without an event, and the user data is
    /// lost. To keep the events and the user data, see [`Self::set_solver_flags`].
    pub fn clear_contacts(&mut self) {
        self.manifold.data.points.clear();
    }

    /// The combined friction coefficient.
    pub fn friction(&self) -> Real {
        self.manifold.data.friction
    }

    /// Sets the combined friction coefficient. A negative or non-finite value is refused with a warning in
    /// the log.
    pub fn set_friction(&mut self, friction: Real) {
        if is_coefficient("friction", friction) {
            self.manifold.data.friction = friction;
        }
    }

    /// The combined restitution coefficient.
    pub fn restitution(&self) -> Real {
        self.manifold.data.restitution
    }

    /// Sets the combined restitution coefficient (1: the speed is conserved). A negative or non-finite value
    /// is refused with a warning in the log.
    pub fn set_restitution(&mut self, restitution: Real) {
        if is_coefficient("restitution", restitution) {
            self.manifold.data.restitution = restitution;
        }
    }

    /// Target velocity of friction for the second body relative to the first, in world space (length/s).
    pub fn tangent_velocity(&self) -> Vector {
        self.manifold.data.tangent_velocity
    }

    /// Sets the target velocity of friction for the second body relative to the first, in world space
    /// (length/s), as for a conveyor belt. If the belt is the first body, this is the velocity of its
    /// surface; if it is the second, the opposite. Only the part along the contact plane counts. A non-finite
    /// velocity is refused with a warning in the log.
    pub fn set_tangent_velocity(&mut self, velocity: Vector) {
        if velocity.is_finite() {
            self.manifold.data.tangent_velocity = velocity;
        } else {
            log::warn!(
                "the tangent velocity {velocity:?} of a contact is not finite and is ignored"
            );
        }
    }

    /// The flags that select the constraints of the manifold.
    pub fn solver_flags(&self) -> SolverFlags {
        self.manifold.data.solver_flags
    }

    /// Sets the flags that select the constraints of the manifold. Without
    /// [`COMPUTE_RIGID_IMPULSES`](SolverFlags::COMPUTE_RIGID_IMPULSES) the contact is reported, but the
    /// bodies pass through each other.
    pub fn set_solver_flags(&mut self, flags: SolverFlags) {
        self.manifold.data.solver_flags = flags;
    }

    /// The number that a hook stored in an earlier step; 0 when the shapes begin to touch.
    pub fn user_data(&self) -> u32 {
        self.manifold.data.user_data
    }

    /// Stores a number for the hooks of later steps.
    pub fn set_user_data(&mut self, user_data: u32) {
        self.manifold.data.user_data = user_data;
    }

    /// Makes the contact solid from one side only, like a platform that characters jump through from below
    /// and stand on.
    ///
    /// The contact is solid while the normal in the frame of the first collider is within `allowed_angle`
    /// (rad) of `allowed_local_n1`. A body from the other side passes until it no longer overlaps and touches
    /// from the solid side; both contacts emit events. The direction is always that of the first collider's
    /// frame: mirror it for a platform that is the second collider.
    ///
    /// Uses [`Self::user_data`], which the hook must not use for anything else. A zero or non-finite
    /// argument is refused with a warning in the log, and the contact stays solid.
    pub fn update_as_oneway_platform(&mut self, allowed_local_n1: Vector, allowed_angle: Real) {
        let length = allowed_local_n1.length();
        if !(length.is_finite() && length > 0.0 && allowed_angle.is_finite()) {
            log::warn!(
                "the normal {allowed_local_n1:?} or the angle {allowed_angle} of a one-way platform is invalid and is ignored"
            );
            return;
        }
        let cos = self.manifold.local_n1.dot(allowed_local_n1) / length;
        let from_solid_side = cos >= allowed_angle.cos();
        let apart = self.contacts().iter().all(|contact| contact.dist > 0.0);
        let state = match self.user_data() {
            oneway::STATE_PASSING if !(from_solid_side && apart) => oneway::STATE_PASSING,
            _ if from_solid_side => oneway::STATE_SOLID,
            _ => oneway::STATE_PASSING,
        };
        self.set_user_data(state);
        if state == oneway::STATE_PASSING {
            self.set_solver_flags(self.solver_flags() - SolverFlags::COMPUTE_RIGID_IMPULSES);
        }
    }
}

fn is_coefficient(what: &str, value: Real) -> bool {
    let valid = value.is_finite() && value >= 0.0;
    if !valid {
        log::warn!(
            "the {what} {value} of a contact is not a finite number of at least 0 and is ignored"
        );
    }
    valid
}
