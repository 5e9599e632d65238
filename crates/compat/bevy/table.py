#!/usr/bin/env python3
"""Prints the measurements of crates/compat/bevy_examples.sh as a Markdown table: table.py FOLDER."""

import pathlib
import sys

folder = pathlib.Path(sys.argv[1])


def runs():
    """Returns the runs by example and engine, each as a dictionary of numbers."""
    result = {}
    for line in (folder / "runs.txt").read_text().splitlines():
        example, engine, *values = line.split()
        run = {name: float(value) for name, value in (entry.split("=") for entry in values)}
        result.setdefault(example, {}).setdefault(engine, []).append(run)
    return result


def lines(example):
    """Returns how the printed lines of both engines compare."""
    upstream, facade = (
        (folder / "lines" / f"{engine}-{example}.txt").read_text(errors="replace").splitlines()
        for engine in ("upstream", "facade")
    )
    if upstream == facade:
        return f"same ({len(upstream)})" if upstream else "none"
    if sorted(upstream) == sorted(facade):
        return f"same ({len(upstream)}), other order"
    return f"differ ({len(upstream)}, {len(facade)})"


def time(seconds):
    """Returns a time in microseconds, with three digits or all digits before the point."""
    value = seconds * 1e6
    return f"{value:,.0f}" if value >= 99.5 else f"{value:.3g}"


print("| example | bodies | step, upstream (µs) | step, facade (µs) | ratio | ratio of means | touching pairs at the end | touching pairs, mean | lines |")
print("|---|--:|--:|--:|--:|--:|--:|--:|---|")
for example, engines in sorted(runs().items()):
    upstream, facade = engines["upstream"], engines["facade"]
    failed = [name for name, runs in engines.items() if any(run["status"] or "steps" not in run for run in runs)]
    if failed:
        print(f"| {example} | failed on {', '.join(failed)} | | | | | | | {lines(example)} |")
        continue
    times, means = ([min(run[key] for run in runs) for runs in (upstream, facade)] for key in ("median", "mean"))
    first, second = upstream[0], facade[0]
    bodies = f"{first['bodies']:.0f}" if first["bodies"] == second["bodies"] else f"{first['bodies']:.0f}, {second['bodies']:.0f}"
    print(
        f"| {example} | {bodies} | {time(times[0])} | {time(times[1])} | {times[1] / times[0]:.2f} | {means[1] / means[0]:.2f}"
        f" | {first['touching']:.0f}, {second['touching']:.0f} | {first['touching_mean']:.0f}, {second['touching_mean']:.0f} | {lines(example)} |"
    )
