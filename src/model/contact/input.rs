//! The solver's input of contact manifolds, lane by lane.

use super::anchor_frame::WideAnchorFrame;
use crate::base::wide::{LANES, Lane};
use crate::dim::math::{DIM, MAX_MANIFOLD_POINTS, Real, Vector};
use crate::dim::state::READ_ONLY;
use crate::dim::wide::WideVector;

/// The solver's input of a block's manifolds.
#[derive(Clone, Debug)]
pub(crate) struct ContactInput {
    /// Solver indices of the two bodies, with [`READ_ONLY`] where it applies.
    pub bodies: [[u32; LANES]; 2],
    /// One where the body is the world (a fixed body or none): it has no centre of mass.
    pub is_world: [Lane; 2],
    /// Factors on the inverse masses of the two bodies: zero where the other one is dominant.
    pub mass_factors: [Lane; 2],
    /// World orientation of the bodies when the anchors were transformed.
    pub anchor_frame: WideAnchorFrame,
    /// From the first centre of mass to the points when the anchors were transformed, in world space.
    pub arms: [WideVector<Lane>; MAX_MANIFOLD_POINTS],
    /// Separations of the points when the anchors were transformed.
    pub anchor_separations: [Lane; MAX_MANIFOLD_POINTS],
    /// One for points that are there, zero for the others.
    pub present: [Lane; MAX_MANIFOLD_POINTS],
    /// Normal impulses with which to start.
    pub impulses: [Lane; MAX_MANIFOLD_POINTS],
    pub friction: Lane,
    pub restitution: Lane,
    /// Velocity of the second surface relative to the first, in world space.
    pub tangent_velocity: WideVector<Lane>,
    /// Friction impulse with which to start, in world space.
    pub friction_impulse: WideVector<Lane>,
    /// Torsional impulse about the normal with which to start: none in the plane.
    pub torsional_impulse: Lane,
    /// Friction impulses of the points with which to start, along the tangents: for friction per point.
    pub tangent_impulses: [[Lane; DIM - 1]; MAX_MANIFOLD_POINTS],
}

impl ContactInput {
    /// No manifold in any lane. An empty lane connects the world with itself, and has no effect.
    pub const EMPTY: Self = {
        let vector = WideVector::ZERO;
        Self {
            bodies: [[READ_ONLY; LANES]; 2],
            is_world: [Lane::splat(1.0); 2],
            mass_factors: [Lane::ZERO; 2],
            anchor_frame: WideAnchorFrame::NOWHERE,
            arms: [vector; MAX_MANIFOLD_POINTS],
            anchor_separations: [Lane::ZERO; MAX_MANIFOLD_POINTS],
            present: [Lane::ZERO; MAX_MANIFOLD_POINTS],
            impulses: [Lane::ZERO; MAX_MANIFOLD_POINTS],
            friction: Lane::ZERO,
            restitution: Lane::ZERO,
            tangent_velocity: vector,
            friction_impulse: vector,
            torsional_impulse: Lane::ZERO,
            tangent_impulses: [[Lane::ZERO; DIM - 1]; MAX_MANIFOLD_POINTS],
        }
    };

    /// Sets the friction impulse of a point with which one lane starts.
    pub fn set_tangent_impulse(&mut self, point: usize, lane: usize, impulse: [Real; DIM - 1]) {
        for (lanes, impulse) in self.tangent_impulses[point].iter_mut().zip(impulse) {
            lanes.0[lane] = impulse;
        }
    }

    /// The friction impulse of a point with which one lane starts.
    pub fn tangent_impulse(&self, point: usize, lane: usize) -> [Real; DIM - 1] {
        self.tangent_impulses[point].map(|lanes| lanes.0[lane])
    }

    /// A point that one lane does not have.
    pub fn leave_out(&mut self, point: usize, lane: usize) {
        self.arms[point].set_lane(lane, Vector::ZERO);
        self.anchor_separations[point].0[lane] = 0.0;
        self.present[point].0[lane] = 0.0;
        self.impulses[point].0[lane] = 0.0;
        self.set_tangent_impulse(point, lane, [0.0; _]);
    }

    /// Removes the manifold of one lane. The empty lane connects the world with itself, and has no effect.
    pub fn clear(&mut self, lane: usize) {
        for side in 0..2 {
            self.bodies[side][lane] = READ_ONLY;
            self.is_world[side].0[lane] = 1.0;
            self.mass_factors[side].0[lane] = 0.0;
        }
        self.anchor_frame.clear(lane);
        (self.friction.0[lane], self.restitution.0[lane]) = (0.0, 0.0);
        self.tangent_velocity.set_lane(lane, Vector::ZERO);
        self.friction_impulse.set_lane(lane, Vector::ZERO);
        self.torsional_impulse.0[lane] = 0.0;
        (0..MAX_MANIFOLD_POINTS).for_each(|point| self.leave_out(point, lane));
    }

    /// Multiplies the impulses with which one lane starts, and those of the points along the tangents if they
    /// act.
    pub fn scale_impulses(&mut self, lane: usize, factor: Real, per_point: bool) {
        self.friction_impulse.set_lane(lane, self.friction_impulse.lane(lane) * factor);
        let tangents = self.tangent_impulses.iter_mut().flatten().filter(|_| per_point);
        let all = self.impulses.iter_mut().chain(tangents).chain([&mut self.torsional_impulse]);
        all.for_each(|impulse| impulse.0[lane] *= factor);
    }
}
