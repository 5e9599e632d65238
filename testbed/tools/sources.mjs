// Finds scenes in the text of their files, for "View source" and for the website.

const SCENE = /^(?:export )?const \w+: Scene = \{\n[\s\S]*?^\};$/gm;

/** The value of a field that is a string. */
function field(source, name) {
    return new RegExp(`^    ${name}:\\s*"((?:[^"\\\\]|\\\\.)*)"`, "m").exec(source)?.[1];
}

/** The scenes of a file: id, title, description, group, whether it is steered, the action, source. */
export function scenesOf(text) {
    const common = /^const group = "([^"]*)";$/m.exec(text)?.[1];
    return Array.from(text.matchAll(SCENE), ([source]) => ({
        id: field(source, "id"),
        title: field(source, "title"),
        description: field(source, "description"),
        group: field(source, "group") ?? common,
        steered: source.includes("\n    steered: true,"),
        action: field(source, "action"),
        source,
    }));
}
