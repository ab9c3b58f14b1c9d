# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Pictures for the page on the paper: those of the manual's drawing code, and rows of them as HTML."""

import html
import io
import pathlib
import sys
import types

import numpy as np
from PIL import Image

from make_report import embedded

HERE = pathlib.Path(__file__).resolve()
sys.path += [str(HERE.parents[3] / "doc/Weakly_convex_segmentation"), str(HERE.parents[3] / "scripts")]
import drawing  # noqa: E402
import panels  # noqa: E402
import plot_scans  # noqa: E402, F401

SIZE = (234, 190)


def jpeg(picture):
    data = io.BytesIO()
    picture.convert("RGB").save(data, "JPEG", quality=85)
    return embedded(data.getvalue(), "jpeg")


def figure(picture, caption, width=None):
    """A picture with a line below it; the caption is HTML."""
    width = width or picture.width
    return (
        f'<figure style="width: {width}px"><img loading="lazy" style="width: {width}px" '
        f'src="{jpeg(picture)}"><figcaption>{caption}</figcaption></figure>'
    )


def tied(figures):
    """Pictures that stay together in a line."""
    return f'<div class="tied">{"".join(figures)}</div>'


def row(figures, title=""):
    head = f"<h4>{html.escape(title)}</h4>" if title else ""
    return f'{head}<div class="grid">{"".join(figures)}</div>'


def colors_for(labels):
    """A color a number, like those of the manual's figures; more parts than colors share some."""
    return drawing.PALETTE[np.arange(int(np.max(labels)) + 1) % len(drawing.PALETTE)]


def camera_along(side):
    """Looks along the axes right, up and forward."""
    right, up, forward = side
    return types.SimpleNamespace(axes=np.array([right, up, -np.asarray(forward)]))


def splats(points, normals, radius=0.005):
    """Points as squares that cover the surface between the scanner's pixels; the radius is a share of the extent."""
    return drawing.Splats(points, normals, radius * np.linalg.norm(np.ptp(points, axis=0)))


def of_cloud(surface, labels, camera, size=SIZE):
    view = drawing.View(surface, camera, size)
    return view.paint_labels(np.repeat(labels, 2), colors_for(labels)).picture()


def of_mesh(mesh, labels, camera, size=SIZE):
    return drawing.View(mesh, camera, size).paint_labels(labels, colors_for(labels)).picture()


def of_points(points, camera, size=SIZE):
    """Bare dots, those of the far side too."""
    seen = points @ camera.axes.T
    low, high = seen[:, :2].min(axis=0), seen[:, :2].max(axis=0)
    scale = 0.96 * min(size / (high - low))
    at = ((seen[:, :2] - 0.5 * (low + high)) * scale * (1, -1) + 0.5 * np.array(size)).astype(int)
    pixels = np.full((size[1], size[0], 3), 255, np.uint8)
    pixels[at[:, 1].clip(0, size[1] - 1), at[:, 0].clip(0, size[0] - 1)] = (70, 70, 78)
    return Image.fromarray(pixels)


def of_lines(trace, mesh, camera, size=SIZE, by_component=True):
    """Free lines of sight: all alike, or those within a component in its color and the others gray."""
    faces, labels = np.array(trace["lines"]["faces"]), np.array(trace["labels"]["components"])
    seen = np.array([[c == "1" for c in line] for line in trace["lines"]["seen"]])
    first, second = np.nonzero(np.tril(seen, -1))
    spots, of = mesh.centers[faces], labels[faces]
    within = (of[first] == of[second]) & by_component
    view = panels.glass(mesh, camera, size)
    color, opacity = ((150, 150, 150), 0.16) if by_component else ((0x2B, 0x6F, 0xB5), 0.3)
    view.lines(spots[first[~within]], spots[second[~within]], color, opacity, 0.6)
    colors = drawing.label_colors(mesh, labels)
    for c in np.unique(of[first[within]]):
        chosen = within & (of[first] == c)
        view.lines(spots[first[chosen]], spots[second[chosen]], colors[c], 0.8, 0.9)
    return view.picture()
