// The Rust reference of each dimension: a page per topic, pages of their own for long types, and a list of all public names.

import { mkdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { kindOf, publicModules } from "./crate.mjs";
import { markdown, summary } from "./markdown.mjs";
import { REST, TOPICS } from "./topics.mjs";
import { generics, signature, type } from "./types.mjs";

/** This sentence replaces the list of methods that all sets of flags have. */
const FLAGS =
    "A set of flags with the methods of the crate [bitflags](https://docs.rs/bitflags): `contains`, `insert`, `remove`, `union` and others, and the operators `|`, `&` and `-`.";

/** Traits behind operators, formats and macros: no reader looks for them. */
const OPERATORS = /^(Structural|Bit|Binary|Octal|.*Hex|Not$|Sub|Extend|FromIterator|Flags$|PublicFlags$)/;

/** Parts of a type that gets a page of its own, at least: its topic's page would be too long to read. */
const PARTS_MIN = 8;

function anchor(...names) {
    return names.map((name) => name.toLowerCase()).join("-");
}

function fenced(code) {
    return ["```rust", code, "```"].join("\n");
}

/** The reference of one crate: `name` of the crate, `folder` of the pages on the site, rustdoc's `json`. */
class Reference {
    constructor({ name, folder, json }) {
        this.crate = name;
        this.folder = folder;
        this.base = `/api/${folder}`;
        this.json = json;
        /** Names of topics that the crate does not have. */
        this.absent = [];
        this.modules = publicModules(json);
        const prelude = this.modules.find(({ module }) => module === "prelude");
        this.prelude = new Set(prelude?.entries.map(({ name }) => name));
        this.addresses = new Map();
        this.pages = this.distribute();
        this.alone = new Set();
        for (const page of this.pages) for (const entry of page.entries) this.register(page, entry);
        this.address = (id) => this.addresses.get(id);
    }

    /** Types by page. */
    distribute() {
        const open = new Map();
        for (const { module, entries } of this.modules) {
            if (module === "prelude") continue;
            for (const entry of entries)
                if (entry.item !== undefined && !open.has(entry.name)) open.set(entry.name, { ...entry, module });
        }
        const take = (name) => {
            const entry = open.get(name);
            open.delete(name);
            return entry;
        };
        const topics = TOPICS.map((topic) => {
            const entries = topic.types.map((name) => take(name) ?? name);
            this.absent.push(...entries.filter((entry) => typeof entry === "string"));
            return { ...topic, entries: entries.filter((entry) => typeof entry !== "string") };
        });
        const rest = REST.map((page) => ({
            ...page,
            entries: [...open.values()].filter(({ module }) => page.modules.includes(module)),
        }));
        return [...topics, ...rest].filter(({ entries }) => entries.length > 0);
    }

    register(page, { name, id, item }) {
        const sections = this.sections(item);
        if (sections.length >= PARTS_MIN && page.entries.length > 1) this.alone.add(name);
        const path = `${this.base}/${page.id}`;
        this.addresses.set(id, this.alone.has(name) ? `${path}/${name}` : `${path}#${anchor(name)}`);
        for (const { section, id: child } of sections)
            this.addresses.set(child, `${path}${this.alone.has(name) ? `/${name}` : ""}#${this.anchor(name, section)}`);
    }

    /** The anchor of a part. Names of types distinguish the parts on pages of topics. */
    anchor(owner, section) {
        return this.alone.has(owner) ? section : `${anchor(owner)}-${section}`;
    }

    children(ids) {
        return ids.map((id) => ({ id, item: this.json.index[id] })).filter(({ item }) => item !== undefined);
    }

    impls(item) {
        const { impls } = item.inner[kindOf(item)];
        if (!Array.isArray(impls)) return [];
        return this.children(impls).map((each) => each.item.inner.impl);
    }

    /** Public methods and constants of inherent implementations, in the order of the source. Methods that macros write are left out. */
    methods(item) {
        const own = this.impls(item).filter(({ trait }) => trait === null);
        const generated = ({ inner, span, docs }) =>
            inner.function !== undefined && (docs === null || String(span.begin) === String(item.span.begin));
        return own
            .flatMap(({ items }) => this.children(items))
            .filter(({ item: method }) => method.visibility === "public" && !generated(method))
            .sort(
                (a, b) => a.item.span.filename.localeCompare(b.item.span.filename) || a.item.span.begin[0] - b.item.span.begin[0],
            );
    }

    fields(item) {
        const { plain } = item.inner.struct?.kind ?? {};
        return this.children(plain?.fields ?? []).filter(({ item: field }) => field.visibility === "public");
    }

    /** The parts of an item that have headings of their own: fields, variants, methods. */
    sections(item) {
        const kind = kindOf(item);
        const parts = [
            ...this.fields(item),
            ...(kind === "enum" ? this.children(item.inner.enum.variants) : []),
            ...(kind === "trait" ? this.children(item.inner.trait.items) : []),
            ...(["struct", "enum", "type_alias"].includes(kind) ? this.methods(item) : []),
        ];
        const seen = new Map();
        return parts.map((part) => {
            const name = anchor(part.item.name);
            const count = seen.get(name) ?? 0;
            seen.set(name, count + 1);
            return { ...part, section: count === 0 ? name : `${name}-${count + 1}` };
        });
    }

    variant({ name, inner }) {
        const { kind } = inner.variant;
        const shown = (ids) => this.children(ids.filter((id) => id !== null)).map(({ item }) => item);
        if (kind.tuple !== undefined)
            return `${name}(${shown(kind.tuple)
                .map((field) => type(field.inner.struct_field))
                .join(", ")})`;
        if (kind.struct === undefined) return name;
        return `${name} { ${shown(kind.struct.fields)
            .map((field) => `${field.name}: ${type(field.inner.struct_field)}`)
            .join(", ")} }`;
    }

    /** The declaration of an item or of a part of one. */
    declaration(item, inTrait = false) {
        const { name, inner } = item;
        if (inner.function !== undefined) {
            const text = signature(name, inner.function);
            return inTrait ? text.replace("pub ", "") : text;
        }
        if (inner.struct_field !== undefined) return `pub ${name}: ${type(inner.struct_field)}`;
        if (inner.variant !== undefined) return this.variant(item);
        if (inner.type_alias !== undefined)
            return `pub type ${name}${generics(inner.type_alias.generics)} = ${type(inner.type_alias.type)}`;
        if (inner.constant !== undefined) return `pub const ${name}: ${type(inner.constant.type)} = ${inner.constant.const.expr}`;
        if (inner.assoc_const !== undefined) return `const ${name}: ${type(inner.assoc_const.type)}`;
        if (inner.assoc_type !== undefined) return `type ${name}`;
        if (inner.macro !== undefined) return inner.macro;
        const kind = kindOf(item);
        return `pub ${kind} ${name}${generics(inner[kind].generics)}`;
    }

    /** Names of the implemented traits that a program relies on. */
    traits(item) {
        if (!["struct", "enum"].includes(kindOf(item))) return "";
        const names = this.impls(item)
            .filter(
                ({ trait, is_synthetic: synthetic, blanket_impl: blanket }) => trait !== null && !synthetic && blanket === null,
            )
            .map(({ trait }) => trait.path.split("::").at(-1))
            .filter((name) => !OPERATORS.test(name));
        return names.length === 0
            ? ""
            : `Implements ${[...new Set(names)]
                  .sort()
                  .map((name) => `\`${name}\``)
                  .join(", ")}.`;
    }

    /** The text of an item or of one of its parts. */
    text(item, owner = item) {
        const fragments = new Map(this.sections(owner).map((part) => [part.item.name, `#${this.anchor(owner.name, part.section)}`]));
        return markdown(item, this.address, (name) => fragments.get(name));
    }

    section(owner, { item, section }) {
        const title = item.name.replace(/_/g, "\\_");
        const code = fenced(this.declaration(item, owner.inner.trait !== undefined));
        const level = this.alone.has(owner.name) ? "##" : "###";
        return [`${level} ${title} {#${this.anchor(owner.name, section)}}`, code, this.text(item, owner)].join("\n\n");
    }

    entry({ name, item, module }) {
        const parts = this.sections(item).map((part) => this.section({ ...item, name }, part));
        const place = `From \`${this.crate}::${module}\`.`;
        const flags = this.impls(item).some(({ trait }) => trait?.path.endsWith("BitOr")) ? FLAGS : "";
        return [
            this.alone.has(name) ? `# ${name}` : `## ${name} {#${anchor(name)}}`,
            fenced(this.declaration(item)),
            this.text(item),
            `${place} ${this.traits(item)} ${flags}`,
            ...parts,
        ].join("\n\n");
    }

    page({ id, title, intro, guides, entries }, position) {
        const head = [`---\nsidebar_position: ${position}\nslug: /${this.folder}/${id}\ntoc_max_heading_level: 3\n---`, `# ${title}`, intro];
        const list = entries
            .map(({ name, id, item }) => `* [\`${name}\`](${this.addresses.get(id)}): ${summary(item, this.address)}`)
            .join("\n");
        const texts = guides.map((guide) => `[${guide.replace(/-/g, " ")}](/docs/guide/${guide})`).join(", ");
        const guide = guides.length === 0 ? "" : `Guide: ${texts}. The programs there and below run as tests.`;
        const here = entries.filter(({ name }) => !this.alone.has(name));
        return [...head, guide, list, ...here.map((entry) => this.entry(entry))].join("\n\n");
    }

    /** The path of a name that the prelude does not have, in brackets. */
    path(module, name) {
        return this.prelude.has(name) ? "" : ` (\`${this.crate}::${module}::${name}\`)`;
    }

    /** Every public name of every module, with a link or the crate of its origin. */
    overview() {
        const lines = this.modules.flatMap(({ module, entries }) => {
            if (module === "prelude") return [];
            const names = entries.map(({ name, id, item }) => {
                const url = this.addresses.get(id);
                const path = this.path(module, name);
                if (url !== undefined) return `* [\`${name}\`](${url})${path}: ${summary(item, this.address)}`;
                const origin = this.json.paths[id]?.path[0];
                return `* \`${name}\`${path}${origin === undefined ? "" : ` of the crate \`${origin}\``}`;
            });
            return [`## ${module} {#${module}}`, names.join("\n")];
        });
        const intro =
            `All public names of \`${this.crate}\` by module. A program imports them with \`use ${this.crate}::prelude::*;\`; names outside the prelude have their own path beside them. \`${this.crate}-f64\` has the same names in double precision, with \`f64\` in place of \`f32\`.`;
        const head = `---\nsidebar_position: 0\nslug: /${this.folder}\n---`;
        return [head, `# Rust reference, ${this.crate}`, intro, ...lines].join("\n\n");
    }

    /** Addresses of types and of their parts by name, for links from the guide. */
    names() {
        const names = {};
        for (const page of this.pages) {
            for (const { name, id, item } of page.entries) {
                names[name] = this.addresses.get(id);
                for (const part of this.sections(item)) names[`${name}::${part.item.name}`] ??= this.addresses.get(part.id);
            }
        }
        return names;
    }
}

/** Fails if a topic names a type that no crate has. */
function checkTopics(references) {
    const lost = references[0].absent.filter((name) => references.every(({ absent }) => absent.includes(name)));
    if (lost.length > 0) throw new Error(`scripts/rust/topics.mjs names items that are not public: ${lost.join(", ")}`);
}

function writePages(website, reference) {
    const target = join(website, "generated/api", reference.folder);
    rmSync(target, { recursive: true, force: true });
    mkdirSync(target, { recursive: true });
    reference.pages.forEach((page, index) => {
        const long = page.entries.filter(({ name }) => reference.alone.has(name));
        const folder = long.length === 0 ? target : join(target, page.id);
        mkdirSync(folder, { recursive: true });
        const file = long.length === 0 ? `${page.id}.md` : "index.md";
        writeFileSync(join(folder, file), `${reference.page(page, index + 1)}\n`);
        for (const entry of long) {
            // Without its own address, `collider/Collider` would be the page of the folder.
            const head = `---\nslug: /${reference.folder}/${page.id}/${entry.name}\n---`;
            writeFileSync(join(folder, `${entry.name}.md`), `${head}\n\n${reference.entry(entry)}\n`);
        }
        const link = { type: "doc", id: `${reference.folder}/${page.id}/index` };
        const category = { label: page.title, position: index + 1, link };
        if (long.length > 0) writeFileSync(join(folder, "_category_.json"), JSON.stringify(category));
    });
    writeFileSync(join(target, "index.md"), `${reference.overview()}\n`);
}

/** Writes the Rust references of these crates (`{ name, folder, json }`). Returns addresses by name in the first one. */
export function writeRustReferences(website, crates) {
    const references = crates.map((crate) => new Reference(crate));
    checkTopics(references);
    for (const reference of references) writePages(website, reference);
    return references[0].names();
}
