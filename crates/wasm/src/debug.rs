//! Debug lines.

use crate::memory::{Single, put_reals};
use crate::query::filter;

use crate::rapier::math::{Real, Vector};
use crate::rapier::pipeline::{
    DebugColor, DebugRenderBackend, DebugRenderMode, DebugRenderObject, DebugRenderPipeline,
    DebugRenderStyle, QueryFilter,
};
use crate::registry::queried;

/// The lines of a world: two points, and a colour for each of them.
struct Lines<'a> {
    filter: QueryFilter<'a>,
    points: Vec<Real>,
    colors: Vec<f32>,
}

impl DebugRenderBackend for Lines<'_> {
    fn filter_object(&self, object: DebugRenderObject<'_>) -> bool {
        match object {
            DebugRenderObject::Collider(handle, collider) => self.filter.test(handle, collider),
            _ => true,
        }
    }

    fn draw_line(&mut self, _: DebugRenderObject<'_>, a: Vector, b: Vector, color: DebugColor) {
        self.points.extend(a.to_array().into_iter().chain(b.to_array()));
        let color = rgba(color);
        self.colors.extend(color.into_iter().chain(color));
    }
}

/// Red, green, blue and opacity of a colour in hue, saturation and lightness.
fn rgba([hue, saturation, lightness, alpha]: DebugColor) -> [f32; 4] {
    let chroma = (1.0 - (2.0 * lightness - 1.0).abs()) * saturation;
    let sector = (hue / 60.0).rem_euclid(6.0);
    let second = chroma * (1.0 - (sector % 2.0 - 1.0).abs());
    let [red, green, blue] = match sector as u32 {
        0 => [chroma, second, 0.0],
        1 => [second, chroma, 0.0],
        2 => [0.0, chroma, second],
        3 => [0.0, second, chroma],
        4 => [second, 0.0, chroma],
        _ => [chroma, 0.0, second],
    };
    let base = lightness - 0.5 * chroma;
    [red + base, green + base, blue + base, alpha]
}

static COLORS: Single<Vec<f32>> = Single::new(Vec::new());

exports! {
    /// Draws a world. The real numbers are points, two for each line. Returns the number of colour
    /// components. Mode 0 selects the default lines.
    fn debug_render(world: u32, mode: u32) -> usize {
        let filter = filter();
        let mode = if mode == 0 { DebugRenderMode::default() } else { DebugRenderMode::from_bits_truncate(mode) };
        let mut lines = Lines { filter, points: Vec::new(), colors: Vec::new() };
        queried(world, |world, _| {
            world.debug_render(&mut DebugRenderPipeline::new(DebugRenderStyle::default(), mode), &mut lines);
        })?;
        put_reals(lines.points);
        // SAFETY: the reference ends with the block.
        let colors = unsafe { COLORS.get() };
        *colors = lines.colors;
        colors.len()
    }

    /// The address of the colours.
    fn debug_colors_address() -> usize {
        // SAFETY: the reference ends with the statement.
        unsafe { COLORS.get().as_ptr() as usize }
    }
}
