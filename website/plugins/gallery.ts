// A page for each scene of the testbeds: /gallery/3d/washer, /gallery/2d/washer.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { LoadContext, Plugin } from "@docusaurus/types";
import type { SceneData } from "../src/live/ScenePage";

/** Scenes with their sources, which `scripts/prepare.mjs` collects. */
const SOURCES = join(__dirname, "..", "generated", "data", "sources.json");

export default function gallery({ baseUrl }: LoadContext): Plugin {
    return {
        name: "gallery",
        getPathsToWatch: () => [SOURCES],
        async contentLoaded({ actions }) {
            for (const scene of JSON.parse(readFileSync(SOURCES, "utf8")) as SceneData[]) {
                const { dimension, id } = scene;
                const path = `${baseUrl}gallery/${dimension}/${id}`;
                const data = await actions.createData(`${dimension}-${id}.json`, scene);
                actions.addRoute({ path, component: "@site/src/live/ScenePage.tsx", modules: { scene: data }, exact: true });
            }
        },
    };
}
