# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes one page of a run over any shapes: make_corpus_page.py OUT_DIR

Reads corpus.json and pictures/ of `run_benchmark.py corpus`; writes corpus.html, which needs no other
file.
"""

import html
import io
import json
import pathlib
import sys

from PIL import Image

from make_report import STYLE, embedded
from scores import median


def picture(path):
    if not path.exists():
        return ""
    data = io.BytesIO()
    Image.open(path).save(data, "JPEG", quality=82)
    return f'<img loading="lazy" style="width: 220px" src="{embedded(data.getvalue(), "jpeg")}">'


def figure(folder, shape):
    name = pathlib.Path(shape["input"]).name
    found = sorted(folder.glob(f"*{name}.png"), key=lambda p: len(p.name))
    size = shape["number_of_faces"] or shape["number_of_points"]
    caption = (
        f"{html.escape(name)}: {size:,} {'faces' if shape['number_of_faces'] else 'points'}, "
        f"<b>{shape['number_of_segments']} parts</b>, {shape['seconds']['segmentation']:.2f} s"
    )
    image = picture(found[0]) if found else ""
    return f'<figure style="width: 222px">{image}<figcaption>{caption}</figcaption></figure>'


def main():
    if len(sys.argv) != 2:
        sys.exit("make_corpus_page.py: give the folder that run_benchmark.py corpus made")
    out = pathlib.Path(sys.argv[1])
    content = json.loads((out / "corpus.json").read_text())
    shapes, failures = content["shapes"], content["failures"]
    seconds = median(s["seconds"]["segmentation"] for s in shapes)
    parts = median(s["number_of_segments"] for s in shapes)
    lines = [f"<li>{html.escape(k)}: {html.escape(v)}</li>" for k, v in failures.items()]
    figures = "".join(figure(out / "pictures", s) for s in shapes)
    text = (
        f"<!DOCTYPE html><html><head><meta charset='utf-8'><style>{STYLE}</style></head><body>"
        f"<h1>{len(shapes)} shapes, {len(failures)} failures</h1>"
        f"<p>Median: {parts:.0f} parts, {seconds:.2f} s without reading, one thread.</p>"
        f'<div class="grid">{figures}</div><h2>Failures</h2><ul>{"".join(lines) or "None."}</ul>'
        "</body></html>\n"
    )
    (out / "corpus.html").write_text(text)
    print(out / "corpus.html")


if __name__ == "__main__":
    main()
