//! Many independent worlds that step together.

use super::joint::{Joint, data_mut};
use super::numbers::{self, STATE, elements, non_negative};
use super::rapier::dynamics::{JointAxis, RigidBodyHandle};
use super::rapier::math::{DIM, Real, Vector};
use super::rapier::pipeline::PhysicsWorld;
use super::space;
use super::world::World;
use crate::errors::invalid;
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Numbers of a force and a torque.
const WRENCH: usize = DIM + space::ANGULAR;

/// Copies of one world that step together on all cores. Each copy gives the bits that it would give alone.
///
/// The bodies of all copies are those of the original, in the order of `World.bodies`. Arrays have the shape (count, bodies, …), and calls that are given an
/// array to fill ask for no memory.
#[pyclass(frozen, module = "rapier")]
pub struct WorldBatch {
    original: PhysicsWorld,
    bodies: Vec<RigidBodyHandle>,
    count: usize,
    /// A thread that waits for the interpreter's lock does not hold this one.
    worlds: Mutex<Vec<PhysicsWorld>>,
}

impl WorldBatch {
    fn worlds(&self) -> MutexGuard<'_, Vec<PhysicsWorld>> {
        self.worlds.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The selected worlds: all without a mask.
    fn mask(&self, mask: Option<Vec<bool>>) -> PyResult<Vec<bool>> {
        match mask {
            None => Ok(vec![true; self.count]),
            Some(mask) if mask.len() == self.count => Ok(mask),
            Some(mask) => Err(invalid(format!("mask has {} elements, but there are {} worlds", mask.len(), self.count))),
        }
    }
}

#[pymethods]
impl WorldBatch {
    /// WorldBatch(world, count): copies of a world as it is now.
    #[new]
    fn new(world: &World, count: usize) -> Self {
        let original = world.read().world.clone();
        let bodies = original.bodies.iter().map(|(handle, _)| handle).collect();
        let worlds = (0..count).into_par_iter().map(|_| original.clone()).collect();
        Self { original, bodies, count, worlds: Mutex::new(worlds) }
    }

    /// The number of worlds.
    fn __len__(&self) -> usize {
        self.count
    }

    /// Moves all worlds forward by some time steps, on all cores. Releases the interpreter's lock.
    #[pyo3(signature = (count=1))]
    fn step(&self, py: Python<'_>, count: usize) {
        py.detach(|| {
            self.worlds().par_iter_mut().for_each(|world| (0..count).for_each(|_| world.step()));
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
        py.detach(|| {
            self.worlds().par_iter().zip(rows.par_chunks_mut(size.max(1))).for_each(|(world, rows)| {
                for (&handle, row) in self.bodies.iter().zip(rows.chunks_exact_mut(STATE)) {
                    numbers::write_state(&world.bodies[handle], row);
                }
            });
        });
        Ok(out)
    }

    /// Changes poses and velocities. mask: the worlds to change, all by default.
    #[pyo3(signature = (state, mask=None))]
    fn set_state(&self, state: &Bound<'_, PyAny>, mask: Option<Vec<bool>>) -> PyResult<()> {
        let rows = elements("state", state, &[self.count, self.bodies.len(), STATE])?;
        let mask = self.mask(mask)?;
        let selected = |world: usize| mask[world];
        for (index, row) in rows.chunks_exact(STATE).enumerate() {
            let (world, body) = (index / self.bodies.len(), index % self.bodies.len());
            let is_state = row.iter().all(|number| number.is_finite()) && space::rotation_of(&row[DIM..numbers::POSE]).is_some();
            if selected(world) && !is_state {
                return Err(invalid(format!("state[{world}, {body}] is {row:?}, which is no state of a body")));
            }
        }
        let mut worlds = self.worlds();
        for (index, row) in rows.chunks_exact(STATE).enumerate() {
            let (world, body) = (index / self.bodies.len(), index % self.bodies.len());
            if selected(world) {
                numbers::read_state(&mut worlds[world].bodies[self.bodies[body]], row);
            }
        }
        Ok(())
    }

    /// Returns worlds to the state of the original. mask: the worlds to reset, all by default.
    #[pyo3(signature = (mask=None))]
    fn reset(&self, py: Python<'_>, mask: Option<Vec<bool>>) -> PyResult<()> {
        let mask = self.mask(mask)?;
        py.detach(|| {
            let mut worlds = self.worlds();
            let selected = worlds.par_iter_mut().zip(mask).filter(|(_, selected)| *selected);
            selected.for_each(|(world, _)| world.clone_from(&self.original));
        });
        Ok(())
    }

    /// Sets the constant forces (N) and torques (N·m) of all bodies: an array of the shape (count, bodies, 6) in 3D, (count, bodies, 3) in 2D. They act at the
    /// centres of mass in each step until they are set again.
    fn set_forces(&self, forces: &Bound<'_, PyAny>) -> PyResult<()> {
        let rows = elements("forces", forces, &[self.count, self.bodies.len(), WRENCH])?;
        if let Some(index) = rows.iter().position(|number| !number.is_finite()) {
            return Err(invalid(format!("forces has the element {}, but must be finite", rows[index])));
        }
        let size = self.bodies.len() * WRENCH;
        self.worlds().par_iter_mut().zip(rows.par_chunks(size.max(1))).for_each(|(world, rows)| {
            for (&handle, row) in self.bodies.iter().zip(rows.chunks_exact(WRENCH)) {
                let body = &mut world.bodies[handle];
                body.reset_forces(false);
                body.reset_torques(false);
                let is_zero = row.iter().all(|&number| number == 0.0);
                if !is_zero {
                    body.add_force(Vector::from_slice(&row[..DIM]), true);
                    body.add_torque(space::angular_of(&row[DIM..]), true);
                }
            }
        });
        Ok(())
    }

    /// Sets the targets of motors: an array of the shape (count, joints), positions (rad or m) with `stiffness` (1/s²) and `damping` (1/s), or velocities (rad/s or m/s)
    /// with `damping` alone. The joints are those of the original.
    #[pyo3(signature = (joints, targets, *, stiffness=0.0, damping))]
    fn set_motors(&self, joints: Vec<PyRef<'_, Joint>>, targets: &Bound<'_, PyAny>, stiffness: f64, damping: f64) -> PyResult<()> {
        let targets = elements("targets", targets, &[self.count, joints.len()])?;
        if let Some(target) = targets.iter().find(|target| !target.is_finite()) {
            return Err(invalid(format!("targets has the element {target}, but must be finite")));
        }
        let (stiffness, damping) = (non_negative("stiffness", stiffness)?, non_negative("damping", damping)?);
        let joints = joints.iter().map(|joint| Ok((joint.key, joint.free_axis()?))).collect::<PyResult<Vec<(_, JointAxis)>>>()?;
        for (world, targets) in self.worlds().iter_mut().zip(targets.chunks_exact(joints.len().max(1))) {
            for (&(key, axis), &target) in joints.iter().zip(targets) {
                let joint = data_mut(world, key).ok_or_else(|| crate::errors::stale("joint"))?;
                match stiffness > 0.0 {
                    true => joint.set_motor_position(axis, target, stiffness, damping),
                    false => joint.set_motor_velocity(axis, target, damping),
                };
            }
        }
        Ok(())
    }

    /// The hashes of all worlds.
    fn hashes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        let hashes: Vec<u64> = py.detach(|| self.worlds().par_iter().map(PhysicsWorld::hash).collect());
        PyArray1::from_vec(py, hashes)
    }

    /// A copy of one of the worlds.
    fn world(&self, index: usize) -> PyResult<World> {
        let worlds = self.worlds();
        let world = worlds.get(index).ok_or_else(|| invalid(format!("index is {index}, but there are {} worlds", worlds.len())))?;
        Ok(World::of(world.clone()))
    }

    fn __repr__(&self) -> String {
        format!("<WorldBatch: {} worlds of {} bodies>", self.count, self.bodies.len())
    }
}
