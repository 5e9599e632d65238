// Data for the charts of errors, from the tables of `docs/fidelity/`, which `cargo run -p fidelity` writes.

import { number, tables } from "./tables.mjs";

/** The column of the measured value: the one before the first reference value. */
const REFERENCES = /^(formula|exact)$/;

/** Largest relative error (%) of a table's rows by build and rate. Tables without a rate or a reference value have none. */
function errors({ columns, rows }) {
    const rate = columns.indexOf("rate");
    const measured = columns.findIndex((column) => REFERENCES.test(column)) - 1;
    const reference = columns.includes("exact") ? columns.indexOf("exact") : columns.indexOf("formula");
    if (rate < 0 || measured <= rate) return [];
    const largest = new Map();
    for (const row of rows) {
        const [value, expected] = [number(row[measured]), number(row[reference])];
        if (value === null || expected === null || expected === 0) continue;
        const key = `${row[0]} ${row[rate]}`;
        const error = 100 * Math.abs(value / expected - 1);
        const found = largest.get(key) ?? { build: row[0], rate: number(row[rate]), error: 0 };
        largest.set(key, { ...found, error: Math.max(found.error, error) });
    }
    return [...largest.values()];
}

/** The laws of a document whose error depends on the rate. */
export function laws(page, markdown) {
    return tables(markdown)
        .map((table) => ({ page, title: table.heading, quantity: quantity(table.columns), errors: errors(table) }))
        .filter((law) => law.errors.length > 0);
}

function quantity(columns) {
    const reference = columns.findIndex((column) => REFERENCES.test(column));
    return reference < 1 ? "" : columns[reference - 1];
}
