//! Elements of the scenes of multibodies.

use crate::dim::{about_z, hinge, loose_joint, spin_momentum, vec};
use crate::suite::joints::stage::bob;
use rapier::prelude::*;

/// A chain of bodies, each a child of the one before. The first may hang on a root.
pub struct Chain {
    /// The bodies, without the root.
    pub bodies: Vec<RigidBodyHandle>,
    /// The joints to their parents.
    pub joints: Vec<MultibodyJointHandle>,
}

/// Returns a body with a different inertia about each axis.
pub fn slab(at: Vector) -> RigidBodyBuilder {
    let shape = crate::dim::slab();
    RigidBodyBuilder::dynamic().translation(at).additional_mass_properties(shape).can_sleep(false)
}

/// Adds a chain of slabs at the origin along x, one length unit apart. It hangs on a body, or starts with a
/// free one.
pub fn chain(world: &mut PhysicsWorld, root: Option<RigidBodyHandle>, count: usize) -> Chain {
    chain_of(world, root, count, |world, k| {
        let body = world.insert_body(slab(vec(k as Real + 0.5, 0.0)));
        let end = if k == 0 { 0.0 } else { 0.5 };
        (body, loose_joint(k, vec(end, 0.0), vec(-0.5, 0.0)))
    })
}

/// Adds a chain that hangs on a body, or starts with a free one. `make` returns each of its bodies, and the
/// joint to the one before.
pub fn chain_of(
    world: &mut PhysicsWorld,
    root: Option<RigidBodyHandle>,
    count: usize,
    make: impl Fn(&mut PhysicsWorld, usize) -> (RigidBodyHandle, GenericJoint),
) -> Chain {
    let mut chain = Chain { bodies: Vec::new(), joints: Vec::new() };
    let mut parent = root;
    for k in 0..count {
        let (body, joint) = make(world, k);
        chain.bodies.push(body);
        if let Some(parent) = parent {
            let joint = world.multibody_joints.insert(parent, body, joint, true);
            chain.joints.push(joint.expect("the joint fits"));
        }
        parent = Some(body);
    }
    chain
}

/// Hangs a bob of mass 1 from a post at the origin by a multibody joint, at the angle `angle` from the
/// vertical.
pub fn hang(
    world: &mut PhysicsWorld,
    length: Real,
    radius: Real,
    angle: Real,
) -> (RigidBodyHandle, MultibodyJointHandle) {
    let post = world.insert_body(RigidBodyBuilder::fixed());
    let at = vec(length * angle.sin(), -length * angle.cos());
    let body = world.insert_body(bob(1.0, radius).translation(at).rotation(about_z(angle)));
    let joint = hinge().local_anchor2(vec(0.0, length));
    let joint = world.multibody_joints.insert(post, body, joint, true);
    (body, joint.expect("the joint fits"))
}

/// Returns the kinetic energy of some bodies.
pub fn kinetic_energy(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> Real {
    bodies.iter().map(|&body| world.bodies[body].kinetic_energy()).sum()
}

/// Returns the total energy of some bodies, half a substep before their pose (see
/// `gravitational_potential_energy`).
pub fn energy(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> Real {
    let h = world.integration_parameters.substep();
    let potential = |&body: &RigidBodyHandle| {
        world.bodies[body].gravitational_potential_energy(h, world.gravity)
    };
    kinetic_energy(world, bodies) + bodies.iter().map(potential).sum::<Real>()
}

/// Returns the linear momentum of some bodies.
pub fn momentum(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> Vector {
    let of = |&body: &RigidBodyHandle| world.bodies[body].linvel() * world.bodies[body].mass();
    bodies.iter().map(of).sum()
}

/// Returns the angular momentum of some bodies about the origin.
pub fn angular_momentum(world: &PhysicsWorld, bodies: &[RigidBodyHandle]) -> AngVector {
    let mut sum = about_z(0.0);
    for &body in bodies {
        let body = &world.bodies[body];
        sum += crate::dim::moment(body.center_of_mass(), body.linvel() * body.mass());
        sum += spin_momentum(body);
    }
    sum
}
