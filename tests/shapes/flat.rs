//! Shapes with a size of zero: plates, lines and points.
//!
//! A page whose floor is a plane was blank, because a box without height was refused. Such shapes collide
//! with no thickness of their own.

use crate::dim::shapes::{bodies, flat_bodies, flat_clouds, flat_floors, points_without_size};
use crate::dim::{cuboid, vec};
use crate::suite::physics::stage::{Dice, add_ground, run, world};
use crate::suite::physics::table::Table;
use rapier::prelude::*;

/// Speeds of the fall (m/s).
const SPEEDS: [Real; 5] = [0.0, 1.0, 3.0, 10.0, 30.0];
/// Largest distance of a resting body from its place (m). Contacts overlap by a millimetre.
const PLACE_TOLERANCE: Real = 2.0e-3;

/// Returns the height of a body above its place, some time (s) after it was thrown down onto a floor.
fn height_after(
    seconds: Real,
    lay: impl Fn(&mut PhysicsWorld),
    (shape, rest): (&ColliderBuilder, Real),
    speed: Real,
) -> Real {
    let mut world = world(60);
    lay(&mut world);
    let body = RigidBodyBuilder::dynamic().translation(vec(0.13, rest + 0.5));
    let (body, _) = world.insert(body.linvel(vec(0.0, -speed)), shape.clone());
    run(&mut world, seconds);
    let body = &world.bodies[body];
    assert!(body.mass().is_finite() && body.mass() > 0.0, "{} kg", body.mass());
    body.translation().y - rest
}

/// Bodies that fall on floors without thickness rest there.
#[test]
fn bodies_rest_on_flat_floors() {
    let mut table =
        Table::new("bodies on floors without thickness", &["floor", "body", "worst (m)"]);
    for (floor_name, floor) in flat_floors() {
        let floor = floor.try_build().unwrap_or_else(|error| panic!("{floor_name}: {error}"));
        for (name, shape, rest) in bodies() {
            let lay = |world: &mut PhysicsWorld| {
                world.insert_collider(floor.clone(), None);
            };
            let heights = SPEEDS.map(|speed| height_after(3.0, lay, (&shape, rest), speed));
            let worst = heights.into_iter().map(Real::abs).fold(0.0, Real::max);
            table.row([floor_name.into(), name.into(), format!("{worst:.4}")]);
            table.require(worst < PLACE_TOLERANCE, "it does not rest on the floor");
        }
    }
}

/// Bodies without thickness come to rest on a thick floor and on a flat one. Plates wobble after a hard
/// landing.
#[test]
fn flat_bodies_rest_on_floors() {
    let columns = ["body", "mass (kg)", "on 2 m (m)", "on a flat floor (m)"];
    let mut table = Table::new("bodies without thickness on floors", &columns);
    for (name, shape, rest, measure) in flat_bodies() {
        let mass = shape.build().mass();
        assert!(mass.is_finite(), "{name}: {mass} kg");
        let flat = cuboid(5.0, 0.0);
        let lay_flat = |world: &mut PhysicsWorld| {
            world.insert_collider(flat.clone(), None);
        };
        let lay_thick = |world: &mut PhysicsWorld| {
            add_ground(world, 0.5);
        };
        let worst = |lay: &dyn Fn(&mut PhysicsWorld)| {
            let heights =
                [0.0, 1.0, 3.0].map(|speed| height_after(8.0, lay, (&shape, rest), speed));
            heights.into_iter().map(Real::abs).fold(0.0, Real::max)
        };
        let mut world = world(60);
        let (body, _) = world.insert(RigidBodyBuilder::dynamic(), shape.clone());
        let found = world.bodies[body].mass();
        let [thick, flat] = [worst(&lay_thick), worst(&lay_flat)];
        let [mass, first, second] = [found, thick, flat].map(|figure| format!("{figure:.4}"));
        table.row([name.into(), mass, first, second]);
        table.require((found / measure - 1.0).abs() < 0.02, "the mass is not area or length");
        table.require(thick < PLACE_TOLERANCE, "it does not rest on the thick floor");
        table.require(flat < PLACE_TOLERANCE, "it does not rest on the flat floor");
    }
}

/// Points rest on a thick floor. A density gives them no mass, as the log reports.
#[test]
fn points_rest_on_floors() {
    for (name, shape) in points_without_size() {
        assert_eq!(shape.build().mass(), 0.0, "{name}");
        let shape = shape.mass(1.0);
        let lay = |world: &mut PhysicsWorld| {
            add_ground(world, 0.5);
        };
        for speed in SPEEDS {
            let height = height_after(3.0, lay, (&shape, 0.0), speed);
            assert!(height.abs() < PLACE_TOLERANCE, "{name} at {speed} m/s: {height} m");
        }
    }
}

/// A collider beside the origin of its body, too, gives the mass of its surface.
#[test]
fn flat_colliders_beside_the_origin_have_a_mass() {
    for (name, shape, _, measure) in flat_bodies() {
        let mut world = world(60);
        let shape = shape.translation(vec(0.7, 0.2));
        let (body, _) = world.insert(RigidBodyBuilder::dynamic(), shape);
        for _ in 0..2 {
            let mass = world.bodies[body].mass();
            assert!((mass / measure - 1.0).abs() < 0.02, "{name}: {mass} kg of {measure}");
            world.step();
        }
    }
}

/// A box slides over flat tiles without friction as over one plane.
#[test]
fn flat_tiles_have_no_edges() {
    let mut world = world(60);
    for i in 0..40 {
        let tile = cuboid(0.5, 0.0).friction(0.0).translation(vec(i as Real, 0.0));
        world.insert_collider(tile, None);
    }
    let body = RigidBodyBuilder::dynamic().translation(vec(1.0, 0.4)).linvel(vec(10.0, 0.0));
    let (body, _) = world.insert(body, cuboid(0.4, 0.4).friction(0.0));
    run(&mut world, 3.0);
    let body = &world.bodies[body];
    assert!((body.linvel().x - 10.0).abs() < 0.02, "{}", body.linvel());
    assert!((body.translation().y - 0.4).abs() < PLACE_TOLERANCE, "{}", body.translation());
}

/// A size of zero is accepted; negative and infinite sizes, and NaN, are refused by name.
#[test]
fn negative_sizes_are_refused_by_name() {
    for bad in [-1.0, -1.0e-9, Real::NAN, Real::INFINITY] {
        for (name, builder) in crate::dim::shapes::of_size(bad) {
            let error = builder.try_build().map(drop).expect_err(name).to_string();
            assert!(error.contains(name), "{name} of {bad}: {error}");
        }
    }
    for (name, builder) in crate::dim::shapes::of_size(0.0) {
        assert!(builder.try_build().is_ok(), "{name}");
    }
}

/// Points of a grid in a plane make a plate with their extent: rounding makes no corners of points on its
/// sides, from which no plate was made.
#[test]
fn grids_of_points_in_a_plane_have_a_hull() {
    for (name, points) in flat_clouds() {
        let hull = ColliderBuilder::try_convex_hull(&points);
        let aabb = hull.unwrap_or_else(|error| panic!("{name}: {error}")).build().compute_aabb();
        let lowest = points.iter().copied().reduce(Vector::min).expect("points");
        let highest = points.iter().copied().reduce(Vector::max).expect("points");
        let error = (aabb.mins - lowest).length().max((aabb.maxs - highest).length());
        // A corner that is dropped is nearer to its side than 1e-5 of the extent.
        assert!(error < 1.0e-4 * (highest - lowest).length(), "{name}: {error} m");
    }
}

/// Rays hit flat floors at their height, and pass beside the floors.
#[test]
fn rays_hit_flat_floors() {
    for (name, floor) in flat_floors() {
        let mut world = world(60);
        world.insert_collider(floor, None);
        world.step();
        let time = |from: Vector, to: Vector| {
            let hit = world.cast_ray(&Ray::new(from, to - from), 1.0, true, QueryFilter::default());
            hit.map(|(_, time)| time)
        };
        for x in [-4.0, 0.1, 3.0] {
            let found = time(vec(x - 0.5, 1.0), vec(x + 0.5, -1.0)).unwrap_or(Real::NAN);
            assert!((found - 0.5).abs() < 1.0e-3, "{name} at {x}: {found}");
        }
        assert_eq!(time(vec(6.5, 1.0), vec(6.6, -1.0)), None, "{name}: a ray beside it hits");
        assert_eq!(time(vec(0.0, 1.0), vec(0.1, 0.2)), None, "{name}: a ray above it hits");
    }
}

/// Rays from all directions hit flat hulls at any slope in their middle. The normals of the two sides of such
/// a hull differ by rounding, so a hull of exactly opposite normals alone was flat.
#[test]
fn rays_hit_flat_hulls_at_any_slope() {
    let mut dice = Dice(12);
    let mut hits = 0;
    for (name, points) in flat_clouds() {
        let middle = points.iter().copied().sum::<Vector>() / points.len() as Real;
        let Ok(hull) = ColliderBuilder::try_convex_hull(&points) else { continue };
        let mut world = world(60);
        world.insert_collider(hull, None);
        world.step();
        for _ in 0..20 {
            let mut path = Vector::ZERO;
            (0..DIM).for_each(|axis| path[axis] = dice.within(-3.0, 3.0));
            let ray = Ray::new(middle - path, path);
            let hit = world.cast_ray(&ray, 2.0, true, QueryFilter::default());
            let place = ray.point_at(hit.map_or(Real::NAN, |(_, time)| time));
            // On a ray that grazes the hull, rounding moves the place along the hull, not off it.
            let nearest = world.project_point(place, 1.0, true, QueryFilter::default());
            let error = nearest.map_or(Real::NAN, |(_, near)| (near.point - place).length());
            assert!(error < 1.0e-3, "{name} along {path}: {error} m off");
            hits += 1;
        }
    }
    assert!(hits > 200, "{hits}");
}

/// The normal of a box without height points to the side from which a ray comes.
#[test]
fn normals_of_flat_boxes_are_against_the_ray() {
    let mut dice = Dice(13);
    let mut world = world(60);
    world.insert_collider(cuboid(5.0, 0.0), None);
    world.step();
    for _ in 0..500 {
        let (mut start, mut target) = (Vector::ZERO, Vector::ZERO);
        for axis in 0..DIM {
            (start[axis], target[axis]) = (dice.within(-3.0, 3.0), dice.within(-3.0, 3.0));
        }
        target.y = 0.0;
        let ray = Ray::new(start, target - start);
        let hit = world.cast_ray_and_get_normal(&ray, 2.0, true, QueryFilter::default());
        let (_, hit) = hit.unwrap_or_else(|| panic!("{ray:?} passes"));
        let side = Vector::Y * start.y.signum();
        assert!((hit.normal - side).length() < 1.0e-3, "{} from {start}", hit.normal);
    }
}
