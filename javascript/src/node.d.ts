// The part of Node.js that an entry uses.

declare module "node:fs" {
    /** The bytes of a file. */
    export function readFileSync(path: URL): Uint8Array;
}

declare module "node:zlib" {
    /** The data of a zlib stream. */
    export function inflateSync(data: Uint8Array): Uint8Array;
}

/** Bytes of Node.js. */
declare const Buffer: { from(text: string, encoding: "base64"): Uint8Array };

declare module "node:worker_threads" {
    /** A thread with a program. */
    export class Worker {
        constructor(program: string, options: { eval: true; execArgv: string[] });
        postMessage(message: unknown): void;
        once(event: string, listener: (value: unknown) => void): this;
        unref(): void;
        terminate(): Promise<number>;
    }
}

declare module "node:os" {
    /** The number of threads that run at the same time. */
    export function availableParallelism(): number;
}
