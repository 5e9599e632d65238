//! Every constructor that is common to all dimensions, with valid and invalid input.

use super::{NOT_COORDINATES, NOT_LENGTHS};
use crate::base::random::Random;
use crate::dim::math::{DIM, Int, Pose, Real, Vector, rotation_from_angle, torque};
use crate::model::collider::{ColliderBuilder, InvalidCollider, MeshConverter};
use parry::math::IVector;
use parry::shape::{PolylineFlags, SharedShape, TriMeshFlags};
use parry::transformation::vhacd::VHACDParameters;
use parry::transformation::voxelization::FillMode;

const O: Vector = Vector::ZERO;
const X: Vector = Vector::X;
const Y: Vector = Vector::Y;

fn cuboid() -> SharedShape {
    SharedShape::new(parry::shape::Cuboid::new(Vector::ONE))
}

/// A closed surface around the unit box: its outline in 2D, its triangles in 3D. As the elements that
/// voxelisation and decomposition take.
fn unit_box_surface() -> (Vec<Vector>, Vec<[u32; DIM]>) {
    let (vertices, indices) = crate::dim::shapes::tests::unit_box_surface();
    (vertices, indices)
}

#[track_caller]
fn assert_builds(builder: &ColliderBuilder) {
    let collider = builder.try_build().expect("nothing is wrong with it");
    let aabb = collider.compute_aabb();
    assert!(aabb.mins.cmple(aabb.maxs).all(), "{aabb:?}");
    assert!(collider.mass().is_finite() && collider.mass() >= 0.0);
    assert!(builder.build().is_enabled());
}

#[track_caller]
fn assert_impossible(builder: &ColliderBuilder, word: &str) {
    let reason = builder.try_build().map(|_| ()).expect_err("nothing was refused");
    assert!(reason.to_string().contains(word), "{reason:?} lacks `{word}`");
    assert!(!builder.build().is_enabled());
}

#[test]
fn good_input_builds() {
    let (vertices, surface) = unit_box_surface();
    let triangle = (vec![O, X, Y], vec![[0, 1, 2]]);
    let mesh = ColliderBuilder::trimesh(triangle.0.clone(), triangle.1.clone()).expect("a mesh");
    let hull = ColliderBuilder::convex_hull(&vertices).expect("a hull");
    let round_hull = ColliderBuilder::round_convex_hull(&vertices, 0.1).expect("a hull");
    let cells = [IVector::ZERO, IVector::ONE];
    let all = [
        ColliderBuilder::ball(0.5),
        ColliderBuilder::halfspace(Y),
        ColliderBuilder::capsule_x(1.0, 0.5),
        ColliderBuilder::capsule_y(0.0, 0.5),
        ColliderBuilder::capsule_from_endpoints(X, Y, 0.1),
        ColliderBuilder::segment(X, Y),
        ColliderBuilder::triangle(O, X, Y),
        ColliderBuilder::round_triangle(O, X, Y, 0.1),
        ColliderBuilder::compound(vec![(Pose::IDENTITY, cuboid())]),
        ColliderBuilder::polyline(vec![O, X, Y], None),
        ColliderBuilder::polyline(vec![O, X, Y], Some(vec![[2, 0]])),
        ColliderBuilder::polyline_with_flags(vec![O, X], None, PolylineFlags::DEFORMABLE),
        mesh,
        hull,
        round_hull,
        ColliderBuilder::voxels(Vector::ONE, &cells),
        ColliderBuilder::voxels_from_points(Vector::ONE, &[O, X * 5.0]),
        ColliderBuilder::voxelized_mesh(&vertices, &surface, 0.1, FillMode::SurfaceOnly),
        ColliderBuilder::convex_decomposition(&vertices, &surface),
        ColliderBuilder::round_convex_decomposition(&vertices, &surface, 0.1),
    ];
    for (number, builder) in all.iter().enumerate() {
        println!("constructor {number}: {:?}", builder.shape.shape_type());
        assert_builds(builder);
    }
}

#[test]
fn bad_lengths_are_refused() {
    for bad in NOT_LENGTHS {
        let all = [
            ColliderBuilder::ball(bad),
            ColliderBuilder::capsule_x(1.0, bad),
            ColliderBuilder::capsule_y(1.0, bad),
            ColliderBuilder::capsule_from_endpoints(X, Y, bad),
        ];
        for builder in all.iter().filter(|_| bad != 0.0) {
            assert_impossible(builder, "radius");
        }
        assert_impossible(&ColliderBuilder::halfspace(Y * bad * 2.0), "outward_normal");
        let cells = [IVector::ZERO];
        assert_impossible(&ColliderBuilder::voxels(Vector::ONE * bad, &cells), "voxel_size");
        assert_impossible(
            &ColliderBuilder::voxels_from_points(Vector::ONE * bad, &[O]),
            "voxel_size",
        );
        let (vertices, surface) = unit_box_surface();
        let voxels = ColliderBuilder::voxelized_mesh(&vertices, &surface, bad, FillMode::default());
        assert_impossible(&voxels, "voxel_size");
        if bad != 0.0 {
            assert_impossible(&ColliderBuilder::capsule_x(bad, 1.0), "half_height");
            assert_impossible(&ColliderBuilder::round_triangle(O, X, Y, bad), "border_radius");
            assert!(ColliderBuilder::round_convex_hull(&vertices, bad).is_none());
            let parts = ColliderBuilder::round_convex_decomposition(&vertices, &surface, bad);
            assert_impossible(&parts, "border_radius");
        }
    }
}

#[test]
fn bad_coordinates_are_refused() {
    for bad in NOT_COORDINATES {
        let far = X * bad + Y;
        let indices = vec![[0, 1, 2]];
        let surface = [core::array::from_fn(|i| i as u32)];
        let all = [
            (ColliderBuilder::capsule_from_endpoints(far, O, 1.0), "a number"),
            (ColliderBuilder::segment(O, far), "b number"),
            (ColliderBuilder::triangle(O, X, far), "c number"),
            (ColliderBuilder::polyline(vec![O, far], None), "vertices number 1"),
            (ColliderBuilder::voxels_from_points(Vector::ONE, &[far]), "points number 0"),
            (
                ColliderBuilder::voxelized_mesh(&[O, X, far], &surface, 1.0, FillMode::default()),
                "vertices number 2",
            ),
            (ColliderBuilder::convex_decomposition(&[O, X, far], &surface), "vertices number 2"),
        ];
        for (builder, word) in &all {
            assert_impossible(builder, word);
        }
        let part = vec![(Pose::from_translation(far), cuboid())];
        assert_impossible(&ColliderBuilder::compound(part), "part 0 of the compound: the pose");
        assert!(ColliderBuilder::trimesh(vec![O, X, far], indices).is_err());
        assert!(ColliderBuilder::convex_hull(&[O, X, Y, far]).is_none());
    }
}

#[test]
fn indices_out_of_range_are_refused() {
    let all = [
        ColliderBuilder::polyline(vec![O, X], Some(vec![[0, 2]])),
        ColliderBuilder::voxelized_mesh(&[O, X], &[[9; DIM]], 1.0, FillMode::default()),
        ColliderBuilder::convex_decomposition(&[O, X, Y], &[[3; DIM]]),
    ];
    for builder in &all {
        assert_impossible(builder, "has the index");
    }
    let reason = ColliderBuilder::trimesh(vec![O, X, Y], vec![[0, 1, 2], [0, 1, 3]])
        .map(|_| ())
        .expect_err("vertex 3 does not exist");
    let expected =
        InvalidCollider::IndexOutOfRange { parameter: "indices", position: 1, index: 3, count: 3 };
    assert_eq!(reason, expected);
}

#[test]
fn empty_and_degenerate_shapes_are_refused() {
    let nothing: [IVector; 0] = [];
    let all = [
        ColliderBuilder::compound(vec![]),
        ColliderBuilder::polyline(vec![], None),
        ColliderBuilder::polyline(vec![O], None),
        ColliderBuilder::polyline(vec![O, X], Some(vec![])),
        ColliderBuilder::voxels(Vector::ONE, &nothing),
        ColliderBuilder::voxels_from_points(Vector::ONE, &[]),
        ColliderBuilder::voxelized_mesh(&[], &[], 1.0, FillMode::default()),
        ColliderBuilder::convex_decomposition(&[], &[]),
        ColliderBuilder::convex_decomposition(&[X, X, X], &[core::array::from_fn(|i| i as u32)]),
    ];
    for builder in &all {
        assert!(builder.try_build().is_err(), "{:?}", builder.shape);
        assert!(!builder.build().is_enabled());
    }
    assert!(ColliderBuilder::trimesh(vec![], vec![]).is_err());
    assert!(ColliderBuilder::trimesh(vec![O, X, Y], vec![]).is_err());
    let flags = TriMeshFlags::DELETE_DEGENERATE_TRIANGLES | TriMeshFlags::MERGE_DUPLICATE_VERTICES;
    assert!(ColliderBuilder::trimesh_with_flags(vec![X, X, Y], vec![[0, 1, 2]], flags).is_err());
    for points in [&[][..], &[O], &[X, X, X, X, X]] {
        assert!(ColliderBuilder::convex_hull(points).is_none(), "{points:?}");
        assert!(ColliderBuilder::round_convex_hull(points, 0.1).is_none(), "{points:?}");
    }
}

#[test]
fn a_compound_of_compounds_is_refused() {
    let inner = ColliderBuilder::compound(vec![(Pose::IDENTITY, cuboid())]).shape;
    let part = (Pose::IDENTITY, cuboid());
    let outer = ColliderBuilder::compound(vec![part, (Pose::IDENTITY, inner)]);
    assert_impossible(&outer, "part 1");
    let broken = ColliderBuilder::compound(vec![(Pose::IDENTITY, SharedShape::ball(-1.0))]);
    assert_impossible(&broken, "radius");
}

#[test]
fn grids_that_do_not_fit_into_memory_are_refused() {
    let (vertices, surface) = unit_box_surface();
    let voxels = ColliderBuilder::voxelized_mesh(&vertices, &surface, 1.0e-6, FillMode::default());
    assert_impossible(&voxels, "cells");
    let cells = [IVector::ONE * Int::MAX];
    assert_impossible(&ColliderBuilder::voxels(Vector::ONE, &cells), "grid coordinates");
    let (far, small) = ([X * 1.0e14], Vector::splat(1.0e-3));
    assert_impossible(&ColliderBuilder::voxels_from_points(small, &far), "grid coordinates");
    let parameters = [
        VHACDParameters { resolution: u32::MAX, ..Default::default() },
        VHACDParameters { resolution: 0, ..Default::default() },
        VHACDParameters { plane_downsampling: 0, ..Default::default() },
        VHACDParameters { convex_hull_downsampling: 0, ..Default::default() },
        VHACDParameters { max_convex_hulls: u32::MAX, ..Default::default() },
        VHACDParameters { concavity: Real::NAN, ..Default::default() },
    ];
    for params in &parameters {
        let builder =
            ColliderBuilder::convex_decomposition_with_params(&vertices, &surface, params);
        assert!(builder.try_build().is_err(), "{params:?}");
    }
}

#[test]
fn a_mesh_is_converted_in_every_way() {
    let (vertices, indices) = crate::dim::shapes::tests::unit_box_mesh();
    let converters = [
        MeshConverter::TriMesh,
        MeshConverter::TriMeshWithFlags(TriMeshFlags::MERGE_DUPLICATE_VERTICES),
        MeshConverter::Obb,
        MeshConverter::Aabb,
        MeshConverter::ConvexHull,
        MeshConverter::ConvexDecomposition,
    ];
    for converter in converters {
        let convert = |offset: Vector| {
            let vertices = vertices.iter().map(|v| *v + offset).collect();
            ColliderBuilder::converted_trimesh(vertices, indices.clone(), converter)
        };
        let collider = convert(X * 10.0).expect("a good mesh").build();
        let aabb = collider.compute_aabb();
        assert!(aabb.center().abs_diff_eq(X * 10.0, 0.1), "{converter:?}: {aabb:?}");
        assert!(aabb.half_extents().abs_diff_eq(Vector::ONE, 0.8), "{converter:?}: {aabb:?}");
        assert!(convert(X * Real::NAN).is_err());
        let empty = ColliderBuilder::converted_trimesh(vec![], vec![], converter);
        assert!(empty.is_err(), "{converter:?}");
    }
}

#[test]
fn a_turned_box_fits_a_turned_mesh() {
    let (vertices, indices) = crate::dim::shapes::tests::unit_box_mesh();
    for angle in [0.0, 0.3, 1.0, 2.0, -0.7] {
        let turn = Pose::from_parts(X * 5.0, rotation_from_angle(torque(X, Y) * angle));
        let stretch = Vector::ONE + X * 2.0;
        let vertices = vertices.iter().map(|v| turn * (*v * stretch)).collect();
        let builder =
            ColliderBuilder::converted_trimesh(vertices, indices.clone(), MeshConverter::Obb);
        let collider = builder.expect("a good mesh").build();
        let half_extents = collider.shape().as_cuboid().expect("a box").half_extents;
        assert!((half_extents.max_element() - 3.0).abs() < 1.0e-4, "{angle}: {half_extents}");
        assert!((half_extents.min_element() - 1.0).abs() < 1.0e-4, "{angle}: {half_extents}");
        let aabb = collider.compute_aabb();
        assert!(aabb.center().abs_diff_eq(X * 5.0, 1.0e-4), "{angle}: {aabb:?}");
        let tip = turn * (X * 3.0 + Y);
        assert!(collider.shape().distance_to_point(collider.position(), tip, true) < 1.0e-3);
    }
}

#[test]
fn no_soup_of_elements_makes_a_constructor_panic() {
    let mut random = Random(5);
    let params = VHACDParameters { resolution: 8, max_convex_hulls: 8, ..Default::default() };
    for round in 0..150 {
        let count = 1 + random.below(9);
        let coarse = |v: Real| if round % 2 == 0 { v.round() } else { v };
        let mut coordinate = || coarse(random.within(-2.0, 2.0));
        let vertices: Vec<Vector> = (0..count)
            .map(|_| Vector::from_array(core::array::from_fn(|_| coordinate())))
            .collect();
        let mut index = || random.below(count) as u32;
        let triangles: Vec<[u32; 3]> = (0..12).map(|_| core::array::from_fn(|_| index())).collect();
        let surface: Vec<[u32; DIM]> = (0..12).map(|_| core::array::from_fn(|_| index())).collect();
        for flag in TriMeshFlags::all().iter().chain([TriMeshFlags::all()]) {
            let mesh =
                ColliderBuilder::trimesh_with_flags(vertices.clone(), triangles.clone(), flag);
            assert!(mesh.is_err() || mesh.is_ok_and(|mesh| mesh.try_build().is_ok()));
        }
        let fill = FillMode::default();
        let all = [
            ColliderBuilder::voxelized_mesh(&vertices, &surface, 0.5, fill),
            ColliderBuilder::convex_decomposition_with_params(&vertices, &surface, &params),
        ];
        for builder in all {
            let collider = builder.build();
            let properties = collider.mass_properties();
            assert!(crate::dim::mass::mass_is_valid(&properties), "{properties:?}");
            assert!(collider.compute_aabb().half_extents().is_finite());
        }
    }
}
