// Draws the gallery's pictures: `npm run thumbnails -- [scene ...]`.

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { openPage, openSession, type Tools } from "./browser.ts";

const SIZE = { width: 240, height: 150 };
/** Bytes of a picture at most. */
const BYTES_MAX = 10_000;
const STEPS = 90;

interface Named {
    readonly id: string;
    readonly poster?: number;
}

/** Writes a WebP picture of each scene. */
export async function drawThumbnails(testbed: string, tools: Tools, scenes: readonly Named[]): Promise<void> {
    const wanted = process.argv.slice(2);
    const folder = join(testbed, "public", "thumbnails");
    mkdirSync(folder, { recursive: true });
    const session = await openSession(testbed, tools);
    try {
        const { page } = await openPage(session, "theme=dark&paused=1", { width: 1308, height: 501 });
        let bytes = 0;
        for (const { id, poster } of scenes) {
            if (wanted.length > 0 && !wanted.includes(id)) continue;
            await page.evaluate(`testbed.openScene("${id}"); testbed.run(${poster ?? STEPS})`);
            bytes += await write(join(folder, `${id}.webp`), (quality) =>
                page.evaluate(`testbed.picture.photograph("image/webp", ${quality}, ${SIZE.width}, ${SIZE.height})`) as Promise<string>,
            );
        }
        console.log(`thumbnails: ${(bytes / 1024).toFixed(0)} kB`);
    } finally {
        await session.close();
    }
}

/** Writes a picture in the best quality that fits the limit; returns its size. */
async function write(path: string, draw: (quality: number) => Promise<string>): Promise<number> {
    for (const quality of [0.75, 0.6, 0.45, 0.3]) {
        const url = await draw(quality);
        const data = Buffer.from(url.slice(url.indexOf(",") + 1), "base64");
        if (data.length > BYTES_MAX) continue;
        writeFileSync(path, data);
        return data.length;
    }
    throw new Error(`${path}: more than ${BYTES_MAX} bytes in the lowest quality`);
}
