# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Figures 1 and 7 of the paper: shapes that are scanned from more and more sides, by benchmark_scans."""

import csv

import matplotlib.pyplot as plt
import numpy as np

import claims
import pictures
import plots
from claims import PRESETS, Section, Verdict
from drawing import Mesh
from labelings import matched, read_labels, read_off
from make_report import chart
from plot_scans import COMPLETE, VIEWS, category_means, condition, overall, side_of


def read_rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def curves(rows):
    """By preset: mean errors by number of views, and those of the complete shape on the same points."""
    means = category_means(rows)
    return {
        preset: {
            kind: [overall(means, condition(v, False), preset + ending) for v in VIEWS]
            for kind, ending in (("scan", ""), ("complete", COMPLETE))
        }
        for preset in PRESETS
    }


def curve_chart(found):
    figure, axes = plt.subplots(figsize=(7, 4.5))
    for color, (preset, of) in zip(("#d62728", "#1f77b4"), found.items()):
        axes.plot(range(len(VIEWS)), of["scan"], "o-", color=color, label=preset)
        axes.plot(range(len(VIEWS)), of["complete"], ":", color=color, label=f"{preset}, complete shape")
    axes.set_xticks(range(len(VIEWS)), VIEWS)
    axes.set(xlabel="scanned views", ylabel="1 - Rand Index of the seen points", ylim=(0, None))
    axes.legend()
    return plots.as_png(figure)


def read_cloud(path, index):
    """Positions, normals, faces, and the labels of the method of an index."""
    columns = np.loadtxt(path, ndmin=2)
    return columns[:, :3], columns[:, 3:6], columns[:, 6].astype(int), columns[:, 7 + index].astype(int)


def progression(out, data, model, errors):
    """For each preset the clouds of one model, and the complete mesh; all from the side of the only view."""
    paths = [out / "clouds" / f"{model}_{condition(v, False).replace(' ', '_')}.xyz" for v in VIEWS]
    mesh = Mesh(*read_off(data / "off" / f"{model}.off"))
    longest = np.eye(3)[np.ptp(mesh.points, axis=0).argmax()]
    camera = pictures.camera_along(side_of(read_cloud(paths[0], 0)[1], longest))
    surfaces = [pictures.splats(*read_cloud(path, 0)[:2]) for path in paths]
    rows = []
    for index, preset in enumerate(PRESETS):
        complete = read_labels(out / "labels" / f"{model}_{preset}.seg")
        figures = []
        for views, path, surface in zip(VIEWS, paths, surfaces):
            faces, labels = read_cloud(path, index)[2:]
            picture = pictures.of_cloud(surface, matched(labels, complete[faces]), camera)
            error = errors[condition(views, False), preset]
            caption = f"{condition(views, False)}: {len(np.unique(labels))} segments, 1 - RI <b>{error:.3f}</b>"
            figures.append(pictures.figure(picture, caption))
        picture = pictures.of_mesh(mesh, complete, camera)
        figures.append(pictures.figure(picture, f"complete shape: {len(np.unique(complete))} segments"))
        rows.append(pictures.row(figures, f"model {model}, preset {preset}"))
    return rows


def views_section(out, data, models):
    rows = read_rows(out / "scans.csv")
    found = curves(rows)
    verdicts = []
    for preset, of in found.items():
        errors = ", ".join(f"{v}: {e:.3f}" for v, e in zip(VIEWS, of["scan"]))
        rise = claims.largest_rise(of["scan"])
        figures = (
            f"1 - RI by views: {errors}; complete shape {of['complete'][-1]:.3f}; {VIEWS[-1]} views are "
            f"{of['scan'][-1] - of['complete'][-1]:+.3f} off; largest rise with more views {rise:.3f}"
        )
        verdicts.append(Verdict(preset, figures, claims.convergence(of["scan"], of["complete"][-1])))
    body = [chart(curve_chart(found))]
    measured = {int(r["model"]) for r in rows}
    for model in [m for m in models if m in measured]:
        of_model = {
            (r["condition"], r["method"]): float(r["rand_error"]) for r in rows if int(r["model"]) == model
        }
        body += progression(out, data, model, of_model)
    return Section(
        "Figures 1 and 7",
        "More and more scanned views",
        "With more views the segmentation approaches that of the complete shape; two or a few are enough for "
        "meaningful parts.",
        claims.VIEWS_CRITERION,
        verdicts,
        [
            f"<p>{len(measured)} meshes of the benchmark, the first of each category, scanned by a virtual camera from 1 to "
            "16 sides, without noise. Labels of points are scored against those that people gave to the faces that "
            "were seen; the labels of the complete mesh are scored on the same points.</p>",
            *body,
        ],
        found,
    )


def excess_of_one_view(section):
    """By preset, how much worse one view is than the complete shape on the same points."""
    return {p: of["scan"][0] - of["complete"][0] for p, of in section.numbers.items()}
