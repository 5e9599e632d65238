//! Definitions of the shared tests in 2D.

use rapier::prelude::*;

#[path = "ghosts/dim2.rs"]
pub mod grounds;
#[path = "ccd/dim2.rs"]
pub mod thin;
#[path = "characters/dim2.rs"]
pub mod floors;
#[path = "hostile/dim2.rs"]
pub mod hostile;
#[path = "queries/dim2.rs"]
pub mod queries;
#[path = "shapes/dim2.rs"]
pub mod shapes;

/// Heading of tables.
pub const NAME: &str = "2D";
/// Acceleration of a disc that rolls down a slope, as a fraction of that of sliding: `1 / (1 + I / m r²)`
/// with `I = 1/2 m r²`.
pub const ROLLING_BALL: Real = 2.0 / 3.0;
/// Compliance of a contact at the end of a side between two unit squares, relative to its fraction of the
/// load. The value is `m K / 2` for half the load, with `K = 2/m + 2 r² / I`, `r² = 1/4` and `I = m/6`.
pub const CORNER_YIELD: Real = 2.5;

/// Returns `None`: 2D has no rotation about the vertical.
pub fn turntable() -> Option<(Real, Real)> {
    None
}

/// Returns a vector.
pub fn vec(x: Real, y: Real) -> Vector {
    Vector::new(x, y)
}

/// Returns an angle or angular velocity.
pub fn about_z(angle: Real) -> AngVector {
    angle
}

/// Returns the angle of a rotation.
pub fn turned_about_z(rotation: &Rotation) -> Real {
    rotation.angle()
}

/// Returns the angle of a rotation vector.
pub fn z_of(w: AngVector) -> Real {
    w
}

/// Returns the angle of a body's rotation.
pub fn angle(rotation: &Rotation) -> Real {
    rotation.angle()
}

/// Returns gears.
pub fn gear(ratio: Real) -> GearJointBuilder {
    GearJointBuilder::new(ratio)
}

/// Returns a pinion, and a rack along x.
pub fn rack(radius: Real) -> RackJointBuilder {
    RackJointBuilder::new(Vector::X, radius)
}

/// Returns a hinge.
pub fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// Returns a joint at these local anchors that leaves rotation free.
pub fn loose_joint(_: usize, anchor1: Vector, anchor2: Vector) -> GenericJoint {
    hinge().local_anchor1(anchor1).local_anchor2(anchor2).build().into()
}

/// Returns mass and inertia of a rectangle.
pub fn slab() -> MassProperties {
    MassProperties::from_cuboid(1.0, Vector::new(0.5, 0.25))
}

/// Returns an angular velocity.
pub fn tumble(about_z: Real, _: Real) -> AngVector {
    about_z
}

/// Returns the momentum of a body at this spatial velocity.
pub fn momentum_of(body: &RigidBody, velocity: &[Real; 3]) -> [Real; 3] {
    let [x, y, w] = *velocity;
    [x * body.mass(), y * body.mass(), w * about_z_of(body.mass_properties().local_mprops())]
}

/// Returns the moment of inertia.
pub fn about_z_of(mass: &MassProperties) -> Real {
    mass.principal_inertia()
}

/// Returns a box.
pub fn cuboid(half_width: Real, half_height: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_width, half_height)
}

/// Returns a box as a hull.
pub fn box_hull(half_width: Real, half_height: Real) -> ColliderBuilder {
    let corners = [-1.0, 1.0].map(|x| [-1.0, 1.0].map(|y| vec(x * half_width, y * half_height)));
    ColliderBuilder::convex_hull(&corners.concat()).expect("a box is a hull")
}

/// Returns a level sheet without thickness at height 0.
pub fn sheet(half_width: Real) -> ColliderBuilder {
    ColliderBuilder::polyline(vec![vec(half_width, 0.0), vec(-half_width, 0.0)], None)
}

/// Does nothing: bodies cannot leave the plane in 2D.
pub fn close_cage(_: &mut PhysicsWorld, _: Real) {}

/// Returns the magnitude of an angle, angular velocity or angular momentum.
pub fn ang_length(w: AngVector) -> Real {
    w.abs()
}

/// Returns the moment `r × p`.
pub fn moment(r: Vector, p: Vector) -> AngVector {
    r.perp_dot(p)
}

/// Makes a body slide along x. (Rotation about the vertical axis exists in 3D only.)
pub fn spin_upright(body: &mut RigidBody, _spin: Real, _arm: Real, slide: Real) {
    body.set_linvel(vec(slide, 0.0), true);
}

/// Returns the angular momentum `I ω` of a body about its centre of mass.
pub fn spin_momentum(body: &RigidBody) -> AngVector {
    body.mass_properties().local_mprops().principal_inertia() * body.angvel()
}

/// Returns all components of a pose, for bitwise comparison.
pub fn components(pose: &Pose) -> [Real; 4] {
    let (r, t) = (pose.rotation, pose.translation);
    [t.x, t.y, r.re, r.im]
}

/// Returns one shape of each kind that rolls, slides or stacks, about half a metre in size.
pub fn assortment() -> Vec<ColliderBuilder> {
    let half: Real = 0.25;
    let hull = [vec(-0.3, -0.2), vec(0.3, -0.2), vec(0.4, 0.1), vec(0.0, 0.35), vec(-0.3, 0.2)];
    let mut shapes = vec![
        ColliderBuilder::cuboid(half, half),
        ColliderBuilder::cuboid(0.4, 0.15),
        ColliderBuilder::ball(half),
        ColliderBuilder::capsule_y(0.2, 0.2),
        ColliderBuilder::round_cuboid(0.2, 0.2, 0.05),
        ColliderBuilder::triangle(vec(-0.3, -0.2), vec(0.3, -0.2), vec(0.0, 0.4)),
    ];
    shapes.extend(ColliderBuilder::convex_hull(&hull));
    shapes
}
