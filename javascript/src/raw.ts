// The WebAssembly module: loading, imports, and the shared memory.

import { requireList, wrong } from "./arguments.js";
import { RapierError } from "./error.js";
import type { Functions } from "./functions.js";
import { type RealArray, RealArrayType } from "#real";
import { type Workers, sharedMemory, startWorkers, supportedThreads } from "./threads.js";

/** The module's exports. */
export interface Raw extends Functions {
    /** The linear memory. */
    readonly memory: WebAssembly.Memory;
    /** The top of the module's stack. */
    readonly __stack_pointer: WebAssembly.Global;
    /** The size, the alignment and the start of thread-local storage, in a module with threads. */
    readonly __tls_size?: WebAssembly.Global;
    readonly __tls_align?: WebAssembly.Global;
    __wasm_init_tls?(address: number): void;
}

/** Options of `init`. */
export interface InitOptions {
    /** The module, its bytes, or their address. Default: the file of the package. */
    module?: WebAssembly.Module | BufferSource | Response | URL | string;
    /** Whether the module with SIMD is used. Default: if the platform has SIMD. */
    simd?: boolean;
    /**
     * Threads that step worlds together, 0 for one per core. Default: 1. Results do not depend on the number.
     * More than one need the module with threads and SIMD, and Node.js or a worker of a page that is
     * cross-origin isolated. Elsewhere one is used: `threads` returns the number. A world with hooks is
     * stepped on one thread.
     */
    threads?: number;
}

/** The modules of a package. */
export type ModuleKind = "simd" | "scalar" | "threads";

/** Their files, beside the entries. */
export const FILES = { simd: "./rapier_simd.wasm", scalar: "./rapier.wasm", threads: "./rapier_threads.wasm" } as const;

/** The end of errors about missing files. */
export const COPY_HINT = "Copy the file from the package, or pass its bytes or address: init({ module }).";

/** Source of an entry's module. */
export interface Source {
    /** Loads the module. */
    load(kind: ModuleKind): Promise<WebAssembly.Module | BufferSource | Response>;
    /** Loads the module at once, where the platform can. */
    loadNow?(kind: ModuleKind): BufferSource;
    /** The platform's support of threads, if there is any. */
    workers?: Workers | undefined;
}

let source: Source | undefined;
let loading: Promise<void> | undefined;
let exportsOfModule: Raw | undefined;
let threadCount = 1;

/** The first use of a function before `init` ends here. */
const uninitialized = new Proxy({} as Raw, {
    get(_, name) {
        if (source?.loadNow) {
            instantiateNow(source.loadNow(kindOf(1)));
            return raw[name as keyof Raw];
        }
        throw new RapierError("NotInitialized", "the engine is not loaded yet: call and await init() first");
    },
});

/** The functions of the module. */
export let raw: Raw = uninitialized;

/** Sets the source of the module. */
export function setSource(entry: Source): void {
    source = entry;
}

/** Returns whether the platform has the SIMD instructions of WebAssembly. */
export function hasSimd(): boolean {
    // A function that returns the sum of two vectors of zeros.
    const bytes = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];
    return WebAssembly.validate(new Uint8Array(bytes));
}

/** The number of threads that step worlds. */
export function threads(): number {
    return threadCount;
}

function kindOf(count: number, simd = hasSimd()): ModuleKind {
    return count > 1 ? "threads" : simd ? "simd" : "scalar";
}

/** Loads the module. Later calls wait for the first one. */
export function load(options: InitOptions = {}): Promise<void> {
    if (exportsOfModule && !loading) {
        return Promise.resolve();
    }
    loading ??= instantiate(options).catch((error: unknown) => {
        loading = undefined;
        throw error;
    });
    return loading;
}

async function instantiate(options: InitOptions): Promise<void> {
    const simd = options.simd ?? hasSimd();
    const wanted = simd ? supportedThreads(options.threads ?? 1, source?.workers) : 1;
    const module = await compile(options, kindOf(wanted, simd));
    const isShared = WebAssembly.Module.imports(module).some(({ kind }) => kind === "memory");
    const memory = isShared ? { env: { memory: sharedMemory() } } : {};
    const instance = await WebAssembly.instantiate(module, { rapier: imported, ...memory });
    if (!isShared || wanted === 1) {
        begin(instance);
        return;
    }
    const workers = await startWorkers(instance.exports as unknown as Raw, module, wanted - 1, source!.workers!);
    if (!begin(instance)) {
        workers.forEach((worker) => worker.terminate());
        throw new RapierError("NotInitialized", "the engine was used before init() with threads had ended: await init() first");
    }
    // In the same turn: no step comes before the pool.
    raw.threads_create(wanted);
    threadCount = raw.threads_count();
}

/** The first bytes of a module: a zero, and `asm`. */
const MAGIC = 0x0061736d;

/** The module that the options or the package supply. */
async function compile(options: InitOptions, kind: ModuleKind): Promise<WebAssembly.Module> {
    let module = options.module;
    if (typeof module === "string" || module instanceof URL) {
        module = await fetch(module).catch((error: unknown) => {
            throw new RapierError("NotInitialized", `the module cannot be fetched: ${String(error)}, ${String(options.module)}. ${COPY_HINT}`);
        });
    }
    if (module === undefined) {
        if (!source) {
            throw new RapierError("NotInitialized", "this entry of the package has no module: pass init({ module })");
        }
        module = await source.load(kind);
    }
    if (typeof Response !== "undefined" && module instanceof Response) {
        if (!module.ok) {
            throw new RapierError("NotInitialized", `the module cannot be fetched: ${module.status} ${module.url}. ${COPY_HINT}`);
        }
        const [{ url }, bytes] = [module, await module.arrayBuffer()];
        // Development servers answer with a page where a file is missing.
        if (bytes.byteLength < 4 || new DataView(bytes).getUint32(0) !== MAGIC) {
            throw new RapierError("NotInitialized", `the file ${url} is no WebAssembly module. ${COPY_HINT}`);
        }
        module = bytes;
    }
    return module instanceof WebAssembly.Module ? module : WebAssembly.compile(module as BufferSource);
}

function instantiateNow(bytes: BufferSource): void {
    begin(new WebAssembly.Instance(new WebAssembly.Module(bytes), { rapier: imported }));
}

/** Makes an instance the engine, if there is none. Returns whether it became the engine. */
function begin(instance: WebAssembly.Instance): boolean {
    if (exportsOfModule) {
        return false;
    }
    exportsOfModule = instance.exports as unknown as Raw;
    raw = exportsOfModule;
    stackFloor = raw.__stack_pointer.value as number;
    raw.start();
    return true;
}

// ---- Memory ----

/** Numbers of a place of the scratch block. */
const PLACE = 4;
/** Numbers of the scratch block. */
const SCRATCH = PLACE * 24;

let scratchView: RealArray = new RealArrayType(0);

/** The scratch block: place `p` begins at `4 * p`. */
export function scratch(): RealArray {
    // A view of memory that has grown has no elements any more. A view of shared memory stays valid.
    if (scratchView.length === 0) {
        scratchView = new RealArrayType(raw.memory.buffer, raw.scratch_address(), SCRATCH);
    }
    return scratchView;
}

/** Writes a number of the scratch block. */
export function putNumber(place: number, component: number, value: number): void {
    scratch()[PLACE * place + component] = value;
}

/** Reads a number of the scratch block. */
export function getNumber(place: number, component: number): number {
    return scratch()[PLACE * place + component]!;
}

/** The list of numbers of the last call. It is valid until the next call. */
export function list(length: number): Float64Array {
    return new Float64Array(raw.memory.buffer, raw.list_address(), length);
}

/** A copy of the list of numbers of the last call. */
export function listCopy(length: number): Float64Array {
    return list(length).slice();
}

/** A copy of the real numbers of the last call. */
export function realsCopy(): RealArray {
    return new RealArrayType(raw.memory.buffer, raw.reals_address(), raw.reals_len()).slice();
}

/** A copy of the integers of the last call. */
export function integersCopy(): Uint32Array {
    return new Uint32Array(raw.memory.buffer, raw.integers_address(), raw.integers_len()).slice();
}

/**
 * Returns whether a buffer may be the module's before it grew. Buffers that are not shared are detached then.
 */
function isSharedBuffer(buffer: ArrayBufferLike): boolean {
    return typeof SharedArrayBuffer !== "undefined" && buffer instanceof SharedArrayBuffer;
}

/**
 * The numbers, or a copy of them if they lie in the module's memory, which may grow or change before they are
 * used.
 */
export function apart<T extends ArrayLike<number>>(numbers: T): T {
    const isView = ArrayBuffer.isView(numbers) && (numbers.buffer === raw.memory.buffer || isSharedBuffer(numbers.buffer));
    return isView ? (numbers as unknown as RealArray).slice() as unknown as T : numbers;
}

/** Writes a list for the next call. */
export function putList(numbers: ArrayLike<number>): void {
    numbers = apart(numbers);
    const address = raw.list_reserve(numbers.length);
    new Float64Array(raw.memory.buffer, address, numbers.length).set(numbers);
}

/** Writes real numbers for the next call. The name is for the error of another value. */
export function putReals(numbers: ArrayLike<number>, name: string): void {
    requireList(numbers, name);
    numbers = apart(numbers);
    const address = raw.reals_reserve(numbers.length);
    new RealArrayType(raw.memory.buffer, address, numbers.length).set(numbers);
}

/** Writes integers for the next call. The name is for the error of another value. */
export function putIntegers(numbers: ArrayLike<number>, name: string): void {
    requireList(numbers, name);
    numbers = apart(numbers);
    const address = raw.integers_reserve(numbers.length);
    new Uint32Array(raw.memory.buffer, address, numbers.length).set(numbers);
}

/** Writes bytes for the next call. The name is for the error of another value. */
export function putBytes(bytes: Uint8Array, name: string): void {
    if (!ArrayBuffer.isView(bytes)) {
        throw wrong(name, bytes, "a Uint8Array");
    }
    bytes = apart(bytes);
    const address = raw.bytes_reserve(bytes.length);
    new Uint8Array(raw.memory.buffer, address, bytes.length).set(bytes);
}

/** A copy of the bytes of the last call. */
export function bytesCopy(length: number): Uint8Array {
    return new Uint8Array(raw.memory.buffer, raw.bytes_address(), length).slice();
}

/** A view of real numbers in memory. It is valid until the memory grows. */
export function realsAt(address: number, length: number): RealArray {
    return new RealArrayType(raw.memory.buffer, address, length);
}

function text(address: number, length: number): string {
    return new TextDecoder().decode(new Uint8Array(raw.memory.buffer, address, length).slice());
}

// ---- Calls from the module ----

/**
 * The stack pointer of the call from JavaScript that is running: an exception gives the stack back down to
 * it.
 */
let stackFloor = 0;

/** The exception of a callback. It is thrown when the module has returned. */
let pending: { error: unknown } | undefined;

/** Returns whether a collider takes part in a query. */
export type Accept = (collider: number) => boolean;
/** Filters a pair or changes a contact in a step. */
export type Hook = (kind: number, collider1: number, collider2: number, body1: number, body2: number) => number;

let accept: Accept | undefined;
let visitor: Accept | undefined;
let hook: Hook | undefined;
let warn: (message: string) => void = (message) => console.warn(`rapier: ${message}`);

/** Runs a callback between two calls of the module. An exception is stored, and the result is 0. */
function guarded(call: () => number): number {
    if (pending) {
        return 0;
    }
    const floor = stackFloor;
    const top = raw.__stack_pointer.value as number;
    const callbacks = [accept, visitor, hook] as const;
    stackFloor = top;
    try {
        return call();
    } catch (error) {
        pending = { error };
        return 0;
    } finally {
        raw.__stack_pointer.value = top;
        stackFloor = floor;
        [accept, visitor, hook] = callbacks;
    }
}

const imported = {
    fail(kind: number, address: number, length: number): never {
        raw.__stack_pointer.value = stackFloor;
        throw RapierError.ofKind(kind, text(address, length));
    },
    warn(address: number, length: number): void {
        const message = text(address, length);
        guarded(() => (warn(message), 0));
    },
    now: (): number => performance.now(),
    // A result that is not a boolean, as that of a function without a result, counts as true.
    accepts: (collider: number): number => guarded(() => Number(accept!(collider) !== false)),
    visit: (collider: number): number => guarded(() => Number(visitor!(collider) !== false)),
    hook: (kind: number, collider1: number, collider2: number, body1: number, body2: number): number =>
        guarded(() => hook!(kind, collider1, collider2, body1, body2)),
};

/** Runs a call of the module with callbacks. An exception of a callback is thrown after it. */
export function withCallbacks<R>(callbacks: { accept?: Accept; visitor?: Accept; hook?: Hook }, call: () => R): R {
    const before = [accept, visitor, hook] as const;
    ({ accept, visitor, hook } = callbacks);
    let result: R;
    try {
        result = call();
    } catch (error) {
        pending = undefined;
        recover();
        throw error;
    } finally {
        [accept, visitor, hook] = before;
    }
    if (pending) {
        const { error } = pending;
        pending = undefined;
        recover();
        throw error;
    }
    return result;
}

/**
 * Ends the calls of the module that an exception ended: gives their stack back, and the worlds and queues
 * that they used.
 */
function recover(): void {
    raw.__stack_pointer.value = stackFloor;
    raw.calls_abandon(stackFloor);
}

/** Replaces the function that receives the engine's warnings. By default they go to the console. */
export function setWarningHandler(handler: (message: string) => void): void {
    warn = handler;
}
