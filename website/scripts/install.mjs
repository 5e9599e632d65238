// The ways to install the engine, from the table of README: today from a clone, and from the registries when it is published.

import { tables } from "./tables.mjs";

/** Splits a cell into its line of code and the words behind it. Links of README lead nowhere on the site. */
function line(cell) {
    const found = /^`([^`]*)`,?\s*(.*)$/.exec(cell);
    if (found === null) throw new Error(`README.md, table of installation: "${cell}" has no code`);
    return { code: found[1], note: found[2].replace(/\[([^\]]*)\]\([^)]*\)/g, "$1") };
}

/** One entry for each language: `{ language, today, published }`. */
export function installation(readme) {
    const table = tables(readme).find(({ columns }) => columns.some((name) => name.includes("clone")));
    if (table === undefined) throw new Error("README.md has no table with a column for clones");
    const today = table.columns.findIndex((name) => name.includes("clone"));
    const published = table.columns.findIndex((name) => name.includes("published"));
    return table.rows.map((row) => ({ language: row[0], today: line(row[today]), published: line(row[published]) }));
}
