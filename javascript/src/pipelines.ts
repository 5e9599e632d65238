// Names of the published packages. The world does their work.

import type { Vector } from "#dim";
import { World as OwnWorld } from "#world";
import { RapierError } from "./error.js";
import { EventQueue } from "./event_queue.js";
import type { PhysicsHooks } from "./hooks.js";
import type { RigidBodySet } from "./rigid_body_set.js";
import type { World } from "./world.js";

/** Continuous collision detection. Its state is part of the world. */
export class CCDSolver {
    /** Does nothing: the world owns the memory. */
    free(): void {}
}

/** The world of a set among arguments. */
function worldOf(bodies: RigidBodySet): World {
    if (!bodies?.world) {
        throw new RapierError("Unsupported", "the sets of a pipeline must be those of a World");
    }
    return bodies.world;
}

/** Steps a world through its sets. `World.step` is shorter. */
export class PhysicsPipeline {
    /**
     * Moves the world of the sets forward by one time step. The last arguments may be an event queue and
     * hooks.
     */
    step(
        gravity: Vector,
        _integrationParameters: unknown,
        _islands: unknown,
        _broadPhase: unknown,
        _narrowPhase: unknown,
        bodies: RigidBodySet,
        ...rest: unknown[]
    ): void {
        const world = worldOf(bodies);
        const queue = rest.find((part) => part instanceof EventQueue) as EventQueue | undefined;
        const isHooks = (part: unknown) => typeof part === "object" && part !== null && "filterContactPair" in part;
        const before = world.gravity;
        world.gravity = gravity;
        try {
            world.step(queue, rest.find(isHooks) as PhysicsHooks | undefined);
        } finally {
            world.gravity = before;
        }
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}

/** Saves a world through its sets. `World.takeSnapshot` is shorter. */
export class SerializationPipeline {
    /** Saves the world of the sets with the given gravity. */
    serializeAll(
        gravity: Vector,
        _integrationParameters: unknown,
        _islands: unknown,
        _broadPhase: unknown,
        _narrowPhase: unknown,
        bodies: RigidBodySet,
        ..._rest: unknown[]
    ): Uint8Array {
        const world = worldOf(bodies);
        const before = world.gravity;
        world.gravity = gravity;
        try {
            return world.takeSnapshot();
        } finally {
            world.gravity = before;
        }
    }

    /** A world from a snapshot. */
    deserializeAll(data: Uint8Array): OwnWorld {
        return OwnWorld.restoreSnapshot(data);
    }

    /** Does nothing: the world owns the memory. */
    free(): void {}
}
