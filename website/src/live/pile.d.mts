import type { Rapier } from "@repository/testbed3d/src/rapier";

export function hashes(RAPIER: Rapier): string[];
export const BODIES: number;
export const TAKEN: readonly number[];
