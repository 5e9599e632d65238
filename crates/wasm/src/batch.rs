//! Changes of many bodies in one call.

use crate::fault::{Fault, finite};
use crate::handle::Handle;
use crate::memory::{self, put_number};
use crate::rapier::dynamics::{RigidBody, RigidBodyHandle};
use crate::rapier::math::{ANG_DIM, DIM, Real};
use crate::registry::{body, write};

/// Changed quantities, in the order of `Batch` in TypeScript.
mod change {
    pub const TRANSLATION: u32 = 0;
    pub const ROTATION: u32 = 1;
    pub const LINVEL: u32 = 2;
    pub const ANGVEL: u32 = 3;
    pub const NEXT_TRANSLATION: u32 = 4;
    pub const NEXT_ROTATION: u32 = 5;
    pub const FORCE: u32 = 6;
    pub const IMPULSE: u32 = 7;

    /// The names in TypeScript.
    pub const NAMES: [&str; 8] = [
        "translation",
        "rotation",
        "linvel",
        "angvel",
        "nextTranslation",
        "nextRotation",
        "addForce",
        "applyImpulse",
    ];
}

/// Numbers of a rotation: an angle or a quaternion.
const ROTATION: usize = if DIM == 2 { 1 } else { 4 };

/// Numbers of the value of a change.
fn stride(what: u32) -> Result<usize, Fault> {
    match what {
        change::ROTATION | change::NEXT_ROTATION => Ok(ROTATION),
        change::ANGVEL => Ok(ANG_DIM),
        change::TRANSLATION
        | change::LINVEL
        | change::NEXT_TRANSLATION
        | change::FORCE
        | change::IMPULSE => Ok(DIM),
        _ => Err(Fault::number("the change", what.into(), "a change of bodies")),
    }
}

/// Changes a body: the value is in the first place of the scratch block.
fn apply(body: &mut RigidBody, what: u32, wake: bool) -> Result<(), Fault> {
    match what {
        change::TRANSLATION => body.set_translation(memory::vector(0, "translation")?, wake),
        change::ROTATION => body.set_rotation(memory::rotation(0, "rotation")?, wake),
        change::LINVEL => body.set_linvel(memory::vector(0, "linvel")?, wake),
        change::ANGVEL => body.set_angvel(memory::angular(0, "angvel")?, wake),
        change::NEXT_TRANSLATION => {
            body.set_next_kinematic_translation(memory::vector(0, "translation")?)
        }
        change::NEXT_ROTATION => body.set_next_kinematic_rotation(memory::rotation(0, "rotation")?),
        change::FORCE => body.add_force(memory::vector(0, "force")?, wake),
        _ => body.apply_impulse(memory::vector(0, "impulse")?, wake),
    }
    Ok(())
}

/// Moves the value of a change into the first place of the scratch block.
fn place(numbers: &[Real]) {
    for (component, value) in numbers.iter().enumerate() {
        put_number(0, component, *value);
    }
}

exports! {
    /// Changes many bodies: the list holds the handles, the real numbers the values. An invalid value
    /// prevents all changes.
    fn bodies_change(world: u32, what: u32, wake: u32) {
        let (handles, values, stride) = (memory::list(), memory::reals(), stride(what)?);
        if values.len() != handles.len() * stride {
            let text = format_args!("{} bodies need {} numbers, not {}", handles.len(), handles.len() * stride, values.len());
            return Err(Fault::invalid(text));
        }
        for handle in &handles {
            body(world, *handle)?;
        }
        for value in &values {
            finite(change::NAMES[what as usize], *value)?;
        }
        if matches!(what, change::ROTATION | change::NEXT_ROTATION) {
            for numbers in values.chunks_exact(stride) {
                place(numbers);
                memory::rotation(0, "rotation")?;
            }
        }
        let world = write(world)?;
        for (handle, numbers) in handles.into_iter().zip(values.chunks_exact(stride)) {
            place(numbers);
            if let Some(body) = world.bodies.get_mut(RigidBodyHandle::of_number(handle)) {
                apply(body, what, wake != 0)?;
            }
        }
    }
}
