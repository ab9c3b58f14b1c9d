# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The page on the paper, its figures for machines, and the table for the manual, from the sections."""

import dataclasses
import html
import math

from claims import PRESETS
from make_report import STYLE

OWN_STYLE = """
p, li { max-width: 62em; } h4 { margin: 0.7em 0 0.3em 0; }
.grid figure, .grid img { width: auto; }
.tied { display: flex; gap: 4px; margin-right: 6px; }
table.verdicts td, table.verdicts th { text-align: left; vertical-align: top; }
td.yes { background: #d9efd5; } td.partly { background: #fbf0c4; } td.no { background: #f6d4d0; }
"""


def escaped(text):
    return html.escape(text, quote=False)


def holds_cell(verdict):
    return f"<td class={verdict.holds}>{verdict.holds}</td>"


def summary_table(sections):
    """All verdicts, each with a link to its section."""
    head = "".join(f"<th>{p}</th>" for p in PRESETS)
    lines = [f"<tr><th>in the paper</th><th>what it shows</th>{head}</tr>"]
    for i, s in enumerate(sections):
        cells = "".join(map(holds_cell, s.verdicts))
        link = f'<a href="#s{i}">{escaped(s.figure)}: {escaped(s.title)}</a>'
        lines.append(f"<tr><td>{link}</td><td>{escaped(s.paper)}</td>{cells}</tr>")
    return '<table class="verdicts">' + "\n".join(lines) + "</table>"


def section_html(index, section):
    lines = ["<tr><th>preset</th><th>what we show</th><th>holds</th></tr>"]
    for v in section.verdicts:
        lines.append(f"<tr><td>{v.preset}</td><td>{escaped(v.figures)}</td>{holds_cell(v)}</tr>")
    return "\n".join(
        [
            f"<h2 id=s{index}>{escaped(section.figure)}: {escaped(section.title)}</h2>",
            f"<p><b>The paper shows:</b> {escaped(section.paper)}</p>",
            f"<p><b>It holds</b> if: {escaped(section.criterion)}</p>",
            f'<table class="verdicts">{"".join(lines)}</table>',
            *section.body,
        ]
    )


def page(sections, settings):
    notes = "".join(f"<li>{escaped(k)}: {escaped(str(v))}</li>" for k, v in settings.items())
    return "\n".join(
        [
            "<!DOCTYPE html><html lang=en><head><meta charset='utf-8'><title>The figures of the paper</title>",
            f"<style>{STYLE}{OWN_STYLE}</style></head><body>",
            "<h1>Shape Segmentation by Approximate Convexity Analysis: the figures of the paper, made again</h1>",
            "<p>Each figure, table and claim of van Kaick et al. 2014 beside what this package does, with the preset "
            "<code>paper</code> (the paper's rules and values) and the default. Whether a claim holds is computed from "
            "the figures by the criterion that its section states; the criteria are ours, as the paper states none. "
            "Shapes and scans are others than the paper's, where those are not public: 1 - RI is 1 - Rand Index, "
            "against people's parts or against the true ones of shapes that are made in code; lower is better.</p>",
            f"<ul>{notes}</ul>",
            "<h2>All verdicts</h2>",
            summary_table(sections),
            *(section_html(i, s) for i, s in enumerate(sections)),
            "</body></html>\n",
        ]
    )


def without_nan(value):
    """JSON has no numbers that are none."""
    if isinstance(value, dict):
        return {str(k): without_nan(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [without_nan(v) for v in value]
    return None if isinstance(value, float) and math.isnan(value) else value


def as_json(sections, settings):
    keys = ("figure", "title", "paper", "criterion", "numbers")
    return without_nan(
        {
            "settings": settings,
            "sections": [
                {**{k: getattr(s, k) for k in keys}, "verdicts": [dataclasses.asdict(v) for v in s.verdicts]}
                for s in sections
            ],
        }
    )


def cell(text):
    """Text that is safe in a cell of a Markdown table that Doxygen reads."""
    return "".join("\\" + sign if sign in "\\%@#|<>" else sign for sign in text)


def fragment(sections, settings):
    """A table for the manual, as Doxygen reads it."""
    lines = [
        f"Made by `scripts/reproduce_paper` ({cell(settings.get('extent', ''))}), whose page has the criteria and pictures:",
        "",
        "| in the paper | what the paper shows | what we show | does it hold |",
        "|---|---|---|---|",
    ]
    for s in sections:
        shown = "<br>".join(f"`{v.preset}`: {cell(v.figures)}." for v in s.verdicts)
        holds = ", ".join(f"`{v.preset}`: {v.holds}" for v in s.verdicts)
        lines.append(f"| {cell(s.figure)}: {cell(s.title)} | {cell(s.paper)} | {shown} | {holds} |")
    return "\n".join(lines) + "\n"


def printed(sections):
    """One line a verdict, for a terminal."""
    return "\n".join(
        f"{s.figure}, {s.title}: {v.preset}: {v.holds.upper()}: {v.figures}" for s in sections for v in s.verdicts
    )
