// Doc comments as Markdown for pages: headings become bold lines, programs are marked as Rust, links lead to the reference.

import { withoutHiddenLines } from "../../plugins/rustdoc.mjs";

/** Rewrites the programs with `code` and each block of text between them with `text`: a link may span lines. */
function byFences(docs, code, text) {
    const out = [];
    let block = { lines: [] };
    const finish = () => {
        if (block.info !== undefined) out.push(code(block));
        else if (block.lines.length > 0) out.push(text(block.lines.join("\n")));
    };
    for (const line of docs.split("\n")) {
        const fence = /^\s*```(.*)$/.exec(line);
        if (fence === null) {
            block.lines.push(line);
            continue;
        }
        finish();
        block = block.info === undefined ? { info: fence[1], lines: [] } : { lines: [] };
    }
    finish();
    return out.join("\n");
}

function program({ info, lines }) {
    const rust = !/^(text|toml|sh|json)/.test(info);
    const code = lines.join("\n");
    return ["```" + (rust ? "rust" : info), rust ? withoutHiddenLines(code) : code, "```"].join("\n");
}

function escape(text) {
    return text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
}

/** Rustdoc's links to a part of the same type, such as `[text](#method.name)`. */
const FRAGMENT = /\[([^[\]]*)\]\(#(?:method|tymethod|structfield|variant)\.(\w+)\)/g;

/** Replaces the links within the crate: `[text](target)` and `[target]`. */
function linked(block, links, address, fragment) {
    let result = block.replace(FRAGMENT, (_, text, name) => (fragment(name) ? `[${text}](${fragment(name)})` : text));
    for (const [target, id] of Object.entries(links)) {
        const url = address(id);
        const written = escape(target);
        result = result.replace(new RegExp(`\\[([^[\\]]*)\\]\\(${written}\\)`, "g"), (_, text) =>
            url ? `[${text}](${url})` : text,
        );
        result = result.replace(new RegExp(`\\[${written}\\](?![(\\[])`, "g"), () => (url ? `[${target}](${url})` : target));
    }
    const dead = /\]\((?:crate|super|self|Self)::[^)]*\)/.exec(result);
    if (dead !== null) throw new Error(`a doc comment keeps the link "${dead[0].slice(1)}", which leads nowhere on a page`);
    return result;
}

/** A doc comment as Markdown. `address` gives the page of an item, `fragment` the part of the same type, or nothing. */
export function markdown(item, address, fragment = () => undefined) {
    const text = (block) => linked(block.replace(/^#+ (.*)$/gm, "**$1.**"), item.links ?? {}, address, fragment);
    return byFences(item.docs ?? "", program, text).trim();
}

/** The first sentence, for lists. */
export function summary(item, address) {
    return markdown(item, address)
        .split(/\n\s*\n/)[0]
        .replace(/\n/g, " ");
}
