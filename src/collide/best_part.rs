//! Best-first search among the parts of a shape.

use super::part::Part;
use super::parts::Parts;
use super::voxels::{all_voxels, box_of_voxels, may_have_voxels, with_voxel_at};
use crate::base::blocks;
use crate::dim::collide::{all_cells, box_of_cells, for_each_of_cell};
use crate::dim::math::Real;
use core::cell::RefCell;
use parry::bounding_volume::Aabb;

/// Called with a part and the current limit of the cost. Returns the new limit.
pub(super) type PartVisitor<'a> = dyn FnMut(Part<'_>, Real) -> Real + 'a;

impl Parts<'_> {
    /// Calls `visit` with the parts whose lower bound of the cost is below the limit, cheap ones first and
    /// always in the same order.
    ///
    /// `lower` returns a lower bound of the costs in a box; infinity if the box is irrelevant.
    pub(super) fn search(
        &self,
        mut limit: Real,
        lower: &dyn Fn(&Aabb) -> Real,
        visit: &mut PartVisitor<'_>,
    ) {
        match *self {
            Self::Convex(shape) => {
                visit(Part::whole(shape), limit);
            }
            Self::Tree(_, composite) => {
                let visit = RefCell::new(visit);
                let cost = |id: u32, limit: Real| {
                    let mut cost = None;
                    composite.map_part_at(id, &mut |pose, shape, constraints| {
                        let part = Part { id, pose, shape, constraints };
                        cost = Some((visit.borrow_mut())(part, limit));
                    });
                    cost
                };
                composite.bvh().find_best(limit, |node, _| lower(&node.aabb()), cost);
            }
            Self::Grid(_, field) => {
                let lower = |cells: &blocks::Block<_>| lower(&box_of_cells(field, cells));
                blocks::search(all_cells(field), &mut limit, &lower, &mut |cell, limit| {
                    let mut limit = limit;
                    for_each_of_cell(field, cell, &mut |id, shape| {
                        limit = visit(Part { id, ..Part::whole(shape) }, limit);
                    });
                    limit
                });
            }
            Self::Voxels(_, voxels) => {
                let lower = |cells: &blocks::Block<_>| {
                    let cost = lower(&box_of_voxels(voxels, cells));
                    let may_count = cost < Real::INFINITY && may_have_voxels(voxels, cells);
                    if may_count { cost } else { Real::INFINITY }
                };
                blocks::search(all_voxels(voxels), &mut limit, &lower, &mut |cell, limit| {
                    let mut limit = limit;
                    with_voxel_at(voxels, cell, &mut |part| limit = visit(part, limit));
                    limit
                });
            }
        }
    }
}
