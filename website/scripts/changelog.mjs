// The changelog as a page: its links into `docs/` lead to pages, and its other relative links become text.

/** The address of a document, or nothing for files that are no documents. */
function page(target) {
    const found = /^docs\/(.*?)(?:\/?README)?\.md(#.*)?$/.exec(target);
    return found === null ? undefined : `/docs/${found[1]}${found[2] ?? ""}`;
}

export function changelog(markdown) {
    const text = markdown.replace(/\[([^\]]*)\]\(([^)]*)\)/g, (link, words, target) => {
        if (/^(\w+:|#)/.test(target)) return link;
        const address = page(target);
        return address === undefined ? words : `[${words}](${address})`;
    });
    return `---\ndescription: What each release changes for its users.\n---\n\n${text}`;
}
