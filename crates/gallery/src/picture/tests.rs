//! Pictures show what they should.

use super::*;

const WHITE: Color = Color { red: 1.0, green: 1.0, blue: 1.0, opacity: 1.0 };
const RED: Color = Color { red: 1.0, green: 0.0, blue: 0.0, opacity: 1.0 };

fn line(from: Point, to: Point, color: Color) -> Line {
    Line { from, to, color, scenery: false, on_top: false }
}

fn pixel(pixels: &[u8], x: usize, y: usize) -> [u8; 3] {
    let start = (y * SIZE[0] + x) * 3;
    [pixels[start], pixels[start + 1], pixels[start + 2]]
}

/// Number of pixels that are nearly as bright as white.
fn bright(pixels: &[u8]) -> usize {
    pixels.chunks_exact(3).filter(|p| p.iter().all(|&c| c > 150)).count()
}

#[test]
fn flat_cross_meets_in_the_middle() {
    let mut picture = Picture::new(View::flat());
    picture.line(line([-3.0, 5.0, 0.0], [7.0, 5.0, 0.0], WHITE));
    picture.line(line([2.0, 0.0, 0.0], [2.0, 10.0, 0.0], WHITE));
    let pixels = picture.render();
    let [x, y] = [SIZE[0] / 2, (SIZE[1] as f32 * 0.5 * (1.0 - camera::LIFT)) as usize];
    assert!(pixel(&pixels, x, y)[0] > 200);
    assert!(pixel(&pixels, x, y + SIZE[1] / 3)[0] > 100);
    assert!(pixel(&pixels, x + 40, y + 40)[0] < 60);
}

#[test]
fn near_triangle_hides_far_line() {
    let far = line([-1.0, 0.0, -5.0], [1.0, 0.0, -5.0], WHITE);
    let mut picture = Picture::new(View::orbit(0.0, 0.0));
    picture.line(far);
    let open = bright(&picture.render());
    picture.triangle(Triangle {
        corners: [[-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [0.0, 12.0, 0.0]],
        color: RED,
        scenery: false,
        floor: false,
    });
    let hidden = bright(&picture.render());
    assert!(open > 100, "the line alone covers {open} pixels");
    assert_eq!(hidden, 0);
    picture.line(Line { on_top: true, ..far });
    assert!(bright(&picture.render()) > 50, "what is on top shows through");
}

#[test]
fn labels_stand_where_they_belong() {
    let mut picture = Picture::new(View::flat().focus([-8.0, -4.5, 0.0], [8.0, 4.5, 0.0]));
    let blank = picture.render();
    picture.label([4.0, 0.0, 0.0], "HINGE");
    picture.label([100.0, 0.0, 0.0], "BEYOND");
    picture.label([f32::NAN, 0.0, 0.0], "NOWHERE");
    let written = picture.render();
    let changed: Vec<usize> = (0..SIZE[0] * SIZE[1])
        .filter(|&at| blank[3 * at..3 * at + 3] != written[3 * at..3 * at + 3])
        .collect();
    assert!(changed.len() > 100, "{} pixels", changed.len());
    let columns = changed.iter().map(|at| at % SIZE[0]);
    let (first, last) = (columns.clone().min().unwrap(), columns.max().unwrap());
    // 86 % of the width shows 16 units, the middle of the picture is at 0.
    let expected = SIZE[0] as f32 * (0.5 + 4.0 * 0.86 / 16.0);
    assert!(((first + last) as f32 * 0.5 - expected).abs() < 3.0, "{first} to {last}");
}

#[test]
fn all_corners_of_a_box_are_in_the_picture() {
    for (yaw, pitch) in [(0.0, 0.0), (35.0, 25.0), (-120.0, 60.0), (200.0, 89.0)] {
        let corners: Vec<Point> = (0..8)
            .map(|i| [(i & 1) as f32 * 9.0, (i >> 1 & 1) as f32, (i >> 2) as f32 * 4.0])
            .collect();
        let camera = Camera::fit(&View::orbit(yaw, pitch), &corners, aspect());
        for &corner in &corners {
            let seen = camera.see(corner);
            assert!(seen.w > 0.0, "{corner:?} is behind the eye at yaw {yaw}, pitch {pitch}");
            assert!(seen.x.abs() < seen.w && seen.y.abs() < seen.w, "{corner:?} is outside");
        }
    }
}

#[test]
fn one_stray_body_does_not_shrink_the_others() {
    let mut picture = Picture::new(View::flat());
    for x in 0..1000 {
        picture.line(line([x as f32, 0.0, 0.0], [x as f32, 300.0, 0.0], WHITE));
    }
    let without = Camera::fit(&View::flat(), &picture.points_to_show(), aspect());
    picture.line(line([0.0, -1.0e6, 0.0], [0.0, -1.0e6, 0.0], WHITE));
    let with = Camera::fit(&View::flat(), &picture.points_to_show(), aspect());
    assert!((with.scale_up() / without.scale_up() - 1.0).abs() < 0.05);
}

#[test]
fn lines_that_are_not_numbers_are_left_out() {
    let mut picture = Picture::new(View::orbit(30.0, 20.0));
    picture.line(line([f32::NAN, 0.0, 0.0], [1.0, 0.0, 0.0], WHITE));
    picture.line(line([0.0, 0.0, 0.0], [f32::INFINITY, 0.0, 0.0], WHITE));
    assert_eq!(bright(&picture.render()), 0);
}

#[test]
fn a_floor_through_the_eye_is_cut_and_seen_from_above_only() {
    let mut picture = Picture::new(View::orbit(30.0, 10.0));
    picture.line(line([-1.0, 1.0, 0.0], [1.0, 1.0, 0.0], WHITE));
    for corners in [
        [[-900.0, 0.0, -900.0], [900.0, 0.0, 900.0], [900.0, 0.0, -900.0]],
        [[-900.0, 0.0, -900.0], [-900.0, 0.0, 900.0], [900.0, 0.0, 900.0]],
    ] {
        picture.triangle(Triangle { corners, color: RED, scenery: true, floor: true });
    }
    let below = |picture: &Picture| pixel(&picture.render(), SIZE[0] / 2, SIZE[1] * 3 / 4);
    let [red, _, blue] = below(&picture);
    assert!(red > blue, "the red floor should show below the line");
    for triangle in &mut picture.triangles {
        triangle.corners.reverse();
    }
    let [red, _, blue] = below(&picture);
    assert!(red < blue, "the floor's other side should not show");
}
