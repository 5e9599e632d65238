// The program of a worker of a module with threads. The build makes a text of it, which precedes `scope` with
// the worker's end of its connection.

import type { Raw } from "./raw.js";

/** Data of a worker. */
export interface Start {
    module: WebAssembly.Module;
    memory: WebAssembly.Memory;
    /** The top of the worker's stack. */
    stackTop: number;
    /** The address of its thread-local storage. */
    storage: number;
}

/** The worker's end of its connection: `self` in browsers, `parentPort` in Node.js. */
declare const scope: {
    postMessage(message: unknown): void;
    onmessage?: (event: { data: Start }) => void;
    once?(event: "message", listener: (start: Start) => void): void;
};

function run({ module, memory, stackTop, storage }: Start): void {
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
}

if (scope.once) {
    scope.once("message", run);
} else {
    scope.onmessage = ({ data }) => run(data);
}
