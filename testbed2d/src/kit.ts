// Common parts of scenes: a floor, boxes, walls.

import type { ColliderDesc, Context, Paint, RigidBody, Vector } from "./rapier.ts";

export const vec = (x: number, y: number): Vector => ({ x, y });
export const ORIGIN: Vector = vec(0, 0);

/** A fixed floor with its top at y = 0. */
export function addFloor({ RAPIER, world }: Context, half = 60): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(0, -3));
    world.createCollider(RAPIER.ColliderDesc.cuboid(half, 3), body);
    return body;
}

/** A fixed body with one collider. */
export function addFixed({ RAPIER, world }: Context, at: Vector, shape: ColliderDesc, angle = 0): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(at.x, at.y).setRotation(angle));
    world.createCollider(shape, body);
    return body;
}

/** A dynamic body with one collider. */
export function add({ RAPIER, world }: Context, at: Vector, shape: ColliderDesc, angle = 0): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(at.x, at.y).setRotation(angle));
    world.createCollider(shape, body);
    return body;
}

/** A wall on each side. */
export function addWalls(context: Context, half: number, height: number): void {
    for (const side of [-1, 1]) {
        addFixed(context, vec(side * (half + 0.3), height / 2), context.RAPIER.ColliderDesc.cuboid(0.3, height / 2));
    }
}

/** A suspension point of a joint, which collides with nothing. */
export function addHook({ RAPIER, world, paint }: Context, at: Vector): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(at.x, at.y));
    world.createCollider(RAPIER.ColliderDesc.ball(0.1).setCollisionGroups(0), body);
    paint(body, "grey");
    return body;
}

/** The corners of an irregular convex stone. */
export function stone({ random }: Context, radius: number, corners = 7): Float32Array {
    const points = new Float32Array(2 * corners);
    for (let corner = 0; corner < corners; corner++) {
        const angle = (2 * Math.PI * (corner + random.between(-0.3, 0.3))) / corners;
        points.set([radius * Math.cos(angle), radius * Math.sin(angle)], 2 * corner);
    }
    return points;
}

export function distance(a: Vector, b: Vector): number {
    return Math.hypot(a.x - b.x, a.y - b.y);
}

/** Lines between the bodies of all joints. */
export function drawJoints({ world }: Context, line: (from: Vector, to: Vector, paint: Paint) => void): void {
    world.impulseJoints.forEach((joint) => line(joint.body1().translation(), joint.body2().translation(), "grey"));
}
