//! Coordinates and motors of joints, of one world and of many.

use super::batch::{SERIAL_MAX, WorldBatch};
use super::joint::{self, Joint, Key};
use super::numbers::{self, finite_elements, non_negative, shaped_array};
use super::rapier::dynamics::JointAxis;
use super::rapier::math::Real;
use super::rapier::pipeline::PhysicsWorld;
use super::simulation::Simulation;
use super::space;
use crate::errors::{invalid, stale};
use numpy::{PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use rayon::prelude::*;

/// Numbers of the state of a joint: its coordinate (rad or m) and the velocity of it.
const JOINT_STATE: usize = 2;

/// The coordinate of a joint about or along its free axis (rad or m), and its velocity.
fn joint_state(world: &PhysicsWorld, key: Key, axis: JointAxis) -> Option<[Real; JOINT_STATE]> {
    let ([handle1, handle2], data) = joint::parts(world, key)?;
    let (body1, body2) = (world.bodies.get(handle1)?, world.bodies.get(handle2)?);
    let direction = *body1.rotation() * data.local_axis1();
    if axis == JointAxis::LinX {
        let anchor1 = body1.position() * data.local_anchor1();
        let anchor2 = body2.position() * data.local_anchor2();
        let speed = body2.velocity_at_point(anchor2) - body1.velocity_at_point(anchor2);
        return Some([(anchor2 - anchor1).dot(direction), speed.dot(direction)]);
    }
    let angle = data.as_revolute()?.angle(body1.rotation(), body2.rotation());
    Some([angle, space::about(body2.angvel() - body1.angvel(), direction)])
}

#[pymethods]
impl Joint {
    /// The coordinate of a revolute joint (rad, from -π to π) or a prismatic joint (m).
    #[getter]
    fn position(&self, py: Python<'_>) -> PyResult<Real> {
        self.state(py).map(|[position, _]| position)
    }

    /// The velocity of the coordinate (rad/s or m/s).
    #[getter]
    fn velocity(&self, py: Python<'_>) -> PyResult<Real> {
        self.state(py).map(|[_, velocity]| velocity)
    }
}

impl Joint {
    fn state(&self, py: Python<'_>) -> PyResult<[Real; JOINT_STATE]> {
        let axis = self.free_axis()?;
        joint_state(&self.world.get().lock(py)?.simulation.world, self.key, axis)
            .ok_or_else(|| stale("joint"))
    }
}

impl WorldBatch {
    /// The keys and the axes of joints with motors.
    fn motors_of(&self, joints: &[PyRef<'_, Joint>]) -> PyResult<Vec<(Key, JointAxis)>> {
        let motor_of = |joint: &PyRef<'_, Joint>| {
            self.check_source(&joint.world, "joint")?;
            match joint::contains(&self.original().world, joint.key) {
                true => Ok((joint.key, joint.free_axis()?)),
                false => Err(stale("joint")),
            }
        };
        joints.iter().map(motor_of).collect()
    }
}

#[pymethods]
impl WorldBatch {
    /// Sets the targets of motors: an array of the shape (count, joints), positions (rad or m) with
    /// `stiffness` (1/s²) and `damping` (1/s), or velocities (rad/s or m/s)
    /// with `damping` alone. The joints are those of the original.
    #[pyo3(signature = (joints, targets, *, stiffness=0.0, damping))]
    fn set_motors(
        &self,
        py: Python<'_>,
        joints: Vec<PyRef<'_, Joint>>,
        targets: &Bound<'_, PyAny>,
        stiffness: f64,
        damping: f64,
    ) -> PyResult<()> {
        let motors = self.motors_of(&joints)?;
        let targets = shaped_array("targets", targets, &[self.count(), motors.len()])?;
        let targets = finite_elements("targets", &targets)?.to_vec();
        let (stiffness, damping) =
            (non_negative("stiffness", stiffness)?, non_negative("damping", damping)?);
        self.change(py, &targets, motors.len(), |simulation, targets| {
            for (&(key, axis), &target) in motors.iter().zip(targets) {
                let Some(joint) = joint::data_mut(&mut simulation.world, key) else { continue };
                match stiffness > 0.0 {
                    true => joint.set_motor_position(axis, target, stiffness, damping),
                    false => joint.set_motor_velocity(axis, target, damping),
                };
            }
        })
    }

    /// The coordinates (rad or m) and velocities (rad/s or m/s) of revolute and prismatic joints:
    /// an array of the shape (count, joints, 2).
    ///
    /// joints: those of the original. out: an array to fill instead of a new one.
    #[pyo3(signature = (joints, out=None))]
    fn joint_state<'py>(
        &self,
        py: Python<'py>,
        joints: Vec<PyRef<'py, Joint>>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
        let motors = self.motors_of(&joints)?;
        let out = numbers::output(py, out, &[self.count(), motors.len(), JOINT_STATE])?;
        let mut rows = out.try_readwrite()?;
        let rows = rows.as_slice_mut()?;
        let size = (motors.len() * JOINT_STATE).max(1);
        let fill = |(simulation, rows): (&Simulation, &mut [Real])| {
            motors.iter().zip(rows.chunks_exact_mut(JOINT_STATE)).all(|(&(key, axis), row)| {
                let state = joint_state(&simulation.world, key, axis);
                row.copy_from_slice(&state.unwrap_or_default());
                state.is_some()
            })
        };
        let complete = self.worlds(py, |worlds| match rows.len() < SERIAL_MAX {
            true => worlds.iter().zip(rows.chunks_mut(size)).all(fill),
            false => {
                let filled = worlds.par_iter().zip(rows.par_chunks_mut(size)).map(fill);
                filled.reduce(|| true, |a, b| a && b)
            }
        })?;
        match complete {
            true => Ok(out),
            false => Err(invalid("a joint of the batch was broken or has no coordinate")),
        }
    }
}
