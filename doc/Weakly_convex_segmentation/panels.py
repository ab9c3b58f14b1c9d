# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The figures of make_figures that are more than labels on a surface."""

import io
import subprocess

import matplotlib
import numpy as np
from PIL import Image, ImageDraw

from drawing import PALETTE, Camera, Splats, View, colors_like, font, grid, label_colors, titled

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

SIZE = (380, 330)
PALE = np.array([170., 170., 178.])
ORANGE = np.array([235., 140., 40.])
FREE, BLOCKED = (0x2b, 0x6f, 0xb5), (0xd6, 0x4a, 0x3f)


def label(name, level, height):
    """the title of a row, on its left"""
    result = Image.new("RGB", (245, height), "white")
    draw = ImageDraw.Draw(result)
    draw.text((4, height / 2), name, fill=(30, 30, 30), font=font(12, True), anchor="lm")
    draw.text((4, height / 2 + 18), level, fill=(90, 90, 90), font=font(12), anchor="lm")
    return result


def color_bar(low, high, width, colors, text):
    """a scale below a picture"""
    result = Image.new("RGB", (width, 46), "white")
    bar = np.tile((255 * colors(np.linspace(0, 1, width - 120))[None, :, :3]).astype(np.uint8), (12, 1, 1))
    result.paste(Image.fromarray(bar), (60, 4))
    draw = ImageDraw.Draw(result)
    for x, value, anchor in ((54, low, "rm"), (width - 54, high, "lm")):
        draw.text((x, 10), value, fill=(60, 60, 60), font=font(12), anchor=anchor)
    draw.text((width / 2, 32), text, fill=(60, 60, 60), font=font(13), anchor="mm")
    return result


def below(picture, strip):
    result = Image.new("RGB", (picture.width, picture.height + strip.height), "white")
    result.paste(picture, (0, 0))
    result.paste(strip, ((picture.width - strip.width) // 2, picture.height))
    return result


def glass(mesh, camera, size=SIZE):
    view = View(mesh, camera, size).paint(np.tile(PALE, (len(mesh.faces), 1)), 0.30)
    return view.edges(np.zeros(len(mesh.faces), int))


def middle_patch(trace, mesh):
    """the patch whose centre is nearest to that of the shape's largest component"""
    patches, components = np.array(trace["labels"]["patches"]), np.array(trace["labels"]["components"])
    largest = np.bincount(components, mesh.areas).argmax()
    center = np.average(mesh.centers[components == largest], axis=0,
                        weights=mesh.areas[components == largest])
    inside = [p for p in np.unique(patches[components == largest])]
    return min(inside, key=lambda p: np.linalg.norm(mesh.centers[patches == p].mean(axis=0) - center))


def sight(trace, mesh, camera):
    lines, patches = trace["lines"], np.array(trace["labels"]["patches"])
    faces, of_patch = np.array(lines["faces"]), np.array(lines["patches"])
    patch = middle_patch(trace, mesh)
    # labels of faces are numbered in the order of the faces, those of the lines as the leaves of the tree
    seen = np.array([[c == "1" for c in row] for row in lines["seen"]])
    own = np.flatnonzero(patches[faces] == patch)
    first = own[0]
    others = np.flatnonzero(patches[faces] != patch)
    spots = mesh.centers[faces]
    view = glass(mesh, camera)
    for free, color in ((False, BLOCKED), (True, FREE)):
        ends = spots[[i for i in others if seen[first, i] == free]]
        view.lines(np.tile(spots[first], (len(ends), 1)), ends, color, 0.75 if free else 0.4, 1.1)
        view.dots(ends, color, 2.)
    view.dots(spots[[first]], (20, 20, 20), 4.5)

    leaf = of_patch[own[0]]
    visible = np.zeros(patches.max() + 1)
    for i in range(len(faces)):
        visible[patches[faces[i]]] = trace["visibility"][leaf][of_patch[i]]
    scale = pyplot.get_cmap("YlGnBu")
    tint = 255 * scale(0.05 + 0.8 * visible[patches])[:, :3]
    tint[patches == patch] = ORANGE
    shown = View(mesh, camera, SIZE).paint(tint).edges(patches == patch)
    bar = color_bar("0", "1", SIZE[0], lambda t: scale(0.05 + 0.8 * t), "visibility with the orange patch")
    key = Image.new("RGB", (SIZE[0], 46), "white")
    draw = ImageDraw.Draw(key)
    draw.text((SIZE[0] / 2 - 8, 22), "free", fill=FREE, font=font(13, True), anchor="rm")
    draw.text((SIZE[0] / 2 + 8, 22), "blocked", fill=BLOCKED, font=font(13, True), anchor="lm")
    return grid([[titled(below(view.picture(), key), "lines of sight of one point"),
                  titled(below(shown.picture(), bar), "what one patch sees")]])


def components(trace, mesh, camera, title):
    lines, labels = trace["lines"], np.array(trace["labels"]["components"])
    colors = label_colors(mesh, labels)
    faces = np.array(lines["faces"])
    spots, of = mesh.centers[faces], labels[faces]
    view = glass(mesh, camera)
    pairs = [(i, j) for i in range(len(faces)) for j in range(i) if lines["seen"][i][j] == "1"]
    first, second = np.array(pairs).T
    between = of[first] != of[second]
    view.lines(spots[first[between]], spots[second[between]], (150, 150, 150), 0.16, 0.6)
    for c in range(labels.max() + 1):
        chosen = ~between & (of[first] == c)
        view.lines(spots[first[chosen]], spots[second[chosen]], colors[c], 0.8, 0.9)
    parts = View(mesh, camera, SIZE).paint_labels(labels, colors)
    return grid([[titled(view.picture(), "free lines of sight", "colored within, grey between components"),
                  titled(parts.picture(), title, "in the same colors")]])


def profiles(trace, mesh, labels, colors):
    """histograms of the diameters of the largest regions, on the scale of the signatures"""
    faces, values = np.array([d[0] for d in trace["diameters"]]), np.array([d[1] for d in trace["diameters"]])
    values = values.astype(float)
    good = values > 0
    area = np.bincount(labels, mesh.areas)
    chosen = np.argsort(-area)[:6]
    edges = np.geomspace(values[good].min(), values.max(), 29)
    figure, axes = pyplot.subplots(len(chosen), 1, sharex=True, figsize=(3.8, 3.7), dpi=100)
    for ax, region in zip(axes, chosen):
        own = values[good & (labels[faces.astype(int)] == region)]
        share = np.histogram(own, edges)[0] / max(1, len(own))
        ax.bar(edges[:-1], share, np.diff(edges), align="edge", color=colors[region] / 255.)
        ax.set_xscale("log")
        ax.set_yticks([])
        for side in ("top", "right", "left"):
            ax.spines[side].set_visible(False)
        ax.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    ticks = [t for t in (0.02, 0.03, 0.05, 0.1, 0.2, 0.3, 0.5) if edges[0] <= t <= edges[-1]]
    axes[-1].set_xticks(ticks, [f"{t:g}" for t in ticks])
    axes[-1].set_xlabel("diameter, units of the shape")
    figure.tight_layout(h_pad=0.2)
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=100)
    pyplot.close(figure)
    return Image.open(buffer).convert("RGB")


def diameters(trace, mesh, camera):
    faces = np.array([int(d[0]) for d in trace["diameters"]])
    values = np.log(np.maximum(1e-6, np.array([d[1] for d in trace["diameters"]])))
    spots = mesh.centers[faces]
    nearest = np.array([((spots - c) ** 2).sum(axis=1).argsort()[:5] for c in mesh.centers])
    smooth = values[nearest].mean(axis=1)
    low, high = np.percentile(smooth, (1, 99))
    scale = pyplot.get_cmap("viridis")
    view = View(mesh, camera, SIZE).paint(255 * scale(np.clip((smooth - low) / (high - low), 0, 1))[:, :3])
    view.edges(np.zeros(len(mesh.faces), int))
    bar = color_bar(f"{np.exp(low):.2f}", f"{np.exp(high):.2f}", SIZE[0], scale, "diameter")
    labels = np.array(trace["labels"]["components"])
    colors = label_colors(mesh, labels)
    return grid([[titled(below(view.picture(), bar), "the diameter at each place"),
                  titled(profiles(trace, mesh, labels, colors), "the profiles of six components",
                         "in the colors of the figure before")]])


def read_cloud(path):
    """points, normals and labels of a PLY file written as text"""
    lines = path.read_text().splitlines()
    names = [line.split()[2] for line in lines if line.startswith("property")]
    rows = np.array([line.split() for line in lines[lines.index("end_header") + 1:]], float)
    column = {name: rows[:, i] for i, name in enumerate(names)}
    points, normals = (np.stack([column[c] for c in names3], 1) for names3 in ("xyz", ("nx", "ny", "nz")))
    return points, normals, column["label"].astype(int)


def scanned(programs, scratch, shape, number, camera, size):
    """the segments of what a virtual depth camera sees of a shape, and how many there are"""
    cloud, parts = scratch / "scan.ply", scratch / "parts.ply"
    subprocess.run([programs / "scan_shape", "--shape", shape, "--views", str(number), "-o", cloud],
                   check=True, stdout=subprocess.DEVNULL)
    subprocess.run([programs / "segment_shape", cloud, "--ascii", "--quiet", "-o", parts], check=True)
    points, normals, labels = read_cloud(parts)
    mesh = Splats(points, normals, 0.0045)
    view = View(mesh, camera, size).paint(PALETTE[labels % len(PALETTE)].repeat(2, axis=0))
    return view.picture(), labels.max() + 1


FRONT = Camera(285, 8)


def views(programs, scratch):
    row = []
    for number in (1, 2, 4, 8):
        picture, segments = scanned(programs, scratch, "figure", number, FRONT, (200, 320))
        row.append(titled(picture, f"{number} view{'s' if number > 1 else ''}", f"{segments} segments"))
    return grid([row])


def limits(traces, plain, count):
    """shapes of which the default gives other parts than most people would"""
    size, row = (255, 220), []
    for shape, camera in (("figure", FRONT), ("octopus", Camera(35, 20)), ("cup", Camera(20, 25)),
                          ("l_shape", Camera(35, 25))):
        picture = plain(traces, shape, camera, size)
        row.append(titled(picture, "", f"{shape}: {count(traces(shape), 'segments')}"))
    for shape in ("chair", "table"):
        picture, segments = scanned(traces.bin, traces.scratch, shape, 1, Camera(35, 25), size)
        row.append(titled(picture, "", f"{shape}, one side: {segments} segments"))
    return grid([row[:3], row[3:]])
