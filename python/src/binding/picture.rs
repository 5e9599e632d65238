//! Pictures of a world.

use super::batch::WorldBatch;
use super::numbers::coordinates;
use super::rapier::pipeline::DebugRenderMode;
use super::scene::{Artist, BodyColors, point};
use super::simulation::Simulation;
use super::space;
use super::world::World;
use crate::errors::invalid;
use crate::pictures::{encode, pixels_out};
use drawing::{Image, View, raster};
use numpy::PyArray3;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Largest number of pixels of a picture.
const PIXELS_MAX: usize = 1 << 26;
/// Size of pictures in notebooks (pixels).
const NOTEBOOK_SIZE: [usize; 2] = [640, 360];
/// Angles of the camera without arguments (degrees).
const YAW: f32 = 30.0;
const PITCH: f32 = 18.0;

/// A point of view, and the content besides the surfaces.
pub struct Shot {
    view: View,
    size: [usize; 2],
    lines: DebugRenderMode,
}

impl Shot {
    /// A shot of a size (pixels) with the angles of the camera (degrees): yaw and pitch.
    fn new(
        size: [usize; 2],
        [yaw, pitch]: [f32; 2],
        focus: Option<(Bound<'_, PyAny>, Bound<'_, PyAny>)>,
        lines: DebugRenderMode,
    ) -> PyResult<Self> {
        let [width, height] = size;
        if width == 0 || height == 0 || width.saturating_mul(height) > PIXELS_MAX {
            return Err(invalid(format!(
                "the size is {width} × {height} pixels, but must have from 1 to {PIXELS_MAX} pixels"
            )));
        }
        if !(yaw.is_finite() && pitch.is_finite()) {
            return Err(invalid(format!("yaw is {yaw} and pitch is {pitch}, but must be finite")));
        }
        let mut view = space::view(yaw, pitch);
        if let Some((low, high)) = focus {
            view =
                view.focus(point(coordinates("focus", &low)?), point(coordinates("focus", &high)?));
        }
        Ok(Self { view, size, lines })
    }

    /// The picture of a world, at the poses of bodies that were moved since the last step.
    fn of(&self, simulation: &mut Simulation, artist: &mut Artist) -> Image {
        simulation.current();
        let Simulation { world, vehicles } = simulation;
        let mut drawing = artist.draw_world(world, &BodyColors::new(), self.lines);
        vehicles.draw(world, &mut drawing);
        let camera = drawing.camera(&self.view, self.size);
        raster::picture(&drawing, &camera, self.size)
    }
}

/// The lines of an artist with the selected overlays.
fn lines(joints: bool, contacts: bool) -> DebugRenderMode {
    let mut lines = DebugRenderMode::empty();
    lines.set(DebugRenderMode::JOINTS, joints);
    lines.set(DebugRenderMode::CONTACTS, contacts);
    lines
}

#[pymethods]
impl World {
    /// A picture: an array of the shape (height, width, 3) with bytes of red, green and blue. The
    /// processor paints it, without a graphics adapter.
    ///
    /// width, height: size (pixels). yaw, pitch: direction of the camera (degrees, 3D only): yaw 0
    /// looks along -z and 90 along -x, pitch is the angle downwards.
    /// focus: two opposite corners of the box to show (m, world), by default all that moves.
    /// joints, contacts: whether lines show them.
    #[pyo3(signature = (width=NOTEBOOK_SIZE[0], height=NOTEBOOK_SIZE[1], *, yaw=YAW, pitch=PITCH, focus=None, joints=false, contacts=false))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        width: usize,
        height: usize,
        yaw: f32,
        pitch: f32,
        focus: Option<(Bound<'py, PyAny>, Bound<'py, PyAny>)>,
        joints: bool,
        contacts: bool,
    ) -> PyResult<Bound<'py, PyArray3<u8>>> {
        let shot = Shot::new([width, height], [yaw, pitch], focus, lines(joints, contacts))?;
        let image = self.detached(py, |state| shot.of(&mut state.simulation, &mut state.artist))?;
        pixels_out(py, image)
    }

    /// The picture of a notebook: PNG bytes.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let shot =
            Shot { view: space::view(YAW, PITCH), size: NOTEBOOK_SIZE, lines: lines(false, false) };
        let image = self.detached(py, |state| shot.of(&mut state.simulation, &mut state.artist))?;
        Ok(PyBytes::new(py, &py.detach(|| encode(&image))?))
    }
}

#[pymethods]
impl WorldBatch {
    /// A picture of one of the worlds, with the arguments of `World.render` after the index.
    #[pyo3(signature = (index, width=NOTEBOOK_SIZE[0], height=NOTEBOOK_SIZE[1], *, yaw=YAW, pitch=PITCH, focus=None, joints=false, contacts=false))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        index: usize,
        width: usize,
        height: usize,
        yaw: f32,
        pitch: f32,
        focus: Option<(Bound<'py, PyAny>, Bound<'py, PyAny>)>,
        joints: bool,
        contacts: bool,
    ) -> PyResult<Bound<'py, PyArray3<u8>>> {
        let shot = Shot::new([width, height], [yaw, pitch], focus, lines(joints, contacts))?;
        pixels_out(py, self.draw(py, index, |simulation, artist| shot.of(simulation, artist))?)
    }
}
