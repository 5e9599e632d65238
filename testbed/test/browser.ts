// Tests of the page in a browser: scenes run, bodies can be pulled, the phone's layout works.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { openPage, openSession, type Session, type Tools } from "../tools/browser.ts";

export interface BrowserTest {
    readonly testbed: string;
    readonly tools: Tools;
    /** Scenes whose pictures are taken. */
    readonly scenes: readonly string[];
    /** A scene with a body in the middle of the picture, and the place of that body in the viewport. */
    readonly pick: { scene: string; x: number; y: number };
}

/** The number of different colours of the canvas, sampled on a grid. */
const COUNT_COLOURS = `(() => {
    const source = document.querySelector(".stage canvas");
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [64, 64];
    const context = copy.getContext("2d");
    context.drawImage(source, 0, 0, 64, 64);
    const data = context.getImageData(0, 0, 64, 64).data;
    const colours = new Set();
    for (let at = 0; at < data.length; at += 4) colours.add((data[at] >> 3) * 65536 + (data[at + 1] >> 3) * 256 + (data[at + 2] >> 3));
    return colours.size;
})()`;

async function engines(page: Page): Promise<string[]> {
    return (await page.evaluate("[...testbed.options.engines.keys()]")) as string[];
}

async function testScenes(session: Session, { testbed, scenes }: BrowserTest): Promise<void> {
    const { page, errors } = await openPage(session, "detail=low&paused=1");
    const own = (await engines(page)).includes("own");
    if (own) await page.evaluate('testbed.setMode("both")');
    for (const scene of scenes) {
        await page.evaluate(`testbed.openScene("${scene}"); testbed.run(60)`);
        await page.waitForTimeout(300);
        const colours = (await page.evaluate(COUNT_COLOURS)) as number;
        assert.ok(colours > 12, `${scene}: the picture has ${colours} colours`);
        assert.match(await page.title(), /–/);
        await page.screenshot({ path: join(testbed, "shots", `test-${scene}.png`) });
    }
    assert.deepEqual(errors, [], "the console has errors");
    await page.context().close();
    console.log(`ok: ${scenes.length} scenes${own ? ", both engines side by side" : ""}`);
}

/** The position of the body that the pointer holds, or null. */
const HELD = `(() => {
    const spring = testbed.stages[0].spring;
    return spring ? { ...spring.body.translation() } : null;
})()`;

async function testPick(session: Session, { testbed, pick }: BrowserTest): Promise<void> {
    const { page, errors } = await openPage(session, `scene=${pick.scene}&detail=low`);
    const box = await page.locator(".stage canvas").boundingBox();
    assert.ok(box, "the page has no canvas");
    const [x, y] = [box.x + pick.x * box.width, box.y + pick.y * box.height];
    await page.waitForTimeout(500);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.waitForTimeout(100);
    const before = (await page.evaluate(HELD)) as { x: number; y: number } | null;
    assert.ok(before, "the pointer holds no body");
    await page.mouse.move(x + 60, y - 120, { steps: 8 });
    await page.waitForTimeout(1500);
    const after = (await page.evaluate(HELD)) as { x: number; y: number } | null;
    await page.screenshot({ path: join(testbed, "shots", "test-pick.png") });
    assert.ok(after, "the pointer lost the body");
    const moved = Math.hypot(after.x - before.x, after.y - before.y);
    assert.ok(moved > 0.3, `the body moved ${moved.toFixed(2)} m`);
    await page.mouse.up();
    assert.equal(await page.evaluate(HELD), null, "the pointer still holds the body");
    assert.deepEqual(errors, []);
    await page.context().close();
    console.log(`ok: the pointer pulls a body by ${moved.toFixed(2)} m`);
}

async function testControls(session: Session, { testbed }: BrowserTest): Promise<void> {
    const { page, errors } = await openPage(session, "scene=pyramid&detail=low&paused=1&theme=light&debug=1");
    const steps = async (): Promise<number> => (await page.evaluate("testbed.stages[0].steps")) as number;
    const bodies = async (): Promise<number> => (await page.evaluate("testbed.stages[0].counts().bodies")) as number;
    assert.equal(await steps(), 0);
    await page.keyboard.press("n");
    await page.waitForFunction("testbed.stages[0].steps === 1");
    await page.keyboard.press("p");
    await page.waitForFunction("testbed.stages[0].steps > 4");
    const count = await bodies();
    await page.keyboard.press(" ");
    assert.equal(await bodies(), count + 1, "the space bar throws a ball");
    if ((await page.evaluate("typeof testbed.stages[0].world.takeSnapshot")) === "function") await testSnapshots(page);
    await page.keyboard.press("p");
    await page.keyboard.press("r");
    await page.waitForFunction("testbed.stages[0].steps === 0");
    assert.equal(await bodies(), count);
    await page.fill("input[type=search]", "rad");
    const shown = await page.locator(".card:visible").count();
    assert.ok(shown > 0 && shown < 10, `the search shows ${shown} scenes`);
    await page.locator('.card[data-scene="radar"]').click();
    assert.match(page.url(), /scene=radar/);
    await page.keyboard.press("Escape");
    await page.waitForTimeout(500);
    await page.screenshot({ path: join(testbed, "shots", "test-light.png") });
    assert.deepEqual(errors, []);
    await page.context().close();
    console.log("ok: keys, search, deep links");
}

async function testSnapshots(page: Page): Promise<void> {
    await page.keyboard.press("t");
    const taken = (await page.evaluate("testbed.stages[0].counts().bodies")) as number;
    await page.keyboard.press(" ");
    await page.keyboard.press("b");
    assert.equal(await page.evaluate("testbed.stages[0].counts().bodies"), taken, "a snapshot restores the bodies");
}

/** Scenes that were left leave no geometry behind. */
async function testMemory(session: Session, { scenes }: BrowserTest): Promise<void> {
    const { page, errors } = await openPage(session, "detail=low&paused=1");
    const visit = async (): Promise<number> => {
        for (const scene of scenes.slice(0, 4)) {
            await page.evaluate(`testbed.openScene("${scene}")`);
            // A slow machine draws the scene later: geometries count from their first picture on.
            await page.evaluate("new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(drawn))))");
        }
        return (await page.evaluate("testbed.picture.renderer.info.memory.geometries")) as number;
    };
    const first = await visit();
    for (let round = 0; round < 3; round++) assert.equal(await visit(), first, "geometries are left behind");
    assert.deepEqual(errors, []);
    await page.context().close();
    console.log(`ok: ${first} geometries after each of four rounds through four scenes`);
}

async function testPhone(session: Session, { testbed, scenes }: BrowserTest): Promise<void> {
    const query = `scene=${scenes[0] ?? ""}&detail=low`;
    const { page, errors } = await openPage(session, query, { width: 390, height: 780 }, true);
    await page.waitForTimeout(800);
    await page.screenshot({ path: join(testbed, "shots", "test-phone.png") });
    const width = (await page.evaluate("document.documentElement.scrollWidth")) as number;
    assert.ok(width <= 390, `the page is ${width} pixels wide`);
    await page.locator("button.scenes").tap();
    await page.waitForTimeout(500);
    await page.screenshot({ path: join(testbed, "shots", "test-phone-scenes.png") });
    await page.locator(".card:visible").nth(2).tap();
    await page.waitForTimeout(500);
    await page.locator("button.settings").tap();
    await page.waitForTimeout(500);
    await page.screenshot({ path: join(testbed, "shots", "test-phone-settings.png") });
    assert.deepEqual(errors, []);
    await page.context().close();
    console.log("ok: a phone's viewport");
}

/** Addresses keep parameters and settings, an unknown scene is named, and the source can be read. */
async function testSharing(session: Session): Promise<void> {
    const { page, errors } = await openPage(session, "scene=pyramid&detail=low&paused=1&set.base=5&gravity=2&set.none=1");
    assert.equal(await page.evaluate("testbed.stages[0].counts().bodies"), await page.evaluate("15 + testbed.stages[0].world.bodies.getAll().filter((body) => body.isFixed()).length"), "five rows of boxes");
    assert.equal(await page.evaluate("testbed.stages[0].settings.gravity"), 2);
    const query = new URL(page.url()).searchParams;
    assert.deepEqual([query.get("set.base"), query.get("gravity"), query.get("set.none"), query.get("rate")], ["5", "2", null, null]);
    await page.getByRole("button", { name: "View source" }).click();
    await page.getByText('id: "pyramid"').waitFor({ timeout: 10_000 });
    assert.deepEqual(errors, []);
    await page.context().close();
    const { page: other } = await openPage(session, "scene=nowhere&detail=low&paused=1");
    assert.match((await other.locator(".toast").textContent()) ?? "", /no scene "nowhere"/);
    await other.context().close();
    console.log("ok: parameters in the address, source, unknown scenes");
}

/** An engine whose script does not arrive: the page states the reason, and offers the other engine. */
async function testMissing(session: Session): Promise<void> {
    const page = await (await session.browser.newContext()).newPage();
    await page.route(/own-engine/, (route) => route.abort());
    await page.goto(`${session.address}?detail=low&paused=1`);
    const reason = await page.locator(".about.missing").textContent({ timeout: 60_000 });
    assert.match(reason ?? "", /package of this repository did not load.*own-engine/);
    await page.getByRole("link", { name: /published package/ }).click();
    await page.waitForFunction("window.testbed !== undefined", undefined, { timeout: 60_000 });
    assert.deepEqual(await engines(page), ["published"]);
    assert.equal(await page.locator('button[data-value="own"]').getAttribute("title"), reason);
    await page.context().close();
    console.log("ok: the reason of a missing engine");
}

export async function testPage(test: BrowserTest): Promise<void> {
    mkdirSync(join(test.testbed, "shots"), { recursive: true });
    const session = await openSession(test.testbed, test.tools);
    try {
        await testScenes(session, test);
        await testPick(session, test);
        await testControls(session, test);
        await testMemory(session, test);
        await testPhone(session, test);
        await testSharing(session);
        await testMissing(session);
    } finally {
        await session.close();
    }
}
