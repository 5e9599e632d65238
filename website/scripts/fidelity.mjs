// Data for the charts of errors, from the tables of `docs/fidelity/`, which `cargo run -p fidelity` writes.

import { number, tables } from "./tables.mjs";

/** The column of the measured value: the one before the first reference value. */
const REFERENCES = /^(formula|exact)$/;

/** References below this part of the largest one of a table are no scale of an error: a speed that damping has removed. */
const SCALE_FRACTION_MIN = 1e-3;

/**
 * Largest relative error (%) of a table's rows by build and rate, and the resolution of the printed digits. Tables without a
 * rate or a reference value have none.
 */
function errors({ columns, rows }) {
    const rate = columns.indexOf("rate");
    const measured = columns.findIndex((column) => REFERENCES.test(column)) - 1;
    const reference = columns.includes("exact") ? columns.indexOf("exact") : columns.indexOf("formula");
    if (rate < 0 || measured <= rate) return [];
    const scale = Math.max(...rows.map((row) => Math.abs(number(row[reference]) ?? 0)));
    const largest = new Map();
    for (const row of rows) {
        const [value, expected] = [number(row[measured]), number(row[reference])];
        if (value === null || expected === null || Math.abs(expected) <= SCALE_FRACTION_MIN * scale) continue;
        const key = `${row[0]} ${row[rate]}`;
        const error = 100 * Math.abs(value / expected - 1);
        const resolution = (100 * Math.max(lastDigit(row[measured]), lastDigit(row[reference]))) / Math.abs(expected);
        const found = largest.get(key) ?? { build: row[0], rate: number(row[rate]), error: 0, resolution: 0 };
        const larger = { error: Math.max(found.error, error), resolution: Math.max(found.resolution, resolution) };
        largest.set(key, { ...found, ...larger });
    }
    return [...largest.values()];
}

/** Half of the last printed digit of a number. */
function lastDigit(text) {
    const [mantissa, exponent = "0"] = text.toLowerCase().split("e");
    const decimals = mantissa.includes(".") ? mantissa.length - mantissa.indexOf(".") - 1 : 0;
    return 0.5 * 10 ** (Number(exponent) - decimals);
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
