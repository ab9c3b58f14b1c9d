# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what scripts/scan_report measured: plot_scans.py OUT_DIR.

scans.csv becomes curves.png and categories.png, views_N.ply become views.png; what is missing is
left out.
"""

import collections
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

VIEWS = [1, 2, 4, 8, 16]


def condition(views, noise):
    return f"{views} view{'' if views == 1 else 's'}{', noise' if noise else ''}"


def category_means(rows):
    """Mean 1 - RI by (condition, method, category)."""
    values = collections.defaultdict(list)
    for row in rows:
        key = row["condition"], row["method"], row["category"]
        values[key].append(float(row["rand_error"]))
    return {key: sum(v) / len(v) for key, v in values.items()}


def overall(means, wanted_condition, method):
    values = [v for (c, m, _), v in means.items() if (c, m) == (wanted_condition, method)]
    return sum(values) / len(values) if values else float("nan")


def draw_curves(axes, value, methods):
    for color, method in enumerate(methods):
        for noise in (False, True):
            heights = [value(condition(v, noise), method) for v in VIEWS]
            axes.plot(
                range(len(VIEWS)),
                heights,
                "--" if noise else "-",
                color=f"C{color}",
                marker=".",
                label=method + (", noise" if noise else ""),
            )
    axes.set_xticks(range(len(VIEWS)), VIEWS)
    axes.set_ylim(bottom=0)


def plot_scores(folder):
    with open(folder / "scans.csv", newline="") as file:
        means = category_means(csv.DictReader(file))
    methods = sorted({m for _, m, _ in means} - {"one segment"})
    categories = list(dict.fromkeys(c for _, _, c in means))
    figure, axes = plt.subplots(figsize=(7, 5))
    draw_curves(axes, lambda c, m: overall(means, c, m), methods)
    axes.set_xlabel("views")
    axes.set_ylabel("1 - Rand Index of the seen points")
    axes.legend(fontsize=7)
    figure.savefig(folder / "curves.png", dpi=110)
    figure, grid = plt.subplots(4, 5, figsize=(16, 11))
    for axes, category in zip(grid.flat, categories):
        nan = float("nan")
        draw_curves(axes, lambda c, m: means.get((c, m, category), nan), methods)
        axes.set_title(category)
    figure.tight_layout()
    figure.savefig(folder / "categories.png", dpi=80)


def read_cloud(path):
    """Rows of an ASCII PLY file as dictionaries."""
    names = []
    with open(path) as file:
        for line in file:
            words = line.split()
            if words[0] == "property":
                names.append(words[-1])
            if words[0] == "end_header":
                break
        return [dict(zip(names, map(float, line.split()))) for line in file]


def plot_views(folder):
    paths = sorted(folder.glob("views_*.ply"), key=lambda p: int(p.stem.split("_")[1]))
    if not paths:
        return
    figure, grid = plt.subplots(1, len(paths), figsize=(3.2 * len(paths), 4.2))
    for axes, path in zip(grid, paths):
        points = read_cloud(path)
        # seen from the side where y is least; what is nearer is drawn later
        points.sort(key=lambda p: -p["y"])
        shade = [0.55 + 0.45 * max(0.0, -0.8 * p["ny"] + 0.5 * p["nz"]) for p in points]
        colors = [
            tuple(min(1.0, s * p[c] / 255) for c in ("red", "green", "blue"))
            for p, s in zip(points, shade)
        ]
        axes.scatter([p["x"] for p in points], [p["z"] for p in points], c=colors, s=1)
        views = int(path.stem.split("_")[1])
        parts = len({p["label"] for p in points})
        axes.set_title(f"{condition(views, False)}: {parts} parts", fontsize=10)
        axes.set_aspect("equal")
        axes.axis("off")
    figure.tight_layout()
    figure.savefig(folder / "views.png", dpi=90)


def main():
    if len(sys.argv) != 2:
        sys.exit("plot_scans.py: the folder is missing; give that of scans.csv and views_*.ply")
    folder = pathlib.Path(sys.argv[1])
    if (folder / "scans.csv").exists():
        plot_scores(folder)
    plot_views(folder)


if __name__ == "__main__":
    main()
