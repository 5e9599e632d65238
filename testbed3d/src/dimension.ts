// The operations of the testbed on a 3D engine.

import type { Counts, Dimension, Hit, Spring } from "../../testbed/src/core/dimension.ts";
import type { BodyLike, ColliderLike, Vec } from "../../testbed/src/core/engine.ts";
import type { Collider, EventQueue, PhysicsHooks, Rapier, RigidBody, World } from "./rapier.ts";

/** Frequency of the pointer's spring in rad/s, and its damping ratio. */
const SPRING_RATE = 18;
const SPRING_DAMPING = 0.9;
/** Angular damping of a body that the pointer holds. */
const HELD_DAMPING = 4;
const PICK_DISTANCE = 1000;

const point = { x: 0, y: 0, z: 0 };
const turn = { x: 0, y: 0, z: 0, w: 1 };

function rotate(q: { x: number; y: number; z: number; w: number }, v: Vec): Vec {
    const tx = 2 * (q.y * v.z - q.z * v.y);
    const ty = 2 * (q.z * v.x - q.x * v.z);
    const tz = 2 * (q.x * v.y - q.y * v.x);
    return {
        x: v.x + q.w * tx + q.y * tz - q.z * ty,
        y: v.y + q.w * ty + q.z * tx - q.x * tz,
        z: v.z + q.w * tz + q.x * ty - q.y * tx,
    };
}

function createSpring(RAPIER: Rapier, world: World, hit: Hit): Spring {
    const body = hit.body as RigidBody;
    const at = body.translation();
    const q = body.rotation();
    const inverse = { x: -q.x, y: -q.y, z: -q.z, w: q.w };
    const anchor = rotate(inverse, { x: hit.point.x - at.x, y: hit.point.y - at.y, z: hit.point.z - at.z });
    const { x, y, z } = hit.point;
    const hand = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(x, y, z));
    const stiffness = body.mass() * SPRING_RATE ** 2;
    const damping = 2 * SPRING_DAMPING * body.mass() * SPRING_RATE;
    const data = RAPIER.JointData.spring(0, stiffness, damping, { x: 0, y: 0, z: 0 }, anchor);
    world.createImpulseJoint(data, hand, body, true);
    const before = body.angularDamping();
    body.setAngularDamping(before + HELD_DAMPING);
    return {
        body,
        move: (target) => {
            body.wakeUp();
            hand.setNextKinematicTranslation(target);
        },
        anchor: () => {
            const centre = body.translation();
            const arm = rotate(body.rotation(), anchor);
            return { x: centre.x + arm.x, y: centre.y + arm.y, z: centre.z + arm.z };
        },
        target: () => hand.translation(),
        free: () => {
            if (body.isValid()) body.setAngularDamping(before);
            world.removeRigidBody(hand);
        },
    };
}

function pick(
    RAPIER: Rapier,
    world: World,
    origin: Vec,
    direction: Vec,
    visible: (handle: number) => boolean,
): Hit | null {
    const ray = new RAPIER.Ray(origin, direction);
    const flags = RAPIER.QueryFilterFlags.EXCLUDE_SENSORS;
    const seen = (collider: Collider): boolean => visible(collider.handle);
    const found = world.castRay(ray, PICK_DISTANCE, true, flags, undefined, undefined, undefined, seen);
    const body = found?.collider.parent();
    if (!found || !body?.isDynamic()) return null;
    return { body, collider: found.collider, point: { ...ray.pointAt(found.timeOfImpact) } };
}

function counts(world: World): Counts {
    return {
        bodies: world.bodies.len(),
        colliders: world.colliders.len(),
        joints: world.impulseJoints.len() + world.multibodyJoints.len(),
    };
}

function readPose(from: ColliderLike, out: Float32Array): void {
    const collider = from as Collider;
    const { x, y, z } = collider.translation(point);
    const q = collider.rotation(turn);
    out[0] = x;
    out[1] = y;
    out[2] = z;
    out[3] = q.x;
    out[4] = q.y;
    out[5] = q.z;
    out[6] = q.w;
}

function readState(from: BodyLike, out: Float64Array): void {
    const body = from as RigidBody;
    const [at, q, v, w] = [body.translation(), body.rotation(), body.linvel(), body.angvel()];
    out.set([at.x, at.y, at.z, q.x, q.y, q.z, q.w, v.x, v.y, v.z, w.x, w.y, w.z]);
}

export const DIMENSION_3: Dimension<Rapier, World> = {
    flat: false,
    createWorld: (RAPIER, gravity) => new RAPIER.World({ x: 0, y: -gravity, z: 0 }),
    restoreWorld: (RAPIER, snapshot) => RAPIER.World.restoreSnapshot(snapshot),
    step: (world, events, hooks) =>
        world.step(events as EventQueue | undefined, hooks as PhysicsHooks | undefined),
    counts,
    readPose,
    readState,
    pick,
    createSpring,
    throwBall: (RAPIER, world, from, velocity, radius) => {
        const description = RAPIER.RigidBodyDesc.dynamic()
            .setTranslation(from.x, from.y, from.z)
            .setLinvel(velocity.x, velocity.y, velocity.z)
            .setCcdEnabled(true);
        const body = world.createRigidBody(description);
        world.createCollider(RAPIER.ColliderDesc.ball(radius).setDensity(4), body);
        return body;
    },
};
