# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes one page of what scripts/report measured: make_report.py OUT_DIR.

Reads scores.json, and, where they are there, sensitivity.json, growth.json, pictures/ and settings.json;
writes report.html (nothing outside of it is needed to read it) and summary.json.
"""

import base64
import html
import io
import json
import math
import pathlib
import sys

from PIL import Image

import plots
import published
from scores import METHODS, METRICS, Scores, mean

STYLE = """
body { font-family: sans-serif; max-width: 1500px; margin: 1em auto; padding: 0 1em; }
table { border-collapse: collapse; font-size: 13px; margin: 1em 0; }
td, th { padding: 2px 7px; text-align: right; border-bottom: 1px solid #ddd; }
td:first-child, th:first-child { text-align: left; }
tr.total td { border-top: 2px solid #333; font-weight: bold; }
td.published, th.published { color: #777; font-style: italic; }
td.best { font-weight: bold; }
.grid { display: flex; flex-wrap: wrap; gap: 8px; }
.grid figure { margin: 0; width: 360px; border: 1px solid #ddd; }
.grid img { width: 360px; } figcaption { font-size: 12px; padding: 2px 5px; }
img.chart { max-width: 100%; }
"""


def number(value, digits=3):
    return "" if value is None or math.isnan(value) else f"{value:.{digits}f}"


def table(header, rows, published_columns=(), total=False):
    """Cells are text; `published_columns` are set apart."""

    def cells(row, tag):
        return "".join(
            f"<{tag}{' class=published' if i in published_columns else ''}>{cell}</{tag}>"
            for i, cell in enumerate(row)
        )

    lines = [f"<tr>{cells(header, 'th')}</tr>"]
    for i, row in enumerate(rows):
        mark = " class=total" if total and i == len(rows) - 1 else ""
        lines.append(f"<tr{mark}>{cells(row, 'td')}</tr>")
    return "<table>" + "\n".join(lines) + "</table>"


def embedded(data, kind="png"):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def chart(data):
    return f'<img class="chart" src="{embedded(data)}">'


def overall_table(scores):
    header = ["method", *METRICS.values(), "parts", "convexity rank"]
    header += ["CPU s a model", "CPU s per 10K faces", "peak MB", "failed"]
    rows = []
    for m in scores.methods:
        if scores.is_skipped(m):
            rows.append([METHODS[m], "skipped: PCL is not installed"])
            continue
        row = [METHODS[m], *(number(scores.overall(m, metric)) for metric in METRICS)]
        row += [number(scores.overall(m, "segments"), 1), number(scores.overall(m, "convexity_rank"))]
        seconds = mean(scores.values(m, "cpu_seconds"))
        row += [number(seconds, 2), number(scores.seconds_per_10000_faces(m))]
        row += [number(max(scores.values(m, "peak_megabytes"), default=math.nan), 0)]
        rows.append(row + [str(len(scores.failed(m)))])
    rows.sort(key=lambda row: row[1] or "9")
    for name, values in published.SCORES.items():
        row = [f"<i>{name}, published, 380 models</i>"]
        rows.append(row + [f"<i>{number(values[metric])}</i>" for metric in METRICS] + [""] * 6)
    return table(header, rows)


def category_table(scores):
    """1 - RI as numbers."""
    methods = [m for m in scores.methods if not scores.is_skipped(m)]
    header = ["category", *(METHODS[m] for m in methods)]
    rows = [
        [c, *(number(scores.of_category(m, "rand_error", c)) for m in methods)]
        for c in scores.categories
    ]
    rows.append(["Overall", *(number(scores.overall(m, "rand_error")) for m in methods)])
    return table(header, rows, total=True)


def rank_table(scores):
    """Like Table I of the paper: our ranks among what is measured here, the published ones beside."""
    methods = [
        m
        for m in scores.methods
        if not scores.is_skipped(m) and m not in ("people", "patches", "components")
    ]
    header = ["category", *(METHODS[m] for m in methods)]
    header += [f"{name} (published)" for name in published.RANKED]
    rows = []
    for c in [*scores.categories, "Overall"]:
        ranks = scores.ranks(c, methods)
        row = [c, *(number(ranks[m], 0) for m in methods)]
        rows.append(row + [str(published.RANKS[c][name]) for name in published.RANKED])
    first = 1 + len(methods)
    return table(header, rows, range(first, first + len(published.RANKED)), total=True)


def ablation_table(scores):
    header = ["what is kept", *METRICS.values(), "parts", "convexity rank"]
    stages = {"patches": "patches", "components": "+ fusion", "default": "+ merging and borders"}
    rows = [
        [
            name,
            *(number(scores.overall(m, metric)) for metric in METRICS),
            number(scores.overall(m, "segments"), 1),
            number(scores.overall(m, "convexity_rank")),
        ]
        for m, name in stages.items()
        if m in scores.methods
    ]
    return table(header, rows)


def sensitivity_tables(path):
    """For each preset the mean change by parameter and step, and that of other seeds."""
    models = json.loads(path.read_text())["models"]
    result = {}
    for preset in ("default", "paper"):
        changes = {}
        for model in models:
            for change in model[preset]["changes"]:
                by_step = changes.setdefault(change["name"], {})
                by_step.setdefault(change["step"], []).append(
                    change["rand_error"] - model[preset]["base"]
                )
        means = {
            name: {step: mean(values) for step, values in steps.items()}
            for name, steps in changes.items()
        }
        seeds = means.pop("seed", {})
        noise = mean(abs(v) for v in seeds.values())
        base = mean(model[preset]["base"] for model in models)
        order = sorted(means.items(), key=lambda item: max(map(abs, item[1].values())))
        result[preset] = {"base": base, "noise": noise, "changes": order, "models": len(models)}
    return result


def sensitivity_section(path):
    parts = ["<h2 id=sensitivity>Sensitivity to each parameter</h2>"]
    parts.append(
        "<p>Every parameter by itself, 3 and 10 percent of its value down and up (counts: at least by "
        "one). Mean change of 1 - RI over the models; the base is the mean over these models.</p>"
    )
    for preset, found in sensitivity_tables(path).items():
        title = f"Preset {preset}: base {found['base']:.4f}, {found['models']} models"
        if not found["changes"]:
            continue
        parts.append(chart(plots.sensitivity_chart(found["changes"], found["noise"], title)))
        rows = [
            [name, *(f"{steps[s]:+.4f}" if s in steps else "" for s in (-10, -3, 3, 10))]
            for name, steps in reversed(found["changes"])
        ]
        if not math.isnan(found["noise"]):
            rows.append(["other seeds, mean absolute change", f"{found['noise']:.4f}", "", "", ""])
        parts.append(table([preset, "-10 %", "-3 %", "+3 %", "+10 %"], rows))
    return parts


def picture(folder, model):
    """Ours left, one person's right, as JPEG."""
    pair = [folder / f"{model}_{side}.png" for side in ("ours", "person")]
    if not all(path.exists() for path in pair):
        return ""
    left, right = (Image.open(path) for path in pair)
    joined = Image.new("RGB", (left.width + right.width, left.height))
    joined.paste(left, (0, 0))
    joined.paste(right, (left.width, 0))
    data = io.BytesIO()
    joined.save(data, "JPEG", quality=82)
    return f'<img loading="lazy" src="{embedded(data.getvalue(), "jpeg")}">'


def picture_grid(scores, folder):
    figures = []
    for model in scores.worst_models():
        ours, people = model["methods"]["default"], model["methods"].get("people", {})
        caption = (
            f"{model['model']} {model['category']}: <b>{ours['rand_error']:.3f}</b>, people "
            f"{number(people.get('rand_error'))}; {ours['segments']:.0f} parts, people "
            f"{number(people.get('segments'), 1)}"
        )
        image = picture(folder, model["model"])
        figures.append(f"<figure>{image}<figcaption>{caption}</figcaption></figure>")
    return f'<div class="grid">{"".join(figures)}</div>'


def worst_lists(scores):
    rows = [
        [
            c,
            number(scores.of_category("default", "rand_error", c)),
            number(scores.of_category("people", "rand_error", c)),
            number(scores.of_category("default", "segments", c), 1),
            number(scores.of_category("people", "segments", c), 1),
        ]
        for c in scores.worst_categories()[:5]
    ]
    return table(["worst categories, by distance to people", "ours", "people", "parts", "theirs"], rows)


def failures(scores):
    lines = [f"<li>{html.escape(n)}: {html.escape(m)}</li>" for n, m in scores.failures.items()]
    for method in scores.methods:
        if not scores.is_skipped(method):
            for model, message in scores.failed(method).items():
                lines.append(f"<li>{METHODS[method]}, model {model}: {html.escape(message)}</li>")
    return f"<ul>{''.join(lines)}</ul>" if lines else "<p>None.</p>"


def read_json(path, otherwise):
    return json.loads(path.read_text()) if path.exists() else otherwise


def page(out):
    scores = Scores(out / "scores.json")
    if not scores.models:
        sys.exit(f"make_report.py: {out / 'scores.json'} has no models; run run_benchmark.py scores")
    growth = read_json(out / "growth.json", [])
    settings = read_json(out / "settings.json", {})
    notes = "".join(f"<li>{html.escape(k)}: {html.escape(str(v))}</li>" for k, v in settings.items())
    parts = [
        "<h1>Segmentation by weakly convex parts: the benchmark</h1>",
        f"<p>{len(scores.models)} models of the Princeton Segmentation Benchmark "
        f"({plots.size_note(scores)}), {len(scores.categories)} categories. Means over a model's "
        "people, a category's models, the categories; lower is better but for convexity. The "
        "default's trees and the constants of training_free were found on the odd-numbered models, as were the "
        "settings that are called tuned. What is <i>published</i> is not measured here.</p>",
        f"<ul>{notes}</ul>",
        "<h2>Overall</h2>",
        overall_table(scores),
        f"<p>Times are of one thread; memory is the largest over the models. {published.TIMES}</p>",
        chart(plots.overall_bars(scores)),
        "<h2>1 - Rand Index by category</h2>",
        category_table(scores),
        chart(plots.category_bars(scores)),
        "<h2>Ranks by the Rand Index, as the paper's Table I</h2>",
        "<p>Left among the methods measured here, right those that the paper prints, among others' "
        "methods on all 380 models: compare within a side.</p>",
        rank_table(scores),
        "<h2>What each stage adds</h2>",
        ablation_table(scores),
        "<h2>Time</h2>",
        chart(plots.time_chart(scores, growth)),
    ]
    if (out / "sensitivity.json").exists():
        parts += sensitivity_section(out / "sensitivity.json")
    parts += [
        "<h2>Worst</h2>",
        worst_lists(scores),
        "<h2>Every model, worst first: ours, and the person nearest to the others</h2>",
        picture_grid(scores, out / "pictures"),
        "<h2>Failures</h2>",
        failures(scores),
    ]
    summary = {"settings": settings, "methods": scores.summary(), "growth": growth}
    (out / "summary.json").write_text(json.dumps(summary, indent=1))
    head = f"<!DOCTYPE html><html><head><meta charset='utf-8'><style>{STYLE}</style></head><body>"
    return head + "\n".join(parts) + "</body></html>\n"


def main():
    if len(sys.argv) != 2:
        sys.exit("make_report.py: give the folder that scripts/report made")
    out = pathlib.Path(sys.argv[1])
    text = page(out)
    (out / "report.html").write_text(text)
    print(f"{out / 'report.html'}: {len(text) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
