// A strict program: it must compile against the definitions of the package. It is not run.

import RAPIER, { type BodyChange, type Collider, PhysicsWorld, RapierError, type RapierErrorCode, type RigidBody, World } from "rapier3d";

export async function program(): Promise<bigint> {
    await RAPIER.init({ simd: false });
    using world = new PhysicsWorld({ x: 0, y: -9.81, z: 0 });
    const [body, collider]: [RigidBody, Collider] = world.insert(
        RAPIER.RigidBodyDesc.dynamic().setTranslation(0, 1, 2).enabledRotations(true, false, true).setAdditionalMassProperties(
            1, { x: 0, y: 0, z: 0 }, { x: 1, y: 1, z: 1 }, { x: 0, y: 0, z: 0, w: 1 },
        ),
        RAPIER.ColliderDesc.roundCylinder(1, 0.5, 0.1).setSensor(true),
    );
    const position: RAPIER.Vector = body.translation({ x: 0, y: 0, z: 0 });
    const inertia: RAPIER.SdpMatrix3 = body.effectiveAngularInertia();
    const code: RapierErrorCode = new RapierError("InvalidValue", "text").code;
    const change: BodyChange = "linvel";
    world.changeBodies(change, [body], new Float32Array([position.x, inertia.m11, code.length]));
    const { poses }: { poses: Float32Array } = world.views;
    collider.setVoxel(1, 2, 3, true);
    const hook: RAPIER.PhysicsHooks = {
        filterContactPair: (one, other, body1, body2) => (one + other + body1 + body2 > 0 ? RAPIER.SolverFlags.COMPUTE_IMPULSE : null),
        modifySolverContacts(contacts: RAPIER.ContactModification) {
            contacts.friction = poses[0] ?? 0;
        },
    };
    using queue = new RAPIER.EventQueue(true);
    world.step(queue, hook);
    world.castRay(new RAPIER.Ray(position, position), 1, true, undefined, 0, collider, body, (found: Collider) => found.isValid())?.collider.friction();
    const car: RAPIER.DynamicRayCastVehicleController = world.createVehicleController(body);
    car.indexForwardAxis = 2;
    const restored: World = World.restoreSnapshot(world.takeSnapshot());
    const copy: PhysicsWorld = world.clone();
    // @ts-expect-error A cuboid needs three numbers.
    RAPIER.ColliderDesc.cuboid(1, 2);
    // @ts-expect-error Rotations are quaternions.
    body.setRotation(0.5, true);
    return restored.hash() + copy.hash();
}
