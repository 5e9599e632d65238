//! Masses of shapes against formulas.

use crate::base::measure::SHAPE_MAX;
use crate::base::random::Random;
use crate::dim::math::{DIM, Pose, Real, Vector};
use crate::dim::shapes::tests::{unit_box_mesh, unit_box_surface};
use crate::model::collider::ColliderBuilder;
use parry::mass_properties::MassProperties;
use parry::math::IVector;
use parry::shape::{Cuboid, SharedShape};

fn cuboid_of(half_extents: Vector, density: Real) -> MassProperties {
    MassProperties::from_cuboid(density, half_extents)
}

/// Equal masses, centres, and angular inertias about any axis.
#[track_caller]
fn assert_same(found: &MassProperties, expected: &MassProperties) {
    let close = |a: Real, b: Real| (a - b).abs() <= 1.0e-3 * b.abs().max(1.0e-3);
    assert!(close(found.mass(), expected.mass()), "{} {}", found.mass(), expected.mass());
    assert!(found.local_com.abs_diff_eq(expected.local_com, 1.0e-3), "{found:?} {expected:?}");
    let (found, expected) = (inertia(found), inertia(expected));
    for (a, b) in found.iter().zip(&expected) {
        assert!((a - b).abs() <= 1.0e-3 * expected[0].abs(), "{found:?} {expected:?}");
    }
}

/// The components of the inertia tensor about the centre of mass.
fn inertia(properties: &MassProperties) -> Vec<Real> {
    crate::dim::shapes::tests::inertia_components(properties)
}

#[test]
fn the_same_box_weighs_the_same_however_it_is_described() {
    let expected = cuboid_of(Vector::ONE, 3.0);
    let (vertices, triangles) = unit_box_mesh();
    let corners: Vec<IVector> =
        (0..1_u32 << DIM)
            .map(|bits| {
                IVector::from_array(core::array::from_fn(|axis| {
                    if bits >> axis & 1 == 0 { -1 } else { 0 }
                }))
            })
            .collect();
    let half = SharedShape::new(Cuboid::new(Vector::ONE - Vector::X * 0.5));
    let halves = [0.5, -0.5].map(|x| (Pose::from_translation(Vector::X * x), half.clone()));
    let all = [
        ColliderBuilder::convex_hull(&vertices).expect("a box"),
        ColliderBuilder::trimesh(vertices.clone(), triangles).expect("a mesh"),
        ColliderBuilder::voxels(Vector::ONE, &corners),
        ColliderBuilder::compound(halves.to_vec()),
    ];
    for builder in all {
        println!("{:?}", builder.shape.shape_type());
        assert_same(&builder.density(3.0).build().mass_properties(), &expected);
    }
    let (_, surface) = unit_box_surface();
    let parts = ColliderBuilder::convex_decomposition(&vertices, &surface).density(3.0).build();
    assert!((parts.mass() / expected.mass() - 1.0).abs() < 0.05, "{}", parts.mass());
}

#[test]
fn far_from_the_origin_a_hull_weighs_the_same() {
    let offset = Vector::splat(100.0);
    let (vertices, _) = unit_box_mesh();
    let vertices: Vec<_> = vertices.iter().map(|v| *v + offset).collect();
    let hull = ColliderBuilder::convex_hull(&vertices).expect("a box").build();
    let expected = MassProperties { local_com: offset, ..cuboid_of(Vector::ONE, 1.0) };
    assert_same(&hull.mass_properties(), &expected);
}

#[test]
fn mass_and_density_imply_each_other() {
    let volume = ColliderBuilder::ball(0.7).build().volume();
    let by_mass = ColliderBuilder::ball(0.7).mass(5.0).build();
    assert!((by_mass.density() - 5.0 / volume).abs() < 1.0e-4);
    let by_density = ColliderBuilder::ball(0.7).density(5.0 / volume).build();
    assert_same(&by_mass.mass_properties(), &by_density.mass_properties());
    assert_eq!(ColliderBuilder::ball(0.7).density(0.0).build().mass(), 0.0);
    assert_eq!(ColliderBuilder::ball(0.7).mass(0.0).build().mass(), 0.0);
    let given = MassProperties { local_com: Vector::X, ..by_mass.mass_properties() };
    let by_properties = ColliderBuilder::ball(0.1).mass_properties(given).build();
    assert_eq!(by_properties.mass_properties(), given);
}

#[test]
fn shapes_without_volume_have_no_mass_from_a_density() {
    let shapes = [
        ColliderBuilder::segment(Vector::ZERO, Vector::X),
        ColliderBuilder::polyline(vec![Vector::ZERO, Vector::X], None),
        ColliderBuilder::halfspace(Vector::Y),
    ];
    for builder in shapes {
        let collider = builder.clone().density(7.0).build();
        assert_eq!((collider.mass(), collider.volume()), (0.0, 0.0));
        let heavy = builder.mass(7.0).build();
        assert!((heavy.mass_properties().mass() - 7.0).abs() < 1.0e-5);
    }
}

#[test]
fn huge_and_tiny_shapes_have_finite_mass_properties() {
    for radius in [1.0e-15, 1.0e-9, 1.0e9, SHAPE_MAX] {
        let collider = ColliderBuilder::ball(radius).try_build().expect("a usable radius");
        let properties = collider.mass_properties();
        assert!(crate::dim::mass::mass_is_valid(&properties), "{radius}: {properties:?}");
    }
}

#[test]
fn nothing_of_a_shape_is_farther_than_the_bounding_radius() {
    let mut random = Random(9);
    let mut some = || Vector::from_array(core::array::from_fn(|_| random.within(-3.0, 3.0)));
    let (vertices, triangles) = unit_box_mesh();
    let part = SharedShape::new(Cuboid::new(Vector::ONE));
    for _ in 0..50 {
        let (a, b, center) = (some(), some(), some());
        let shapes = [
            ColliderBuilder::ball(1.5),
            ColliderBuilder::capsule_from_endpoints(a, b, 0.5),
            ColliderBuilder::segment(a, b),
            ColliderBuilder::triangle(a, b, center + Vector::X),
            ColliderBuilder::polyline(vec![a, b, center], None),
            ColliderBuilder::trimesh(vertices.clone(), triangles.clone()).expect("a mesh"),
            ColliderBuilder::convex_hull(&vertices).expect("a hull"),
            ColliderBuilder::round_convex_hull(&vertices, 0.3).expect("a hull"),
            ColliderBuilder::voxels(Vector::ONE, &[IVector::ZERO]),
            ColliderBuilder::compound(vec![(Pose::from_translation(a), part.clone())]),
        ];
        for builder in shapes {
            let collider = builder.build();
            let reach = collider.bounding_radius_about(center);
            let sphere = collider.shape().compute_local_aabb();
            // Each side of the box touches the shape, so the shape reaches at least to each side.
            let sides = (sphere.maxs - center).max(center - sphere.mins);
            assert!(reach >= 0.999 * sides.max_element(), "{:?}", collider.shared_shape());
            let corner = (sphere.maxs - center).abs().max((center - sphere.mins).abs()).length();
            assert!(reach <= 1.001 * corner, "{:?}", collider.shared_shape());
        }
    }
    let ground = ColliderBuilder::halfspace(Vector::Y).build();
    assert_eq!(ground.bounding_radius_about(Vector::ZERO), Real::INFINITY);
}
