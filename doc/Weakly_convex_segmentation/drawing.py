# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""What make_figures draws with: meshes seen from far away, in rows of panels with titles.

Drawn here and not by a viewer, so that lines and values can be laid over the surface and the pictures
come out the same on every machine.
"""

import math
import pathlib

import matplotlib
import numpy as np
from PIL import Image, ImageDraw, ImageFont

SAMPLES = 3  # a side of a pixel

# Neighbours differ in lightness too, so that the parts can be told apart in grey.
PALETTE = np.array([(0xe4, 0x9a, 0x3c), (0x3b, 0x7d, 0xb8), (0x8f, 0xc1, 0x6b), (0xc8, 0x55, 0x4b),
                    (0x84, 0x6a, 0xb0), (0xf2, 0xd0, 0x5c), (0x4d, 0xa8, 0xa1), (0xdd, 0x8f, 0xb6),
                    (0x8c, 0x6b, 0x52), (0xa5, 0xc8, 0xe8), (0x4f, 0x8a, 0x4a), (0xb9, 0xb3, 0xa9),
                    (0xea, 0xb4, 0x9e), (0x5b, 0x62, 0x92), (0x9e, 0x40, 0x70), (0x2f, 0x70, 0x66)],
                   float)


def font(size, bold=False):
    name = "DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf"
    return ImageFont.truetype(str(pathlib.Path(matplotlib.get_data_path()) / "fonts/ttf" / name), size)


class Mesh:
    """Triangles and their smoothed normals; shapes stand upright on z."""

    def __init__(self, points, faces):
        self.points = np.asarray(points, float)
        self.faces = np.asarray(faces, int)
        corners = self.points[self.faces]
        self.centers = corners.mean(axis=1)
        cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length = np.linalg.norm(cross, axis=1)
        self.areas = 0.5 * length
        self.normals = self._smoothed(cross / np.maximum(length, 1e-30)[:, None])

    def _smoothed(self, normals):
        """the mean over the faces at the corners, but not across sharp edges"""
        at = [[] for _ in self.points]
        for f, face in enumerate(self.faces):
            for v in face:
                at[v].append(f)
        result = np.empty_like(normals)
        for f, face in enumerate(self.faces):
            near = normals[at[face[0]] + at[face[1]] + at[face[2]]]
            result[f] = near[near @ normals[f] > 0.75].sum(axis=0)
        return result / np.linalg.norm(result, axis=1)[:, None]

    def adjacent_faces(self):
        first, pairs = {}, []
        for f, face in enumerate(self.faces):
            for i in range(3):
                edge = tuple(sorted((face[i], face[i - 1])))
                if edge in first:
                    pairs.append((first[edge], f))
                else:
                    first[edge] = f
        return np.array(pairs)


class Splats(Mesh):
    """Points as small squares on their tangent planes, two faces each; labels of points are doubled for it."""

    def __init__(self, points, normals, radius):
        points, normals = np.asarray(points, float), np.asarray(normals, float)
        flat = np.abs(normals[:, 2:]) < 0.9
        across = np.cross(normals, np.where(flat, [[0., 0., 1.]], [[1., 0., 0.]]))
        across *= radius / np.linalg.norm(across, axis=1)[:, None]
        along = np.cross(normals, across)
        corners = [points + i * across + j * along for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        first = 4 * np.arange(len(points))
        faces = np.stack([first, first + 1, first + 2, first, first + 2, first + 3], 1).reshape(-1, 3)
        self.of_faces = np.repeat(normals, 2, axis=0)
        super().__init__(np.stack(corners, 1).reshape(-1, 3), faces)

    def _smoothed(self, normals):
        return self.of_faces


def label_colors(mesh, labels):
    """a colour a label, the large ones first, none like those of its neighbours"""
    labels = np.asarray(labels)
    count = labels.max() + 1
    pairs = labels[mesh.adjacent_faces()]
    neighbors = [set() for _ in range(count)]
    for a, b in pairs[pairs[:, 0] != pairs[:, 1]]:
        neighbors[a].add(b)
        neighbors[b].add(a)
    area = np.bincount(labels, mesh.areas, count)
    color, used = np.full(count, -1), np.zeros(len(PALETTE))
    for label in np.argsort(-area):
        taken = {color[n] for n in neighbors[label]}
        free = [c for c in range(len(PALETTE)) if c not in taken] or range(len(PALETTE))
        color[label] = min(free, key=lambda c: used[c])
        used[color[label]] += 1
    return PALETTE[color]


def colors_like(mesh, labels, reference, reference_colors):
    """each label in the colour of what it has most area in common with in another labelling"""
    labels, reference = np.asarray(labels), np.asarray(reference)
    common = np.zeros((labels.max() + 1, reference.max() + 1))
    np.add.at(common, (labels, reference), mesh.areas)
    return reference_colors[common.argmax(axis=1)]


class Camera:
    """Looks from far away; angles in degrees, about the z axis and above the ground."""

    def __init__(self, around, above):
        a, b = math.radians(around), math.radians(above)
        out = np.array([math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), math.sin(b)])
        right = np.array([-math.sin(a), math.cos(a), 0.])
        self.axes = np.array([right, np.cross(out, right), out])


class View:
    """A mesh in a picture; `window` is a part of it in shares, (left, top, right, bottom)."""

    def __init__(self, mesh, camera, size, window=(0., 0., 1., 1.)):
        self.mesh, self.camera = mesh, camera
        seen = mesh.points @ camera.axes.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        width, height = size[0] * SAMPLES, size[1] * SAMPLES
        scale = 0.96 * min(width / (high[0] - low[0]), height / (high[1] - low[1]))
        zoom = 1. / (window[2] - window[0])
        middle = 0.5 * (low + high)
        middle[0] += (0.5 * (window[0] + window[2]) - 0.5) * width / scale
        middle[1] -= (0.5 * (window[1] + window[3]) - 0.5) * height / scale
        self.scale, self.middle, self.width, self.height = scale * zoom, middle, width, height
        self.image = Image.new("RGB", (width, height), "white")
        self._find_faces()

    def project(self, points):
        q = (np.asarray(points, float) @ self.camera.axes.T - self.middle) * self.scale
        return np.stack([q[..., 0] + 0.5 * self.width, 0.5 * self.height - q[..., 1], q[..., 2]], -1)

    def _find_faces(self):
        """the face in front at each pixel, -1 for none: all pixels of all faces, the near ones last"""
        corners = self.project(self.mesh.points)[self.mesh.faces]
        flat = corners[..., :2]
        low = np.clip(np.floor(flat.min(axis=1)).astype(int), 0, (self.width, self.height))
        high = np.clip(np.ceil(flat.max(axis=1)).astype(int), 0, (self.width, self.height))
        extent = np.maximum(high - low, 0)
        count = extent[:, 0] * extent[:, 1]
        face = np.repeat(np.arange(len(count)), count)
        step = np.arange(len(face)) - np.repeat(np.cumsum(count) - count, count)
        x = low[face, 0] + step % np.maximum(extent[face, 0], 1)
        y = low[face, 1] + step // np.maximum(extent[face, 0], 1)
        a, u, v = corners[face, 0], corners[face, 1] - corners[face, 0], corners[face, 2] - corners[face, 0]
        area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        area[area == 0.] = np.inf
        dx, dy = x + 0.5 - a[:, 0], y + 0.5 - a[:, 1]
        s, t = (dx * v[:, 1] - dy * v[:, 0]) / area, (u[:, 0] * dy - u[:, 1] * dx) / area
        inside = (s >= 0) & (t >= 0) & (s + t <= 1) & np.isfinite(area)
        depth = (a[:, 2] + s * u[:, 2] + t * v[:, 2])[inside]
        order = np.argsort(depth, kind="stable")
        self.face = np.full((self.height, self.width), -1)
        self.depth = np.full((self.height, self.width), -np.inf)
        self.face[y[inside][order], x[inside][order]] = face[inside][order]
        self.depth[y[inside][order], x[inside][order]] = depth[order]

    def paint(self, face_colors, opacity=1.):
        n = self.mesh.normals @ self.camera.axes.T
        above = 0.45 * n[:, 1] - 0.35 * n[:, 0] + 0.82 * n[:, 2]
        shade = 0.42 + 0.22 * np.abs(n[:, 2]) + 0.42 * np.maximum(above, 0.)
        lit = np.minimum(np.asarray(face_colors, float) * shade[:, None], 255.)
        hit = self.face >= 0
        pixels = np.full((self.height, self.width, 3), 255.)
        pixels[hit] = 255. - opacity * (255. - lit[self.face[hit]])
        self.image = Image.fromarray(pixels.astype(np.uint8))
        return self

    def paint_labels(self, labels, colors):
        labels = np.asarray(labels)
        self.paint(colors[labels])
        return self.edges(labels)

    def edges(self, labels):
        """darkens where labels meet, and where one thing is in front of another"""
        label = np.where(self.face >= 0, np.asarray(labels)[self.face], -1)
        depth = np.where(self.face >= 0, self.depth, -1e9)
        jump = 0.05 * self.width
        dark = np.zeros(label.shape, bool)
        for axis in (0, 1):
            meets = (label != np.roll(label, 1, axis)) | (np.abs(depth - np.roll(depth, 1, axis)) > jump)
            dark |= meets | np.roll(meets, -1, axis)
        pixels = np.asarray(self.image, float).copy()
        pixels[dark & (self.face >= 0)] *= 0.45
        self.image = Image.fromarray(pixels.astype(np.uint8))
        return self

    def lines(self, starts, ends, color, opacity, width=1.):
        self._overlay(color, opacity, lambda draw: [
            draw.line([tuple(p), tuple(q)], fill=255, width=max(1, round(width * SAMPLES)))
            for p, q in zip(self.project(starts)[:, :2], self.project(ends)[:, :2])])
        return self

    def dots(self, points, color, radius):
        r = radius * SAMPLES
        self._overlay(color, 1., lambda draw: [
            draw.ellipse([x - r, y - r, x + r, y + r], fill=255)
            for x, y in self.project(points)[:, :2]])
        return self

    def _overlay(self, color, opacity, draw_on):
        mask = Image.new("L", self.image.size, 0)
        draw_on(ImageDraw.Draw(mask))
        mask = mask.point(lambda v: round(v * opacity))
        self.image.paste(Image.new("RGB", self.image.size, tuple(int(c) for c in color)), (0, 0), mask)

    def picture(self):
        return self.image.resize((self.width // SAMPLES, self.height // SAMPLES), Image.LANCZOS)


def titled(picture, title, subtitle="", size=15):
    """a picture with a title above it, and a fainter line below that"""
    height = int(size * (1.7 if title else 0) + size * (1.35 if subtitle else 0))
    result = Image.new("RGB", (picture.width, picture.height + height), "white")
    draw = ImageDraw.Draw(result)
    draw.text((picture.width / 2, size * 0.85), title, fill=(30, 30, 30), font=font(size, True), anchor="mm")
    if subtitle:
        draw.text((picture.width / 2, height - size * 0.8), subtitle, fill=(90, 90, 90),
                  font=font(size - 2), anchor="mm")
    result.paste(picture, (0, height))
    return result


def grid(rows, gap=14):
    """rows of pictures, each row centred"""
    widths = [sum(p.width for p in row) + gap * (len(row) - 1) for row in rows]
    heights = [max(p.height for p in row) for row in rows]
    result = Image.new("RGB", (max(widths) + 2 * gap, sum(heights) + gap * (len(rows) + 1)), "white")
    y = gap
    for row, width, height in zip(rows, widths, heights):
        x = (result.width - width) // 2
        for picture in row:
            result.paste(picture, (x, y))
            x += picture.width + gap
        y += height + gap
    return result


def save(picture, path):
    picture.quantize(256, kmeans=2, dither=Image.Dither.NONE).save(path, optimize=True)
    print(f"{path}: {picture.width} x {picture.height}, {pathlib.Path(path).stat().st_size // 1024} kB")
