// Rustdoc's JSON as Rust: types, bounds, signatures.

function list(items, print, separator = ", ") {
    return items.map(print).join(separator);
}

/** The last part of a path: `core::option::Option` is `Option`. */
function short(path) {
    return path.split("::").at(-1);
}

function argument(arg) {
    if (typeof arg === "string") return "_";
    return arg.lifetime ?? (arg.type === undefined ? (arg.const?.expr ?? "_") : type(arg.type));
}

function constraint({ name, binding }) {
    if (binding.equality === undefined) return `${name}: ${bounds(binding.constraint ?? [])}`;
    const term = binding.equality;
    return `${name} = ${term.type === undefined ? term.constant.expr : type(term.type)}`;
}

function args(value) {
    if (!value || typeof value === "string") return "";
    if (value.parenthesized !== undefined) {
        const { inputs, output } = value.parenthesized;
        return `(${list(inputs, type)})${output === null ? "" : ` -> ${type(output)}`}`;
    }
    const { args: given, constraints } = value.angle_bracketed;
    const parts = [...given.map(argument), ...constraints.map(constraint)];
    return parts.length === 0 ? "" : `<${parts.join(", ")}>`;
}

function path(value) {
    return short(value.path ?? value.name) + args(value.args);
}

function bound(value) {
    if (value.outlives !== undefined) return value.outlives;
    if (value.trait_bound === undefined) return "use<..>";
    const { trait, modifier } = value.trait_bound;
    return (modifier === "maybe" ? "?" : "") + path(trait);
}

function bounds(values) {
    return list(values, bound, " + ");
}

function dynamic({ traits, lifetime }) {
    return `dyn ${list(traits, ({ trait }) => path(trait), " + ")}${lifetime === null ? "" : ` + ${lifetime}`}`;
}

function reference({ lifetime, is_mutable: mutable, type: target }) {
    const inner = type(target);
    const several = /^(dyn|impl) .* \+ /.test(inner);
    return `&${lifetime === null ? "" : `${lifetime} `}${mutable ? "mut " : ""}${several ? `(${inner})` : inner}`;
}

function projection({ name, self_type: self, trait }) {
    const owner = type(self);
    return owner === "Self" || trait === null || trait.path === ""
        ? `${owner}::${name}`
        : `<${owner} as ${path(trait)}>::${name}`;
}

const PRINTERS = {
    resolved_path: path,
    dyn_trait: dynamic,
    generic: (name) => name,
    primitive: (name) => (name === "never" ? "!" : name),
    function_pointer: ({ sig }) => `fn(${list(sig.inputs, ([, input]) => type(input))})${output(sig)}`,
    tuple: (items) => `(${list(items, type)}${items.length === 1 ? "," : ""})`,
    slice: (item) => `[${type(item)}]`,
    array: ({ type: item, len }) => `[${type(item)}; ${len}]`,
    impl_trait: (values) => `impl ${bounds(values)}`,
    infer: () => "_",
    raw_pointer: ({ is_mutable: mutable, type: target }) => `*${mutable ? "mut" : "const"} ${type(target)}`,
    borrowed_ref: reference,
    qualified_path: projection,
};

/** A type as Rust. Fails for a kind that this script does not know: the format has changed. */
export function type(value) {
    const [[kind, content]] = Object.entries(value);
    const print = PRINTERS[kind];
    if (print === undefined) throw new Error(`rustdoc's JSON has the unknown kind of type "${kind}"`);
    return print(content);
}

function output({ output: result }) {
    return result === null ? "" : ` -> ${type(result)}`;
}

function parameter({ name, kind }) {
    if (kind.lifetime !== undefined) return name;
    if (kind.const !== undefined) return `const ${name}: ${type(kind.const.type)}`;
    return kind.type.bounds.length === 0 ? name : `${name}: ${bounds(kind.type.bounds)}`;
}

/** Parameters in angle brackets. Those of `impl Trait` stand in the list of arguments. */
export function generics({ params }) {
    const shown = params.filter(({ kind, name }) => !(kind.type?.is_synthetic ?? false) && !name.startsWith("'_"));
    return shown.length === 0 ? "" : `<${list(shown, parameter)}>`;
}

function where({ where_predicates: predicates }) {
    const shown = predicates.flatMap(({ bound_predicate: predicate }) =>
        predicate === undefined ? [] : [`${type(predicate.type)}: ${bounds(predicate.bounds)}`],
    );
    return shown.length === 0 ? "" : `\nwhere\n${shown.map((line) => `    ${line},`).join("\n")}`;
}

function input([name, value]) {
    if (name !== "self") return `${name}: ${type(value)}`;
    const shown = type(value);
    if (shown === "Self") return "self";
    return (
        { "&Self": "&self", "&mut Self": "&mut self" }[shown] ??
        (/^&'\w+ (mut )?Self$/.test(shown) ? shown.replace("Self", "self") : `self: ${shown}`)
    );
}

/** Longest signature on one line. */
const WIDTH = 80;

/** The declaration of a function. */
export function signature(name, { sig, generics: parameters, header }) {
    const words = [header.is_const && "const ", header.is_async && "async ", header.is_unsafe && "unsafe "]
        .filter(Boolean)
        .join("");
    const start = `pub ${words}fn ${name}${generics(parameters)}(`;
    const end = `)${output(sig)}${where(parameters)}`;
    const inputs = sig.inputs.map(input);
    const line = start + inputs.join(", ") + end;
    if (line.split("\n")[0].length <= WIDTH) return line;
    return `${start}\n${inputs.map((each) => `    ${each},\n`).join("")}${end}`;
}
