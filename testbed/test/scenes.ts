// Tests of scenes without a picture: each scene runs in each engine that is there.

import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import type { Dimension } from "../src/core/dimension.ts";
import { loadEngine, type Engine, type EngineModule, type WorldLike } from "../src/core/engine.ts";
import type { SceneDefinition } from "../src/core/scene.ts";
import { Stage } from "../src/core/stage.ts";
import { findOwnEngine } from "../tools/own-engine.ts";

const STEPS = 120;

/** The published package, and the one of this repository where it was built. */
export async function loadEngines<R extends EngineModule>(
    published: R,
    testbed: string,
    dimension: 2 | 3,
): Promise<Engine<R>[]> {
    const engines = [await loadEngine("published", published)];
    const entry = findOwnEngine(testbed, dimension, "node");
    if (entry === null) return engines;
    const own = (await import(pathToFileURL(entry).href)) as R;
    return [await loadEngine("own", own), ...engines];
}

/** Runs a scene until its claims were checked. */
function runScene<R extends EngineModule, W extends WorldLike>(stage: Stage<R, W>): void {
    const claims = stage.run.claims ?? [];
    const steps = Math.max(STEPS, ...claims.map((claim) => claim.after));
    for (let step = 1; step <= steps; step++) {
        stage.advance();
        if (step % 30 === 0) assert.equal(stage.findInvalid(), null, `a body is not finite after ${step} steps`);
        for (const claim of claims.filter(({ after }) => after === step)) {
            const result = claim.check();
            assert.ok(result === true, `${claim.text}: ${result === false ? "it does not hold" : result}`);
        }
    }
}

function testScene<R extends EngineModule, W extends WorldLike>(
    dimension: Dimension<R, W>,
    engine: Engine<R>,
    scene: SceneDefinition<R, W>,
): void {
    const stage = new Stage(dimension, engine, scene);
    try {
        assert.ok(stage.counts().bodies > 0, "the scene has no bodies");
        runScene(stage);
    } finally {
        stage.dispose();
    }
}

/** Texts, identifiers and groups of the gallery. */
function testTexts<R, W>(scenes: readonly SceneDefinition<R, W>[], minimum: number): void {
    test("the gallery is complete", () => {
        assert.ok(scenes.length >= minimum, `${scenes.length} scenes, fewer than ${minimum}`);
        assert.equal(new Set(scenes.map((scene) => scene.id)).size, scenes.length, "an identifier occurs twice");
        for (const scene of scenes) {
            assert.match(scene.id, /^[a-z0-9-]+$/);
            assert.match(scene.description, /^[A-Z].*\.$/s, `${scene.id}: the description is no sentence`);
            assert.ok(scene.description.length < 110, `${scene.id}: the description is long`);
        }
    });
}

/** Snapshots restore the same state in the same engine. */
function testSnapshot<R extends EngineModule, W extends WorldLike>(
    dimension: Dimension<R, W>,
    engine: Engine<R>,
    scene: SceneDefinition<R, W>,
): void {
    const state = (stage: Stage<R, W>): string => {
        const values: string[] = [];
        const body = new Float64Array(13);
        stage.world.forEachRigidBody((one) => {
            dimension.readState(one, body);
            values.push(body.join(" "));
        });
        return values.join("\n");
    };
    const stage = new Stage(dimension, engine, scene);
    for (let step = 0; step < 40; step++) stage.advance();
    const snapshot = stage.takeSnapshot();
    for (let step = 0; step < 40; step++) stage.advance();
    const expected = state(stage);
    stage.restore(snapshot);
    for (let step = 0; step < 40; step++) stage.advance();
    assert.equal(state(stage), expected);
    stage.dispose();
}

/** Two stages of the same scene and engine have the same states. */
function testRepeats<R extends EngineModule, W extends WorldLike>(
    dimension: Dimension<R, W>,
    engine: Engine<R>,
    scene: SceneDefinition<R, W>,
): void {
    const runs = [0, 1].map(() => {
        const stage = new Stage(dimension, engine, scene);
        for (let step = 0; step < 60; step++) stage.advance();
        const body = new Float64Array(13);
        const values: number[] = [];
        stage.world.forEachRigidBody((one) => {
            dimension.readState(one, body);
            values.push(...body);
        });
        const hash = stage.hash();
        stage.dispose();
        return { values, hash };
    });
    assert.deepEqual(runs[0], runs[1]);
}

/** The tests of a gallery. `repeated` names a scene without a script. */
export function testGallery<R extends EngineModule, W extends WorldLike>(options: {
    dimension: Dimension<R, W>;
    scenes: readonly SceneDefinition<R, W>[];
    engines: readonly Engine<R>[];
    minimum: number;
    repeated: string;
}): void {
    const { dimension, scenes, engines } = options;
    testTexts(scenes, options.minimum);
    const repeated = scenes.find(({ id }) => id === options.repeated);
    assert.ok(repeated, `there is no scene ${options.repeated}`);
    for (const engine of engines) {
        describe(engine.label, () => {
            for (const scene of scenes) {
                test(`${scene.group}: ${scene.title}`, () => testScene(dimension, engine, scene));
            }
            test("a snapshot restores the state", () => testSnapshot(dimension, engine, repeated));
            test("a scene repeats its states", () => testRepeats(dimension, engine, repeated));
        });
    }
}
