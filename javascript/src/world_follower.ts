import { DIM, blendRotation } from "#dim";
import { type RealArray, RealArrayType } from "#real";
import { type Message, POSE, type Port, SharedSteps, type Step, listen } from "./shared_steps.js";

/**
 * Follows the world of a `WorldPublisher` in another thread: gives the poses of its bodies between the last
 * two steps, at the times of frames. It needs no `init`. A page makes one of its worker.
 */
export class WorldFollower {
    /** Numbers of a body in the poses: translation, rotation. */
    readonly poseStride = POSE;
    private readonly unlisten: () => void;
    private memory: SharedSteps | null = null;
    /** Steps of messages that no call has read yet: two at most. */
    private received: Step[] = [];
    private previous: Step | null = null;
    private last: Step | null = null;
    private blended: RealArray = new RealArrayType(0);

    constructor(port: Port) {
        this.unlisten = listen(port, (message) => this.receive(message));
        port.postMessage({ rapier: "hello" });
    }

    /** Returns whether the poses come through shared memory. */
    isShared(): boolean {
        return this.memory !== null;
    }

    /** The number of the last step that has arrived. 0 before the first one. */
    get step(): number {
        this.update();
        return this.last?.number ?? 0;
    }

    /**
     * The handle of the body in each slot, at the step of the last call of `poses` or `step`. NaN for slots
     * without a body.
     */
    get handles(): Float64Array {
        return this.last?.handles ?? new Float64Array(0);
    }

    /**
     * Translation and rotation of each body by slot, between the last two steps: one step behind the world.
     * The array is the same in each call unless the number of slots changes. The time is in milliseconds
     * since 1970.
     */
    poses(time = performance.timeOrigin + performance.now()): RealArray {
        this.update();
        const { last, previous } = this;
        if (!last) {
            return this.blended;
        }
        const share = Math.min(1, Math.max(0, (time - last.time) / last.interval));
        if (this.blended.length !== last.poses.length) {
            this.blended = new RealArrayType(last.poses.length);
        }
        this.blended.set(last.poses);
        if (previous && previous.number === last.number - 1) {
            blend(this.blended, previous, last, share);
        }
        return this.blended;
    }

    /** Releases the port. */
    free(): void {
        this.unlisten();
    }

    private receive(message: Message): void {
        if (message.rapier === "shared") {
            this.memory = new SharedSteps(message.capacity, message.buffer);
            this.received = [];
        } else if (message.rapier === "step") {
            this.memory = null;
            this.received = [...this.received.slice(-1), message.step];
        }
    }

    /** Takes the last two steps that have arrived. */
    private update(): void {
        for (const step of this.memory ? this.read(this.memory) : this.received.splice(0)) {
            this.previous = this.last;
            this.last = step;
        }
    }

    /** Copies the new ones of the last two steps from shared memory. */
    private read(memory: SharedSteps): Step[] {
        const number = memory.last();
        const known = this.last?.number ?? 0;
        // A second publisher at the same port restarts the numbers at 1.
        const first = number < known ? number - 1 : Math.max(known + 1, number - 1);
        return [first, first + 1].filter((next) => next <= number).flatMap((next) => memory.read(next) ?? []);
    }
}

/** Blends the poses of bodies that both steps have. Others stay where the last step has them. */
function blend(poses: RealArray, previous: Step, last: Step, share: number): void {
    const slots = Math.min(previous.handles.length, last.handles.length);
    for (let slot = 0; slot < slots; slot += 1) {
        if (previous.handles[slot] !== last.handles[slot]) {
            continue;
        }
        const at = slot * POSE;
        for (let component = at; component < at + DIM; component += 1) {
            const from = previous.poses[component]!;
            poses[component] = from + (last.poses[component]! - from) * share;
        }
        blendRotation(poses, at + DIM, previous.poses, last.poses, share);
    }
}
