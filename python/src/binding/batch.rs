//! Many independent worlds that step together.

use super::garbage::traverse;
use super::joint;
use super::numbers::{self, STATE, finite_elements, parse_state, shaped_array};
use super::rapier::dynamics::{RigidBodyHandle, RigidBodyVelocity};
use super::rapier::math::{AngVector, DIM, Pose, Real, Vector};
use super::scene::Artist;
use super::simulation::Simulation;
use super::space;
use super::world::World;
use crate::errors::invalid;
use crate::shared::Shared;
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use rayon::prelude::*;
use std::borrow::BorrowMut;

/// Fewer elements of arrays than this are copied by one thread: waking others would take longer.
pub const SERIAL_MAX: usize = 1 << 12;
/// Numbers of a force and a torque.
const WRENCH: usize = DIM + space::ANGULAR;

/// Copies of one world, or of several worlds with the same bodies, that step together on all cores.
/// Each copy gives the bits that it would give alone.
///
/// The bodies of all copies are those of the original, in the order of `World.bodies`. Arrays have
/// the shape (count, bodies, …), and calls with an array to fill create no other one. Hooks and events
/// of the original belong to it alone.
#[pyclass(frozen, module = "rapier")]
pub struct WorldBatch {
    /// The world whose joints and vehicles the batch accepts.
    source: Py<World>,
    /// One original for all worlds, or one for each.
    originals: Vec<Simulation>,
    bodies: Vec<RigidBodyHandle>,
    count: usize,
    worlds: Shared<Vec<Simulation>>,
    /// The artist of all worlds, which keeps the meshes of shapes from picture to picture.
    artist: Shared<Artist>,
}

traverse!(WorldBatch, batch => batch.source);

impl WorldBatch {
    fn of(
        py: Python<'_>,
        source: Py<World>,
        originals: Vec<Simulation>,
        count: usize,
    ) -> PyResult<Self> {
        let mut worlds = Vec::new();
        worlds
            .try_reserve_exact(count)
            .map_err(|_| PyMemoryError::new_err(format!("{count} worlds need too much memory")))?;
        py.detach(|| {
            worlds.par_extend(
                (0..count).into_par_iter().map(|index| originals[index % originals.len()].clone()),
            )
        });
        let bodies = handles(&originals[0]);
        let (worlds, artist) = (Shared::new(worlds), Shared::new(Artist::default()));
        Ok(Self { source, originals, bodies, count, worlds, artist })
    }

    /// The number of worlds.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The original of the first world, whose joints and vehicles select those of all.
    pub fn original(&self) -> &Simulation {
        &self.originals[0]
    }

    /// Returns an error for an object of another world than the original.
    pub fn check_source(&self, world: &Py<World>, what: &str) -> PyResult<()> {
        match world.is(&self.source) {
            true => Ok(()),
            false => Err(invalid(format!(
                "the {what} belongs to another world than the original of the batch"
            ))),
        }
    }

    /// Reads all worlds detached from the interpreter.
    pub fn worlds<R: Send>(
        &self,
        py: Python<'_>,
        read: impl FnOnce(&[Simulation]) -> R + Send,
    ) -> PyResult<R> {
        self.worlds.detached(py, |worlds| read(worlds))
    }

    /// Draws one of the worlds, detached from the interpreter.
    pub fn draw<R: Send>(
        &self,
        py: Python<'_>,
        index: usize,
        draw: impl FnOnce(&mut Simulation, &mut Artist) -> R + Send,
    ) -> PyResult<R> {
        let mut world = self.one(py, index)?;
        self.artist.detached(py, |artist| draw(&mut world, artist))
    }

    /// A copy of one of the worlds.
    fn one(&self, py: Python<'_>, index: usize) -> PyResult<Simulation> {
        let world = self.worlds(py, |worlds| worlds.get(index).cloned())?;
        world.ok_or_else(|| {
            invalid(format!("index is {index}, but there are {} worlds", self.count))
        })
    }

    /// Changes all worlds on all cores by their rows, detached from the interpreter.
    pub fn change<T: Sync>(
        &self,
        py: Python<'_>,
        rows: &[T],
        rows_per_world: usize,
        change: impl Fn(&mut Simulation, &[T]) + Send + Sync,
    ) -> PyResult<()> {
        self.worlds.detached(py, |worlds| change_each(worlds, rows, rows_per_world, change))
    }

    /// The selected worlds: all without a mask.
    fn mask(&self, mask: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<bool>> {
        let Some(mask) = mask else { return Ok(vec![true; self.count]) };
        let mask: Vec<bool> = match mask.extract::<PyReadonlyArray1<'_, bool>>() {
            Ok(array) => array.as_array().iter().copied().collect(),
            Err(_) => mask.extract()?,
        };
        match mask.len() == self.count {
            true => Ok(mask),
            false => Err(invalid(format!(
                "mask has {} elements, but there are {} worlds",
                mask.len(),
                self.count
            ))),
        }
    }

    /// The states of the bodies of the selected worlds.
    fn parse_states(
        &self,
        rows: &[Real],
        mask: &[bool],
    ) -> PyResult<Vec<(Pose, RigidBodyVelocity)>> {
        let bodies = self.bodies.len();
        let mut states = Vec::new();
        for world in (0..self.count).filter(|&world| mask[world]) {
            let own = &rows[world * bodies * STATE..(world + 1) * bodies * STATE];
            for (body, row) in own.chunks_exact(STATE).enumerate() {
                states.push(parse_state(row).ok_or_else(|| {
                    invalid(format!(
                        "state[{world}, {body}] is {row:?}, which is no state of a body"
                    ))
                })?);
            }
        }
        Ok(states)
    }
}

/// The worlds with a true element of the mask.
fn selected<'a>(worlds: &'a mut [Simulation], mask: &[bool]) -> Vec<&'a mut Simulation> {
    worlds.iter_mut().zip(mask).filter_map(|(world, &chosen)| chosen.then_some(world)).collect()
}

/// Changes worlds on all cores by their rows.
fn change_each<W: BorrowMut<Simulation> + Send, T: Sync>(
    worlds: &mut [W],
    rows: &[T],
    rows_per_world: usize,
    change: impl Fn(&mut Simulation, &[T]) + Send + Sync,
) {
    let size = rows_per_world.max(1);
    let change = |(world, rows): (&mut W, &[T])| change(world.borrow_mut(), rows);
    match rows.len() < SERIAL_MAX {
        true => worlds.iter_mut().zip(rows.chunks(size)).for_each(change),
        false => worlds.par_iter_mut().zip(rows.par_chunks(size)).for_each(change),
    }
}

/// The bodies of a world, in the order of `World.bodies`.
fn handles(simulation: &Simulation) -> Vec<RigidBodyHandle> {
    simulation.world.bodies.iter().map(|(handle, _)| handle).collect()
}

/// The kind of objects whose handles, joined bodies, locked axes or wheels differ between two worlds.
fn difference(first: &Simulation, other: &Simulation) -> Option<&'static str> {
    if handles(first) != handles(other) {
        return Some("bodies");
    }
    if joint::structures(&first.world) != joint::structures(&other.world) {
        return Some("joints");
    }
    (first.vehicles.wheel_counts() != other.vehicles.wheel_counts()).then_some("vehicles")
}

#[pymethods]
impl WorldBatch {
    /// WorldBatch(world, count): copies of a world as it is now.
    #[new]
    fn new(py: Python<'_>, world: Py<World>, count: usize) -> PyResult<Self> {
        let original = world.get().simulation(py)?;
        Self::of(py, world, vec![original], count)
    }

    /// A batch of worlds with different parameters: one copy of each. All have the same bodies, joints
    /// and vehicles, inserted in the same order.
    ///
    /// worlds: the originals. Joints and vehicles of the first one select those of all.
    #[staticmethod]
    fn from_worlds(py: Python<'_>, worlds: Vec<Py<World>>) -> PyResult<Self> {
        let originals =
            worlds.iter().map(|world| world.get().simulation(py)).collect::<PyResult<Vec<_>>>()?;
        let Some(first) = originals.first() else { return Err(invalid("worlds is empty")) };
        for (index, other) in originals.iter().enumerate() {
            if let Some(what) = difference(first, other) {
                return Err(invalid(format!("worlds[{index}] has other {what} than worlds[0]")));
            }
        }
        let count = originals.len();
        Self::of(py, worlds[0].clone_ref(py), originals, count)
    }

    /// The number of worlds.
    fn __len__(&self) -> usize {
        self.count
    }

    /// Moves all worlds forward by some time steps, on all cores. Releases the interpreter's lock.
    #[pyo3(signature = (count=1))]
    fn step(&self, py: Python<'_>, count: usize) -> PyResult<()> {
        self.worlds.detached(py, |worlds| {
            let step =
                |simulation: &mut Simulation| (0..count).for_each(|_| simulation.step(&(), &()));
            match worlds.len() {
                1 => worlds.iter_mut().for_each(step),
                _ => worlds.par_iter_mut().for_each(step),
            }
        })
    }

    /// Poses and velocities: an array of the shape (count, bodies, 13) in 3D, (count, bodies, 6) in
    /// 2D. Rows are those of `World.state`.
    ///
    /// out: an array to fill instead of a new one.
    #[pyo3(signature = (out=None))]
    fn state<'py>(
        &self,
        py: Python<'py>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<Real>>> {
        let out = numbers::output(py, out, &[self.count, self.bodies.len(), STATE])?;
        let mut rows = out.try_readwrite()?;
        let rows = rows.as_slice_mut()?;
        let size = (self.bodies.len() * STATE).max(1);
        let write = |(simulation, rows): (&Simulation, &mut [Real])| {
            for (&handle, row) in self.bodies.iter().zip(rows.chunks_exact_mut(STATE)) {
                numbers::write_state(&simulation.world.bodies[handle], row);
            }
        };
        self.worlds(py, |worlds| match rows.len() < SERIAL_MAX {
            true => worlds.iter().zip(rows.chunks_mut(size)).for_each(write),
            false => worlds.par_iter().zip(rows.par_chunks_mut(size)).for_each(write),
        })?;
        Ok(out)
    }

    /// Changes poses and velocities: an array of the shape of `state`. Fixed bodies have no
    /// velocity and ignore it.
    ///
    /// mask: booleans of the shape (count), the worlds to change, all by default.
    #[pyo3(signature = (state, mask=None))]
    fn set_state(
        &self,
        py: Python<'_>,
        state: &Bound<'_, PyAny>,
        mask: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let rows = shaped_array("state", state, &[self.count, self.bodies.len(), STATE])?;
        let mask = self.mask(mask)?;
        let states = self.parse_states(rows.as_slice()?, &mask)?;
        let change = |simulation: &mut Simulation, states: &[(Pose, RigidBodyVelocity)]| {
            for (&handle, &(pose, velocity)) in self.bodies.iter().zip(states) {
                let body = &mut simulation.world.bodies[handle];
                body.set_position(pose, true);
                body.set_vels(velocity, true);
            }
        };
        self.worlds.detached(py, |worlds| {
            change_each(&mut selected(worlds, &mask), &states, self.bodies.len(), change)
        })
    }

    /// Returns worlds to the state of their original.
    ///
    /// mask: booleans of the shape (count), the worlds to reset, all by default.
    #[pyo3(signature = (mask=None))]
    fn reset(&self, py: Python<'_>, mask: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let mask = self.mask(mask)?;
        self.worlds.detached(py, |worlds| {
            worlds.par_iter_mut().enumerate().filter(|(index, _)| mask[*index]).for_each(
                |(index, simulation)| {
                    simulation.clone_from(&self.originals[index % self.originals.len()]);
                },
            );
        })
    }

    /// Sets the constant forces (N) and torques (N·m) of all bodies: an array of the shape (count,
    /// bodies, 6) in 3D, (count, bodies, 3) in 2D. They act at the
    /// centres of mass in each step until they are set again.
    fn set_forces(&self, py: Python<'_>, forces: &Bound<'_, PyAny>) -> PyResult<()> {
        let rows = shaped_array("forces", forces, &[self.count, self.bodies.len(), WRENCH])?;
        let wrench =
            |row: &[Real]| (Vector::from_slice(&row[..DIM]), space::angular_of(&row[DIM..]));
        let wrenches: Vec<(Vector, AngVector)> =
            finite_elements("forces", &rows)?.chunks_exact(WRENCH).map(wrench).collect();
        self.change(py, &wrenches, self.bodies.len(), |simulation, wrenches| {
            for (&handle, &(force, torque)) in self.bodies.iter().zip(wrenches) {
                let body = &mut simulation.world.bodies[handle];
                body.reset_forces(false);
                body.reset_torques(false);
                // Zero forces and torques change nothing and leave the body asleep.
                body.add_force(force, true);
                body.add_torque(torque, true);
            }
        })
    }

    /// The hashes of all worlds.
    fn hashes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<u64>>> {
        let hashes: Vec<u64> = self
            .worlds
            .detached(py, |worlds| worlds.par_iter_mut().map(Simulation::hash).collect())?;
        Ok(PyArray1::from_vec(py, hashes))
    }

    /// A copy of one of the worlds.
    fn world(&self, py: Python<'_>, index: usize) -> PyResult<World> {
        self.one(py, index).map(World::of)
    }

    fn __repr__(&self) -> String {
        format!("<WorldBatch: {} worlds of {} bodies>", self.count, self.bodies.len())
    }
}
