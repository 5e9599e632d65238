// The order of pages, from the lists of documents.

/** The documents that the rows of a table link to in their first cell, in order. */
export function tabled(markdown) {
    return [...markdown.matchAll(/^\| \[[^\]]*\]\(([\w-]+)\.md\)/gm)].map(([, page]) => page);
}

/** The documents that the items of a numbered list link to, in order. */
export function numbered(markdown) {
    return [...markdown.matchAll(/^\d+\. \[[^\]]*\]\(([\w-]+)\.md\)/gm)].map(([, page]) => page);
}
