//! The vocabulary of the shared tests in 2D.

use rapier::prelude::*;

#[path = "ghosts/dim2.rs"]
pub mod grounds;
#[path = "ccd/dim2.rs"]
pub mod thin;
#[path = "characters/dim2.rs"]
pub mod floors;
#[path = "hostile/dim2.rs"]
pub mod hostile;

/// Heading of tables.
pub const NAME: &str = "2D";
/// Acceleration of a disc that rolls down a slope, as a share of sliding: `1 / (1 + I / m r²)` with
/// `I = 1/2 m r²`.
pub const ROLLING_BALL: Real = 2.0 / 3.0;
/// How much easier the end of a side between two unit squares gives way than its share of the load: `m K / 2`
/// of half the load, with `K = 2/m + 2 r² / I`, `r² = 1/4` and `I = m/6`.
pub const CORNER_YIELD: Real = 2.5;

/// Nothing turns about the vertical.
pub fn turntable() -> Option<(Real, Real)> {
    None
}

/// A vector.
pub fn vec(x: Real, y: Real) -> Vector {
    Vector::new(x, y)
}

/// An angle or angular velocity.
pub fn about_z(angle: Real) -> AngVector {
    angle
}

/// By what angle a rotation turns.
pub fn turned_about_z(rotation: &Rotation) -> Real {
    rotation.angle()
}

/// The same, back.
pub fn z_of(w: AngVector) -> Real {
    w
}

/// The angle by which a body is turned.
pub fn angle(rotation: &Rotation) -> Real {
    rotation.angle()
}

/// A hinge.
pub fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// A joint that lets its bodies turn against each other, at these points of theirs.
pub fn loose_joint(_: usize, anchor1: Vector, anchor2: Vector) -> GenericJoint {
    hinge().local_anchor1(anchor1).local_anchor2(anchor2).build().into()
}

/// Mass and inertia of a rectangle.
pub fn slab() -> MassProperties {
    MassProperties::from_cuboid(1.0, Vector::new(0.5, 0.25))
}

/// An angular velocity.
pub fn tumble(about_z: Real, _: Real) -> AngVector {
    about_z
}

/// The momentum of a body at this spatial velocity.
pub fn momentum_of(body: &RigidBody, velocity: &[Real; 3]) -> [Real; 3] {
    let [x, y, w] = *velocity;
    [x * body.mass(), y * body.mass(), w * about_z_of(body.mass_properties().local_mprops())]
}

/// The moment of inertia.
pub fn about_z_of(mass: &MassProperties) -> Real {
    mass.principal_inertia()
}

/// A box.
pub fn cuboid(half_width: Real, half_height: Real) -> ColliderBuilder {
    ColliderBuilder::cuboid(half_width, half_height)
}

/// Closes a cage before and behind the plane of the picture: nothing leaves it in 2D.
pub fn close_cage(_: &mut PhysicsWorld, _: Real) {}

/// The size of an angle, angular velocity or angular momentum.
pub fn ang_length(w: AngVector) -> Real {
    w.abs()
}

/// The moment `r × p`.
pub fn moment(r: Vector, p: Vector) -> AngVector {
    r.perp_dot(p)
}

/// Lets a body slide along x. (What could turn about the upright axis is 3D.)
pub fn spin_upright(body: &mut RigidBody, _spin: Real, _arm: Real, slide: Real) {
    body.set_linvel(vec(slide, 0.0), true);
}

/// The angular momentum `I ω` of a body about its centre of mass.
pub fn spin_momentum(body: &RigidBody) -> AngVector {
    body.mass_properties().local_mprops().principal_inertia() * body.angvel()
}

/// All components of a pose, to be compared bit by bit.
pub fn components(pose: &Pose) -> [Real; 4] {
    let (r, t) = (pose.rotation, pose.translation);
    [t.x, t.y, r.re, r.im]
}

/// One shape of each kind that rolls, slides or stacks, about half a metre in size.
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
