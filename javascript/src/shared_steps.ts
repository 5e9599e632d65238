// Poses of the last steps in memory that two threads share.

import { DIM, ROTATION } from "#dim";
import { type RealArray, RealArrayType } from "#real";

/** Numbers of a pose: translation, rotation. */
export const POSE = DIM + ROTATION;

/** The poses of one step. */
export interface Step {
    /** Counts steps from 1. */
    number: number;
    /** When the step was published, in milliseconds since 1970. */
    time: number;
    /** Milliseconds from step to step. */
    interval: number;
    /** The handle of the body in each slot. NaN for slots without a body. */
    handles: Float64Array;
    /** Translation and rotation of each body, by slot. */
    poses: RealArray;
}

/** Messages between publishers and followers. Other messages through the same port are ignored. */
export type Message =
    | { rapier: "hello" }
    | { rapier: "shared"; buffer: SharedArrayBuffer; capacity: number }
    | { rapier: "step"; step: Step };

/** A worker, the scope of a worker, or a message port: of a browser or of Node.js. */
export interface Port {
    postMessage(message: unknown, transfer?: ArrayBuffer[]): void;
    addEventListener?(type: "message", listener: (event: { data: unknown }) => void): void;
    removeEventListener?(type: "message", listener: (event: { data: unknown }) => void): void;
    on?(type: "message", listener: (data: unknown) => void): unknown;
    off?(type: "message", listener: (data: unknown) => void): unknown;
    start?(): void;
}

/** Calls a function with each message of this kind. Returns a function that ends this. */
export function listen(port: Port, receive: (message: Message) => void): () => void {
    const accept = (data: unknown): void => {
        if (typeof (data as Message | null)?.rapier === "string") {
            receive(data as Message);
        }
    };
    if (port.on && port.off) {
        port.on("message", accept);
        return () => port.off!("message", accept);
    }
    const listener = (event: { data: unknown }): void => accept(event.data);
    port.addEventListener?.("message", listener);
    port.start?.();
    return () => port.removeEventListener?.("message", listener);
}

/** The steps that the memory holds. While one is written, the two before it can be read. */
const STEPS = 3;
/** The words of the header: the last step whose writing has begun, and the last one that is written. */
const [BEGUN, WRITTEN] = [0, 1];
/** Numbers before the handles of a step: its own number, time, interval and the number of slots. */
const NOTES = 4;
const [NUMBER, TIME, INTERVAL, LENGTH] = [0, 1, 2, 3];
const HEADER_BYTES = 8;

/** Memory for the last steps of a world. One thread writes, others read. */
export class SharedSteps {
    readonly buffer: SharedArrayBuffer;
    /** Most slots of bodies. */
    readonly capacity: number;
    private readonly header: Int32Array;
    private readonly steps: { notes: Float64Array; handles: Float64Array; poses: RealArray }[];

    constructor(capacity: number, buffer?: SharedArrayBuffer) {
        const notes = 8 * (NOTES + capacity);
        const bytes = notes + 8 * Math.ceil((capacity * POSE * RealArrayType.BYTES_PER_ELEMENT) / 8);
        this.capacity = capacity;
        this.buffer = buffer ?? new SharedArrayBuffer(HEADER_BYTES + STEPS * bytes);
        this.header = new Int32Array(this.buffer, 0, HEADER_BYTES / 4);
        this.steps = Array.from({ length: STEPS }, (_, index) => {
            const start = HEADER_BYTES + index * bytes;
            return {
                notes: new Float64Array(this.buffer, start, NOTES),
                handles: new Float64Array(this.buffer, start + 8 * NOTES, capacity),
                poses: new RealArrayType(this.buffer as unknown as ArrayBuffer, start + notes, capacity * POSE),
            };
        });
    }

    /** Writes a step. It must have a place for each of its slots. */
    write({ number, time, interval, handles, poses }: Step): void {
        const to = this.steps[number % STEPS]!;
        Atomics.store(this.header, BEGUN, number);
        to.notes[NUMBER] = number;
        to.notes[TIME] = time;
        to.notes[INTERVAL] = interval;
        to.notes[LENGTH] = handles.length;
        to.handles.set(handles);
        to.poses.set(poses);
        Atomics.store(this.header, WRITTEN, number);
    }

    /** The number of the last step. 0 before the first one. */
    last(): number {
        return Atomics.load(this.header, WRITTEN);
    }

    /**
     * Copies a step. Null if this memory does not contain it yet or any more, or a write overlaps the copy.
     */
    read(number: number): Step | null {
        if (number < 1 || number > this.last()) {
            return null;
        }
        const { notes, handles, poses } = this.steps[number % STEPS]!;
        // Memory that has just replaced a smaller one contains none of the steps before.
        if (notes[NUMBER] !== number) {
            return null;
        }
        const length = Math.min(notes[LENGTH]!, this.capacity);
        const step = {
            number,
            time: notes[TIME]!,
            interval: notes[INTERVAL]!,
            handles: handles.slice(0, length),
            poses: poses.slice(0, length * POSE),
        };
        return Atomics.load(this.header, BEGUN) < number + STEPS ? step : null;
    }
}
