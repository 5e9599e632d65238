import { RigidBody, RigidBodyDesc } from "#rigid_body";
import { requireClass, requireFunction } from "./arguments.js";
import { listCopy, raw } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import type { World } from "./world.js";

/** The rigid bodies of a world. */
export class RigidBodySet {
    /** @internal */
    readonly world: World;
    private readonly map = new Map<RigidBodyHandle, RigidBody>();

    /** @internal Worlds make their sets. */
    constructor(world: World) {
        this.world = world;
    }

    /** Creates a body. */
    createRigidBody(_colliders: unknown, desc: RigidBodyDesc): RigidBody {
        requireClass(desc, RigidBodyDesc, "body", "a RigidBodyDesc");
        return this.adopt(desc.create(this.world.id), desc);
    }

    /** @internal The object of a body that is in the module. */
    adopt(handle: RigidBodyHandle, desc?: RigidBodyDesc): RigidBody {
        const body = new RigidBody(this.world, handle, desc);
        this.map.set(handle, body);
        return body;
    }

    /** Removes a body with its colliders and joints. A stale handle has no effect, as any in a freed world. */
    remove(handle: RigidBodyHandle): void {
        if (!this.world.isAlive()) {
            return;
        }
        const groups = listCopy(raw.body_remove(this.world.id, handle));
        this.map.delete(handle);
        const sets = [this.world.colliders, this.world.impulseJoints, this.world.multibodyJoints];
        let at = 0;
        for (const set of groups.length === 0 ? [] : sets) {
            const end = at + 1 + groups[at]!;
            for (at += 1; at < end; at += 1) {
                set.unmap(groups[at]!);
            }
        }
    }

    /** The number of bodies. */
    len(): number {
        return this.map.size;
    }

    /** Returns whether a handle finds a body. */
    contains(handle: RigidBodyHandle): boolean {
        return this.map.has(handle);
    }

    /** The body of a handle, or null. */
    get(handle: RigidBodyHandle): RigidBody | null {
        return this.map.get(handle) ?? null;
    }

    /** Calls a function with each body. */
    forEach(f: (body: RigidBody) => void): void {
        requireFunction(f, "f");
        this.map.forEach((body) => f(body));
    }

    /** Calls a function with each body that is awake and not fixed. */
    forEachActiveRigidBody(_islands: unknown, f: (body: RigidBody) => void): void {
        requireFunction(f, "f");
        this.world.islands.forEachActiveRigidBodyHandle((handle) => {
            // The function may remove bodies.
            const body = this.get(handle);
            if (body) {
                f(body);
            }
        });
    }

    /** All bodies. */
    getAll(): RigidBody[] {
        return [...this.map.values()];
    }

    /** @internal */
    clear(): void {
        this.map.clear();
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}
