// Measures the steps of one scene with one engine.

import { ENGINES } from "./engines.mjs";
import { SCENES } from "./scenes.mjs";

/** Steps after which engines of WebAssembly have compiled what is hot. */
const COMPILED = 120;

/** Builds a scene, makes some steps, and returns the function that makes one. */
async function begin(dimension, engine, scene, warm) {
    const running = await ENGINES[dimension][engine](dimension, SCENES[scene](dimension));
    for (let count = 0; count < warm; count += 1) running.step();
    return running;
}

/** Milliseconds per step by this clock (ms). The scene runs once before: the time of the processor would contain that of the compiler. */
export async function measure(dimension, engine, scene, clock) {
    const { steps = 200, warm = 20 } = SCENES[scene](dimension);
    await begin(dimension, engine, scene, Math.max(COMPILED, warm));
    const { step, height } = await begin(dimension, engine, scene, warm);
    const start = clock();
    for (let count = 0; count < steps; count += 1) step();
    const time = (clock() - start) / steps;
    const result = height();
    if (!Number.isFinite(result)) {
        throw new Error(`the scene ended at a height of ${result}`);
    }
    return time;
}
