// The page for addresses without a page.

import Link from "@docusaurus/Link";
import Heading from "@theme/Heading";
import type { ReactNode } from "react";

const PLACES = [
    ["/docs/guide", "Guide", "bodies, colliders, joints, queries, saving"],
    ["/api/rust", "Rust reference", "every public name"],
    ["/api/javascript", "JavaScript reference", "classes and interfaces"],
    ["/gallery", "Gallery", "scenes that run in the page"],
    ["/benchmarks", "Benchmarks", "times beside other engines"],
] as const;

export default function NotFoundContent(): ReactNode {
    return (
        <main className="container margin-vert--xl">
            <Heading as="h1">No page has this address</Heading>
            <p>It was moved, renamed or mistyped. The search in the bar covers all documents, and these pages lead to the others:</p>
            <ul>
                {PLACES.map(([address, name, content]) => (
                    <li key={address}>
                        <Link to={address}>{name}</Link>: {content}
                    </li>
                ))}
            </ul>
        </main>
    );
}
