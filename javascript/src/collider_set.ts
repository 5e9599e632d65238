import { requireClass, requireFunction } from "./arguments.js";
import { Collider, type ColliderHandle } from "./collider.js";
import { ColliderDescBase } from "./collider_desc.js";
import { raw } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import type { World } from "./world.js";

/** The colliders of a world. */
export class ColliderSet {
    /** @internal */
    readonly world: World;
    private readonly map = new Map<ColliderHandle, Collider>();

    /** @internal Worlds make their sets. */
    constructor(world: World) {
        this.world = world;
    }

    /** Creates a collider. */
    createCollider(_bodies: unknown, desc: ColliderDescBase, parentHandle?: RigidBodyHandle | null): Collider {
        requireClass(desc, ColliderDescBase, "desc", "a ColliderDesc");
        return this.adopt(desc.create(this.world.id, parentHandle ?? NaN), parentHandle);
    }

    /** @internal The object of a collider that is in the module. */
    adopt(handle: ColliderHandle, parent: RigidBodyHandle | null | undefined): Collider {
        const body = parent === null || parent === undefined ? null : this.world.bodies.get(parent);
        const collider = new Collider(this.world, handle, body);
        this.map.set(handle, collider);
        return collider;
    }

    /** Removes a collider. A stale handle has no effect, as any in a freed world. */
    remove(handle: ColliderHandle, _islands?: unknown, _bodies?: unknown, wakeUp = true): void {
        if (!this.world.isAlive()) {
            return;
        }
        raw.collider_remove(this.world.id, handle, +wakeUp);
        this.map.delete(handle);
    }

    /** Removes the object of a collider that the module no longer contains. */
    unmap(handle: ColliderHandle): void {
        this.map.delete(handle);
    }

    /** The collider of a handle, or null. */
    get(handle: ColliderHandle): Collider | null {
        return this.map.get(handle) ?? null;
    }

    /** The number of colliders. */
    len(): number {
        return this.map.size;
    }

    /** Returns whether a handle finds a collider. */
    contains(handle: ColliderHandle): boolean {
        return this.map.has(handle);
    }

    /** Calls a function with each collider. */
    forEach(f: (collider: Collider) => void): void {
        requireFunction(f, "f");
        this.map.forEach((collider) => f(collider));
    }

    /** All colliders. */
    getAll(): Collider[] {
        return [...this.map.values()];
    }

    /** A function of handles made from a function of colliders. */
    castClosure<Res>(f?: (collider: Collider) => Res): ((handle: ColliderHandle) => Res | undefined) | undefined {
        return f && ((handle) => f(this.get(handle)!));
    }

    /** @internal */
    clear(): void {
        this.map.clear();
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}
