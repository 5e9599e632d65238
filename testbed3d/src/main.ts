// The page of the 3D testbed.

import { start } from "../../testbed/src/app/start.ts";
import { DIMENSION_3 } from "./dimension.ts";
import type { Rapier } from "./rapier.ts";
import { SCENES } from "./scenes/index.ts";

await start({
    dimension: DIMENSION_3,
    scenes: SCENES,
    modules: {
        own: async () => (await import("virtual:own-engine")).default as Rapier | null,
        published: async () => await import("@dimforge/rapier3d-compat"),
    },
    sources: import.meta.glob("./scenes/*.ts", { query: "?raw", import: "default" }),
});
