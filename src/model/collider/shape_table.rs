//! A shape that several colliders of a set use is saved, loaded and measured once.
//!
//! Serde's derived code hands no context to the fields of a value. So a set opens a table for its thread
//! while it is saved or loaded, and the shapes of its colliders are entered in it. Both directions visit the
//! same shapes in the same order: the number of a shape is the number of preceding shapes. The alternative, a
//! list of shapes beside the colliders, needs a second type for every container between the set and a shape.
//! Colliders that are saved alone have no table, and contain their shapes.

use super::widths::Widths;
use crate::dim::width;
use core::cell::{OnceCell, RefCell};
use parry::shape::{SharedShape, TypedShape};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::thread_local;

thread_local! {
    static TABLE: RefCell<Option<ShapeTable>> = const { RefCell::new(None) };
}

/// The shapes so far.
#[derive(Default)]
struct ShapeTable {
    shapes: Vec<Entry>,
    /// By address: the number of a shape. The table owns the shapes, so an address is not used twice.
    numbers: BTreeMap<usize, u32>,
}

struct Entry {
    shape: SharedShape,
    widths: OnceCell<Option<Arc<[Widths]>>>,
}

impl ShapeTable {
    fn entry_of(&self, shape: &SharedShape) -> Option<&Entry> {
        self.shapes.get(*self.numbers.get(&address(shape))? as usize)
    }
}

/// A table is open as long as this lives.
pub(super) struct OpenTable {
    /// The table that was open before.
    outer: Option<ShapeTable>,
}

impl OpenTable {
    pub fn new() -> Self {
        Self { outer: TABLE.replace(Some(ShapeTable::default())) }
    }
}

impl Drop for OpenTable {
    fn drop(&mut self) {
        TABLE.set(self.outer.take());
    }
}

/// The number of a shape that is in the table.
pub(super) fn number_of(shape: &SharedShape) -> Option<u32> {
    TABLE.with_borrow(|table| table.as_ref()?.numbers.get(&address(shape)).copied())
}

/// The shape with a number.
pub(super) fn shape_at(number: u32) -> Option<SharedShape> {
    TABLE.with_borrow(|table| Some(table.as_ref()?.shapes.get(number as usize)?.shape.clone()))
}

/// Enters a shape that is not in the table, if a table is open and the shape takes more bytes than a number.
pub(super) fn enter(shape: &SharedShape) {
    TABLE.with_borrow_mut(|table| {
        if let Some(table) = table.as_mut().filter(|_| is_large(shape)) {
            table.numbers.insert(address(shape), table.shapes.len() as u32);
            table.shapes.push(Entry { shape: shape.clone(), widths: OnceCell::new() });
        }
    });
}

/// The [costly](Widths::of_costly) widths of a shape, computed once for a shape in the table.
pub(super) fn widths_of(shape: &SharedShape) -> Option<Arc<[Widths]>> {
    let compute = || Widths::of_costly(&**shape);
    TABLE.with_borrow(|table| {
        let entry = table.as_ref().and_then(|table| table.entry_of(shape));
        entry.map_or_else(compute, |entry| entry.widths.get_or_init(compute).clone())
    })
}

fn address(shape: &SharedShape) -> usize {
    Arc::as_ptr(&shape.0).addr()
}

/// Returns whether a shape takes more bytes than a number: a hull, or a shape of many parts.
fn is_large(shape: &SharedShape) -> bool {
    let typed = shape.as_typed_shape();
    match typed {
        TypedShape::TriMesh(_)
        | TypedShape::Polyline(_)
        | TypedShape::HeightField(_)
        | TypedShape::Voxels(_)
        | TypedShape::Compound(_) => true,
        _ => width::corners(typed).is_some(),
    }
}
