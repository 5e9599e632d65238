// How to install the engine, by language: the lines of the table in README.

import Link from "@docusaurus/Link";
import CodeBlock from "@theme/CodeBlock";
import TabItem from "@theme/TabItem";
import Tabs from "@theme/Tabs";
import type { ReactNode } from "react";
import rows from "@site/generated/data/installation.json";
import styles from "./Install.module.css";

const GUIDES: Readonly<Record<string, string>> = {
    Rust: "/docs/guide/getting-started",
    JavaScript: "/docs/guide/javascript",
    Python: "/docs/guide/python",
    Bevy: "/docs/guide/bevy",
};

interface LineProps {
    readonly title: string;
    readonly line: { readonly code: string; readonly note: string };
}

/** A line of a manifest or of a shell. */
function Line({ title, line: { code, note } }: LineProps): ReactNode {
    const shell = /^\w+ install/.test(code);
    return (
        <CodeBlock language={shell ? "bash" : "toml"} title={note === "" ? title : `${title}, ${note}`}>
            {shell ? code : `[dependencies]\n${code}`}
        </CodeBlock>
    );
}

export default function Install(): ReactNode {
    const order = Object.keys(GUIDES);
    const sorted = [...rows].sort((a, b) => order.indexOf(a.language) - order.indexOf(b.language));
    return (
        <Tabs groupId="language">
            {sorted.map(({ language, today, published }) => (
                <TabItem key={language} value={language} label={language}>
                    <div className={styles.lines}>
                        <Line title="From a clone, today" line={today} />
                        <Line title="When it is published" line={published} />
                    </div>
                    <Link to={GUIDES[language] ?? "/docs/guide"}>A first program: {language}</Link>
                </TabItem>
            ))}
        </Tabs>
    );
}
