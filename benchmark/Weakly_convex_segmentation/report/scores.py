# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The outcomes of run_benchmark.py: averages as the benchmark has them, ranks, the worst."""

import json
import math

from published import CATEGORIES

# name in the files: name in the report, in the order of the tables
METHODS = {
    "people": "people",
    "default": "ours, default",
    "training_free": "ours, training free",
    "paper": "ours, paper",
    "components": "components alone",
    "patches": "patches alone",
    "lines_of_sight": "lines of sight",
    "lines_of_sight_told": "lines of sight, told our number",
    "lines_of_sight_told_paper": "lines of sight, told paper's number",
    "sdf": "CGAL SDF",
    "sdf_tuned": "CGAL SDF, tuned",
    "cpc": "PCL CPC, tuned",
    "lccp": "PCL LCCP, tuned",
    "one_segment": "one segment",
}
METRICS = {
    "rand_error": "1 - Rand Index",
    "hamming": "Hamming distance",
    "gce_area": "GCEa",
    "lce_area": "LCEa",
    "cut_discrepancy": "Cut discrepancy",
}


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else math.nan


def median(values):
    values = sorted(values)
    if not values:
        return math.nan
    half = len(values) // 2
    return values[half] if len(values) % 2 else (values[half - 1] + values[half]) / 2


class Scores:
    """All scores of all models."""

    def __init__(self, path):
        with open(path) as file:
            content = json.load(file)
        self.models = content["models"]
        self.failures = content["failures"]
        present = {m for model in self.models for m in model["methods"]}
        self.methods = [m for m in METHODS if m in present]
        self.categories = [
            c for c in CATEGORIES if any(m["category"] == c for m in self.models)
        ]

    def values(self, method, score, category=None):
        """Of the models where the method succeeded and has this score."""
        return [
            model["methods"][method][score]
            for model in self.models
            if (category is None or model["category"] == category)
            and model["methods"].get(method, {}).get(score) is not None
        ]

    def of_category(self, method, score, category):
        return mean(self.values(method, score, category))

    def overall(self, method, score):
        """The mean over the categories of the means over their models."""
        of_categories = [self.of_category(method, score, c) for c in self.categories]
        return mean(v for v in of_categories if not math.isnan(v))

    def failed(self, method):
        """Messages by model."""
        return {
            model["model"]: model["methods"][method]["failure"]
            for model in self.models
            if model["methods"].get(method, {}).get("failure")
        }

    def is_skipped(self, method):
        failures = self.failed(method)
        return len(failures) == len(self.models) and any(
            f.startswith("skipped") for f in failures.values()
        )

    def seconds_per_10000_faces(self, method):
        ratios = [
            model["methods"][method]["cpu_seconds"] / model["faces"] * 1e4
            for model in self.models
            if model["methods"].get(method, {}).get("cpu_seconds") is not None
        ]
        return mean(ratios)

    def ranks(self, category, methods):
        """1 for the best by the Rand Index; ties have the better rank."""
        if category == "Overall":
            errors = {m: self.overall(m, "rand_error") for m in methods}
        else:
            errors = {m: self.of_category(m, "rand_error", category) for m in methods}
        return {
            m: math.nan if math.isnan(e) else 1 + sum(1 for o in errors.values() if o < e)
            for m, e in errors.items()
        }

    def worst_models(self, method="default"):
        """Models where the method succeeded, worst first."""
        scored = [m for m in self.models if m["methods"].get(method, {}).get("rand_error") is not None]
        return sorted(scored, key=lambda m: -m["methods"][method]["rand_error"])

    def worst_categories(self, method="default"):
        """By the distance to people."""

        def excess(category):
            return self.of_category(method, "rand_error", category) - self.of_category(
                "people", "rand_error", category
            )

        return sorted(self.categories, key=lambda c: -excess(c))

    def summary(self):
        """What a machine wants to read: by method, overall and by category."""
        columns = [*METRICS, "segments", "convexity_rank", "cpu_seconds", "peak_megabytes"]

        def numbers(value):
            return {c: None if math.isnan(value(c)) else value(c) for c in columns}

        return {
            m: {
                "failed": len(self.failed(m)),
                "overall": numbers(lambda c, m=m: self.overall(m, c)),
                "categories": {
                    k: numbers(lambda c, m=m, k=k: self.of_category(m, c, k)) for k in self.categories
                },
            }
            for m in self.methods
        }
