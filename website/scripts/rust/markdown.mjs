// Doc comments as Markdown for pages: headings become bold lines, programs are marked as Rust, links lead to the reference.

/** Lines of a program that readers see. */
function visible(lines) {
    return lines.filter((line) => !/^\s*#(\s|$)/.test(line)).map((line) => line.replace(/^(\s*)##/, "$1#"));
}

/** Rewrites the programs with `code` and the text between them with `text`. */
function byFences(docs, code, text) {
    const out = [];
    let block = null;
    for (const line of docs.split("\n")) {
        const fence = /^\s*```(.*)$/.exec(line);
        if (fence === null) (block?.lines ?? out).push(block === null ? text(line) : line);
        else if (block === null) block = { info: fence[1], lines: [] };
        else {
            out.push(code(block));
            block = null;
        }
    }
    return out.join("\n");
}

function program({ info, lines }) {
    const rust = !/^(text|toml|sh|json)/.test(info);
    return ["```" + (rust ? "rust" : info), ...(rust ? visible(lines) : lines), "```"].join("\n");
}

function escape(text) {
    return text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
}

/** Rustdoc's links to a part of the same type, such as `[text](#method.name)`. */
const FRAGMENT = /\[([^\]]*)\]\(#(?:method|tymethod|structfield|variant)\.(\w+)\)/g;

/** Replaces the links within the crate: `[text](target)` and `[target]`. */
function linked(line, links, address, fragment) {
    let result = line.replace(FRAGMENT, (_, text, name) => (fragment(name) ? `[${text}](${fragment(name)})` : text));
    for (const [target, id] of Object.entries(links)) {
        const url = address(id);
        const written = escape(target);
        result = result.replace(new RegExp(`\\[([^\\]]*)\\]\\(${written}\\)`, "g"), (_, text) =>
            url ? `[${text}](${url})` : text,
        );
        result = result.replace(new RegExp(`\\[${written}\\](?![(\\[])`, "g"), () => (url ? `[${target}](${url})` : target));
    }
    return result;
}

/** A doc comment as Markdown. `address` gives the page of an item, `fragment` the part of the same type, or nothing. */
export function markdown(item, address, fragment = () => undefined) {
    const text = (line) => linked(line.replace(/^#+ (.*)$/, "**$1.**"), item.links ?? {}, address, fragment);
    return byFences(item.docs ?? "", program, text).trim();
}

/** The first sentence, for lists. */
export function summary(item, address) {
    return markdown(item, address)
        .split(/\n\s*\n/)[0]
        .replace(/\n/g, " ");
}
