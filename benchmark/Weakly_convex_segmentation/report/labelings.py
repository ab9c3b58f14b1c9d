# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Labels of points or faces against other labels of the same; reading of files with points and labels."""

import numpy as np


def contingency(first, second):
    """How many elements have each pair of labels."""
    a = np.unique(first, return_inverse=True)[1]
    b = np.unique(second, return_inverse=True)[1]
    table = np.zeros((a.max() + 1, b.max() + 1))
    np.add.at(table, (a, b), 1)
    return table


def rand_error(first, second):
    """1 - Rand Index: the share of the pairs that one puts together and the other apart."""

    def pairs(n):
        return (n * (n - 1) / 2).sum()

    table = contingency(first, second)
    apart = pairs(table.sum(axis=1)) + pairs(table.sum(axis=0)) - 2 * pairs(table)
    return float(apart / max(1.0, pairs(table.sum())))


def share_found(labels, truth, least=0.01):
    """The share of the true parts, above a least size, that one segment has half of the union in common with."""
    table = contingency(labels, truth)
    union = table.sum(axis=1, keepdims=True) + table.sum(axis=0, keepdims=True) - table
    large = table.sum(axis=0) >= least * table.sum()
    return float(((table / union).max(axis=0) >= 0.5)[large].mean())


def purity(labels, truth):
    """The share of the elements that belong to what most of their segment belongs to."""
    table = contingency(labels, truth)
    return float(table.max(axis=1).sum() / table.sum())


def pieces(labels, is_of_part, least=0.05):
    """How many segments have a share of a part; slivers don't count."""
    counts = np.unique(np.asarray(labels)[is_of_part], return_counts=True)[1]
    return int((counts >= least * counts.sum()).sum())


def matched(labels, reference):
    """Other numbers for the labels: that of the reference label they have most in common with, each once.

    The rest get the numbers from that of the reference on."""
    first, index = np.unique(labels, return_inverse=True)
    table = np.zeros((len(first), int(np.max(reference)) + 1))
    np.add.at(table, (index, np.asarray(reference)), 1)
    number, taken = np.full(len(first), -1), set()
    for flat in np.argsort(-table, axis=None, kind="stable"):
        label, other = divmod(int(flat), table.shape[1])
        if number[label] < 0 and other not in taken and table[label, other] > 0:
            number[label] = other
            taken.add(other)
    rest = np.flatnonzero(number < 0)
    number[rest] = table.shape[1] + np.arange(len(rest))
    return number[index]


def read_labels(path):
    return np.loadtxt(path, dtype=int, ndmin=1)


def read_ply(path):
    """The columns of an ASCII PLY file of points, by name."""
    lines = path.read_text().splitlines()
    names = [line.split()[-1] for line in lines if line.startswith("property")]
    rows = np.array([line.split() for line in lines[lines.index("end_header") + 1 :]], float)
    return {name: rows[:, i] for i, name in enumerate(names)}


def read_off(path):
    """The points and triangles of an OFF file."""
    words = path.read_text().split()
    points, faces = int(words[1]), int(words[2])
    at = 4 + 3 * points
    corners = np.array(words[at : at + 4 * faces], int).reshape(-1, 4)[:, 1:]
    return np.array(words[4:at], float).reshape(-1, 3), corners
