//! The rows of joints in double precision, and the coupling of the rows of two joints.

use super::dense::{Block, Column, PIVOT_MIN, add};
use super::joint::DirectJoint;
use super::memory::Jacobians;
use crate::dim::math::{DIM, SPATIAL_DIM};
use core::ops::Range;

/// The velocity of a body.
pub(super) type Motion = [f64; SPATIAL_DIM];

/// Up to `N` rows of one joint, for both of its bodies.
#[derive(Copy, Clone)]
pub(super) struct JointRows<const N: usize> {
    /// By body: `J`, a column for each component of a velocity.
    jacobians: [[[f64; N]; SPATIAL_DIM]; 2],
    /// By body: `M⁻¹ Jᵀ`, a velocity for each row.
    responses: [[Motion; N]; 2],
}

impl<const N: usize> JointRows<N> {
    pub const EMPTY: Self =
        Self { jacobians: [[[0.0; N]; SPATIAL_DIM]; 2], responses: [[[0.0; SPATIAL_DIM]; N]; 2] };

    /// Reads the rows of a joint into an empty place.
    #[inline(always)]
    pub fn read(&mut self, member: &DirectJoint, memory: &Jacobians) {
        let (from, lane) = (&memory.blocks[member.block as usize], member.lane as usize);
        for (side, _) in member.movable() {
            let masses = from.inverse_mass(side, lane);
            let locked = locked_axes::<N>(member).map(|axis| &from.rows[axis]);
            let driven = memory.driven_of(member).iter().map(|driven| &driven.row);
            for (row, numbers) in locked.chain(driven).enumerate() {
                let jacobian = numbers[side].map(|number| f64::from(number.0[lane]));
                for (column, number) in self.jacobians[side].iter_mut().zip(jacobian) {
                    column[row] = number;
                }
                self.responses[side][row] = masses.response(&jacobian);
            }
        }
    }

    /// The largest number of a row.
    pub fn size_of(&self, row: usize) -> f64 {
        let mut most: f64 = 0.0;
        for column in self.jacobians.iter().flatten() {
            let size = column[row].abs();
            // `f64::max` is a function of several branches in WebAssembly.
            most = if size > most { size } else { most };
        }
        most
    }

    /// The velocity that impulses along the rows give a body.
    #[inline(always)]
    pub fn push(&self, side: usize, impulses: &[f64; N]) -> Motion {
        let mut change = [0.0; SPATIAL_DIM];
        for (response, impulse) in self.responses[side].iter().zip(impulses) {
            add(&mut change, response, *impulse);
        }
        change
    }

    /// The part of a row's rate that the velocity of a body gives.
    pub fn rate(&self, side: usize, row: usize, velocity: &Motion) -> f64 {
        let columns = self.jacobians[side].iter().zip(velocity);
        columns.map(|(column, velocity)| column[row] * velocity).sum()
    }

    /// Diagonal element of a translation row without its moment arms; of a rotation row, the whole element.
    pub fn without_arms(&self, row: usize) -> f64 {
        let linear = self.fraction(row, 0..DIM);
        if linear > 0.0 { linear } else { self.fraction(row, DIM..SPATIAL_DIM) }
    }

    /// The part of a row's diagonal element that these components of the velocities give.
    fn fraction(&self, row: usize, components: Range<usize>) -> f64 {
        let products = self.jacobians.iter().zip(&self.responses).flat_map(|(j, response)| {
            components.clone().map(move |k| j[k][row] * response[row][k])
        });
        products.sum()
    }

    /// The smallest pivots that are not rounding, for these diagonal elements: see [`PIVOT_MIN`].
    pub fn pivots_min(&self, own: &[f64; N]) -> [f64; N] {
        let translates = |row: usize| {
            self.jacobians
                .iter()
                .any(|columns| columns[..DIM].iter().any(|column| column[row] != 0.0))
        };
        let mut largest = [0.0_f64; 2];
        for (row, &own) in own.iter().enumerate() {
            let largest = &mut largest[usize::from(translates(row))];
            *largest = largest.max(own);
        }
        core::array::from_fn(|row| PIVOT_MIN * largest[usize::from(translates(row))])
    }
}

/// Adds `J_row M⁻¹ J_columnᵀ` of two joints over their common bodies.
#[inline(always)]
pub(super) fn couple<const N: usize>(
    members: &[DirectJoint],
    rows: &[JointRows<N>],
    [row, column]: [usize; 2],
    block: &mut Block<N>,
    columns: usize,
) {
    for (side, body) in members[row].movable() {
        for (other_side, _) in members[column].movable().filter(|(_, other)| *other == body) {
            let jacobian = &rows[row].jacobians[side];
            let responses = &rows[column].responses[other_side];
            for (target, response) in block[..columns].iter_mut().zip(responses) {
                for (component, factor) in jacobian.iter().zip(response) {
                    add(target, component, *factor);
                }
            }
        }
    }
}

/// Compliance of the rows of a joint.
#[inline(always)]
pub(super) fn compliance_of(member: &DirectJoint, memory: &Jacobians) -> f64 {
    f64::from(memory.blocks[member.block as usize].compliance.0[member.lane as usize])
}

/// The impulses of a joint's locked axes.
#[inline(always)]
pub(super) fn impulses_of<const N: usize>(member: &DirectJoint, memory: &Jacobians) -> Column<N> {
    let (from, lane) = (&memory.blocks[member.block as usize], member.lane as usize);
    let mut impulses = [0.0; N];
    for (impulse, axis) in impulses.iter_mut().zip(locked_axes::<N>(member)) {
        *impulse = f64::from(from.impulses[axis].0[lane]);
    }
    impulses
}

/// The locked axes of a joint that locks none but the first `N`.
#[inline(always)]
pub(super) fn locked_axes<const N: usize>(
    member: &DirectJoint,
) -> impl Iterator<Item = usize> + use<N> {
    let locked = member.form.locked;
    (0..N).filter(move |axis| locked >> axis & 1 == 1)
}
