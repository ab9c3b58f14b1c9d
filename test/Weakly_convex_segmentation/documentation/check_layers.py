#!/usr/bin/env python3
# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks that the stages of the library include only what comes before them, and that no headers include
each other in a circle.

  check_layers.py SOURCE_DIR

The check tries itself on wrong includes that it makes up: it fails if it does not find them.
"""

import pathlib
import re
import sys

FOLDER = "CGAL/Weakly_convex_segmentation/"

# From what all may include to what only callers include. A name that ends with a slash is a folder.
LAYERS = (
    ("internal/kernel/", "Symmetry_plane.h", "Visitor.h", "Parameters.h", "Normal_orientation.h", "Piece_rule.h", "Merge_tree.h",
     "Result.h", "Default_traits.h", "named_parameters.h", "Convexity_graph.h"),
    ("internal/input/",),
    ("internal/points/",),
    ("internal/patches/", "Patch_clustering.h"),
    ("internal/visibility/",),
    ("internal/diameters/",),
    ("internal/oracles.h", "internal/shape_analysis.h"),
    ("internal/merging/", "Region_pair.h", "Merge_cost.h"),
    ("internal/consensus/",),
    ("internal/borders/",),
    ("internal/output/",),
    ("internal/pipeline.h", "internal/Segmenter_impl.h"),
)


def layer_of(header):
    """the number of the layer of a header, named from FOLDER on"""
    for number, layer in enumerate(LAYERS):
        if any(header == name or (name.endswith("/") and header.startswith(name)) for name in layer):
            return number
    if header.startswith("internal/"):
        raise ValueError(f"{header} belongs to no stage")
    return len(LAYERS)


def wrong_includes(includes):
    """the errors in a dictionary from headers to the headers that they include"""
    errors = []
    for header, included in sorted(includes.items()):
        try:
            errors += [f"{header} includes {other}, which comes later" for other in sorted(included)
                       if layer_of(other) > layer_of(header)]
        except ValueError as error:
            errors.append(str(error))
    return errors + circles(includes)


def circles(includes):
    """the first headers found to include themselves by way of others"""
    errors, done = [], set()

    def visit(header, way):
        if header in way:
            errors.append("in a circle: " + " -> ".join(way[way.index(header):] + [header]))
        elif header not in done:
            for other in sorted(includes.get(header, ())):
                visit(other, way + [header])
            done.add(header)

    for header in sorted(includes):
        visit(header, [])
    return errors


def includes_of(source):
    """what the headers of the library include of each other"""
    root = pathlib.Path(source) / "include" / FOLDER
    return {str(path.relative_to(root)): set(re.findall(rf"#\s*include\s*[<\"]{FOLDER}([^>\"]+)[>\"]",
                                                       path.read_text(encoding="utf-8")))
            for path in root.rglob("*.h")}


def check_the_check():
    """finds wrong includes that are made up"""
    def count(includes):
        return len(wrong_includes(includes))

    right = {"internal/points/a.h": {"internal/kernel/b.h"}, "internal/kernel/b.h": {"Parameters.h"}}
    return (count(right) == 0 and count({"internal/kernel/a.h": {"internal/input/b.h"}}) == 1
            and count({"internal/points/a.h": {"Segmenter.h"}}) == 1
            and count({"internal/new_stage/a.h": {"Parameters.h"}}) == 1
            and count({"Parameters.h": {"Visitor.h"}, "Visitor.h": {"Parameters.h"}}) == 1)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if not check_the_check():
        sys.exit("the check does not find wrong includes")
    includes = includes_of(sys.argv[1])
    if not any(includes.values()):
        sys.exit(f"there are no headers in {sys.argv[1]}")
    errors = wrong_includes(includes)
    print("\n".join(errors) or f"{len(includes)} headers include what comes before them only")
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
