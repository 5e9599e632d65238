// Names and colours of the engines that the benchmark tables compare.

/** The name of this engine in the tables. */
export const OWN = "this engine";
const DOUBLE = "this engine, f64";

/** Colour of an engine: peers of both dimensions that share an author share a colour. */
export function colour(engine: string): string {
    if (engine === OWN) return "var(--engine-own)";
    if (engine === DOUBLE) return "var(--engine-double)";
    return engine.startsWith("Rapier") ? "var(--engine-rapier)" : "var(--engine-box)";
}

export function isPeer(engine: string): boolean {
    return engine !== OWN && engine !== DOUBLE;
}
