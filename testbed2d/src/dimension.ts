// The operations of the testbed on a 2D engine.

import type { Counts, Dimension, Hit, Spring } from "../../testbed/src/core/dimension.ts";
import type { BodyLike, ColliderLike, Vec } from "../../testbed/src/core/engine.ts";
import type { Collider, EventQueue, PhysicsHooks, Rapier, RigidBody, Vector, World } from "./rapier.ts";

/** Frequency of the pointer's spring in rad/s, and its damping ratio. */
const SPRING_RATE = 18;
const SPRING_DAMPING = 0.9;
/** Angular damping of a body that the pointer holds. */
const HELD_DAMPING = 4;

const point = { x: 0, y: 0 };

function rotate(angle: number, v: Vector): Vector {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    return { x: cos * v.x - sin * v.y, y: sin * v.x + cos * v.y };
}

function spaced({ x, y }: Vector): Vec {
    return { x, y, z: 0 };
}

function createSpring(RAPIER: Rapier, world: World, hit: Hit): Spring {
    const body = hit.body as RigidBody;
    const at = body.translation();
    const anchor = rotate(-body.rotation(), { x: hit.point.x - at.x, y: hit.point.y - at.y });
    const hand = world.createRigidBody(
        RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(hit.point.x, hit.point.y),
    );
    const stiffness = body.mass() * SPRING_RATE ** 2;
    const damping = 2 * SPRING_DAMPING * body.mass() * SPRING_RATE;
    world.createImpulseJoint(RAPIER.JointData.spring(0, stiffness, damping, { x: 0, y: 0 }, anchor), hand, body, true);
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
            return { x: centre.x + arm.x, y: centre.y + arm.y, z: 0 };
        },
        target: () => spaced(hand.translation()),
        free: () => {
            if (body.isValid()) body.setAngularDamping(before);
            world.removeRigidBody(hand);
        },
    };
}

/** The pointer's ray is perpendicular to the plane: its origin is the point. */
function pick(RAPIER: Rapier, world: World, origin: Vec): Hit | null {
    const found: { hit: Hit | null } = { hit: null };
    const visit = (collider: Collider): boolean => {
        const body = collider.parent();
        if (!body?.isDynamic()) return true;
        found.hit = { body, collider, point: spaced(origin) };
        return false;
    };
    world.intersectionsWithPoint(origin, visit, RAPIER.QueryFilterFlags.EXCLUDE_SENSORS);
    return found.hit;
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
    const { x, y } = collider.translation(point);
    const half = 0.5 * collider.rotation();
    out[0] = x;
    out[1] = y;
    out[5] = Math.sin(half);
    out[6] = Math.cos(half);
}

function readState(from: BodyLike, out: Float64Array): void {
    const body = from as RigidBody;
    const [at, v] = [body.translation(), body.linvel()];
    out.fill(0);
    out.set([at.x, at.y, body.rotation(), v.x, v.y, body.angvel()]);
}

export const DIMENSION_2: Dimension<Rapier, World> = {
    flat: true,
    createWorld: (RAPIER, gravity) => new RAPIER.World({ x: 0, y: -gravity }),
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
            .setTranslation(from.x, from.y)
            .setLinvel(velocity.x, velocity.y)
            .setCcdEnabled(true);
        const body = world.createRigidBody(description);
        world.createCollider(RAPIER.ColliderDesc.ball(radius).setDensity(4), body);
        return body;
    },
};
