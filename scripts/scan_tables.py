# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Tables of what scripts/scan_report measured, and whether its targets are met: scan_tables.py OUT_DIR.

Reads scans.csv and, if it is there, scenes.csv; prints the tables and writes them to tables.md.
"""

import collections
import csv
import math
import pathlib
import sys

OURS = ["default", "training_free"]
# a difference that rounding could make is none
EPSILON = 1e-9


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else math.nan


def read_rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def unique(values):
    return list(dict.fromkeys(values))


def is_complete(method):
    return method.endswith(", complete mesh")


class Scores:
    """1 - RI of every method on every cloud."""

    def __init__(self, rows):
        self.conditions = unique(r["condition"] for r in rows)
        self.methods = unique(r["method"] for r in rows)
        self.of = {
            (r["condition"], r["method"], int(r["model"])): float(r["rand_error"]) for r in rows
        }
        self.category = {int(r["model"]): r["category"] for r in rows}
        self.failures = collections.Counter(
            (r["condition"], r["method"]) for r in rows if r["failure"]
        )
        self.reasons = collections.Counter(
            (r["method"], r["failure"]) for r in rows if r["failure"]
        )

    def overall(self, condition, method):
        """Over a category's models, then over the categories, as the benchmark averages."""
        categories = collections.defaultdict(list)
        for (c, m, model), value in self.of.items():
            if (c, m) == (condition, method):
                categories[self.category[model]].append(value)
        return mean(mean(values) for values in categories.values())

    def alternatives(self):
        return [
            m
            for m in self.methods
            if m not in OURS + ["paper", "one segment"] and not is_complete(m)
        ]

    def worse_models(self, condition, method, other):
        """Models on which a method is worse than another."""
        pairs = [
            (self.of[condition, method, m], self.of.get((condition, other, m)), m)
            for m in self.category
            if (condition, method, m) in self.of
        ]
        return [m for ours, theirs, m in pairs if theirs is not None and ours > theirs + EPSILON]


def markdown(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows]


def score_table(scores):
    rows = []
    for c in scores.conditions:
        best = min((scores.overall(c, m) for m in scores.methods if not is_complete(m)))
        row = [c]
        for m in scores.methods:
            value = scores.overall(c, m)
            text = f"{value:.3f}"
            if not is_complete(m) and value <= best:
                text = f"**{text}**"
            failed = scores.failures[c, m]
            row.append(text + (f" ({failed} failed)" if failed else ""))
        rows.append(row)
    return markdown(["1 - RI"] + scores.methods, rows)


def verdict(is_met):
    return "pass" if is_met else "MISS"


def near_complete(scores, method):
    """Few views within a margin of the labels of the complete mesh on the same points."""
    for views, margin in ((2, 0.05), (4, 0.02)):
        for noise in ("", ", noise"):
            c = f"{views} views{noise}"
            if c not in scores.conditions or method + ", complete mesh" not in scores.methods:
                continue
            ours = scores.overall(c, method)
            complete = scores.overall(c, method + ", complete mesh")
            what = f"{method}, {c}: within {margin} of the complete mesh"
            figures = f"{ours:.3f} against {complete:.3f}: {ours - complete:+.3f}"
            yield what, figures, ours - complete <= margin


def better_than_others(scores, method):
    """Better than the best alternative on every kind of cloud."""
    others = scores.alternatives()
    for c in scores.conditions if others else []:
        best = min(others, key=lambda m: scores.overall(c, m))
        ours, theirs = scores.overall(c, method), scores.overall(c, best)
        worse = len(scores.worse_models(c, method, best))
        what = f"{method}, {c}: better than every alternative"
        figures = f"{ours:.3f} against {best} {theirs:.3f}; worse on {worse} models"
        yield what, figures, ours < theirs


def never_worse_than_one(scores, method):
    """Not worse than one segment on any model seen from one side."""
    for c in ("1 view", "1 view, noise"):
        if c not in scores.conditions:
            continue
        count = sum(1 for m in scores.category if (c, method, m) in scores.of)
        worse = scores.worse_models(c, method, "one segment")
        names = ", ".join(f"{m} ({scores.category[m]})" for m in worse)
        what = f"{method}, {c}: no model worse than one segment"
        yield what, f"{len(worse)} of {count} models worse" + (f": {names}" if names else ""), not worse


def targets(scores):
    for method in [m for m in OURS if m in scores.methods]:
        yield from near_complete(scores, method)
        yield from never_worse_than_one(scores, method)
        yield from better_than_others(scores, method)


def one_segment_counts(scores):
    """How many models each method makes worse than one segment, from one side."""
    conditions = [c for c in ("1 view", "1 view, noise") if c in scores.conditions]
    methods = [m for m in scores.methods if m != "one segment"]
    rows = [
        [c] + [len(scores.worse_models(c, m, "one segment")) for m in methods] for c in conditions
    ]
    return markdown(["models worse than one segment"] + methods, rows)


def scan_report(rows):
    scores = Scores(rows)
    lines = [f"# Incomplete scans of {len(scores.category)} models", ""]
    lines += score_table(scores) + [""] + one_segment_counts(scores)
    for (method, reason), count in scores.reasons.items():
        lines += ["", f"{method} failed on {count} clouds, counted as one segment: {reason}"]
    lines += ["", "## Targets", ""]
    lines += markdown(
        ["target", "measured", ""], [[w, f, verdict(ok)] for w, f, ok in targets(scores)]
    )
    return lines


def scene_report(rows):
    methods = unique(r["method"] for r in rows)
    names = ["over_segmentation", "under_segmentation", "weighted_overlap", "unweighted_overlap"]
    count = len(unique(r["scene"] for r in rows))
    table, overlap, longest = [], {}, {}
    for m in methods:
        of_method = [r for r in rows if r["method"] == m]
        values = [mean(float(r[n]) for r in of_method) for n in names]
        seconds = [float(r["seconds"]) for r in of_method]
        overlap[m], longest[m] = values[2], max(seconds)
        failed = sum(1 for r in of_method if r["failure"])
        table.append(
            [m] + [f"{v:.3f}" for v in values] + [f"{mean(seconds):.2f}", f"{max(seconds):.2f}", failed]
        )
    header = ["", "F_os", "F_us", "weighted overlap", "overlap", "s", "most s", "failed"]
    lines = ["", f"# {count} depth-camera scenes", ""] + markdown(header, table)
    verdicts = []
    others = [m for m in methods if m not in OURS + ["pieces"]]
    for m in [m for m in OURS if m in methods]:
        verdicts.append([f"{m}: at most 5 s a scene", f"{longest[m]:.2f} s", verdict(longest[m] <= 5)])
        for other in others:
            verdicts.append(
                [
                    f"{m}: weighted overlap above {other}",
                    f"{overlap[m]:.3f} against {overlap[other]:.3f}",
                    verdict(overlap[m] > overlap[other]),
                ]
            )
    return lines + ["", "## Targets", ""] + markdown(["target", "measured", ""], verdicts)


def main():
    if len(sys.argv) != 2:
        sys.exit("scan_tables.py: the folder is missing; give that of scans.csv")
    folder = pathlib.Path(sys.argv[1])
    if not (folder / "scans.csv").exists():
        sys.exit(f"scan_tables.py: {folder / 'scans.csv'} is missing; run scripts/scan_report")
    lines = scan_report(read_rows(folder / "scans.csv"))
    if (folder / "scenes.csv").exists():
        lines += scene_report(read_rows(folder / "scenes.csv"))
    text = "\n".join(lines) + "\n"
    (folder / "tables.md").write_text(text)
    print(text, end="")


if __name__ == "__main__":
    main()
