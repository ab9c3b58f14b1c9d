# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Draws what scripts/scan_report measured: plot_scans.py OUT_DIR.

scans.csv becomes curves.png and categories.png, views_N.ply become views.png, clouds/ becomes
progression.png; what is missing is left out.
"""

import collections
import csv
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

VIEWS = [1, 2, 4, 8, 16]
HOLES = [0, 10, 30, 50]
COMPLETE = ", complete mesh"


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


def color_of(method, methods):
    """The labels of the complete mesh have the color of the method that found them."""
    return f"C{methods.index(method.replace(COMPLETE, ''))}"


def draw_curves(axes, value, methods):
    """Solid: without noise; dashed: with noise; dotted: the complete mesh on the same points."""
    plain = [m for m in methods if not m.endswith(COMPLETE)]
    for method in methods:
        for noise in (False, True):
            if noise and method.endswith(COMPLETE):
                continue
            heights = [value(condition(v, noise), method) for v in VIEWS]
            style = ":" if method.endswith(COMPLETE) else "--" if noise else "-"
            axes.plot(
                range(len(VIEWS)),
                heights,
                style,
                color=color_of(method, plain),
                marker=".",
                label=method + (", noise" if noise else ""),
            )
    axes.set_xticks(range(len(VIEWS)), VIEWS)
    axes.set_ylim(bottom=0)


def plot_scores(folder):
    with open(folder / "scans.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    means = category_means(rows)
    methods = [m for m in dict.fromkeys(r["method"] for r in rows) if m != "one segment"]
    categories = list(dict.fromkeys(c for _, _, c in means))
    figure, (axes, holes) = plt.subplots(1, 2, figsize=(12, 5.5), sharey=True)
    draw_curves(axes, lambda c, m: overall(means, c, m), methods)
    axes.set_xlabel("views")
    axes.set_ylabel("1 - Rand Index of the seen points")
    axes.legend(fontsize=7)
    for method in methods:
        plain = [m for m in methods if not m.endswith(COMPLETE)]
        heights = [overall(means, f"{h} % removed", method) for h in HOLES]
        style = ".:" if method.endswith(COMPLETE) else ".-"
        holes.plot(range(len(HOLES)), heights, style, color=color_of(method, plain))
    holes.set_xticks(range(len(HOLES)), HOLES)
    holes.set_xlabel("% of the surface removed")
    figure.tight_layout()
    figure.savefig(folder / "curves.png", dpi=110)
    plt.close(figure)
    figure, grid = plt.subplots(4, 5, figsize=(17, 12))
    nan = float("nan")
    for axes, category in zip(grid.flat, categories):
        draw_curves(axes, lambda c, m: means.get((c, m, category), nan), methods)
        axes.set_title(category)
    for axes in list(grid.flat)[len(categories) :]:
        axes.axis("off")
    handles, labels = grid.flat[0].get_legend_handles_labels()
    grid.flat[-1].legend(handles, labels, fontsize=7, loc="center")
    figure.tight_layout()
    figure.savefig(folder / "categories.png", dpi=80)
    plt.close(figure)


def read_labeled(path):
    """Positions, normals and labels of a cloud that benchmark_scans wrote."""
    table = np.loadtxt(path, ndmin=2)
    return table[:, :3], table[:, 3:6], table[:, 7].astype(int)


def side_of(normals, upwards=(0.0, 1.0, 0.0)):
    """Axes of a picture from where the only camera of a cloud of one view was."""
    forward = -normals.mean(axis=0)
    forward /= np.linalg.norm(forward)
    helper = np.array(upwards)
    if abs(forward @ helper) >= 0.9:
        helper = np.roll(helper, 1)
    right = np.cross(forward, helper)
    right /= np.linalg.norm(right)
    return right, np.cross(right, forward), forward


def draw_cloud(axes, cloud, side):
    """Parts by color, the largest first; what is nearer covers what is behind."""
    points, normals, labels = cloud
    right, up, forward = side
    order = np.argsort(-(points @ forward))
    rank = {label: i for i, (label, _) in enumerate(collections.Counter(labels).most_common())}
    palette = np.array(plt.get_cmap("tab20").colors)
    colors = palette[[(2 * rank[l] + rank[l] // 10) % 20 for l in labels[order]]]
    shade = np.clip(0.55 + 0.45 * -(normals[order] @ forward), 0.3, 1.0)
    axes.scatter(points[order] @ right, points[order] @ up, c=colors * shade[:, None], s=0.5, lw=0)
    axes.set_aspect("equal")
    axes.axis("off")


def plot_progression(folder):
    """A row a category: its first model from more and more sides, and sampled all over."""
    names = [condition(v, False) for v in VIEWS] + ["0 % removed"]
    file_names = [n.replace(" ", "_").replace("%", "_") for n in names]
    models = sorted(int(p.name.split("_")[0]) for p in folder.glob("clouds/*_1_view.xyz"))
    with open(folder / "scans.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    if not models or not rows:
        return
    category = {int(r["model"]): r["category"] for r in rows}
    method = next(r["method"] for r in rows if r["method"] != "one segment")
    errors = {
        (int(r["model"]), r["condition"]): float(r["rand_error"])
        for r in rows
        if r["method"] == method
    }
    first = {category[m]: m for m in reversed(models) if m in category}
    shown = sorted(first.values())
    size = (2.1 * len(names), 1.9 * len(shown))
    figure, grid = plt.subplots(len(shown), len(names), figsize=size, squeeze=False)
    for line, model in zip(grid, shown):
        side = side_of(read_labeled(folder / "clouds" / f"{model}_1_view.xyz")[1])
        for axes, name, file_name in zip(line, names, file_names):
            path = folder / "clouds" / f"{model}_{file_name}.xyz"
            axes.axis("off")
            if not path.exists():
                continue
            cloud = read_labeled(path)
            draw_cloud(axes, cloud, side)
            error = errors.get((model, name), float("nan"))
            axes.set_title(f"{name}: {len(set(cloud[2]))} parts, {error:.3f}", fontsize=7)
        line[0].set_title(f"{category[model]} {model}, " + line[0].get_title(), fontsize=7)
    figure.tight_layout(pad=0.3)
    figure.savefig(folder / "progression.png", dpi=70)
    plt.close(figure)


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
        plot_progression(folder)
    plot_views(folder)


if __name__ == "__main__":
    main()
