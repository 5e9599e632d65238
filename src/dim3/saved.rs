//! Saved forms of shapes that exist in three dimensions only.

use super::math::{Real, Vector};
use crate::base::fault::{Fault, ensure};
use crate::base::plain_shape::plain_shapes;
use parry::shape::{
    Ball, Capsule, Cone, ConvexPolyhedron, Cuboid, Cylinder, HalfSpace, HeightField,
    HeightFieldCellStatus, HeightFieldFlags, RoundCone, RoundConvexPolyhedron, RoundCuboid,
    RoundCylinder, RoundTriangle, Segment, SharedShape, Triangle, TypedShape,
};
use parry::utils::Array2;

plain_shapes!(
    Ball,
    Cuboid,
    Capsule,
    Segment,
    Triangle,
    HalfSpace,
    ConvexPolyhedron,
    Cylinder,
    Cone,
    RoundCuboid,
    RoundTriangle,
    RoundCylinder,
    RoundCone,
    RoundConvexPolyhedron
);

/// A height field without the data that follow from its heights.
#[derive(serde::Serialize, serde::Deserialize)]
pub struct SavedField {
    rows: usize,
    columns: usize,
    heights: Vec<Real>,
    scale: Vector,
    flags: u8,
    /// By cell.
    statuses: Vec<u8>,
}

impl SavedField {
    pub fn of(field: &HeightField) -> Self {
        let heights = field.heights();
        let statuses = field.cells_statuses().data().iter();
        Self {
            rows: heights.nrows(),
            columns: heights.ncols(),
            heights: heights.data().to_vec(),
            scale: field.scale(),
            flags: field.flags().bits(),
            statuses: statuses.map(HeightFieldCellStatus::bits).collect(),
        }
    }

    pub fn restore(self) -> Result<HeightField, Fault> {
        let Self { rows, columns, heights, scale, flags, statuses } = self;
        ensure!(rows.min(columns) > 1, "a height field has {rows} rows, {columns} columns");
        let counts = [rows.checked_mul(columns), (rows - 1).checked_mul(columns - 1)];
        let expected = [heights.len(), statuses.len()].map(Some);
        ensure!(counts == expected, "{rows} rows, {columns} columns: {expected:?} heights, cells");
        let heights = Array2::new(rows, columns, heights);
        let flags = HeightFieldFlags::from_bits_truncate(flags);
        let mut field = HeightField::with_flags(heights, scale, flags);
        for (cell, status) in field.cells_statuses_mut().data_mut().iter_mut().zip(statuses) {
            *cell = HeightFieldCellStatus::from_bits_truncate(status);
        }
        Ok(field)
    }
}

/// Checks the parts of convex shapes that their constructors compute.
pub fn check_hull(shape: TypedShape<'_>) -> Result<(), Fault> {
    match shape {
        TypedShape::ConvexPolyhedron(hull) => check_polyhedron(hull),
        TypedShape::RoundConvexPolyhedron(round) => check_polyhedron(&round.inner_shape),
        _ => Ok(()),
    }
}

/// Points, edges and faces that name each other are there.
fn check_polyhedron(hull: &ConvexPolyhedron) -> Result<(), Fault> {
    let counts = [hull.points().len(), hull.edges().len(), hull.faces().len()];
    ensure!(counts[0] > 2 && counts[1] > 2 && counts[2] > 1, "a hull of {counts:?} parts");
    let all_below = |list: &[u32], bound: usize| list.iter().all(|&id| (id as usize) < bound);
    let lists = [hull.vertices_adj_to_face(), hull.edges_adj_to_face(), hull.faces_adj_to_vertex()];
    let are_there = all_below(lists[0], counts[0]) && all_below(lists[1], counts[1]);
    ensure!(are_there && all_below(lists[2], counts[2]), "a hull lists parts that are not there");
    ensure!(lists[0].len() == lists[1].len(), "the faces of a hull have fewer edges than corners");
    ensure!(hull.vertices().len() == counts[0], "a hull has {} vertices", hull.vertices().len());
    let is_range = |first: u32, count: u32, list: &[u32]| {
        (first as usize).checked_add(count as usize).is_some_and(|end| end <= list.len())
    };
    for vertex in hull.vertices() {
        let (first, count) = (vertex.first_adj_face_or_edge, vertex.num_adj_faces_or_edge);
        ensure!(
            is_range(first, count, lists[2]),
            "a vertex of a hull has faces {first} to {count}"
        );
    }
    for face in hull.faces() {
        let (first, count) = (face.first_vertex_or_edge, face.num_vertices_or_edges);
        let is_face = count > 2 && is_range(first, count, lists[0]) && is_unit(face.normal);
        ensure!(is_face, "a hull has {face:?}");
    }
    for edge in hull.edges() {
        let are_there = all_below(&edge.vertices, counts[0]) && all_below(&edge.faces, counts[2]);
        ensure!(are_there && is_unit(edge.dir), "a hull has {edge:?}");
    }
    Ok(())
}

fn is_unit(direction: Vector) -> bool {
    direction.is_finite() && (direction.length_squared() - 1.0).abs() < 1.0e-2
}
