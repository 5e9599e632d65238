// A strict program: it must compile against the definitions of the package. It is not run.

import RAPIER, { type Collider, PhysicsWorld, type RigidBody, World } from "rapier2d";

export async function program(): Promise<bigint> {
    await RAPIER.init();
    using world = new PhysicsWorld({ x: 0, y: -9.81 });
    const [body, collider]: [RigidBody, Collider] = world.insert(
        RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 1).setRotation(0.5).lockRotations().setAdditionalMassProperties(1, { x: 0, y: 0 }, 1),
        RAPIER.ColliderDesc.cuboid(1, 2),
    );
    const angle: number = body.rotation();
    const spin: number = body.angvel();
    body.setAngvel(angle + spin, true);
    collider.setVoxel(1, 2, true);
    const outline: RAPIER.ColliderDesc | null = RAPIER.ColliderDesc.convexPolyline(new Float32Array(8));
    if (outline) world.createCollider(outline, body);
    world.step();
    world.createImpulseJoint(RAPIER.JointData.revolute({ x: 0, y: 0 }, { x: 0, y: 0 }), body, body, true);
    const restored: World = World.restoreSnapshot(world.takeSnapshot());
    // @ts-expect-error There are no cylinders in 2D.
    RAPIER.ColliderDesc.cylinder(1, 2);
    // @ts-expect-error A cuboid needs two numbers.
    RAPIER.ColliderDesc.cuboid(1, 2, 3);
    return restored.hash();
}
