// The entry for Node.js: the module is part of the script, so that bundles need no other file. Modules without
// SIMD or with threads are files beside it.

import { readFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { inflateSync } from "node:zlib";
import { RapierError } from "./error.js";
import { COPY_HINT, FILES, type ModuleKind, setSource } from "./raw.js";
import type { ThreadWorker } from "./threads.js";

/** The module with SIMD, compressed, in base 64: the build writes it. */
declare const MODULE: string;

function read(kind: ModuleKind): Uint8Array<ArrayBuffer> {
    if (kind === "simd") {
        return new Uint8Array(inflateSync(Buffer.from(MODULE, "base64")));
    }
    const file = new URL(FILES[kind], import.meta.url);
    try {
        return new Uint8Array(readFileSync(file));
    } catch (error) {
        throw new RapierError("NotInitialized", `the module ${kind} cannot be read: ${(error as Error).message}. ${COPY_HINT}`);
    }
}

function start(program: string): ThreadWorker {
    // Options of this process, such as `--input-type=module`, would change the meaning of the program.
    const worker = new Worker(`const scope = require("node:worker_threads").parentPort; ${program}`, { eval: true, execArgv: [] });
    // A program ends while its threads wait for work.
    const ready = new Promise((resolve, reject) => worker.once("message", resolve).once("error", reject)).finally(() => worker.unref());
    return { postMessage: (message) => worker.postMessage(message), ready, terminate: () => void worker.terminate() };
}

setSource({ load: async (kind) => read(kind), loadNow: read, workers: { start, cores: availableParallelism } });

export * from "#entry";
export { default } from "#entry";
