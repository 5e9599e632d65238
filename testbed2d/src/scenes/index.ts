// All scenes of the 2D gallery, in the order of the gallery.

import type { Scene } from "../rapier.ts";
import { FORCES, MATERIALS, SHAPES } from "./basics.ts";
import { FAST } from "./bullets.ts";
import { EVENTS } from "./events.ts";
import { GROUND } from "./ground.ts";
import { JOINTS } from "./joints.ts";
import { PLATFORMS, RAGDOLLS, VEHICLES } from "./moving.ts";
import { QUERIES } from "./queries.ts";
import { STACKS } from "./stacks.ts";
import { STRESS } from "./stress.ts";

export const SCENES: readonly Scene[] = [
    ...STACKS,
    ...SHAPES,
    ...MATERIALS,
    ...FORCES,
    ...JOINTS,
    ...RAGDOLLS,
    ...VEHICLES,
    ...PLATFORMS,
    ...FAST,
    ...QUERIES,
    ...EVENTS,
    ...GROUND,
    ...STRESS,
];
