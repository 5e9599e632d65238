//! The ground below the wheels, and its compliance.
//!
//! A free dynamic body below a wheel moves under the wheel's load. A plank in space does; the same plank on a
//! floor does not, because the floor supports it within the same step. A solver without the floor would treat
//! the plank as free, and let the car sink. The estimate is measured per world axis: the fraction of the
//! expected velocity change that the ground took on. The rows use that fraction of its inverse mass (`D^½ M⁻¹
//! D^½` for the inertia).

use super::contact::Mover;
use super::place::velocities_ahead;
use crate::dim::math::{AngularInertia, Real, Vector, mul_inertia, zero_inertia};
use crate::model::body::{RigidBody, RigidBodyHandle, RigidBodySet};
use crate::model::collider::{ColliderHandle, ColliderSet};

/// A body that wheels stand on, or none: colliders without a body never move.
#[derive(Clone, Debug)]
pub(super) struct Ground {
    pub handle: Option<RigidBodyHandle>,
    pub is_dynamic: bool,
    pub mover: Mover,
}

/// Compliance of a dynamic body.
#[derive(Copy, Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde-serialize", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct GroundCompliance {
    handle: RigidBodyHandle,
    /// Fractions, linear and angular.
    fractions: [Vector; 2],
    /// The velocities at the last update, and their expected changes by pushes.
    old: [Vector; 2],
    expected: [Vector; 2],
}

/// The bodies below the wheels in one update, and their stored compliances.
#[derive(Clone, Debug, Default)]
pub(super) struct Grounds {
    pub all: Vec<Ground>,
}

impl Grounds {
    /// The index of the body of a collider.
    pub fn index_of(
        &mut self,
        collider: ColliderHandle,
        bodies: &RigidBodySet,
        colliders: &ColliderSet,
        compliances: &[GroundCompliance],
        dt: Real,
    ) -> usize {
        let handle = colliders.get(collider).and_then(|collider| collider.parent());
        let body = handle.and_then(|handle| bodies.get(handle));
        let handle = handle.filter(|_| body.is_some());
        if let Some(index) = self.all.iter().position(|ground| ground.handle == handle) {
            return index;
        }
        let compliance = compliances.iter().find(|compliance| Some(compliance.handle) == handle);
        let mover = body.map_or_else(Mover::fixed, |body| mover_of(body, compliance, dt));
        let is_dynamic = body.is_some_and(RigidBody::is_dynamic);
        self.all.push(Ground { handle, is_dynamic, mover });
        self.all.len() - 1
    }
}

fn mover_of(body: &RigidBody, compliance: Option<&GroundCompliance>, dt: Real) -> Mover {
    let (linvel, angvel) = velocities_ahead(body, dt);
    let mprops = body.mass_properties();
    let mut mover = Mover {
        center: mprops.world_com(),
        inv_mass: mprops.effective_inv_mass(),
        inv_inertia: *mprops.effective_world_inv_inertia(),
        old_linvel: linvel,
        old_angvel: angvel,
        linvel,
        angvel,
    };
    if let Some(compliance) = compliance {
        mover.inv_mass *= compliance.fractions[0];
        mover.inv_inertia = scaled(&mover.inv_inertia, compliance.fractions[1]);
    }
    // Effect of other vehicles on it in this step.
    let (force, torque) = body.pending_push();
    mover.linvel += mover.inv_mass * force * dt;
    mover.angvel += mul_inertia(&mover.inv_inertia, torque) * dt;
    mover
}

/// `D^½ A D^½`.
fn scaled(inertia: &AngularInertia, fractions: Vector) -> AngularInertia {
    let root = Vector::new(fractions.x.sqrt(), fractions.y.sqrt(), fractions.z.sqrt());
    let mut result = zero_inertia();
    result.m11 = inertia.m11 * fractions.x;
    result.m22 = inertia.m22 * fractions.y;
    result.m33 = inertia.m33 * fractions.z;
    result.m12 = inertia.m12 * (root.x * root.y);
    result.m13 = inertia.m13 * (root.x * root.z);
    result.m23 = inertia.m23 * (root.y * root.z);
    result
}

impl GroundCompliance {
    /// Measures the response of bodies to the pushes of the last update. Removes missing bodies.
    pub fn observe(compliances: &mut Vec<Self>, bodies: &RigidBodySet) {
        compliances.retain_mut(|compliance| {
            let Some(body) = bodies.get(compliance.handle) else { return false };
            for (i, now) in [body.linvel(), body.angvel()].into_iter().enumerate() {
                let (changed, expected) = (now - compliance.old[i], compliance.expected[i]);
                for axis in 0..3 {
                    let fraction = &mut compliance.fractions[i][axis];
                    *fraction = next_fraction(*fraction, changed[axis], expected[axis]);
                }
            }
            true
        });
    }

    /// Stores the expected effect of the pending pushes on the bodies below the wheels.
    pub fn expect(compliances: &mut Vec<Self>, grounds: &Grounds, bodies: &RigidBodySet, dt: Real) {
        let known = core::mem::take(compliances);
        for ground in grounds.all.iter().filter(|ground| ground.is_dynamic) {
            let Some(handle) = ground.handle else { continue };
            let Some(body) = bodies.get(handle) else { continue };
            let fractions = known.iter().find(|compliance| compliance.handle == handle);
            let (force, torque) = body.pending_push();
            let mprops = body.mass_properties();
            let by_torque = mul_inertia(mprops.effective_world_inv_inertia(), torque);
            compliances.push(Self {
                handle,
                fractions: fractions.map_or([Vector::ONE; 2], |compliance| compliance.fractions),
                old: [body.linvel(), body.angvel()],
                expected: [mprops.effective_inv_mass() * force * dt, by_torque * dt],
            });
        }
    }
}

/// The mean of the old estimate and the new measurement, so that a bouncing body does not make the fraction
/// jump.
fn next_fraction(fraction: Real, changed: Real, expected: Real) -> Real {
    let seen = changed / expected;
    if expected != 0.0 && seen.is_finite() {
        0.5 * (fraction + seen.clamp(0.0, 1.0))
    } else {
        fraction
    }
}

#[cfg(test)]
mod tests {
    use super::next_fraction;

    #[test]
    fn a_fraction_follows_the_measurement() {
        assert_eq!(next_fraction(1.0, 0.0, -2.0), 0.5);
        assert_eq!(next_fraction(0.5, -2.0, -2.0), 0.75);
        assert_eq!(next_fraction(0.5, 8.0, 2.0), 0.75);
        assert_eq!(next_fraction(0.3, 1.0, 0.0), 0.3);
    }
}
