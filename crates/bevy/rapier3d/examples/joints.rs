//! A motor turns a wheel, and a chain of links hangs from it until the load breaks a link.

use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use rapier3d_bevy::prelude::*;
use std::time::Duration;

const LINKS: usize = 5;

fn main() -> AppExit {
    App::new()
        .add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugin::default()))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_millis(16)))
        .add_systems(Startup, (spawn_wheel, spawn_chain))
        .add_systems(FixedUpdate, load)
        .add_systems(Update, report)
        .run()
}

#[derive(Component)]
struct Wheel;

#[derive(Component)]
struct Weight;

fn spawn_wheel(mut commands: Commands) {
    let axle = commands.spawn((RigidBody::Fixed, Transform::from_xyz(5.0, 0.0, 0.0))).id();
    let wheel =
        (Wheel, RigidBody::Dynamic, Collider::ball(0.5), Transform::from_xyz(5.0, 0.0, 0.0));
    let wheel = commands.spawn(wheel).id();
    let hinge = Joint::revolute(axle, wheel, Vector::Z);
    commands.spawn(hinge.with_motor_velocity(JointAxis::AngX, 6.0, 10.0));
}

fn spawn_chain(mut commands: Commands) {
    let mut above = commands.spawn(RigidBody::Fixed).id();
    for link in 1..=LINKS {
        let place = Transform::from_xyz(0.0, -(link as f32), 0.0);
        let mass = ColliderMass::Mass(1.0);
        let below = (RigidBody::Dynamic, Collider::ball(0.2), mass, place);
        let below = commands.spawn(below).id();
        let joint = Joint::spherical(above, below)
            .with_anchors(Vector::Y * -0.5, Vector::Y * 0.5)
            .with_break_thresholds(200.0, Scalar::INFINITY);
        commands.spawn(joint).observe(|broken: On<JointBroken>| {
            println!("the joint {} breaks at {:.0} N", broken.entity, broken.force);
        });
        above = below;
    }
    commands.entity(above).insert(Weight);
}

/// A force that grows by 50 N each second pulls at the last link.
fn load(time: Res<Time>, mut force: Single<&mut ExternalForce, With<Weight>>) {
    force.force = Vector::Y * -50.0 * time.elapsed_secs() as Scalar;
}

fn report(
    time: Res<Time>,
    wheel: Single<&Velocity, With<Wheel>>,
    weight: Single<&Transform, With<Weight>>,
    mut exit: MessageWriter<AppExit>,
) {
    if time.elapsed_secs() > 4.5 {
        let (speed, height) = (wheel.angular.z, weight.translation.y);
        println!("the wheel turns at {speed:.2} rad/s, the weight is at {height:.1} m");
        assert!((speed - 6.0).abs() < 0.1);
        assert!(height < -(LINKS as f32) - 5.0, "the chain must break");
        exit.write(AppExit::Success);
    }
}
