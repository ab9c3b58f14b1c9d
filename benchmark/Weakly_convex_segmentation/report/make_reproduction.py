# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the page on the paper of what scripts/reproduce_paper measured: make_reproduction.py BIN_DIR DATA_DIR OUT_DIR.

Reads scores.json, labels/, scans.csv, clouds/, sensitivity.json, growth_*.json and settings.json, and runs the
programs on shapes that are made in code (kept in made/); writes reproduction.html, reproduction.json and
reproduction.txt.
"""

import json
import pathlib
import sys

import pictures  # noqa: F401  first: it finds the drawing code of the manual
import benchmark_sections as of_benchmark
import made_sections as of_made
import reproduction_page
import views_section as of_views
from made_shapes import Made_shapes
from make_report import read_json
from scores import Scores

SHOWN = (1, 121)  # models whose progression is drawn


def all_sections(bin_dir, data, out):
    scores, made = Scores(out / "scores.json"), Made_shapes(bin_dir, out / "made")
    drawn = of_benchmark.Drawn_models(bin_dir, data, out)
    views = of_views.views_section(out, data, SHOWN)
    return [
        views,
        of_made.stages_section(made),
        of_made.gallery_section(made),
        of_benchmark.meshes_section(scores, drawn),
        of_benchmark.metrics_section(scores),
        of_benchmark.ranks_section(scores),
        of_benchmark.convexity_section(scores, drawn),
        of_made.room_section(made),
        of_made.limits_section(made, of_views.excess_of_one_view(views)),
        of_benchmark.sensitivity_section(out / "sensitivity.json"),
        of_benchmark.time_section(out, scores),
    ]


def main():
    if len(sys.argv) != 4:
        sys.exit("make_reproduction.py: give BIN_DIR DATA_DIR OUT_DIR")
    bin_dir, data, out = map(pathlib.Path, sys.argv[1:])
    sections = all_sections(bin_dir, data, out)
    settings = read_json(out / "settings.json", {})
    text = reproduction_page.page(sections, settings)
    (out / "reproduction.html").write_text(text)
    (out / "reproduction.json").write_text(json.dumps(reproduction_page.as_json(sections, settings), indent=1))
    (out / "reproduction.txt").write_text(reproduction_page.fragment(sections, settings))
    print(reproduction_page.printed(sections))
    print(f"{out / 'reproduction.html'}: {len(text) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
