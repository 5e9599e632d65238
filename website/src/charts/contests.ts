// Contests of engines: the rows of docs/benchmarks/latest.md, grouped by scene.

import data from "@site/generated/data/contests.json";
import { OWN, isPeer } from "./engines";

export type Measure = "time" | "memory" | "overlap";

export interface Entry {
    readonly engine: string;
    readonly value: number;
}

export interface Contest {
    readonly scene: string;
    readonly entries: readonly Entry[];
    /** The best peer's value divided by this engine's: above 1 this engine is ahead. */
    readonly lead: number;
}

export const { machine: MACHINE, conditions: CONDITIONS } = data;

/** Names of the peers, with their versions where the tables have them. */
export const PEERS = [...new Set(data.rows.map(({ engine }) => engine).filter(isPeer))];

function contest(scene: string, entries: readonly Entry[]): Contest {
    const own = entries.find(({ engine }) => engine === OWN)?.value ?? Number.NaN;
    const peers = entries.filter(({ engine }) => isPeer(engine)).map(({ value }) => value);
    return { scene: scene.replace(/^\dd\//, "").replaceAll("_", " "), entries, lead: Math.min(...peers) / own };
}

/** The contests of a dimension with a number of threads, in the order of the table. */
export function contests(dimension: "2d" | "3d", threads: number, measure: Measure): Contest[] {
    const rows = data.rows.filter((row) => row.scene.startsWith(dimension) && row.threads === threads);
    const scenes = [...new Set(rows.map((row) => row.scene))];
    return scenes.map((scene) => {
        const entries = rows
            .filter((row) => row.scene === scene && row[measure] !== null)
            .map((row) => ({ engine: row.engine, value: row[measure] ?? Number.NaN }));
        return contest(scene, entries);
    });
}

export function geometricMean(values: readonly number[]): number {
    return Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
}
