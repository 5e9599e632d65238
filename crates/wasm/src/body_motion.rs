//! Bodies: poses, velocities and forces.

use crate::memory::{self, put_angular, put_rotation, put_vector};
use crate::registry::{body, body_mut};

exports! {
    /// Writes the translation.
    fn body_translation(world: u32, handle: f64) {
        put_vector(0, body(world, handle)?.translation());
    }

    /// Writes the rotation.
    fn body_rotation(world: u32, handle: f64) {
        put_rotation(0, *body(world, handle)?.rotation());
    }

    /// Writes the translation that a kinematic body has after the next step.
    fn body_next_translation(world: u32, handle: f64) {
        put_vector(0, body(world, handle)?.next_position().translation);
    }

    /// Writes the rotation that a kinematic body has after the next step.
    fn body_next_rotation(world: u32, handle: f64) {
        put_rotation(0, body(world, handle)?.next_position().rotation);
    }

    /// Writes the velocity of the centre of mass.
    fn body_linvel(world: u32, handle: f64) {
        put_vector(0, body(world, handle)?.linvel());
    }

    /// Writes the angular velocity.
    fn body_angvel(world: u32, handle: f64) {
        put_angular(0, body(world, handle)?.angvel());
    }

    /// Writes the velocity of a point of the body.
    fn body_velocity_at_point(world: u32, handle: f64) {
        let body = body(world, handle)?;
        put_vector(0, body.velocity_at_point(memory::vector(0, "point")?));
    }

    /// Moves the body.
    fn body_set_translation(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.set_translation(memory::vector(0, "translation")?, wake != 0);
    }

    /// Rotates the body.
    fn body_set_rotation(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.set_rotation(memory::rotation(0, "rotation")?, wake != 0);
    }

    /// Sets the translation that a kinematic body has after the next step.
    fn body_set_next_translation(world: u32, handle: f64) {
        let body = body_mut(world, handle)?;
        body.set_next_kinematic_translation(memory::vector(0, "translation")?);
    }

    /// Sets the rotation that a kinematic body has after the next step.
    fn body_set_next_rotation(world: u32, handle: f64) {
        let body = body_mut(world, handle)?;
        body.set_next_kinematic_rotation(memory::rotation(0, "rotation")?);
    }

    /// Sets the velocity of the centre of mass.
    fn body_set_linvel(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.set_linvel(memory::vector(0, "linvel")?, wake != 0);
    }

    /// Sets the angular velocity.
    fn body_set_angvel(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.set_angvel(memory::angular(0, "angvel")?, wake != 0);
    }

    /// Resets the added forces.
    fn body_reset_forces(world: u32, handle: f64, wake: u32) {
        body_mut(world, handle)?.reset_forces(wake != 0);
    }

    /// Resets the added torques.
    fn body_reset_torques(world: u32, handle: f64, wake: u32) {
        body_mut(world, handle)?.reset_torques(wake != 0);
    }

    /// Adds a force on the centre of mass.
    fn body_add_force(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.add_force(memory::vector(0, "force")?, wake != 0);
    }

    /// Adds a torque.
    fn body_add_torque(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.add_torque(memory::angular(0, "torque")?, wake != 0);
    }

    /// Adds a force on a point.
    fn body_add_force_at_point(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.add_force_at_point(memory::vector(0, "force")?, memory::vector(1, "point")?, wake != 0);
    }

    /// Applies an impulse to the centre of mass.
    fn body_apply_impulse(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.apply_impulse(memory::vector(0, "impulse")?, wake != 0);
    }

    /// Applies an angular impulse.
    fn body_apply_torque_impulse(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.apply_torque_impulse(memory::angular(0, "torqueImpulse")?, wake != 0);
    }

    /// Applies an impulse to a point.
    fn body_apply_impulse_at_point(world: u32, handle: f64, wake: u32) {
        let body = body_mut(world, handle)?;
        body.apply_impulse_at_point(memory::vector(0, "impulse")?, memory::vector(1, "point")?, wake != 0);
    }

    /// Writes the force that was added.
    fn body_user_force(world: u32, handle: f64) {
        put_vector(0, body(world, handle)?.user_force());
    }

    /// Writes the torque that was added.
    fn body_user_torque(world: u32, handle: f64) {
        put_angular(0, body(world, handle)?.user_torque());
    }

    /// The kinetic energy.
    fn body_kinetic_energy(world: u32, handle: f64) -> f64 {
        body(world, handle)?.kinetic_energy().into()
    }
}
