# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Runs the programs on shapes that the project makes; what is there, and newer than the programs, is kept."""

import json
import pathlib
import subprocess

import numpy as np

from labelings import read_labels, read_ply


class Cloud:
    """Points, their normals and their true labels."""

    def __init__(self, path):
        columns = read_ply(path)
        self.path = path
        self.points = np.stack([columns[c] for c in "xyz"], 1)
        self.normals = np.stack([columns[c] for c in ("nx", "ny", "nz")], 1)
        self.truth = columns["label"].astype(int)


class Made_shapes:
    def __init__(self, bin_dir, folder):
        self.bin, self.folder = pathlib.Path(bin_dir), pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def _make(self, outcome, program, *arguments):
        """Runs a program that makes a file, if it has to; the file is there as a whole or not at all."""
        path = self.bin / program
        if not outcome.exists() or outcome.stat().st_mtime < path.stat().st_mtime:
            subprocess.run([path, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)
        return outcome

    def scan(self, name):
        """A scan of make_scans."""
        return Cloud(self._make(self.folder / f"{name}.ply", "make_scans", self.folder, name))

    def one_view(self, shape, seed):
        """What a camera sees of a shape from one side."""
        path = self.folder / f"{shape}_one_view_{seed}.ply"
        options = ["--shape", shape, "--views", "1", "--seed", seed, "-o", path]
        return Cloud(self._make(path, "scan_shape", *options))

    def segments(self, cloud, preset):
        """A label a point."""
        path = cloud.path.with_name(f"{cloud.path.stem}_{preset}.seg")
        options = [cloud.path, "--preset", preset, "--threads", "1", "--quiet", "--labels", path]
        return read_labels(self._make(path, "segment_shape", *options))

    def trace(self, shape, preset):
        """What each stage makes of a shape, with the true part of each face as the labels `truth`."""
        path = self.folder / f"{shape}_{preset}.json"
        trace = json.loads(self._make(path, "trace_stages", shape, path, preset).read_text())
        truth = self._make(self.folder / f"{shape}.seg", "make_shapes", "-o", self.folder, shape)
        trace["labels"]["truth"] = read_labels(truth).tolist()
        return trace
