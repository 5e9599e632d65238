//! Pictures show their content.

use super::*;
use crate::{Color, Instance, Line, Mesh, Point, View};

const SIZE: [usize; 2] = [640, 360];
const ASPECT: f32 = 16.0 / 9.0;
const WHITE: Color = Color { red: 1.0, green: 1.0, blue: 1.0, opacity: 1.0 };
const RED: Color = Color { red: 1.0, green: 0.0, blue: 0.0, opacity: 1.0 };

fn line(from: Point, to: Point) -> Line {
    Line { from, to, color: WHITE, on_top: false }
}

fn instance(position: Point, scale: Point, role: Role) -> Instance {
    let rotation = [0.0, 0.0, 0.0, 1.0];
    Instance { position, rotation, scale, color: RED, role, id: 7, highlighted: false }
}

fn fit(view: View, drawing: &Drawing) -> Camera {
    Camera::fit(&view, &drawing.points_to_frame(), ASPECT)
}

fn pixel(image: &Image, x: usize, y: usize) -> [u8; 3] {
    let start = (y * image.width + x) * 3;
    [image.pixels[start], image.pixels[start + 1], image.pixels[start + 2]]
}

/// Number of pixels that are nearly as bright as white.
fn bright(image: &Image) -> usize {
    image.pixels.chunks_exact(3).filter(|p| p.iter().all(|&c| c > 150)).count()
}

#[test]
fn near_box_hides_far_line() {
    let mut drawing = Drawing::default();
    let far = line([-1.0, 0.0, -5.0], [1.0, 0.0, -5.0]);
    drawing.line(far);
    let camera = Camera::looking([0.0, 0.0, 5.0], [0.0; 3], ASPECT);
    let open = bright(&picture(&drawing, &camera, SIZE));
    drawing.add(Mesh::cube(), instance([0.0; 3], [2.0, 2.0, 0.5], Role::Moving));
    assert!(open > 50, "the line alone covers {open} pixels");
    assert_eq!(bright(&picture(&drawing, &camera, SIZE)), 0);
    drawing.line(Line { on_top: true, ..far });
    assert!(bright(&picture(&drawing, &camera, SIZE)) > 25, "a line on top shows through");
}

#[test]
fn a_ball_throws_a_shadow() {
    let mut drawing = Drawing::default();
    drawing.add(Mesh::cube(), instance([0.0, -1.0, 0.0], [90.0, 1.0, 90.0], Role::Scenery));
    let camera = Camera::looking([0.0, 9.0, 5.0], [0.0; 3], ASPECT);
    let bare = picture(&drawing, &camera, SIZE);
    drawing.add(Mesh::ball(), instance([0.0, 1.5, 0.0], [0.5; 3], Role::Moving));
    let shaded = picture(&drawing, &camera, SIZE);
    let pairs = bare.pixels.iter().zip(&shaded.pixels).step_by(3);
    let darker = pairs.filter(|(old, new)| old.saturating_sub(**new) > 40).count();
    assert!(darker > 500, "{darker} pixels");
}

#[test]
fn the_same_drawing_gives_the_same_bytes() {
    let mut drawing = Drawing::default();
    drawing.add(Mesh::ball(), instance([0.3, 1.5, 0.0], [0.5, 0.7, 0.5], Role::Moving));
    drawing.add(Mesh::cone(), instance([1.3, 0.5, 0.4], [0.5; 3], Role::Moving));
    let camera = fit(View::orbit(30.0, 20.0), &drawing);
    assert_eq!(picture(&drawing, &camera, SIZE), picture(&drawing.clone(), &camera, SIZE));
}

#[test]
fn flat_shapes_have_a_bright_rim() {
    let mut drawing = Drawing::default();
    drawing.add(Mesh::square(), instance([0.0; 3], [2.0, 1.0, 1.0], Role::Moving));
    let camera = Camera::level([0.0; 2], 2.0, ASPECT);
    let image = picture(&drawing, &camera, SIZE);
    let row: Vec<u8> = (0..SIZE[0]).map(|x| pixel(&image, x, SIZE[1] / 2)[0]).collect();
    // The square reaches from x = -2 to 2, and half the width shows 2 · 16 / 9.
    let border = (SIZE[0] as f32 * (0.5 + 0.5 * 2.0 / (2.0 * ASPECT))) as usize;
    let rim = row[border - 3..border + 2].iter().max();
    assert!(rim > Some(&(row[SIZE[0] / 2] + 30)), "{rim:?} and {}", row[SIZE[0] / 2]);
    assert!(row[border + 5] < 100);
}

/// A shape that crosses the border of the picture has the light of one that does not.
#[test]
fn flat_shapes_beyond_the_picture_keep_their_light() {
    let camera = Camera::level([0.0; 2], 2.0, ASPECT);
    let light = |half: f32| {
        let mut drawing = Drawing::default();
        drawing.add(Mesh::square(), instance([0.0; 3], [half; 3], Role::Moving));
        pixel(&picture(&drawing, &camera, SIZE), SIZE[0] / 2, SIZE[1] / 2)
    };
    assert_eq!(light(1.0), light(50.0));
}

#[test]
fn each_pixel_belongs_to_the_nearest_instance() {
    let mut drawing = Drawing::default();
    drawing.add(Mesh::ball(), instance([0.0; 3], [1.0; 3], Role::Moving));
    drawing.add(
        Mesh::cube(),
        Instance { id: 9, ..instance([0.0, 0.0, -3.0], [3.0, 3.0, 0.1], Role::Fixed) },
    );
    let camera = Camera::looking([0.0, 0.0, 6.0], [0.0; 3], ASPECT);
    let seen = visible(&drawing, &camera, [64, 36]);
    assert_eq!(seen[18 * 64 + 32], Some((Role::Moving, 7)));
    assert_eq!(seen[4 * 64 + 32], Some((Role::Fixed, 9)));
    assert_eq!(seen[18 * 64], None);
}

#[test]
fn labels_stand_where_they_belong() {
    let drawing = Drawing::default();
    let camera = Camera::level([0.0; 2], 4.5, ASPECT);
    let blank = picture(&drawing, &camera, SIZE);
    let mut words = Drawing::default();
    words.label([4.0, 0.0, 0.0], "HINGE");
    words.label([100.0, 0.0, 0.0], "BEYOND");
    words.label([f32::NAN, 0.0, 0.0], "NOWHERE");
    let written = write(&blank, &camera, &words.labels, &Default::default());
    let changed: Vec<usize> = (0..SIZE[0] * SIZE[1])
        .filter(|&at| blank.pixels[3 * at..3 * at + 3] != written.pixels[3 * at..3 * at + 3])
        .collect();
    assert!(changed.len() > 100, "{} pixels", changed.len());
    let columns = changed.iter().map(|at| at % SIZE[0]);
    let (first, last) = (columns.clone().min().unwrap(), columns.max().unwrap());
    let expected = SIZE[0] as f32 * (0.5 + 4.0 / 16.0);
    assert!(((first + last) as f32 * 0.5 - expected).abs() < 3.0, "{first} to {last}");
}

#[test]
fn all_corners_of_a_box_are_in_the_picture() {
    for (yaw, pitch) in [(0.0, 0.0), (35.0, 25.0), (-120.0, 60.0), (200.0, 89.0)] {
        let corners = crate::sheet::box_corners([[0.0; 3], [9.0, 1.0, 4.0]]);
        let camera = Camera::fit(&View::orbit(yaw, pitch), &corners, ASPECT);
        for &corner in &corners {
            let seen = camera.see(corner);
            assert!(seen.w > 0.0, "{corner:?} is behind the eye at yaw {yaw}, pitch {pitch}");
            assert!(seen.x.abs() < seen.w && seen.y.abs() < seen.w, "{corner:?} is outside");
        }
    }
}

#[test]
fn one_stray_body_does_not_shrink_the_others() {
    let mut points: Vec<Point> = (0..1000).map(|x| [x as f32, (x * 7 % 300) as f32, 0.0]).collect();
    let without = Camera::fit(&View::flat(), &points, ASPECT);
    points.push([0.0, -1.0e6, 0.0]);
    let with = Camera::fit(&View::flat(), &points, ASPECT);
    assert!((with.scale[1] / without.scale[1] - 1.0).abs() < 0.05);
}

#[test]
fn values_that_are_not_finite_are_left_out() {
    let mut drawing = Drawing::default();
    drawing.line(line([f32::NAN, 0.0, 0.0], [1.0, 0.0, 0.0]));
    drawing.add(Mesh::ball(), instance([f32::INFINITY, 0.0, 0.0], [1.0; 3], Role::Moving));
    assert!(drawing.lines.is_empty() && drawing.batches.is_empty());
}

#[test]
fn the_matrix_agrees_with_the_camera() {
    let looking = Camera::looking([3.0, 4.0, 6.0], [0.5, 0.0, 0.0], ASPECT);
    for camera in [looking, Camera::level([1.0, 2.0], 3.0, ASPECT)] {
        let matrix = camera.matrix();
        let point = [0.3, -0.4, 0.7];
        let row = |i: usize| (0..3).map(|c| matrix[c][i] * point[c]).sum::<f32>() + matrix[3][i];
        let seen = camera.see(point);
        for (a, b) in [(row(0), seen.x), (row(1), seen.y), (row(3), seen.w)] {
            assert!((a - b).abs() < 1.0e-4, "{a} and {b}");
        }
    }
}

#[test]
fn a_floor_through_the_eye_is_cut_and_seen_from_above_only() {
    let mut drawing = Drawing::default();
    let corners =
        [[-900.0, 0.0, -900.0], [-900.0, 0.0, 900.0], [900.0, 0.0, 900.0], [900.0, 0.0, -900.0]];
    let plane =
        |triangles: &[[u32; 3]]| std::sync::Arc::new(Mesh::from_triangles(&corners, triangles));
    let ground = instance([0.0; 3], [1.0; 3], Role::Ground);
    drawing.add(&plane(&[[0, 1, 2], [0, 2, 3]]), ground);
    let camera = Camera::looking([0.0, 2.0, 6.0], [0.0, 1.0, 0.0], ASPECT);
    let below =
        |drawing: &Drawing| pixel(&picture(drawing, &camera, SIZE), SIZE[0] / 2, SIZE[1] * 3 / 4);
    let [red, _, blue] = below(&drawing);
    assert!(red > blue, "the red floor should show");
    let mut other = Drawing::default();
    other.add(&plane(&[[2, 1, 0], [3, 2, 0]]), ground);
    let [red, _, blue] = below(&other);
    assert!(red < blue, "the other side of the floor should not show");
}
