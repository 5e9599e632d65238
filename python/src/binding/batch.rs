//! Many independent worlds that step together.

use super::joint::{self, Joint};
use super::numbers::{self, STATE, finite_elements, non_negative, parse_state, shaped_array};
use super::rapier::dynamics::{JointAxis, RigidBodyHandle, RigidBodyVelocity};
use super::rapier::math::{AngVector, DIM, Pose, Real, Vector};
use super::rapier::pipeline::PhysicsWorld;
use super::space;
use super::world::World;
use crate::errors::{invalid, stale};
use crate::shared::Shared;
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use rayon::prelude::*;

/// Numbers of a force and a torque.
const WRENCH: usize = DIM + space::ANGULAR;

/// Copies of one world that step together on all cores. Each copy gives the bits that it would give alone.
///
/// The bodies of all copies are those of the original, in the order of `World.bodies`. Arrays have the shape (count, bodies, …), and calls with an array to fill
/// allocate no memory.
#[pyclass(frozen, module = "rapier")]
pub struct WorldBatch {
    /// The world whose joints `set_motors` accepts.
    source: Py<World>,
    original: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    count: usize,
    worlds: Shared<Vec<PhysicsWorld>>,
}

impl WorldBatch {
    /// The selected worlds: all without a mask.
    fn mask(&self, mask: Option<Vec<bool>>) -> PyResult<Vec<bool>> {
        match mask {
            None => Ok(vec![true; self.count]),
            Some(mask) if mask.len() == self.count => Ok(mask),
            Some(mask) => Err(invalid(format!("mask has {} elements, but there are {} worlds", mask.len(), self.count))),
        }
    }

    /// Changes all worlds on all cores by their rows, detached from the interpreter.
    fn change<T: Sync>(&self, py: Python<'_>, rows: &[T], rows_per_world: usize, change: impl Fn(&mut PhysicsWorld, &[T]) + Send + Sync) {
        self.worlds.detached(py, |worlds| {
            let rows = rows.par_chunks(rows_per_world.max(1));
            worlds.par_iter_mut().zip(rows).for_each(|(world, rows)| change(world, rows));
        });
    }

    /// The states of the bodies of the selected worlds. Rows of other worlds give `None`.
    fn parse_states(&self, rows: &[Real], mask: &[bool]) -> PyResult<Vec<Option<(Pose, RigidBodyVelocity)>>> {
        let parse = |(index, row): (usize, &[Real])| {
            let (world, body) = (index / self.bodies.len(), index % self.bodies.len());
            match mask[world] {
                true => parse_state(row).map(Some).ok_or_else(|| invalid(format!("state[{world}, {body}] is {row:?}, which is no state of a body"))),
                false => Ok(None),
            }
        };
        rows.chunks_exact(STATE).enumerate().map(parse).collect()
    }

    /// The key and the axis of a joint with a motor.
    fn motor_of(&self, joint: &Joint) -> PyResult<(joint::Key, JointAxis)> {
        if !joint.world.is(&self.source) {
            return Err(invalid("the joint belongs to another world than the original of the batch"));
        }
        match joint::contains(&self.original, joint.key) {
            true => Ok((joint.key, joint.free_axis()?)),
            false => Err(stale("joint")),
        }
    }
}

#[pymethods]
impl WorldBatch {
    /// WorldBatch(world, count): copies of a world as it is now.
    #[new]
    fn new(py: Python<'_>, world: Py<World>, count: usize) -> PyResult<Self> {
        let mut worlds = Vec::new();
        worlds.try_reserve_exact(count).map_err(|_| PyMemoryError::new_err(format!("{count} worlds need too much memory")))?;
        let original = world.get().detached(py, |state| state.world.clone());
        py.detach(|| worlds.par_extend((0..count).into_par_iter().map(|_| original.clone())));
        let bodies = original.bodies.iter().map(|(handle, _)| handle).collect();
        Ok(Self { source: world, original, bodies, count, worlds: Shared::new(worlds) })
    }

    /// The number of worlds.
    fn __len__(&self) -> usize {
        self.count
    }

    /// Moves all worlds forward by some time steps, on all cores. Releases the interpreter's lock.
    #[pyo3(signature = (count=1))]
    fn step(&self, py: Python<'_>, count: usize) {
        self.worlds.detached(py, |worlds| {
            worlds.par_iter_mut().for_each(|world| (0..count).for_each(|_| world.step()));
        });
    }

    /// Poses and velocities: an array of the shape (count, bodies, 13) in 3D, (count, bodies, 6) in 2D. Rows are those of `World.state`.
    ///
    /// out: an array to fill instead of a new one.
    #[pyo3(signature = (out=None))]
    fn state<'py>(&self, py: Python<'py>, out: Option<Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
        let out = numbers::output(py, out, &[self.count, self.bodies.len(), STATE])?;
        let mut rows = out.try_readwrite()?;
        let rows = rows.as_slice_mut()?;
        let size = self.bodies.len() * STATE;
        self.worlds.detached(py, |worlds| {
            worlds.par_iter().zip(rows.par_chunks_mut(size.max(1))).for_each(|(world, rows)| {
                for (&handle, row) in self.bodies.iter().zip(rows.chunks_exact_mut(STATE)) {
                    numbers::write_state(&world.bodies[handle], row);
                }
            });
        });
        Ok(out)
    }

    /// Changes poses and velocities: an array of the shape of `state`. Fixed bodies have no velocity and ignore it.
    ///
    /// mask: booleans of the shape (count), the worlds to change, all by default.
    #[pyo3(signature = (state, mask=None))]
    fn set_state(&self, py: Python<'_>, state: &Bound<'_, PyAny>, mask: Option<Vec<bool>>) -> PyResult<()> {
        let rows = shaped_array("state", state, &[self.count, self.bodies.len(), STATE])?;
        let states = self.parse_states(rows.as_slice()?, &self.mask(mask)?)?;
        self.change(py, &states, self.bodies.len(), |world, states| {
            for (&handle, state) in self.bodies.iter().zip(states) {
                let Some((pose, velocity)) = *state else { continue };
                let body = &mut world.bodies[handle];
                body.set_position(pose, true);
                body.set_vels(velocity, true);
            }
        });
        Ok(())
    }

    /// Returns worlds to the state of the original.
    ///
    /// mask: booleans of the shape (count), the worlds to reset, all by default.
    #[pyo3(signature = (mask=None))]
    fn reset(&self, py: Python<'_>, mask: Option<Vec<bool>>) -> PyResult<()> {
        self.change(py, &self.mask(mask)?, 1, |world, selected| {
            if selected[0] {
                world.clone_from(&self.original);
            }
        });
        Ok(())
    }

    /// Sets the constant forces (N) and torques (N·m) of all bodies: an array of the shape (count, bodies, 6) in 3D, (count, bodies, 3) in 2D. They act at the
    /// centres of mass in each step until they are set again.
    fn set_forces(&self, py: Python<'_>, forces: &Bound<'_, PyAny>) -> PyResult<()> {
        let rows = shaped_array("forces", forces, &[self.count, self.bodies.len(), WRENCH])?;
        let wrench = |row: &[Real]| (Vector::from_slice(&row[..DIM]), space::angular_of(&row[DIM..]));
        let wrenches: Vec<(Vector, AngVector)> = finite_elements("forces", &rows)?.chunks_exact(WRENCH).map(wrench).collect();
        self.change(py, &wrenches, self.bodies.len(), |world, wrenches| {
            for (&handle, &(force, torque)) in self.bodies.iter().zip(wrenches) {
                let body = &mut world.bodies[handle];
                body.reset_forces(false);
                body.reset_torques(false);
                // Zero forces and torques change nothing and leave the body asleep.
                body.add_force(force, true);
                body.add_torque(torque, true);
            }
        });
        Ok(())
    }

    /// Sets the targets of motors: an array of the shape (count, joints), positions (rad or m) with `stiffness` (1/s²) and `damping` (1/s), or velocities (rad/s or m/s)
    /// with `damping` alone. The joints are those of the original.
    #[pyo3(signature = (joints, targets, *, stiffness=0.0, damping))]
    fn set_motors(&self, py: Python<'_>, joints: Vec<PyRef<'_, Joint>>, targets: &Bound<'_, PyAny>, stiffness: f64, damping: f64) -> PyResult<()> {
        let motors = joints.iter().map(|joint| self.motor_of(joint)).collect::<PyResult<Vec<_>>>()?;
        let targets = shaped_array("targets", targets, &[self.count, motors.len()])?;
        let targets = finite_elements("targets", &targets)?.to_vec();
        let (stiffness, damping) = (non_negative("stiffness", stiffness)?, non_negative("damping", damping)?);
        self.change(py, &targets, motors.len(), |world, targets| {
            for (&(key, axis), &target) in motors.iter().zip(targets) {
                let Some(joint) = joint::data_mut(world, key) else { continue };
                match stiffness > 0.0 {
                    true => joint.set_motor_position(axis, target, stiffness, damping),
                    false => joint.set_motor_velocity(axis, target, damping),
                };
            }
        });
        Ok(())
    }

    /// The hashes of all worlds.
    fn hashes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        let hashes: Vec<u64> = self.worlds.detached(py, |worlds| worlds.par_iter().map(PhysicsWorld::hash).collect());
        PyArray1::from_vec(py, hashes)
    }

    /// A copy of one of the worlds.
    fn world(&self, py: Python<'_>, index: usize) -> PyResult<World> {
        let world = self.worlds.detached(py, |worlds| worlds.get(index).cloned());
        world.map(World::of).ok_or_else(|| invalid(format!("index is {index}, but there are {} worlds", self.count)))
    }

    fn __repr__(&self) -> String {
        format!("<WorldBatch: {} worlds of {} bodies>", self.count, self.bodies.len())
    }
}
