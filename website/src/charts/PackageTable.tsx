// Times of npm packages, with the best of each row in bold.

import type { ReactNode } from "react";
import ScrollTable from "@site/src/components/ScrollTable";
import data from "@site/generated/data/packages.json";

export default function PackageTable({ title }: { readonly title: string }): ReactNode {
    const table = data.find((candidate) => candidate.title === title);
    if (table === undefined) throw new RangeError(`docs/benchmarks/javascript.md has no table "${title}"`);
    return (
        <ScrollTable label={title}>
            <caption>{title}: milliseconds per step</caption>
            <thead>
                <tr>
                    <th scope="col">scene</th>
                    {table.engines.map((engine) => (
                        <th key={engine} scope="col">
                            {engine}
                        </th>
                    ))}
                </tr>
            </thead>
            <tbody>
                {table.rows.map(({ scene, times }) => {
                    const best = Math.min(...times.map((time) => time ?? Infinity));
                    return (
                        <tr key={scene}>
                            <th scope="row">{scene}</th>
                            {times.map((time, index) => (
                                <td key={table.engines[index]}>{time === best ? <strong>{time}</strong> : (time ?? "–")}</td>
                            ))}
                        </tr>
                    );
                })}
            </tbody>
        </ScrollTable>
    );
}
