// Differences between 2D and 3D engines outside of scenes. Each package implements the interface with its own
// typings.

import type { BodyLike, ColliderLike, EngineModule, Vec, WorldLike } from "./engine.ts";

/** The result of a pick: the body under the pointer. */
export interface Hit {
    readonly body: BodyLike;
    readonly collider: ColliderLike;
    readonly point: Vec;
}

/** A spring between a body and the pointer. */
export interface Spring {
    readonly body: BodyLike;
    /** Moves the end that follows the pointer. */
    move(target: Vec): void;
    /** The anchor at the body, in world coordinates. */
    anchor(): Vec;
    target(): Vec;
    free(): void;
}

export interface Counts {
    bodies: number;
    colliders: number;
    joints: number;
}

/** The number of floats of a pose: position and quaternion. */
export const POSE_SIZE = 7;

export interface Dimension<R extends EngineModule, W extends WorldLike> {
    readonly flat: boolean;
    createWorld(module: R, gravity: number): W;
    restoreWorld(module: R, snapshot: Uint8Array): W;
    /** Runs one step. `events` and `hooks` come from the scene, whose types match the package. */
    step(world: W, events: unknown, hooks: unknown): void;
    counts(world: W): Counts;
    /** Writes position and quaternion of a collider into `out`. */
    readPose(collider: ColliderLike, out: Float32Array): void;
    /** Writes position, quaternion, linear and angular velocity of a body into an array of 13 numbers. */
    readState(body: BodyLike, out: Float64Array): void;
    /** Finds the first body along a ray; a 2D engine looks at the point where the ray meets the plane. */
    pick(module: R, world: W, origin: Vec, direction: Vec, visible: (handle: number) => boolean): Hit | null;
    createSpring(module: R, world: W, hit: Hit): Spring;
    throwBall(module: R, world: W, from: Vec, velocity: Vec, radius: number): BodyLike;
}
