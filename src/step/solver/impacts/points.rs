//! Access of impacts to a block: velocities of its points, impulses at them, and their friction.
//!
//! `rows.rs` decides which points hit, and their target velocity.

use crate::base::disjoint::DisjointMut;
use crate::base::wide::{Lane, Wide};
use crate::dim::contact::{ContactBlock, CoulombBlock, Frame, NormalImpulse, NormalRow};
use crate::dim::math::MAX_MANIFOLD_POINTS;
use crate::dim::state::BodyState;
use crate::dim::wide::WideVector;
use crate::step::solver::contacts::{self, values_at};
use crate::step::solver::states::{Bodies, gather_velocities};

/// The normal rows of a block with the motion of its bodies.
pub struct NormalRows<'a, W> {
    block: &'a ContactBlock,
    bodies: Bodies<W>,
}

impl<'a, W: Wide> NormalRows<'a, W> {
    /// # Safety
    /// No other thread writes the states of the block's bodies.
    #[inline(always)]
    pub unsafe fn gather(states: &DisjointMut<BodyState>, block: &'a ContactBlock) -> Self {
        // SAFETY: the caller's promise.
        Self { block, bodies: unsafe { Bodies::gather(states, &block.bodies) } }
    }

    /// # Safety
    /// The caller has exclusive access to the states of the block's bodies.
    #[inline(always)]
    pub unsafe fn scatter(self, states: &DisjointMut<BodyState>) {
        // SAFETY: the caller's promise.
        unsafe { self.bodies.scatter(states, &self.block.bodies) };
    }

    /// The relative normal velocities at the points.
    #[inline(always)]
    pub fn velocities(&self) -> [W; MAX_MANIFOLD_POINTS] {
        let c = WideVector::load(&self.block.offset);
        let row = NormalRow::new(&Frame::load(self.block), c, self.bodies.velocities);
        values_at(self.block, row)
    }

    /// The separations of the points.
    #[inline(always)]
    pub fn separations(&self) -> [W; MAX_MANIFOLD_POINTS] {
        let c = WideVector::load(&self.block.offset);
        let row = NormalRow::new(&Frame::load(self.block), c, self.bodies.moved());
        let mut separations = values_at(self.block, row);
        for (separation, point) in separations.iter_mut().zip(&self.block.points) {
            *separation = *separation + W::load(&point.separation);
        }
        separations
    }

    /// Gauss–Seidel over the points of each lane. `solve` returns the additional impulse of a point from its
    /// velocity.
    #[inline(always)]
    pub fn iterate(&mut self, mut solve: impl FnMut(usize, W) -> W) {
        let mut velocities = self.velocities();
        let mut sum = NormalImpulse::zero();
        let mut coupling = 0;
        for k in 0..MAX_MANIFOLD_POINTS {
            let point = &self.block.points[k];
            let added = solve(k, velocities[k]);
            sum.add(added, point.place());
            for velocity in &mut velocities[k + 1..] {
                *velocity = *velocity + W::load(&self.block.coupling[coupling]) * added;
                coupling += 1;
            }
        }
        let frame = Frame::load(self.block);
        self.bodies.velocities = sum.apply(self.block, &frame, self.bodies.velocities);
    }
}

/// The relative normal velocities at the points of a block when its bodies moved like this.
#[inline(always)]
pub fn velocities_of<W: Wide>(
    states: &[BodyState],
    block: &ContactBlock,
) -> [W; MAX_MANIFOLD_POINTS] {
    let velocities = [
        gather_velocities::<W>(states, &block.bodies[0]),
        gather_velocities::<W>(states, &block.bodies[1]),
    ];
    let c = WideVector::load(&block.offset);
    values_at(block, NormalRow::new(&Frame::load(block), c, velocities))
}

/// Solves the friction rows once under these normal impulses alone. These impulses are no warm-start load,
/// and are not stored.
///
/// # Safety
/// The caller has exclusive access to the states of the block's bodies.
#[inline(always)]
pub unsafe fn solve_friction<W: Wide>(
    block: &mut ContactBlock,
    coulomb: Option<&mut CoulombBlock>,
    states: &DisjointMut<BodyState>,
    impulses: [Lane; MAX_MANIFOLD_POINTS],
) {
    let kept = (block.points.map(|point| point.impulse), block.friction.impulse);
    for (point, impulse) in block.points.iter_mut().zip(impulses) {
        point.impulse = impulse;
    }
    block.friction.impulse = Default::default();
    let mut fresh = coulomb.map(|rows| rows.clone());
    if let Some(rows) = &mut fresh {
        rows.scale_impulses(&Lane::ZERO);
    }
    // SAFETY: the caller's promise.
    let mut bodies = unsafe { Bodies::<W>::gather(states, &block.bodies) };
    bodies.velocities = contacts::solve_friction(block, fresh.as_mut(), bodies.velocities);
    // SAFETY: the caller's promise.
    unsafe { bodies.scatter(states, &block.bodies) };
    let (normal, friction) = kept;
    for (point, impulse) in block.points.iter_mut().zip(normal) {
        point.impulse = impulse;
    }
    block.friction.impulse = friction;
}
