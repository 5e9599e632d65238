// Common parts of scenes: a floor, boxes, a pit.

import type { ColliderDesc, Context, RigidBody, Rotation, Vector } from "./rapier.ts";

export const vec = (x: number, y: number, z: number): Vector => ({ x, y, z });
export const ORIGIN: Vector = vec(0, 0, 0);
export const UPRIGHT: Rotation = { x: 0, y: 0, z: 0, w: 1 };

/** A rotation about an axis of length 1, by an angle in radians. */
export function turn(axis: Vector, angle: number): Rotation {
    const s = Math.sin(angle / 2);
    return { x: axis.x * s, y: axis.y * s, z: axis.z * s, w: Math.cos(angle / 2) };
}

/** A vector after a rotation. */
export function rotated(q: Rotation, v: Vector): Vector {
    const tx = 2 * (q.y * v.z - q.z * v.y);
    const ty = 2 * (q.z * v.x - q.x * v.z);
    const tz = 2 * (q.x * v.y - q.y * v.x);
    return vec(
        v.x + q.w * tx + q.y * tz - q.z * ty,
        v.y + q.w * ty + q.z * tx - q.x * tz,
        v.z + q.w * tz + q.x * ty - q.y * tx,
    );
}

export const X: Vector = vec(1, 0, 0);
export const Y: Vector = vec(0, 1, 0);
export const Z: Vector = vec(0, 0, 1);

/** A fixed floor with its top at y = 0. */
export function addFloor({ RAPIER, world }: Context, half = 60): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(0, -0.5, 0));
    world.createCollider(RAPIER.ColliderDesc.cuboid(half, 0.5, half), body);
    return body;
}

/** A fixed body with one collider. */
export function addFixed({ RAPIER, world }: Context, at: Vector, shape: ColliderDesc, rotation = UPRIGHT): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(at.x, at.y, at.z).setRotation(rotation));
    world.createCollider(shape, body);
    return body;
}

/** A dynamic body with one collider. */
export function add({ RAPIER, world }: Context, at: Vector, shape: ColliderDesc, rotation = UPRIGHT): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(at.x, at.y, at.z).setRotation(rotation));
    world.createCollider(shape, body);
    return body;
}

/** Four glass walls around a square of the floor. */
export function addPit(context: Context, half: number, height: number): void {
    const { RAPIER, paint } = context;
    for (const side of [-1, 1]) {
        const along = RAPIER.ColliderDesc.cuboid(half + 0.2, height / 2, 0.1);
        const across = RAPIER.ColliderDesc.cuboid(0.1, height / 2, half);
        paint(addFixed(context, vec(0, height / 2, side * (half + 0.1)), along), "glass");
        paint(addFixed(context, vec(side * (half + 0.1), height / 2, 0), across), "glass");
    }
}

/** A suspension point of a joint, which collides with nothing. */
export function addHook({ RAPIER, world, paint }: Context, at: Vector, half = 0.12): RigidBody {
    const body = world.createRigidBody(RAPIER.RigidBodyDesc.fixed().setTranslation(at.x, at.y, at.z));
    world.createCollider(RAPIER.ColliderDesc.cuboid(half, half, half).setCollisionGroups(0), body);
    paint(body, "grey");
    return body;
}

/** The corners of an irregular rock. */
export function rock({ random }: Context, radius: number, corners = 14): Float32Array {
    const points = new Float32Array(3 * corners);
    for (let corner = 0; corner < corners; corner++) {
        // Points on a spiral are well spread; a random length makes them irregular.
        const y = 1 - (2 * (corner + 0.5)) / corners;
        const angle = corner * 2.39996 + random.between(-0.3, 0.3);
        const around = Math.sqrt(1 - y * y);
        const length = radius * random.between(0.75, 1.1);
        points.set([length * around * Math.cos(angle), length * y, length * around * Math.sin(angle)], 3 * corner);
    }
    return points;
}

export function distance(a: Vector, b: Vector): number {
    return Math.hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

export function speed({ x, y, z }: Vector): number {
    return Math.hypot(x, y, z);
}
