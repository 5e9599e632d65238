//! Letters made of strokes. A caption needs no font file, and is as smooth as the lines.
//!
//! A letter occupies a grid 4 wide and 6 high. Spaces separate its strokes; each stroke is a chain of points,
//! two digits (x, y) a point.

use super::canvas::Canvas;
use super::stroke::Stroke;
use crate::{Camera, Point};

/// Distance between the left edges of neighbouring letters, in units of the grid.
const ADVANCE: f32 = 5.9;
/// Distance of the caption from the picture's edges, in pixels.
const MARGIN: f32 = 30.0;

/// Size of a label's letters: pixels in a step of their grid.
const LABEL_UNIT: f32 = 1.9;

/// The strokes of a letter; small letters have the strokes of large ones.
fn strokes(letter: char) -> &'static str {
    match letter.to_ascii_uppercase() {
        'A' => "000516364540 0343",
        'B' => "00063645443303 3342413000",
        'C' => "4536160501103041",
        'D' => "00063645413000",
        'E' => "46060040 0333",
        'F' => "460600 0333",
        'G' => "45361605011030414323",
        'H' => "0006 4046 0343",
        'I' => "2026 1030 1636",
        'J' => "4641301001",
        'K' => "0006 460340",
        'L' => "060040",
        'M' => "0006234640",
        'N' => "00064046",
        'O' => "010516364541301001",
        'P' => "00063645443303",
        'Q' => "010516364541301001 2240",
        'R' => "00063645443303 2340",
        'S' => "453616050413334241301001",
        'T' => "2026 0646",
        'U' => "060110304146",
        'V' => "062046",
        'W' => "0610243046",
        'X' => "0046 0640",
        'Y' => "062346 2320",
        'Z' => "06460040",
        '0' => "010516364541301001",
        '1' => "152620 1030",
        '2' => "05163645440040",
        '3' => "0516364544334241301001 1333",
        '4' => "30360242",
        '5' => "460604344341301001",
        '6' => "36160501103041423303",
        '7' => "064620",
        '8' => "13040516364544331302011030414233",
        '9' => "10304145361605041343",
        '.' => "2020",
        ',' => "2110",
        ':' => "2121 2424",
        '-' => "1333",
        '_' => "0040",
        '/' => "0046",
        '(' => "36252130",
        ')' => "16252110",
        '+' => "2125 0343",
        '=' => "0242 0444",
        '%' => "0046 1515 3131",
        _ => "",
    }
}

/// Writes the two lines of the caption into the upper left corner.
pub(super) fn caption(canvas: &mut Canvas, [title, details]: &[String; 2]) {
    write(canvas, title, [MARGIN, MARGIN + 16.0], 2.7, 0.85);
    write(canvas, details, [MARGIN, MARGIN + 41.0], 1.65, 0.42);
}

/// Writes a line of text with its middle at a point of the scene, if that is in the picture.
pub(super) fn label(canvas: &mut Canvas, camera: &Camera, at: Point, text: &str) {
    let Some([x, y]) = camera.in_picture(at) else { return };
    let fineness = canvas.fineness as f32;
    let middle = canvas.place(x, y).map(|c| c / fineness);
    // The gap behind the last letter is not part of the text.
    let width = (text.chars().count() as f32 * ADVANCE - (ADVANCE - 4.0)) * LABEL_UNIT;
    let start = [middle[0] - 0.5 * width, middle[1] + 3.0 * LABEL_UNIT];
    write(canvas, text, start, LABEL_UNIT, 0.7);
}

/// Writes a line of text: `start` is the left end of its foot line, `unit` the size of a step of the
/// letters' grid, both in pixels.
fn write(canvas: &mut Canvas, text: &str, start: [f32; 2], unit: f32, opacity: f32) {
    let fine = canvas.fineness as f32;
    for (column, letter) in text.chars().enumerate() {
        let left = start[0] + column as f32 * ADVANCE * unit;
        for stroke in strokes(letter).split_whitespace() {
            let points: Vec<[f32; 2]> = stroke
                .as_bytes()
                .chunks_exact(2)
                .map(|p| [p[0], p[1]].map(|digit| f32::from(digit - b'0') * unit))
                .map(|[x, y]| [(left + x) * fine, (start[1] - y) * fine])
                .collect();
            for ends in points.windows(2) {
                let stroke = Stroke {
                    ends: [ends[0], ends[1]],
                    nearness: [f32::MAX; 2],
                    light: [0.72, 0.80, 0.95],
                    opacity: [opacity; 2],
                    width: 0.85 * unit.sqrt() * fine,
                };
                stroke.paint(canvas);
            }
        }
    }
}
