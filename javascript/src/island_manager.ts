import { requireFunction } from "./arguments.js";
import { listCopy, raw } from "./raw.js";
import type { RigidBodyHandle } from "./rigid_body.js";
import type { World } from "./world.js";

/** The bodies that are awake. */
export class IslandManager {
    private readonly world: World;

    /** @internal Worlds make theirs. */
    constructor(world: World) {
        this.world = world;
    }

    /** Calls a function with the handle of each body that is awake and not fixed. */
    forEachActiveRigidBodyHandle(f: (handle: RigidBodyHandle) => void): void {
        requireFunction(f, "f");
        listCopy(raw.bodies_list_active(this.world.id)).forEach((handle) => f(handle));
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}
