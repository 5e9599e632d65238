//! Fills the triangles of an instance, pixel by pixel.

use super::{clip, whole};
use crate::light::RIM_PIXELS;
use crate::vector::{add_scaled, cross, dot, normalize, rotate, sub};
use crate::{Camera, Instance, Mesh, Point, Role, Seen};

/// Twice the area of a triangle (square pixels) below which it covers no pixel.
const AREA_MIN: f32 = 1.0e-6;

/// A pixel of a surface.
pub(super) struct Pixel {
    pub x: usize,
    pub y: usize,
    /// One over the distance. It is linear across the image of a plane, and the distance is not.
    pub nearness: f32,
    /// The normal there, not normalised; zero on the rim of a flat shape.
    pub normal: Point,
}

/// A vertex in the world and in the picture.
#[derive(Copy, Clone)]
struct Corner {
    place: Point,
    normal: Point,
    seen: Seen,
}

/// Visits the pixels of an instance in a picture of this size.
pub(super) fn instance(
    camera: &Camera,
    size: [usize; 2],
    mesh: &Mesh,
    instance: &Instance,
    mut visit: impl FnMut(&Pixel),
) {
    if is_outside(camera, mesh, instance) {
        return;
    }
    let rim = camera.pixel_at(1.0, 720.0) * RIM_PIXELS;
    let corners: Vec<Corner> = mesh
        .vertices
        .iter()
        .map(|vertex| {
            let mut place = instance.place(vertex.position);
            let mut normal = vertex.normal;
            if camera.flat {
                let inside = normal[2] > 0.5;
                if !inside {
                    place = add_scaled(place, rotate(instance.rotation, normal), rim);
                }
                normal = [0.0, 0.0, if inside { 1.0 } else { 0.0 }];
            } else {
                let unscaled = std::array::from_fn(|axis| normal[axis] / instance.scale[axis]);
                normal = normalize(rotate(instance.rotation, unscaled));
            }
            Corner { place, normal, seen: camera.see(place) }
        })
        .collect();
    for triangle in &mesh.triangles {
        let corners = triangle.map(|index| corners[index as usize]);
        if instance.role == Role::Ground && !camera.flat && !faces_eye(camera, &corners) {
            continue;
        }
        triangle_pixels(camera, size, corners, &mut visit);
    }
}

/// Returns whether the box of the instance is entirely behind the eye or beside the picture.
fn is_outside(camera: &Camera, mesh: &Mesh, instance: &Instance) -> bool {
    let corners = crate::sheet::box_corners(mesh.bounds).map(|p| camera.see(instance.place(p)));
    let all = |test: fn(&Seen) -> bool| corners.iter().all(test);
    corners.iter().all(|p| p.w < camera.nearest())
        || all(|p| p.x > p.w)
        || all(|p| p.x < -p.w)
        || all(|p| p.y > p.w)
        || all(|p| p.y < -p.w)
}

fn faces_eye(camera: &Camera, corners: &[Corner; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.place);
    dot(cross(sub(b, a), sub(c, a)), camera.toward_eye(a)) > 0.0
}

fn triangle_pixels(
    camera: &Camera,
    size: [usize; 2],
    corners: [Corner; 3],
    visit: &mut impl FnMut(&Pixel),
) {
    let seen = corners.map(|corner| corner.seen);
    let within = |p: &Seen| p.w > camera.nearest() && p.x.abs() <= p.w && p.y.abs() <= p.w;
    if seen.iter().all(within) {
        return fill(size, seen, corners.map(|corner| corner.normal), visit);
    }
    // Triangles that cross a border of the view are flat enough for one normal.
    let third = 1.0 / 3.0;
    let normal = corners.iter().fold([0.0; 3], |sum, corner| add_scaled(sum, corner.normal, third));
    let polygon = clip::triangle(seen, camera.nearest());
    let [first, rest @ ..] = polygon.as_slice() else { return };
    for pair in rest.windows(2) {
        fill(size, [*first, pair[0], pair[1]], [normal; 3], visit);
    }
}

/// Visits the pixels whose middle lies in the triangle.
fn fill(size: [usize; 2], corners: [Seen; 3], normals: [Point; 3], visit: &mut impl FnMut(&Pixel)) {
    let at = |c: Seen| {
        let (x, y) = (c.x / c.w, c.y / c.w);
        [(x * 0.5 + 0.5) * size[0] as f32, (0.5 - y * 0.5) * size[1] as f32]
    };
    let p = corners.map(at);
    if twice_area(p[0], p[1], p[2]).abs() < AREA_MIN {
        return;
    }
    let nearness = corners.map(|c| 1.0 / c.w);
    cover(size, p, |x, y, weights| {
        visit(&Pixel {
            x,
            y,
            nearness: (0..3).map(|i| weights[i] * nearness[i]).sum(),
            normal: std::array::from_fn(|axis| (0..3).map(|i| weights[i] * normals[i][axis]).sum()),
        });
    });
}

/// Visits the pixels with their middle in a triangle, with barycentric coordinates.
pub(super) fn cover(
    size: [usize; 2],
    p: [[f32; 2]; 3],
    mut visit: impl FnMut(usize, usize, [f32; 3]),
) {
    let inverse = 1.0 / twice_area(p[0], p[1], p[2]);
    // Barycentric coordinate of corner `i`: the area between the opposite side and the pixel, over the whole
    // area.
    let weight = |i: usize, at: [f32; 2]| twice_area(p[(i + 1) % 3], p[(i + 2) % 3], at) * inverse;
    let range = |axis: usize| {
        let values = p.map(|p| p[axis]);
        [values.into_iter().fold(f32::MAX, f32::min), values.into_iter().fold(f32::MIN, f32::max)]
    };
    let (columns, rows) = (whole(range(0), size[0]), whole(range(1), size[1]));
    for y in rows {
        for x in columns.clone() {
            let at = [x as f32 + 0.5, y as f32 + 0.5];
            let mut weights = [0.0; 3];
            // Most pixels of the range are outside, and the first sides reject them.
            let inside = (0..3).all(|i| {
                weights[i] = weight(i, at);
                weights[i] > 0.0
            });
            if inside {
                visit(x, y, weights);
            }
        }
    }
}

/// Twice the area of a triangle, positive if it turns clockwise in the picture.
///
/// The side from `a` to `b` is always measured from the same end. Two triangles that share it agree on the
/// side of every point. No pixel along it is therefore painted twice, or not at all. A point exactly on it
/// belongs to the triangle that has the side in rising order.
fn twice_area(a: [f32; 2], b: [f32; 2], point: [f32; 2]) -> f32 {
    let rising = |a: [f32; 2], b: [f32; 2]| {
        let area = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
        if area == 0.0 { f32::EPSILON } else { area }
    };
    if (a[0], a[1]) < (b[0], b[1]) { rising(a, b) } else { -rising(b, a) }
}
