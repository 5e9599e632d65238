import { DIM, type Vector, vectorAt } from "#dim";
import { requireFunction } from "./arguments.js";
import type { ColliderHandle } from "./collider.js";
import { RapierError } from "./error.js";
import { Owner } from "./owner.js";
import { listCopy, raw, realsCopy } from "./raw.js";
import type { RealArray } from "#real";

/** Numbers of a contact force event: two vectors, each with its magnitude. */
const STRIDE = 2 * (DIM + 1);

/** A strong contact force between two colliders. It is valid while the callback runs. */
export class TempContactForceEvent {
    /** @internal */
    handles: Float64Array = new Float64Array(0);
    /** @internal */
    numbers: RealArray | undefined;
    /** @internal */
    index = 0;

    private values(): RealArray {
        if (!this.numbers) {
            throw new RapierError("Freed", "the contact force event is used after its callback");
        }
        return this.numbers;
    }

    /** The first collider. */
    collider1(): ColliderHandle {
        this.values();
        return this.handles[2 * this.index]!;
    }

    /** The second collider. */
    collider2(): ColliderHandle {
        this.values();
        return this.handles[2 * this.index + 1]!;
    }

    /** The sum of the contact forces. */
    totalForce(target?: Vector): Vector {
        return vectorAt(this.values(), STRIDE * this.index, target);
    }

    /** The sum of the magnitudes of the contact forces. */
    totalForceMagnitude(): number {
        return this.values()[STRIDE * this.index + DIM]!;
    }

    /** The direction of the largest contact force. */
    maxForceDirection(target?: Vector): Vector {
        return vectorAt(this.values(), STRIDE * this.index + DIM + 1, target);
    }

    /** The largest contact force. */
    maxForceMagnitude(): number {
        return this.values()[STRIDE * this.index + 2 * DIM + 1]!;
    }

    /** Ends the use of the event. */
    free(): void {
        this.numbers = undefined;
    }
}

/** Collects the events of steps. */
export class EventQueue extends Owner {
    /** With `autoDrain`, each step begins with an empty queue. */
    constructor(autoDrain: boolean) {
        super(raw.queue_new(+autoDrain), (id) => raw.queue_free(id));
    }

    /** Calls a function with each collision that started or stopped, and removes them. */
    drainCollisionEvents(f: (handle1: ColliderHandle, handle2: ColliderHandle, started: boolean) => void): void {
        requireFunction(f, "f");
        const events = this.takeCollisionEvents();
        for (let at = 0; at < events.length; at += 3) {
            f(events[at]!, events[at + 1]!, events[at + 2] !== 0);
        }
    }

    /**
     * Removes and returns the collisions that started or stopped. Each has three numbers: two handles, then 1
     * for a start and 0 for an end.
     */
    takeCollisionEvents(): Float64Array {
        return listCopy(raw.queue_take_collisions(this.id));
    }

    /** Calls a function with each strong contact force, and removes them. */
    drainContactForceEvents(f: (event: TempContactForceEvent) => void): void {
        requireFunction(f, "f");
        const count = raw.queue_take_forces(this.id) / 2;
        if (count === 0) {
            return;
        }
        const event = new TempContactForceEvent();
        event.handles = listCopy(2 * count);
        const numbers = realsCopy();
        try {
            for (event.index = 0; event.index < count; event.index += 1) {
                event.numbers = numbers;
                f(event);
            }
        } finally {
            event.free();
        }
    }

    /** Discards all events. */
    clear(): void {
        raw.queue_clear(this.id);
    }
}
