// Data for the charts, from the documents of `docs/benchmarks/`. `cargo run -p bench -- --write` writes latest.md and growth.md.
// The tables of javascript.md are entered by hand from the output of `npm run bench`. This script copies figures and adds none.

import { number, tables } from "./tables.mjs";

/** Rows of a table as objects, under the names of the columns. Fails if a column is missing: the format has changed. */
function records(table, columns) {
    for (const column of columns) {
        if (!table.columns.includes(column)) throw new Error(`a benchmark table has no column "${column}"`);
    }
    return table.rows.map((row) => Object.fromEntries(columns.map((column) => [column, row[table.columns.indexOf(column)]])));
}

/** The line of a document that begins so. */
function line(markdown, start) {
    return markdown.split("\n").find((text) => text.startsWith(start)) ?? "";
}

/** Times of all engines in all scenes, from docs/benchmarks/latest.md. */
export function contests(markdown) {
    const table = tables(markdown).find((candidate) => candidate.columns.includes("ms/step"));
    if (table === undefined) throw new Error("the benchmark document has no table of times");
    const rows = records(table, ["scene", "threads", "engine", "ms/step", "overlap", "bytes/body"]).map((row) => ({
        scene: row.scene,
        threads: number(row.threads),
        engine: row.engine,
        time: number(row["ms/step"]),
        overlap: number(row.overlap),
        memory: number(row["bytes/body"]),
    }));
    return { machine: line(markdown, "Machine:"), conditions: line(markdown, "All:"), rows };
}

/** Curves of time over size, from docs/benchmarks/growth.md. */
export function growth(markdown) {
    return tables(markdown)
        .filter((table) => table.columns.includes("ms/step"))
        .map((table) => ({
            title: table.picture,
            note: table.note,
            rows: records(table, ["engine", "bodies", "threads", "ms/step"]).map((row) => ({
                engine: row.engine,
                bodies: number(row.bodies),
                threads: number(row.threads),
                time: number(row["ms/step"]),
            })),
        }));
}

/** Times in Node.js and Chromium, from docs/benchmarks/javascript.md. */
export function packages(markdown) {
    return tables(markdown)
        .filter((table) => /^\dD, /.test(table.columns[0]))
        .map((table) => ({
            title: table.columns[0],
            engines: table.columns.slice(1),
            rows: table.rows.map(([scene, ...times]) => ({ scene, times: times.map(number) })),
        }));
}
