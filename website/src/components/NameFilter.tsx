// Hides the sections of a page whose headings lack a word.

import { type ReactNode, type RefObject, useEffect, useState } from "react";
import styles from "./NameFilter.module.css";

const HEADING = /^H[23]$/;

/** Hides sections without the word. A section of second level stays where one of its parts matches. */
function filter(children: readonly Element[], word: string): void {
    let shown = true;
    let chapter: Element | null = null;
    for (const child of children) {
        if (HEADING.test(child.tagName)) {
            shown = (child.textContent ?? "").toLowerCase().includes(word);
            if (child.tagName === "H2") chapter = child;
            else if (shown) chapter?.removeAttribute("hidden");
        }
        child.toggleAttribute("hidden", !shown);
    }
}

function NameFilter({ page }: { readonly page: RefObject<HTMLElement | null> }): ReactNode {
    const [word, setWord] = useState("");
    useEffect(() => {
        const text = page.current?.querySelector(".markdown");
        if (text) filter(Array.from(text.children), word.trim().toLowerCase());
    }, [word]);
    return (
        <input
            type="search"
            className={styles.filter}
            aria-label="Filter the names of this page"
            placeholder="Filter the names of this page"
            value={word}
            onChange={(event) => setWord(event.target.value)}
        />
    );
}

/** Headings of a page with a filter at least. */
NameFilter.NAMES_MIN = 12;

export default NameFilter;
