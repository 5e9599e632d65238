//! Definitions of the shared tests in 3D. Their scenes are in the plane of x and y.

use rapier::prelude::*;

#[path = "ghosts/dim3.rs"]
pub mod grounds;
#[path = "ccd/dim3.rs"]
pub mod thin;
#[path = "characters/dim3.rs"]
pub mod floors;
#[path = "characters/space.rs"]
mod space;
#[path = "hostile/dim3.rs"]
pub mod hostile;
#[path = "queries/dim3.rs"]
pub mod queries;
#[path = "shapes/dim3.rs"]
pub mod shapes;
#[path = "joints/angles.rs"]
mod angles;
#[path = "joints/boards.rs"]
mod boards;
#[path = "joints/limbs.rs"]
mod limbs;
#[path = "joints/top.rs"]
mod top;
#[path = "joints/space.rs"]
mod joints;
#[path = "joints/swings.rs"]
mod swings;
#[path = "multibody/whips.rs"]
mod whips;
#[path = "physics/beams.rs"]
mod beams;
#[path = "physics/hulls.rs"]
mod hulls;
#[path = "physics/heaps.rs"]
mod heaps;
#[path = "physics/rods.rs"]
mod rods;
#[path = "physics/tumbling.rs"]
mod tumbling;
#[path = "physics/turntable.rs"]
mod turntable;
#[path = "vehicle/mod.rs"]
mod vehicle;

/// Heading of tables.
pub const NAME: &str = "3D";
/// Acceleration of a ball that rolls down a slope, as a fraction of that of sliding: `1 / (1 + I / m r²)`
/// with `I = 2/5 m r²`.
pub const ROLLING_BALL: Real = 5.0 / 7.0;
/// Compliance of a contact at the corner of a face between two unit cubes, relative to its fraction of the
/// load. The value is `m K / 4` for a quarter of the load, with `K = 2/m + 2 r² / I`, `r² = 1/2` and `I =
/// m/6`.
pub const CORNER_YIELD: Real = 2.0;

/// Returns the errors of a ride on a turntable: see `space`.
pub fn turntable() -> Option<(Real, Real)> {
    Some(space::turntable())
}

/// Returns a vector in the plane of the picture.
pub fn vec(x: Real, y: Real) -> Vector {
    Vector::new(x, y, 0.0)
}

/// Returns a rotation vector or angular velocity about the axis out of the plane.
pub fn about_z(angle: Real) -> AngVector {
    AngVector::new(0.0, 0.0, angle)
}

/// Returns the angle of a rotation about that axis.
pub fn turned_about_z(rotation: &Rotation) -> Real {
    rotation.to_scaled_axis().z
}

/// Returns the component about that axis.
pub fn z_of(w: AngVector) -> Real {
    w.z
}

/// Returns the angle of a body's rotation about that axis.
pub fn angle(rotation: &Rotation) -> Real {
    rotation.to_scaled_axis().z
}

/// Returns gears about the axis out of the plane.
pub fn gear(ratio: Real) -> GearJointBuilder {
    GearJointBuilder::new(Vector::Z, Vector::Z, ratio)
}

/// Returns a pinion about the axis out of the plane, and a rack along x.
pub fn rack(radius: Real) -> RackJointBuilder {
    RackJointBuilder::new(Vector::Z, Vector::X, radius)
}

/// Returns a hinge about the axis out of the plane.
pub fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new(Vector::Z)
}

/// Returns a joint at these local anchors that leaves rotation free: ball joints, and hinges about several
/// axes in turn.
pub fn loose_joint(k: usize, anchor1: Vector, anchor2: Vector) -> GenericJoint {
    let hinge =
        |axis| RevoluteJointBuilder::new(axis).local_anchor1(anchor1).local_anchor2(anchor2);
    match k % 4 {
        0 => SphericalJointBuilder::new()
            .local_anchor1(anchor1)
            .local_anchor2(anchor2)
            .build()
            .into(),
        1 => hinge(Vector::Z).build().into(),
        2 => hinge(Vector::Y).build().into(),
        _ => {
            let locked = JointAxesMask::LIN_AXES | JointAxesMask::ANG_X;
            GenericJointBuilder::new(locked).local_anchor1(anchor1).local_anchor2(anchor2).build()
        }
    }
}

/// Returns mass and inertia of a box with three different sides.
pub fn slab() -> MassProperties {
    MassProperties::from_cuboid(1.0, Vector::new(0.5, 0.25, 0.15))
}

/// Returns an angular velocity about an oblique axis.
pub fn tumble(about_z: Real, across: Real) -> AngVector {
    AngVector::new(across, 0.6 * across, about_z)
}

/// Returns the momentum of a body at this spatial velocity.
pub fn momentum_of(body: &RigidBody, velocity: &[Real; 6]) -> [Real; 6] {
    let mut moving = body.clone();
    let [x, y, z, a, b, c] = *velocity;
    moving.set_angvel(AngVector::new(a, b, c), false);
    let (p, l) = (Vector::new(x, y, z) * body.mass(), spin_momentum(&moving));
    [p.x, p.y, p.z, l.x, l.y, l.z]
}

/// Returns the moment of inertia about that axis.
pub fn about_z_of(mass: &MassProperties) -> Real {
    mass.principal_inertia().z
}

/// Closes a cage of this half width in front of and behind the plane of the picture.
pub fn close_cage(world: &mut PhysicsWorld, half: Real) {
    for side in [1.0, -1.0] {
        let wall =
            ColliderBuilder::halfspace(Vector::Z * -side).translation(Vector::Z * side * half);
        world.insert_collider(wall.friction(0.5), None);
    }
}

/// Returns a box that is as deep as it is wide.
pub fn cuboid(half_width: Real, half_height: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_width, half_height, half_width)
}

/// Returns a box as a hull, as wide as deep.
pub fn box_hull(half_width: Real, half_height: Real) -> ColliderBuilder {
    let corner = |signs: [Real; 3]| {
        Vector::from_array(signs) * Vector::new(half_width, half_height, half_width)
    };
    let signs = [-1.0, 1.0];
    let corners = signs.map(|x| signs.map(|y| signs.map(|z| corner([x, y, z]))));
    ColliderBuilder::convex_hull(&corners.concat().concat()).expect("a box is a hull")
}

/// Returns a level square of two triangles at height 0.
pub fn sheet(half_width: Real) -> ColliderBuilder {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[x, z]| Vector::new(x, 0.0, z) * half_width).to_vec();
    ColliderBuilder::trimesh(corners, vec![[0, 2, 1], [0, 3, 2]]).expect("it has two triangles")
}

/// Returns the length of a rotation vector, angular velocity or angular momentum.
pub fn ang_length(w: AngVector) -> Real {
    w.length()
}

/// Returns the moment `r × p`.
pub fn moment(r: Vector, p: Vector) -> AngVector {
    r.cross(p)
}

/// Makes a body slide along x while it revolves about the vertical axis at the distance of its arm along x.
pub fn spin_upright(body: &mut RigidBody, spin: Real, arm: Real, slide: Real) {
    body.set_angvel(Vector::Y * spin, true);
    body.set_linvel(Vector::new(slide, 0.0, -spin * arm), true);
}

/// Returns the angular momentum `I ω` of a body about its centre of mass.
pub fn spin_momentum(body: &RigidBody) -> AngVector {
    let local = body.mass_properties().local_mprops();
    let to_world = *body.rotation() * local.principal_inertia_local_frame;
    to_world * (local.principal_inertia() * (to_world.inverse() * body.angvel()))
}

/// Returns all components of a pose, for bitwise comparison.
pub fn components(pose: &Pose) -> [Real; 7] {
    let (r, t) = (pose.rotation, pose.translation);
    [t.x, t.y, t.z, r.x, r.y, r.z, r.w]
}

/// Returns one shape of each kind that rolls, slides or stacks, about half a metre in size.
pub fn assortment() -> Vec<ColliderBuilder> {
    let (half, tip): (Real, Real) = (0.25, 0.4);
    let axes = [Vector::X * half, Vector::Z * half, Vector::Y * tip];
    let hull: Vec<_> = axes.iter().flat_map(|&axis| [axis, -axis]).collect();
    let mut shapes = vec![
        ColliderBuilder::cuboid(half, half, half),
        ColliderBuilder::cuboid(0.4, 0.15, 0.25),
        ColliderBuilder::ball(half),
        ColliderBuilder::capsule_y(0.2, 0.2),
        ColliderBuilder::cylinder(0.2, 0.3),
        ColliderBuilder::cone(0.3, 0.3),
    ];
    shapes.extend(ColliderBuilder::convex_hull(&hull));
    shapes
}
