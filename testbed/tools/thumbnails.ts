// Draws the gallery's pictures, and a strip of pictures of each scene that moves under the pointer: `npm run thumbnails -- [scene ...]`.

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { openPage, openSession, type Tools } from "./browser.ts";

const SIZE = { width: 240, height: 150 };
/** Bytes of a picture at most. */
const BYTES_MAX = 10_000;
const STEPS = 90;

/** Pictures of a strip, steps between two of them, and bytes of a strip at most. */
const FRAMES = 8;
const STRIDE = 5;
const STRIP_SIZE = { width: 192, height: 120 };
const STRIP_BYTES_MAX = 50_000;

interface Named {
    readonly id: string;
    readonly poster?: number;
}

/** Writes a WebP picture and a strip of each scene. */
export async function drawThumbnails(testbed: string, tools: Tools, scenes: readonly Named[]): Promise<void> {
    const wanted = process.argv.slice(2);
    const folder = join(testbed, "public", "thumbnails");
    mkdirSync(join(folder, "moving"), { recursive: true });
    const session = await openSession(testbed, tools);
    try {
        const { page } = await openPage(session, "theme=light&paused=1", { width: 1308, height: 501 });
        let bytes = 0;
        for (const { id, poster } of scenes) {
            if (wanted.length > 0 && !wanted.includes(id)) continue;
            await page.evaluate(`testbed.openScene("${id}"); testbed.run(${poster ?? STEPS})`);
            const draw = async (path: string, limit: number, { width, height }: typeof SIZE, more = ""): Promise<void> => {
                bytes += await write(path, limit, (quality) =>
                    page.evaluate(`testbed.picture.photograph("image/webp", ${quality}, ${width}, ${height}${more})`) as Promise<string>,
                );
            };
            await draw(join(folder, `${id}.webp`), BYTES_MAX, SIZE);
            await draw(join(folder, "moving", `${id}.webp`), STRIP_BYTES_MAX, STRIP_SIZE, `, ${FRAMES}, () => testbed.run(${STRIDE})`);
        }
        console.log(`thumbnails: ${(bytes / 1024).toFixed(0)} kB`);
    } finally {
        await session.close();
    }
}

/** Writes a picture in the best quality that fits the limit; returns its size. */
async function write(path: string, limit: number, draw: (quality: number) => Promise<string>): Promise<number> {
    for (const quality of [0.75, 0.6, 0.45, 0.3]) {
        const url = await draw(quality);
        const data = Buffer.from(url.slice(url.indexOf(",") + 1), "base64");
        if (data.length > limit) continue;
        writeFileSync(path, data);
        return data.length;
    }
    throw new Error(`${path}: more than ${limit} bytes in the lowest quality`);
}
