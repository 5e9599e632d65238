// The entry for Node.js: the module is a file beside this one.

import { readFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { Worker } from "node:worker_threads";
import { FILES, type ModuleKind, setSource } from "./raw.js";
import type { ThreadWorker } from "./threads.js";

const read = (kind: ModuleKind): Uint8Array<ArrayBuffer> => new Uint8Array(readFileSync(new URL(FILES[kind], import.meta.url)));

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
