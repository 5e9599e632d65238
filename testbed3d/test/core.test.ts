// Tests of the shared source that needs neither an engine nor a picture.

import assert from "node:assert/strict";
import { test } from "node:test";
import { applyParameters, changedValues, readLink } from "../../testbed/src/app/link.ts";
import { Clock } from "../../testbed/src/core/clock.ts";
import { enumNames, stepHash } from "../../testbed/src/core/engine.ts";
import { Random } from "../../testbed/src/core/random.ts";
import { Series } from "../../testbed/src/core/series.ts";

test("the clock takes one step a frame at 60 Hz, also on a display at 59.9 Hz", () => {
    for (const rate of [60, 59.9]) {
        const clock = new Clock();
        const steps = Array.from({ length: 600 }, () => clock.take(1 / rate, 1 / 60));
        const total = steps.reduce((sum, one) => sum + one, 0);
        assert.ok(Math.abs(total - 600) <= 2, `${total} steps in 600 frames at ${rate} Hz`);
        assert.ok(Math.max(...steps) <= 2);
    }
});

test("slow motion takes a step every tenth frame, and fractions in between grow", () => {
    const clock = new Clock();
    clock.speed = 0.1;
    const fractions: number[] = [];
    let steps = 0;
    for (let frame = 0; frame < 100; frame++) {
        steps += clock.take(1 / 60, 1 / 60);
        fractions.push(clock.fraction(1 / 60));
    }
    assert.ok(steps === 10 || steps === 9, `${steps} steps`);
    assert.ok(fractions.every((fraction) => fraction >= 0 && fraction <= 1));
    assert.ok(new Set(fractions.map((fraction) => Math.round(10 * fraction))).size >= 9);
});

test("a long frame runs four steps, and the backlog is dropped", () => {
    const clock = new Clock();
    assert.equal(clock.take(10, 1 / 60), 4);
    assert.equal(clock.take(0, 1 / 60), 0);
});

test("a paused clock takes the requested steps", () => {
    const clock = new Clock();
    clock.stepOnce();
    clock.stepOnce();
    assert.equal(clock.running, false);
    assert.equal(clock.take(1, 1 / 60), 2);
    assert.equal(clock.take(1, 1 / 60), 0);
});

test("a series keeps its last values in order", () => {
    const series = new Series(3);
    assert.equal(series.mean(5), 0);
    for (const value of [1, 2, 3, 4]) series.push(value);
    assert.deepEqual(series.padded(), [2, 3, 4]);
    assert.equal(series.mean(2), 3.5);
    series.clear();
    assert.deepEqual(series.padded(), [null, null, null]);
});

test("random numbers repeat with their seed and stay in their range", () => {
    const numbers = (seed: number): number[] => {
        const random = new Random(seed);
        return Array.from({ length: 1000 }, () => random.between(-2, 3));
    };
    assert.deepEqual(numbers(4), numbers(4));
    assert.notDeepEqual(numbers(4), numbers(5));
    assert.ok(numbers(4).every((value) => value >= -2 && value < 3));
    assert.throws(() => new Random().pick([]), RangeError);
});

test("links with bad values fall back to the defaults", () => {
    const link = readLink("?scene=tower&engine=both&theme=light&steps=120&debug=1");
    assert.deepEqual(link, { scene: "tower", engine: "both", theme: "light", debug: true, paused: false, steps: 120, detail: "high", parameters: {}, settings: {} });
    const bad = readLink("?engine=none&theme=pink&steps=-4&detail=ultra&rate=7&gravity=heavy");
    assert.deepEqual(bad, { scene: null, engine: null, theme: null, debug: false, paused: false, steps: 0, detail: "high", parameters: {}, settings: {} });
    assert.equal(readLink("?steps=1e9").steps, 10_000);
    assert.equal(readLink("?steps=many").steps, 0);
});

test("links carry values of parameters and settings, and others are ignored", () => {
    const link = readLink("?set.count=12&set.kind=ball&gravity=2.5&rate=120&iterations=99");
    assert.deepEqual(link.settings, { gravity: 2.5, rate: 120 });
    const values = { count: 3, kind: "box", open: true };
    const definitions = {
        count: { label: "Count", value: 3, min: 1, max: 20, step: 1 },
        kind: { label: "Kind", value: "box", options: ["box", "ball"] },
        open: { label: "Open", value: true },
    };
    applyParameters({ ...link.parameters, open: "perhaps" }, definitions, values);
    assert.deepEqual(values, { count: 12, kind: "ball", open: true });
    applyParameters({ count: "1000", open: "false" }, definitions, values);
    assert.deepEqual(values, { count: 12, kind: "ball", open: false });
    const settings = { gravity: 2.5, iterations: 4, rate: 60 };
    const changed = changedValues(settings, { ...settings, gravity: 9.81 }, values, { ...values, kind: "box" });
    assert.deepEqual(changed, { "set.kind": "ball", gravity: 2.5 });
});

test("one long step does not raise the percentiles of a plot", () => {
    const series = new Series(240);
    for (const value of [50, ...Array<number>(40).fill(1)]) series.push(value);
    assert.equal(series.percentile(0.95), 1);
    assert.equal(series.percentile(1), 50);
});

test("hashes are methods or values, of each type, or missing", () => {
    assert.equal(stepHash({ hash: () => 0xabn }), "00000000000000ab");
    assert.equal(stepHash({ hash: 255 }), "000000ff");
    assert.equal(stepHash({ hash: () => "beef" }), "beef");
    assert.equal(stepHash({}), null);
});

test("names of enumerations with and without a reverse mapping", () => {
    for (const shapes of [{ Ball: 0, Cuboid: 1 }, { Ball: 0, Cuboid: 1, 0: "Ball", 1: "Cuboid" }]) {
        assert.deepEqual([...enumNames(shapes)], [[0, "Ball"], [1, "Cuboid"]]);
    }
});
