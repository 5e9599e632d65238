// Threads of the module: workers that share its memory. crates/wasm/src/threads.rs is the other side.

import { RapierError } from "./error.js";
import type { Raw } from "./raw.js";
import type { Start } from "./thread_worker.js";

/** Whether the package contains the module with threads: the build writes it. */
declare const HAS_THREADS: boolean;
/** The text of thread_worker.ts: the build writes it. */
declare const THREAD_PROGRAM: string;

/** The most threads: as many as the engine uses. */
const THREADS_MAX = 64;
/** Pages of 64 KiB of the shared memory at first, as in crates/wasm/build.sh. */
const PAGES_INITIAL = 256;
/** The most pages. A device that refuses the address space for the larger number may have the smaller one. */
const PAGES_MAX = [32768, 8192];
/** Bytes of the stack of a worker. */
const STACK_BYTES = 1 << 20;

/** A worker, as its starter uses it. */
export interface ThreadWorker {
    /** Sends the start. */
    postMessage(start: Start): void;
    /** Resolves when the worker runs, and fails with the first error. */
    ready: Promise<unknown>;
    /** Ends the worker. */
    terminate(): void;
}

/** A platform's support of threads. */
export interface Workers {
    /** Starts a worker with a program. */
    start(program: string): ThreadWorker;
    /** The number of cores. */
    cores(): number;
}

/** Returns whether the platform lets threads share memory. */
export function canShareMemory(): boolean {
    return typeof SharedArrayBuffer !== "undefined" && (globalThis as { crossOriginIsolated?: boolean }).crossOriginIsolated !== false;
}

/**
 * The number of threads that the package and the platform support, up to `wanted`. 0 requests one per core.
 */
export function supportedThreads(wanted: number, workers: Workers | undefined): number {
    if (!(Number.isInteger(wanted) && wanted >= 0 && wanted <= THREADS_MAX)) {
        throw new RapierError("InvalidValue", `threads is ${wanted}, but must be an integer from 0 to ${THREADS_MAX}`);
    }
    // The thread of a page must not block, and the module's locks block.
    const isPage = typeof document !== "undefined";
    if (!HAS_THREADS || !workers || isPage || !canShareMemory()) {
        return 1;
    }
    return wanted === 0 ? Math.min(workers.cores(), THREADS_MAX) : wanted;
}

/** Memory for a module with threads. */
export function sharedMemory(): WebAssembly.Memory {
    let refusal: unknown;
    for (const maximum of PAGES_MAX) {
        try {
            return new WebAssembly.Memory({ initial: PAGES_INITIAL, maximum, shared: true });
        } catch (error) {
            refusal = error;
        }
    }
    throw unsupported("shared memory cannot be reserved", refusal);
}

/** Starts the workers of a module: each waits for a thread of the pool. If one fails, all end. */
export async function startWorkers(raw: Raw, module: WebAssembly.Module, count: number, platform: Workers): Promise<ThreadWorker[]> {
    const workers: ThreadWorker[] = [];
    try {
        while (workers.length < count) {
            const stackTop = allocate(raw, STACK_BYTES, 16) + STACK_BYTES;
            const storage = allocate(raw, raw.__tls_size!.value as number, raw.__tls_align!.value as number);
            const worker = platform.start(THREAD_PROGRAM);
            workers.push(worker);
            worker.postMessage({ module, memory: raw.memory, stackTop, storage });
        }
        await Promise.all(workers.map(({ ready }) => ready));
        return workers;
    } catch (error) {
        workers.forEach((worker) => worker.terminate());
        await Promise.allSettled(workers.map(({ ready }) => ready));
        throw unsupported("a thread cannot be started", error);
    }
}

function allocate(raw: Raw, bytes: number, align: number): number {
    const address = raw.thread_memory(bytes, align) >>> 0;
    if (address === 0) {
        throw new Error(`the memory has no ${bytes} bytes for a thread`);
    }
    return address;
}

function unsupported(what: string, error: unknown): RapierError {
    const { message } = error as Partial<Error>;
    return new RapierError("Unsupported", message ? `${what}: ${message}` : what);
}

/** The workers of a browser or of Deno, from a scope that has some. */
export function webWorkers(): Workers | undefined {
    if (typeof Worker === "undefined" || typeof navigator === "undefined") {
        return undefined;
    }
    return {
        start(program) {
            const url = URL.createObjectURL(new Blob([`const scope = self; ${program}`], { type: "text/javascript" }));
            const worker = new Worker(url, { type: "module", name: "rapier" });
            const ready = new Promise((resolve, reject) => {
                worker.onmessage = resolve;
                worker.onerror = reject;
            }).finally(() => URL.revokeObjectURL(url));
            return { postMessage: (start) => worker.postMessage(start), ready, terminate: () => worker.terminate() };
        },
        cores: () => navigator.hardwareConcurrency ?? 1,
    };
}
