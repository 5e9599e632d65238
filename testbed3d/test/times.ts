// Step times of the 3D scenes in each engine.

import * as RAPIER from "@dimforge/rapier3d-compat";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { loadEngines } from "../../testbed/test/scenes.ts";
import { compareTimes } from "../../testbed/tools/times.ts";
import { DIMENSION_3 } from "../src/dimension.ts";
import type { Rapier } from "../src/rapier.ts";
import { SCENES } from "../src/scenes/index.ts";

const engines = await loadEngines<Rapier>(RAPIER, dirname(dirname(fileURLToPath(import.meta.url))), 3);
compareTimes(DIMENSION_3, engines, SCENES);
