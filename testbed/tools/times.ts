// Compares the engines on all scenes: `npm run times -- [scene ...]`. It measures the processor's time of a
// step, including the scene's script, so other programs on the machine hardly matter.

import type { Dimension } from "../src/core/dimension.ts";
import type { Engine, EngineModule, WorldLike } from "../src/core/engine.ts";
import type { SceneDefinition } from "../src/core/scene.ts";
import { Stage } from "../src/core/stage.ts";

/** Steps that are not measured, and steps that are. */
const WARM = 30;
const STEPS = 270;

/** Mean milliseconds of a step. */
function measure<R extends EngineModule, W extends WorldLike>(
    dimension: Dimension<R, W>,
    engine: Engine<R>,
    scene: SceneDefinition<R, W>,
): number {
    const stage = new Stage(dimension, engine, scene);
    for (let step = 0; step < WARM; step++) stage.advance();
    const before = process.cpuUsage();
    for (let step = 0; step < STEPS; step++) stage.advance();
    const { user, system } = process.cpuUsage(before);
    stage.dispose();
    return (user + system) / 1000 / STEPS;
}

export function compareTimes<R extends EngineModule, W extends WorldLike>(
    dimension: Dimension<R, W>,
    engines: readonly Engine<R>[],
    scenes: readonly SceneDefinition<R, W>[],
): void {
    const wanted = process.argv.slice(2);
    console.log(`| scene | ${engines.map(({ label }) => `${label} (ms)`).join(" | ")} | ratio |`);
    console.log(`|---|${engines.map(() => "--:|").join("")}--:|`);
    for (const scene of scenes) {
        if (wanted.length > 0 && !wanted.includes(scene.id)) continue;
        const times = engines.map((engine) => measure(dimension, engine, scene));
        const ratio = times.length > 1 ? (times[1]! / times[0]!).toFixed(2) : "";
        console.log(`| ${scene.id} | ${times.map((time) => time.toFixed(3)).join(" | ")} | ${ratio} |`);
    }
}
