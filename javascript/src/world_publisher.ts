import type { World } from "#world";
import { RapierError } from "./error.js";
import { canShareMemory } from "./threads.js";
import { type Port, SharedSteps, type Step, listen } from "./shared_steps.js";

/** Options of a publisher. */
export interface PublishOptions {
    /** Steps per second. The world's time step becomes the inverse. */
    rate?: number;
    /**
     * Whether poses are written to shared memory. Otherwise each step is a message. By default memory is
     * shared if the platform allows it.
     */
    shared?: boolean;
    /** Called before each step, for forces, events and inputs. */
    beforeStep?: (world: World) => void;
}

/** Most steps in a row after a delay. The time of more steps is lost. */
const STEPS_MAX = 5;
/** The least number of slots for which memory is shared. */
const CAPACITY_MIN = 64;

/**
 * Steps a world at a fixed rate, and publishes the poses of its bodies to a `WorldFollower` in another
 * thread. A worker makes one of its world and the port to its page: `self` in a browser, `parentPort` of
 * `node:worker_threads`.
 */
export class WorldPublisher {
    private readonly world: World;
    private readonly port: Port;
    private readonly interval: number;
    private readonly isShared: boolean;
    private readonly beforeStep: ((world: World) => void) | undefined;
    private readonly unlisten: () => void;
    private memory: SharedSteps | null = null;
    private number = 0;
    private timer: ReturnType<typeof setTimeout> | undefined;

    constructor(world: World, port: Port, { rate = 60, shared = canShareMemory(), beforeStep }: PublishOptions = {}) {
        if (!(rate > 0 && Number.isFinite(rate))) {
            throw new RapierError("InvalidValue", `the rate is ${rate}, but must be finite and greater than 0`);
        }
        this.world = world;
        this.port = port;
        this.interval = 1000 / rate;
        this.isShared = shared;
        this.beforeStep = beforeStep;
        world.timestep = 1 / rate;
        this.unlisten = listen(port, ({ rapier }) => {
            if (rapier === "hello") {
                this.announce();
            }
        });
    }

    /** Makes one step, and publishes it. Makes none if `beforeStep` frees the world. */
    step(): void {
        const wasAlive = this.world.isAlive();
        this.beforeStep?.(this.world);
        if (wasAlive && !this.world.isAlive()) {
            return;
        }
        this.world.step();
        this.publish();
    }

    /** Steps at the rate from now on. */
    start(): void {
        this.stop();
        let due = performance.now();
        const run = (): void => {
            const now = performance.now();
            const late = Math.max(0, Math.floor((now - due) / this.interval) + 1);
            due += late * this.interval;
            // The timer exists before the steps: `beforeStep` can stop this loop, or start another one.
            const timer = (this.timer = setTimeout(run, Math.max(0, due - now)));
            for (let left = Math.min(late, STEPS_MAX); left > 0 && this.timer === timer; left -= 1) {
                this.step();
            }
        };
        run();
    }

    /** Stops until the next `start`. */
    stop(): void {
        clearTimeout(this.timer);
        this.timer = undefined;
    }

    /** Stops, and releases the port. The world continues to exist. */
    free(): void {
        this.stop();
        this.unlisten();
    }

    private publish(): void {
        const { views } = this.world;
        const { handles, poses } = views;
        this.number += 1;
        const time = performance.timeOrigin + performance.now();
        const step = { number: this.number, time, interval: this.interval, handles, poses };
        if (this.isShared) {
            this.reserve(handles.length);
            this.memory!.write(step);
        } else {
            this.send({ ...step, handles: handles.slice(), poses: poses.slice() });
        }
    }

    private send(step: Step): void {
        this.port.postMessage({ rapier: "step", step }, [step.handles.buffer as ArrayBuffer, step.poses.buffer as ArrayBuffer]);
    }

    /** Makes larger memory if there are more slots than it has. */
    private reserve(slots: number): void {
        if (!this.memory || this.memory.capacity < slots) {
            this.memory = new SharedSteps(Math.max(CAPACITY_MIN, 2 * slots));
            this.announce();
        }
    }

    /** Passes the shared memory on. */
    private announce(): void {
        if (this.memory) {
            const { buffer, capacity } = this.memory;
            this.port.postMessage({ rapier: "shared", buffer, capacity });
        }
    }
}
