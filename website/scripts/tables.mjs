// Reads the tables of a Markdown document.

/** Splits a row at its bars, except those behind a backslash. */
function cells(line) {
    return line
        .trim()
        .replace(/^\|/, "")
        .replace(/\|$/, "")
        .split(/(?<!\\)\|/)
        .map((cell) => cell.trim().replaceAll("\\|", "|"));
}

/** All tables of a document: the last heading, the first line of text and the last picture above, the names of the columns, and the rows. */
export function tables(markdown) {
    const found = [];
    let heading = "";
    let note = "";
    let picture = "";
    let current = null;
    for (const line of markdown.split("\n")) {
        if (/^#+ /.test(line)) [heading, note] = [line.replace(/^#+ /, ""), ""];
        if (!line.startsWith("|")) {
            current = null;
            if (note === "" && /^\w/.test(line)) note = line;
            picture = /^!\[([^\]]*)\]/.exec(line)?.[1] ?? picture;
        } else if (current === null) {
            current = { heading, note, picture, columns: cells(line), rows: [] };
            found.push(current);
        } else if (!/^\|[\s:|-]+$/.test(line)) {
            current.rows.push(cells(line));
        }
    }
    return found;
}

/** Returns the number in a cell: thin spaces separate thousands, asterisks mark the best. Empty cells have none. */
export function number(cell) {
    const text = cell.replace(/[\s\u00a0\u202f,*]/g, "");
    return text === "" || !Number.isFinite(Number(text)) ? null : Number(text);
}
