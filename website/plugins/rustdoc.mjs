// Conventions of rustdoc's programs.

/** A program without the lines that rustdoc compiles and does not show. */
export function withoutHiddenLines(code) {
    return code
        .split("\n")
        .filter((line) => !/^\s*#(\s|$)/.test(line))
        .map((line) => line.replace(/^(\s*)##/, "$1#"))
        .join("\n");
}
