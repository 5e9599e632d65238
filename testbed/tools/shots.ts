// Pictures of scenes for the eye: `npm run shots -- [scene ...] [--engine both] [--theme light] [--steps 60]
// [--phone]`.

import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { openPage, openSession, type Tools } from "./browser.ts";

interface Named {
    readonly id: string;
    readonly poster?: number;
}

/** Writes a picture of each scene into the folder `shots`, which git ignores. */
export async function takeShots(testbed: string, tools: Tools, scenes: readonly Named[]): Promise<void> {
    const { values, positionals } = parseArgs({
        allowPositionals: true,
        options: {
            engine: { type: "string", default: "published" },
            theme: { type: "string", default: "dark" },
            steps: { type: "string" },
            phone: { type: "boolean", default: false },
        },
    });
    const folder = join(testbed, "shots");
    mkdirSync(folder, { recursive: true });
    const session = await openSession(testbed, tools);
    try {
        const query = `engine=${values.engine}&theme=${values.theme}&paused=1&detail=low`;
        const size = values.phone ? { width: 390, height: 780 } : { width: 1000, height: 640 };
        const { page, errors } = await openPage(session, query, size, values.phone);
        for (const scene of scenes) {
            if (positionals.length > 0 && !positionals.includes(scene.id)) continue;
            const steps = Number(values.steps ?? scene.poster ?? 90);
            await page.evaluate(`testbed.openScene("${scene.id}"); testbed.run(${steps})`);
            await page.waitForTimeout(250);
            await page.screenshot({ path: join(folder, `${scene.id}${values.phone ? "-phone" : ""}.png`) });
            for (const error of errors.splice(0)) console.error(`${scene.id}: ${error}`);
        }
    } finally {
        await session.close();
    }
}
