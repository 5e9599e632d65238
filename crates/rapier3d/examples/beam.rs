use rapier3d::prelude::*;
fn run(model: FrictionModel, half: Vector, degrees: f32, is_link: bool) {
    let mut world = PhysicsWorld::new();
    world.integration_parameters.friction_model = model;
    world.insert_collider(ColliderBuilder::halfspace(Vector::Y).friction(0.5), None);
    let (s, c) = degrees.to_radians().sin_cos();
    let v = Vector::new(c, 0.0, s) * 8.0;
    let b = RigidBodyBuilder::dynamic().translation(Vector::new(0.0, half.y, 0.0)).linvel(v);
    let (h, _) = world.insert(b, ColliderBuilder::cuboid(half.x, half.y, half.z).friction(0.5));
    if is_link {
        let root =
            world.insert_body(RigidBodyBuilder::fixed().translation(Vector::new(0.0, half.y, 0.0)));
        let free = GenericJointBuilder::new(JointAxesMask::empty()).build();
        let m = world.multibody_joints.insert(root, h, free, true);
        assert!(m.is_some());
        world.bodies[h].set_linvel(v, true);
    }
    let mut t = 0.0;
    let mut heading = 0.0f32;
    for _ in 0..30 {
        world.step();
        t += 1.0 / 60.0;
    }
    let vel = world.bodies[h].linvel();
    heading = vel.z.atan2(vel.x).to_degrees();
    let decel = (8.0 - vel.length()) / t / (0.5 * 9.81);
    for _ in 0..270 {
        world.step();
    }
    let p = world.bodies[h].translation();
    println!(
        "{model:?} link {is_link} half {half} at {degrees}°: heading {heading:.2}°, decel {decel:.4} µg, distance {:.4} of {:.4}, direction {:.2}°",
        Vector::new(p.x, 0.0, p.z).length(),
        64.0 / 9.81,
        p.z.atan2(p.x).to_degrees()
    );
}
fn main() {
    for model in [FrictionModel::Standard, FrictionModel::Coulomb] {
        for half in
            [Vector::new(2.0, 0.25, 0.25), Vector::new(1.0, 0.5, 1.0), Vector::new(0.5, 0.5, 0.5)]
        {
            for degrees in [0.0, 45.0, 70.0] {
                run(model, half, degrees, false);
            }
        }
    }
    for half in [Vector::new(2.0, 0.25, 0.25), Vector::new(1.0, 0.5, 1.0)] {
        for degrees in [0.0, 45.0] {
            run(FrictionModel::Standard, half, degrees, true);
        }
    }
}
