//! Coplanar patches: bodies on them have the contacts of a plane.

use super::{ManifoldScratch, ShapePair, compute_manifolds};
use crate::base::random::Random;
use crate::base::wide::Simd;
use crate::dim::collide::samples;
use crate::dim::math::{DIM, Pose, Real, Rotation, Vector};
use crate::model::contact::{Contact, ContactManifold, TriangleCache};
use parry::shape::{Shape, SharedShape};
use smallvec::SmallVec;

const PREDICTION: Real = 0.02;

type Manifolds = SmallVec<[ContactManifold; 1]>;

/// The manifolds of a ground and a body at a pose.
fn contacts(
    ground: &SharedShape,
    body: &SharedShape,
    pose: &Pose,
    previous: &[ContactManifold],
    kept: Option<&mut Option<Box<TriangleCache>>>,
    motion: Vector,
) -> Manifolds {
    let pair = ShapePair {
        pos12: *pose,
        shapes: [&**ground, &**body],
        motion,
        prediction: PREDICTION,
        step_height_tolerance: 1.0e-3,
        neighbors: [&[], &[]],
        simd: Simd::detect(),
    };
    let mut found = Manifolds::new();
    compute_manifolds(&pair, previous, kept, &mut ManifoldScratch::default(), &mut found);
    found
}

/// The contacts of a body with a history at the same place.
fn resting(ground: &SharedShape, body: &SharedShape, pose: &Pose) -> Manifolds {
    let first = contacts(ground, body, pose, &[], None, Vector::ZERO);
    contacts(ground, body, pose, &first, None, Vector::ZERO)
}

fn level(_: Vector) -> Real {
    0.0
}

fn rough(at: Vector) -> Real {
    0.05 * (7.0 * at.x).sin() - 0.2 * (at.x - 1.5).max(0.0)
}

fn terrace(at: Vector) -> Real {
    if at.x > 0.5 { 0.1 } else { 0.0 }
}

fn everywhere(_: Vector) -> bool {
    true
}

/// A pose at which the lowest point of a body is at a height.
fn standing(body: &dyn Shape, at: Vector, rotation: Rotation, height: Real) -> Pose {
    let down = rotation.inverse() * -Vector::Y;
    let support = body.as_support_map().expect("is convex").local_support_point(down);
    Pose::from_parts(at + Vector::Y * (height + down.dot(support)), rotation)
}

fn deepest(manifolds: &[ContactManifold]) -> Real {
    let points = manifolds.iter().flat_map(ContactManifold::contacts);
    points.map(|contact| contact.dist).fold(Real::INFINITY, Real::min)
}

/// Returns whether `manifolds` contain a contact at the same place on the body.
fn has(manifolds: &[ContactManifold], other: &Contact) -> bool {
    let mut points = manifolds.iter().flat_map(ContactManifold::contacts);
    points.any(|contact| contact.local_p2.distance(other.local_p2) < 1.0e-3)
}

/// A body on pieces of a plane has the depth and the normal of a body on a plane.
#[test]
fn bodies_stand_on_pieces_as_on_a_plane() {
    let mut random = Random(11);
    let ground = samples::carpet(40, 0.2, level, everywhere);
    for round in 0..600 {
        let body = samples::shape(round % samples::CONVEX_KINDS, &mut random, 0.7);
        let at = Vector::X * random.within(-1.0, 1.0);
        // A body that is deep at its first contact may leave a small piece by its side.
        let height = random.within(0.0, 0.01);
        let pose = standing(&*body, at, samples::rotation(&mut random), height);
        let found = resting(&ground, &body, &pose);
        let what = format!("{:?} at {pose:?}", body.as_typed_shape());
        let dist = deepest(&found);
        assert!((dist - height).abs() < 2.0e-3, "{dist}, not {height}: {what}");
        for manifold in &found {
            assert!(manifold.local_n1.distance(Vector::Y) < 2.0e-3, "{what}: {found:?}");
        }
    }
}

/// A box that lies on pieces touches them with its corners alone, whatever is between these.
#[test]
fn boxes_lie_on_pieces_with_their_corners() {
    let mut random = Random(12);
    let plane = samples::cuboid(Vector::splat(10.0));
    let body = samples::cuboid(Vector::splat(0.5));
    let pair = samples::cuboid(Vector::splat(0.3));
    let apart = Pose::from_translation(0.5 * Vector::X);
    let pair = SharedShape::compound(vec![(apart, pair.clone()), (apart.inverse(), pair)]);
    let with_hole = |at: Vector| at.abs().max_element() > 0.06;
    for (body, half) in [(&body, 0.5), (&pair, 0.3)] {
        for keep in [everywhere, with_hole as fn(Vector) -> bool] {
            let ground = samples::carpet(40, 0.1, level, keep);
            for _ in 0..100 {
                // No corner over the hole.
                let at = Vector::X * random.within(-0.09, 0.09) + Vector::Y * (half - 0.002);
                let tilt = samples::planar_rotation(random.within(-1.0e-3, 1.0e-3));
                let pose = Pose::from_parts(at, tilt * samples::about_y(random.within(-0.1, 0.1)));
                let found = resting(&ground, body, &pose);
                let above = Pose::from_translation(Vector::Y * -10.0);
                let on_plane =
                    contacts(&plane, body, &(above.inverse() * pose), &[], None, Vector::ZERO);
                assert_eq!(found.len(), 1);
                let points = found[0].contacts();
                assert_eq!(points.len(), if DIM == 2 { 2 } else { 4 }, "{found:?}");
                let on_plane = on_plane.iter().flat_map(ContactManifold::contacts);
                assert!(
                    on_plane.filter(|point| has(&found, point)).count() >= points.len(),
                    "{found:?}"
                );
            }
        }
    }
}

/// No contact lies beyond the edge of a patch, or over a hole.
#[test]
fn no_contact_is_where_no_piece_is() {
    let mut random = Random(13);
    let body = samples::cuboid(Vector::splat(0.5));
    let is_there = |at: Vector| at.x < 0.2 || at.x > 0.9;
    let ground = samples::carpet(40, 0.1, level, is_there);
    for _ in 0..300 {
        let at = Vector::X * random.within(-1.0, 2.0) + Vector::Y * 0.498;
        let pose = Pose::from_parts(at, samples::about_y(random.within(-1.0, 1.0)));
        let found = resting(&ground, &body, &pose);
        for contact in found.iter().flat_map(ContactManifold::contacts) {
            let x = contact.local_p1.x;
            assert!(!(0.2011..=0.8989).contains(&x), "{x} in {found:?}");
        }
        assert!(found.iter().all(|manifold| manifold.local_n1.y > 0.999), "{found:?}");
    }
}

/// A body that has left a patch over a long edge is not supported, although its fraction of the length is
/// more than the body.
#[test]
fn nothing_stands_beyond_a_long_edge() {
    let half = 0.05;
    let (ground, rotation, out) = samples::long_edge(1000.0);
    let body = samples::cuboid(Vector::splat(half));
    let up = rotation * Vector::Y * (half - 1.0e-3);
    let mut found = Manifolds::new();
    for step in 0..40 {
        let beyond = 0.005 * step as Real - 0.1;
        let pose = Pose::from_parts(out * beyond + up, rotation);
        found = contacts(&ground, &body, &pose, &found, None, Vector::ZERO);
        // The diagonal of the box, the prediction distance, and rounding.
        if beyond > 1.5 * half + PREDICTION + 1.0e-3 {
            assert!(found.is_empty(), "{beyond}: {found:?}");
        } else if beyond < -1.5 * half {
            assert!(!found.is_empty(), "{beyond}");
        }
    }
}

/// The triangle cache changes no bit, on rough ground or on level ground.
#[test]
fn the_triangle_cache_changes_nothing() {
    let mut random = Random(14);
    for height in [level, rough, terrace] {
        let ground = samples::carpet(60, 0.1, height, everywhere);
        for kind in 0..samples::CONVEX_KINDS {
            let body = samples::shape(kind, &mut random, 0.5);
            let mut pose = standing(&*body, -Vector::X, Rotation::IDENTITY, 0.05);
            let (mut kept, mut with, mut without) = (None, Manifolds::new(), Manifolds::new());
            for _ in 0..80 {
                let motion = Vector::X * random.within(0.0, 0.1) - Vector::Y * 0.01;
                let turn = samples::planar_rotation(random.within(-0.02, 0.02));
                pose.translation += motion;
                pose.rotation = turn * pose.rotation;
                with = contacts(&ground, &body, &pose, &with, Some(&mut kept), motion);
                without = contacts(&ground, &body, &pose, &without, None, Vector::ZERO);
                assert_eq!(bits(&with), bits(&without));
            }
        }
    }
}

/// All numbers of the manifolds, to the last bit.
fn bits(manifolds: &[ContactManifold]) -> Vec<u64> {
    let vector = |vector: Vector| vector.to_array().map(|x| f64::from(x).to_bits());
    let mut all = Vec::new();
    for manifold in manifolds {
        all.extend([manifold.subshape1, manifold.subshape2].map(u64::from));
        all.extend(vector(manifold.local_n1));
        for contact in manifold.contacts() {
            all.extend(vector(contact.local_p1).into_iter().chain(vector(contact.local_p2)));
            all.push(f64::from(contact.dist).to_bits());
        }
    }
    all
}
