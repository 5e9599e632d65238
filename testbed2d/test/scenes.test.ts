// Tests of the 2D scenes.

import * as RAPIER from "@dimforge/rapier2d-compat";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { loadEngines, testGallery } from "../../testbed/test/scenes.ts";
import { DIMENSION_2 } from "../src/dimension.ts";
import type { Rapier } from "../src/rapier.ts";
import { SCENES } from "../src/scenes/index.ts";

const testbed = dirname(dirname(fileURLToPath(import.meta.url)));
const engines = await loadEngines<Rapier>(RAPIER, testbed, 2);
testGallery({ dimension: DIMENSION_2, scenes: SCENES, engines, minimum: 25, repeated: "pyramid" });
