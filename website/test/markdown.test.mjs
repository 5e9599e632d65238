// Links of doc comments on the pages of the reference.

import assert from "node:assert/strict";
import { test } from "node:test";
import { markdown } from "../scripts/rust/markdown.mjs";

const address = (id) => ({ 1: "/api/rust/collider#collider" })[id];

test("a link that spans two lines leads to the reference", () => {
    const item = { docs: "A [shape\nof a body](crate::Collider) here.", links: { "crate::Collider": 1 } };
    assert.equal(markdown(item, address), "A [shape\nof a body](/api/rust/collider#collider) here.");
});

test("brackets before a link stay text", () => {
    const item = { docs: "In [0, 1):\nsee [it](Self::new).", links: { "Self::new": 1 } };
    assert.equal(markdown(item, address), "In [0, 1):\nsee [it](/api/rust/collider#collider).");
});

test("a link to an item without a page becomes text", () => {
    assert.equal(markdown({ docs: "See [it](crate::Hidden).", links: { "crate::Hidden": 2 } }, address), "See it.");
});

test("a link without a target fails", () => {
    for (const target of ["crate::Lost", "super::Lost", "Self::lost"])
        assert.throws(() => markdown({ docs: `See [it](${target}).`, links: {} }, address), /leads nowhere/);
});

test("programs lose their hidden lines and keep their brackets", () => {
    const item = { docs: "Text.\n```\n# use x;\nlet a = b[c](crate::d);\n```\nMore.", links: {} };
    assert.equal(markdown(item, address), "Text.\n```rust\nlet a = b[c](crate::d);\n```\nMore.");
});
