import { type Vector, getVector } from "#dim";
import { integer, requireFunction } from "./arguments.js";
import type { ColliderHandle } from "./collider.js";
import { getNumber, integersCopy, listCopy, raw } from "./raw.js";
import type { World } from "./world.js";

/** A contact manifold of a pair. It is valid while the callback runs. */
export class TempContactManifold {
    private readonly world: World;
    private readonly handles: readonly [ColliderHandle, ColliderHandle];
    private readonly index: number;

    /** @internal */
    constructor(world: World, handles: readonly [ColliderHandle, ColliderHandle], index: number) {
        this.world = world;
        this.handles = handles;
        this.index = index;
    }

    private read(): void {
        raw.manifold_read(this.world.id, this.handles[0], this.handles[1], this.index);
    }

    private contact(i: number): boolean {
        return raw.manifold_contact(this.world.id, this.handles[0], this.handles[1], this.index, integer(i, "i")) !== 0;
    }

    /** The normal in world space, from the first collider to the second one. */
    normal(target?: Vector): Vector {
        this.read();
        return getVector(0, target);
    }

    /** The normal in the frame of the first collider. */
    localNormal1(target?: Vector): Vector {
        this.read();
        return getVector(1, target);
    }

    /** The normal in the frame of the second collider. */
    localNormal2(target?: Vector): Vector {
        this.read();
        return getVector(2, target);
    }

    /** The part of the first collider that touches. */
    subshape1(): number {
        this.read();
        return integersCopy()[0]!;
    }

    /** The part of the second collider that touches. */
    subshape2(): number {
        this.read();
        return integersCopy()[1]!;
    }

    /** The number of contact points. */
    numContacts(): number {
        this.read();
        return getNumber(3, 2);
    }

    /** A contact point in the frame of the first collider. */
    localContactPoint1(i: number, target?: Vector): Vector | null {
        return this.contact(i) ? getVector(0, target) : null;
    }

    /** A contact point in the frame of the second collider. */
    localContactPoint2(i: number, target?: Vector): Vector | null {
        return this.contact(i) ? getVector(1, target) : null;
    }

    /** The distance of the two surfaces at a contact point. Negative if they overlap. */
    contactDist(i: number): number {
        return this.contact(i) ? getNumber(2, 0) : 0;
    }

    /** The feature of the first collider at a contact point. */
    contactFid1(i: number): number {
        return this.contact(i) ? integersCopy()[0]! : 0;
    }

    /** The feature of the second collider at a contact point. */
    contactFid2(i: number): number {
        return this.contact(i) ? integersCopy()[1]! : 0;
    }

    /** The impulse along the normal in the last step. */
    contactImpulse(i: number): number {
        return this.contact(i) ? getNumber(2, 1) : 0;
    }

    /** The friction impulse along the tangent (2D). */
    contactTangentImpulse(i: number): number {
        return this.contact(i) ? getNumber(2, 2) : 0;
    }

    /** The friction impulse along the first tangent. */
    contactTangentImpulseX(i: number): number {
        return this.contactTangentImpulse(i);
    }

    /** The friction impulse along the second tangent. */
    contactTangentImpulseY(i: number): number {
        return this.contact(i) ? getNumber(2, 3) : 0;
    }

    /** The number of points that the solver used. */
    numSolverContacts(): number {
        this.read();
        return getNumber(3, 3);
    }

    /** A point that the solver used, in world space. */
    solverContactPoint(i: number, target?: Vector): Vector | null {
        return this.contact(i) ? getVector(3, target) : null;
    }

    /** The distance at a point that the solver used. */
    solverContactDist(i: number): number {
        return this.contactDist(i);
    }

    /** The coefficient of friction. */
    friction(): number {
        this.read();
        return getNumber(3, 0);
    }

    /** The coefficient of restitution. */
    restitution(): number {
        this.read();
        return getNumber(3, 1);
    }

    /** The velocity of the surface, as of a conveyor belt. */
    solverContactTangentVelocity(_i: number, target?: Vector): Vector {
        this.read();
        return getVector(4, target);
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}

/** The contacts and intersections of a world, as of its last step. */
export class NarrowPhase {
    private readonly world: World;

    /** @internal Worlds make theirs. */
    constructor(world: World) {
        this.world = world;
    }

    /** Calls a function with each collider that has a contact pair with a collider. */
    contactPairsWith(collider1: ColliderHandle, f: (collider2: ColliderHandle) => void): void {
        requireFunction(f, "f");
        listCopy(raw.contacts_with(this.world.id, collider1)).forEach((handle) => f(handle));
    }

    /** Calls a function with each collider that intersects a collider, one of them a sensor. */
    intersectionPairsWith(collider1: ColliderHandle, f: (collider2: ColliderHandle) => void): void {
        requireFunction(f, "f");
        listCopy(raw.intersections_with(this.world.id, collider1)).forEach((handle) => f(handle));
    }

    /**
     * Calls a function with each manifold of a pair. `flipped` is true if the manifold has the colliders in
     * the other order.
     */
    contactPair(
        collider1: ColliderHandle,
        collider2: ColliderHandle,
        _bodies: unknown,
        f: (manifold: TempContactManifold, flipped: boolean) => void,
    ): void {
        requireFunction(f, "f");
        const count = raw.manifold_count(this.world.id, collider1, collider2);
        const flipped = integersCopy()[0] !== 0;
        for (let index = 0; index < count; index += 1) {
            f(new TempContactManifold(this.world, [collider1, collider2], index), flipped);
        }
    }

    /** Returns whether two colliders, one of them a sensor, intersect. */
    intersectionPair(collider1: ColliderHandle, collider2: ColliderHandle): boolean {
        return raw.intersection_exists(this.world.id, collider1, collider2) !== 0;
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}
