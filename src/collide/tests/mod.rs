//! Tests of contact generation.

mod boxes;
mod capsules;
mod coplanar;
mod fuzz;
mod hulls;
mod lines;
mod matching;
mod polytopes;
mod small;
mod timing;

use super::manifolds::{ManifoldScratch, compute_manifolds};
use super::matching::inherit_impulses;
use super::pair::ShapePair;
use super::queries::shapes_intersect;
use crate::base::random::Random;
use crate::dim::collide::samples;
use crate::dim::math::{Pose, Real, Vector};
use crate::model::contact::ContactManifold;
use parry::shape::{Shape, SharedShape};
use smallvec::SmallVec;

/// Two shapes whose manifolds persist from step to step.
struct Scene {
    shapes: [SharedShape; 2],
    found: SmallVec<[ContactManifold; 1]>,
}

impl Scene {
    fn new(shape1: SharedShape, shape2: SharedShape) -> Self {
        Self { shapes: [shape1, shape2], found: SmallVec::new() }
    }

    /// A step in which the second shape comes to `pos12` in the frame of the first.
    fn place(&mut self, pos12: Pose) {
        let (old, scratch) = (core::mem::take(&mut self.found), &mut ManifoldScratch::default());
        let [shape1, shape2] = &self.shapes;
        let pair = ShapePair::alone(&pos12, [&**shape1, &**shape2], 0.02);
        compute_manifolds(&pair, &old, None, scratch, &mut self.found);
        inherit_impulses(&mut self.found, &old);
    }
}

/// The manifolds of two shapes and the bound of their distance, with no history.
fn manifolds(
    pos12: &Pose,
    shape1: &dyn Shape,
    shape2: &dyn Shape,
    prediction: Real,
) -> (SmallVec<[ContactManifold; 1]>, Real) {
    let mut found = SmallVec::new();
    let scratch = &mut ManifoldScratch::default();
    let pair = ShapePair::alone(pos12, [shape1, shape2], prediction);
    let bound = compute_manifolds(&pair, &[], None, scratch, &mut found);
    (found, bound)
}

/// A pose at which two shapes, coming together along a line through the centres, overlap by about
/// `depth`.
fn just_touching(shape1: &dyn Shape, shape2: &dyn Shape, depth: Real, random: &mut Random) -> Pose {
    let direction = samples::rotation(random) * Vector::X;
    let rotation = samples::rotation(random);
    let (mut low, mut high) = (0.0, 10.0);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        let pose = Pose::from_parts(direction * middle, rotation);
        if shapes_intersect(&pose, shape1, shape2) { low = middle } else { high = middle }
    }
    Pose::from_parts(direction * (low - depth), rotation)
}

/// Checks the invariants of every manifold: points within the prediction, unit normals, finite numbers.
fn assert_sound(found: &[ContactManifold], pos12: &Pose, prediction: Real, what: &str) {
    for manifold in found {
        let (n1, n2) = (manifold.local_n1, manifold.local_n2);
        assert!((n1.length() - 1.0).abs() < 1.0e-4, "{what}: normal {n1} is not a unit vector");
        assert!((pos12.rotation * n2 + n1).length() < 1.0e-3, "{what}: normals {n1}, {n2} differ");
        assert!(!manifold.contacts().is_empty(), "{what}: a manifold without points");
        for contact in manifold.contacts() {
            assert!(contact.local_p1.is_finite() && contact.local_p2.is_finite(), "{what}");
            assert!(contact.dist <= prediction, "{what}: distance {}", contact.dist);
        }
    }
}
