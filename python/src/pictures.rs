//! Pictures and moving pictures as PNG bytes, for all dimensions.

use crate::errors::invalid;
use drawing::{Animation, Image};
use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Red, green and blue.
const CHANNELS: usize = 3;

/// The array of a picture, of the shape (height, width, 3).
pub fn pixels_out(py: Python<'_>, image: Image) -> PyResult<Bound<'_, PyArray3<u8>>> {
    let Image { width, height, pixels } = image;
    PyArray1::from_vec(py, pixels).reshape([height, width, CHANNELS])
}

/// The picture of an array.
fn image_of(name: &str, array: &Bound<'_, PyAny>) -> PyResult<Image> {
    let array: PyReadonlyArray3<'_, u8> = array
        .extract()
        .map_err(|_| invalid(format!("{name} must be an array of bytes with three dimensions")))?;
    match *array.shape() {
        [height, width, CHANNELS] if width > 0 && height > 0 => {
            Ok(Image { width, height, pixels: array.to_vec()? })
        }
        ref shape => Err(invalid(format!(
            "{name} has the shape {shape:?}, but must have (height, width, 3)"
        ))),
    }
}

/// The PNG bytes of a picture.
pub fn encode(image: &Image) -> PyResult<Vec<u8>> {
    let mut bytes = Vec::new();
    image.encode(&mut bytes).map_err(|error| PyOSError::new_err(error.to_string()))?;
    Ok(bytes)
}

/// The PNG bytes of a picture, an array of the shape (height, width, 3) with bytes of red, green
/// and blue.
#[pyfunction]
pub fn encode_png<'py>(
    py: Python<'py>,
    picture: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyBytes>> {
    let image = image_of("picture", picture)?;
    Ok(PyBytes::new(py, &py.detach(|| encode(&image))?))
}

/// The bytes of a moving picture (APNG) of frames of one size, which repeats without end. Browsers
/// and notebooks play it.
///
/// frames: arrays of the shape (height, width, 3) with bytes of red, green and blue. fps: frames
/// per second.
#[pyfunction]
#[pyo3(signature = (frames, fps=30))]
pub fn encode_apng<'py>(
    py: Python<'py>,
    frames: Vec<Bound<'py, PyAny>>,
    fps: u16,
) -> PyResult<Bound<'py, PyBytes>> {
    if frames.is_empty() || fps == 0 {
        return Err(invalid(format!(
            "there are {} frames at {fps} per second, but both must be at least 1",
            frames.len()
        )));
    }
    let mut animation = Animation::default();
    for (number, frame) in frames.iter().enumerate() {
        animation.push(image_of(&format!("frames[{number}]"), frame)?);
        if animation.len() != number + 1 {
            return Err(invalid(format!(
                "frames[{number}] has the shape of no earlier frame: all must have one shape"
            )));
        }
    }
    let bytes = py.detach(|| {
        let mut bytes = Vec::new();
        animation.encode(&mut bytes, fps).map(|()| bytes)
    });
    Ok(PyBytes::new(py, &bytes.map_err(|error| PyOSError::new_err(error.to_string()))?))
}
