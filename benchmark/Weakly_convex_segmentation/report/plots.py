# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The charts of the report, as PNG bytes."""

import io
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import published
from scores import METHODS, METRICS, median


def as_png(figure):
    data = io.BytesIO()
    figure.tight_layout()
    figure.savefig(data, format="png", dpi=90)
    plt.close(figure)
    return data.getvalue()


def color_of(method):
    if method == "people":
        return "#444444"
    if method in ("default", "training_free", "paper"):
        return "#d62728"
    if method in ("components", "patches"):
        return "#f4a3a3"
    return "#1f77b4"


def overall_bars(scores):
    """One chart a metric, as the paper's Figure 8: measured bars solid, published ones hatched."""
    figure, grid = plt.subplots(2, 3, figsize=(17, 12))
    for axes, (metric, title) in zip(grid.flat, METRICS.items()):
        bars = [
            (scores.overall(m, metric), METHODS[m], color_of(m), "")
            for m in scores.methods
            if not math.isnan(scores.overall(m, metric)) and m != "one_segment"
        ]
        bars += [
            (values[metric], name + " (published)", "#cccccc", "//")
            for name, values in published.SCORES.items()
        ]
        bars.sort(reverse=True)
        for row, (value, _, color, hatch) in enumerate(bars):
            axes.barh(row, value, color=color, hatch=hatch, edgecolor="white")
            axes.text(value, row, f" {value:.3f}", va="center", fontsize=7)
        axes.set_yticks(range(len(bars)), [name for _, name, _, _ in bars], fontsize=7)
        axes.set_title(f"{title} (lower is better)", fontsize=10)
        axes.margins(x=0.15)
    draw_ranks(grid.flat[5], scores)
    return as_png(figure)


def draw_ranks(axes, scores):
    bars = sorted(
        (scores.overall(m, "convexity_rank"), METHODS[m], color_of(m))
        for m in scores.methods
        if not math.isnan(scores.overall(m, "convexity_rank"))
    )
    for row, (value, _, color) in enumerate(bars):
        axes.barh(row, value, color=color)
        axes.text(value, row, f" {value:.3f}", va="center", fontsize=7)
    axes.set_yticks(range(len(bars)), [name for _, name, _ in bars], fontsize=7)
    axes.set_title("Convexity rank of the parts, size-weighted (1: convex)", fontsize=10)
    axes.margins(x=0.15)


def category_bars(scores):
    """1 - RI of every category: people, ours, and the best others."""
    chosen = [
        m
        for m in ("people", "default", "training_free", "paper", "cpc", "sdf_tuned", "lines_of_sight")
        if m in scores.methods and scores.values(m, "rand_error")
    ]
    figure, axes = plt.subplots(figsize=(17, 5))
    width = 0.85 / max(1, len(chosen))
    for i, method in enumerate(chosen):
        heights = [scores.of_category(method, "rand_error", c) for c in scores.categories]
        places = [c + (i - (len(chosen) - 1) / 2) * width for c in range(len(heights))]
        color = "#444444" if method == "people" else f"C{i - 1}"
        axes.bar(places, heights, width, label=METHODS[method], color=color)
    axes.set_xticks(range(len(scores.categories)), scores.categories, rotation=30)
    axes.set_ylabel("1 - Rand Index")
    axes.legend(fontsize=8, ncol=4)
    return as_png(figure)


def time_chart(scores, growth):
    """Left: every model and method; right: clouds of one shape that grow."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(15, 5.5))
    for method in scores.methods:
        points = [
            (m["faces"], m["methods"][method]["cpu_seconds"])
            for m in scores.models
            if m["methods"].get(method, {}).get("cpu_seconds")
        ]
        if points and method not in ("components", "patches", "one_segment"):
            left.scatter(*zip(*points), s=7, label=METHODS[method])
    left.set_title("Models of the benchmark")
    left.set_xlabel("faces")
    if growth:
        right.plot([g["points"] for g in growth], [g["seconds"] for g in growth], "o-", label="all")
    for stage in growth[0]["stages"] if growth else []:
        right.plot(
            [g["points"] for g in growth], [g["stages"][stage] for g in growth], ".--", label=stage
        )
    right.set_title("Clouds of one shape (default, one thread)")
    right.set_xlabel("points")
    for axes in (left, right):
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_ylabel("seconds")
        if axes.has_data():
            axes.legend(fontsize=7)
    return as_png(figure)


def sensitivity_chart(table, noise, title):
    """Change of the score a parameter; the gray band is what another seed changes."""
    figure, axes = plt.subplots(figsize=(11, 1.2 + 0.3 * len(table)))
    if not math.isnan(noise):
        label = f"other seeds: {noise:.4f} (mean absolute change)"
        axes.axvspan(-noise, noise, color="#dddddd", label=label)
    largest = max(abs(c) for _, changes in table for c in changes.values())
    axes.set_xlim(-1.1 * largest - 1e-5, 1.1 * largest + 1e-5)
    for row, (_, changes) in enumerate(table):
        for step, color in ((-10, "#1f77b4"), (-3, "#9ecae1"), (3, "#fdae6b"), (10, "#e6550d")):
            if step in changes:
                label = f"{step:+d} %" if row == 0 else None
                axes.plot(changes[step], row, "o", color=color, label=label)
    axes.set_yticks(range(len(table)), [name for name, _ in table], fontsize=8)
    axes.set_ylim(-0.6, len(table) - 0.4)
    axes.axvline(0, color="black", linewidth=0.5)
    axes.set_xlabel("change of 1 - Rand Index (to the right is worse)")
    axes.set_title(title, fontsize=10)
    axes.legend(fontsize=7)
    return as_png(figure)


def size_note(scores):
    faces = [m["faces"] for m in scores.models]
    return f"{min(faces):,} to {max(faces):,} faces, median {median(faces):,.0f}" if faces else ""
