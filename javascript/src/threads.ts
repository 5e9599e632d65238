// Threads of the module: workers that share its memory. crates/wasm/src/threads.rs is the other side.

import { RapierError } from "./error.js";
import type { Raw } from "./raw.js";

/** The most threads: as many as the engine uses. */
const THREADS_MAX = 64;
/** Pages of 64 KiB of the shared memory, as in crates/wasm/build.sh. */
const PAGES = { initial: 256, maximum: 32768, shared: true };
/** Bytes of the stack of a worker. */
const STACK_BYTES = 1 << 20;

/** The end of a worker that starts it: `postMessage` and the first answer. */
export interface ThreadWorker {
    /** Sends the start. */
    postMessage(start: unknown): void;
    /** Resolves with the first message, and fails with the first error. */
    ready: Promise<unknown>;
}

/** Returns whether the platform lets threads share memory. */
export function canShareMemory(): boolean {
    return typeof SharedArrayBuffer !== "undefined" && (globalThis as { crossOriginIsolated?: boolean }).crossOriginIsolated !== false;
}

/** The number of threads that the platform supports, of those that are wanted. 0 wants one per core. */
export function supportedThreads(wanted: number, cores: () => number): number {
    if (!(Number.isInteger(wanted) && wanted >= 0 && wanted <= THREADS_MAX)) {
        throw new RapierError("InvalidValue", `threads is ${wanted}, but must be an integer from 0 to ${THREADS_MAX}`);
    }
    // The thread of a page must not block, and the module's locks block.
    const isPage = typeof document !== "undefined";
    if (isPage || !canShareMemory()) {
        return 1;
    }
    return wanted === 0 ? Math.min(cores(), THREADS_MAX) : wanted;
}

/** Memory for a module with threads. */
export function sharedMemory(): WebAssembly.Memory {
    return new WebAssembly.Memory(PAGES);
}

/** The cores of a browser's machine, as far as the browser tells. */
export function webCores(): number {
    return navigator.hardwareConcurrency ?? 1;
}

/** Creates the threads of a module. One is the calling thread, each other one a worker. */
export async function startThreads(raw: Raw, module: WebAssembly.Module, count: number, startWorker: (script: string) => ThreadWorker): Promise<void> {
    const workers = Array.from({ length: count - 1 }, () => {
        const stack = raw.thread_memory(STACK_BYTES, 16) >>> 0;
        const storage = raw.thread_memory(raw.__tls_size!.value as number, raw.__tls_align!.value as number) >>> 0;
        const worker = startWorker(String(runThread));
        worker.postMessage({ module, memory: raw.memory, stackTop: stack + STACK_BYTES, storage });
        return worker.ready;
    });
    await Promise.all(workers);
    raw.threads_create(count);
}

/** Starts a worker of a browser or of Deno. */
export function startWebWorker(script: string): ThreadWorker {
    const url = URL.createObjectURL(new Blob([`(${script})(self)`], { type: "text/javascript" }));
    const worker = new Worker(url, { type: "module", name: "rapier" });
    const ready = new Promise((resolve, reject) => {
        worker.onmessage = resolve;
        worker.onerror = reject;
    }).finally(() => URL.revokeObjectURL(url));
    return { postMessage: (start) => worker.postMessage(start), ready };
}

/** What a worker receives. */
interface Start {
    module: WebAssembly.Module;
    memory: WebAssembly.Memory;
    stackTop: number;
    storage: number;
}

/** The worker's end of its connection, in browsers and in Node.js. */
interface ThreadScope {
    postMessage(message: unknown): void;
    onmessage?: (event: { data: Start }) => void;
    once?(event: "message", listener: (start: Start) => void): void;
}

/** The program of a worker. It is sent as text, so it names nothing outside of itself. */
function runThread(scope: ThreadScope): void {
    const run = ({ module, memory, stackTop, storage }: Start): void => {
        const fail = (_kind: number, address: number, length: number): never => {
            throw new Error(new TextDecoder().decode(new Uint8Array(memory.buffer, address, length).slice()));
        };
        const unreachable = (): never => {
            throw new Error("JavaScript runs on the thread that loads the module");
        };
        const rapier = { fail, warn: () => undefined, now: () => performance.now(), accepts: unreachable, visit: unreachable, hook: unreachable };
        const raw = new WebAssembly.Instance(module, { rapier, env: { memory } }).exports as unknown as Raw;
        raw.__stack_pointer.value = stackTop;
        raw.__wasm_init_tls!(storage);
        scope.postMessage("ready");
        raw.thread_run();
    };
    if (scope.once) {
        scope.once("message", run);
    } else {
        scope.onmessage = ({ data }) => run(data);
    }
}
