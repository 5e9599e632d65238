//! Parts near a swept line: all of them, and few others.

use crate::base::random::Random;
use crate::collide::parts::{Line, Near, Parts};
use crate::dim::collide::samples;
use crate::dim::math::{Pose, Real, Vector};
use parry::bounding_volume::Aabb;
use parry::math::IVector;
use parry::shape::{Compound, Shape, SharedShape, Voxels};

const SIDE: usize = 64;

/// Returns whether the cell is filled. The black fields of a chess board: none is closed in by others, which
/// would make it no part.
fn is_black([x, y]: [usize; 2]) -> bool {
    (x + y).is_multiple_of(2)
}

/// A chess board of boxes with a side of 1.
fn squares() -> [SharedShape; 2] {
    let cells = || (0..SIDE * SIDE).map(|k| [k % SIDE, k / SIDE]).filter(|&cell| is_black(cell));
    let at = |[x, y]: [usize; 2]| {
        let mut at = Vector::splat(0.5);
        (at.x, at.y) = (x as Real + 0.5, y as Real + 0.5);
        at
    };
    let cell = |[x, y]: [usize; 2]| {
        let mut cell = IVector::ZERO;
        (cell.x, cell.y) = (x as _, y as _);
        cell
    };
    let block = || samples::cuboid(Vector::splat(0.5));
    let boxes = cells().map(|k| (Pose::from_translation(at(k)), block())).collect();
    let grid: Vec<IVector> = cells().map(cell).collect();
    [SharedShape::new(Compound::new(boxes)), SharedShape::new(Voxels::new(Vector::ONE, &grid))]
}

/// Returns the number of parts visited for a line. Checks that they include each part near the line.
fn count_near(shape: &dyn Shape, start: Vector, displacement: Vector, radius: Real) -> usize {
    let path = Aabb::new(start.min(start + displacement), start.max(start + displacement));
    let region = Aabb::new(path.mins - Vector::splat(radius), path.maxs + Vector::splat(radius));
    let near =
        Line::new(start, displacement, radius, region).map_or(Near::Inside(region), Near::Along);
    let (mut seen, mut count) = (vec![false; SIDE * SIDE], 0);
    let place = |at: Vector| at.x.floor() as usize * SIDE + at.y.floor() as usize;
    Parts::of(shape).for_each_part(&near, &mut |part| {
        let center = part.pose() * part.shape.compute_local_aabb().center();
        seen[place(center)] = true;
        count += 1;
    });
    for k in 0..=4096 {
        let at = start + displacement * (k as Real / 4096.0);
        let is_over = |x: Real| x > 0.0 && x < SIDE as Real;
        if is_over(at.x) && is_over(at.y) && is_black([at.x as usize, at.y as usize]) {
            assert!(
                seen[place(at)],
                "{start} {displacement} {radius}: the cell at {at} was not visited"
            );
        }
    }
    count
}

/// A line passes no more squares than two per row and column, and those beside them within the radius; pieces
/// of a line overlap.
#[test]
fn a_line_passes_few_parts() {
    let mut random = Random(7);
    for shape in squares() {
        for _ in 0..200 {
            let side = SIDE as f64;
            let mut corner = |low, high| {
                let mut corner = Vector::splat(0.5);
                (corner.x, corner.y) = (random.within(low, high), random.within(low, high));
                corner
            };
            let (start, end) = (corner(-side, side), corner(0.0, 2.0 * side));
            let count = count_near(shape.as_ref(), start, end - start, 0.3);
            assert!(count <= 16 * SIDE, "{count} parts for {start} to {end}");
        }
    }
}
