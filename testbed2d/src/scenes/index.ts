// All scenes of the 2D gallery, in the order of the gallery.

import type { Scene } from "../rapier.ts";
import { FORCES, MATERIALS, SHAPES } from "./basics.ts";
import { EVENTS, FAST, GROUND, QUERIES, STRESS } from "./contacts.ts";
import { JOINTS } from "./joints.ts";
import { PLATFORMS, RAGDOLLS, VEHICLES } from "./moving.ts";
import { STACKS } from "./stacks.ts";

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
