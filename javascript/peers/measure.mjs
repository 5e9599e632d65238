// Measures the steps of one scene with one engine.

import { ENGINES } from "./engines.mjs";
import { SCENES } from "./scenes.mjs";

/** Time (ms) of steps after which V8 has compiled the hot functions of a module of some megabytes. */
const WARM_UP_MS = 6000;

/** Builds a scene, makes some steps, and returns the functions of its world. */
async function begin(dimension, engine, scene, warm) {
    const running = await ENGINES[dimension][engine](dimension, SCENES[scene](dimension));
    for (let count = 0; count < warm; count += 1) running.step();
    return running;
}

/**
 * Milliseconds per step by this clock (ms). The scene runs before the measurement until V8 has compiled the
 * module: processor time contains that of the compiler.
 */
export async function measure(dimension, engine, scene, clock) {
    const { steps = 200, warm = 20 } = SCENES[scene](dimension);
    for (const begun = clock(); clock() - begun < WARM_UP_MS; ) {
        const { free } = await begin(dimension, engine, scene, warm + steps);
        free?.();
    }
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
