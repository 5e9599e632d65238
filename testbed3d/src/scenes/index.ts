// All scenes of the 3D gallery, in the order of the gallery.

import type { Scene } from "../rapier.ts";
import { STACKS } from "./stacks.ts";

export const SCENES: readonly Scene[] = [...STACKS];
