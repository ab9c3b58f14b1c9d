#!/usr/bin/python3
# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Fits the probabilities of the default preset to labeled shapes and writes them as a header.

    fit_merge_cost.py PROGRAM DATA_DIR WORK_DIR [--header FILE] [--variants mesh,mesh:1,surface]

PROGRAM is build/bin/fit_merge_cost, DATA_DIR holds off/ and seg/ as the Princeton benchmark has
them. Needs Debian's python3-numpy and python3-xgboost. WORK_DIR keeps the samples: remove it after a
change of the features or of the stages before them. A variant is a name that the program knows, and
with :N another seed of its patches and random choices.

Before the fit to all models, what it is worth is cross-validated twice (--protocols): `kinds` leaves
out whole categories, so that a model is only ever scored by trees that saw no shape of its kind;
`shapes` leaves out a fifth of each category, and tells what to expect on other shapes of these kinds.
Scores are those of the whole pipeline, for each of --score with its seed.
"""

import argparse
import json
import pathlib
import subprocess

import numpy as np
import xgboost

CATEGORIES = ["Human", "Cup", "Glasses", "Airplane", "Ant", "Chair", "Octopus", "Table", "Teddy",
              "Hand", "Plier", "Fish", "Bird", "Armadillo", "Bust", "Mech", "Bearing", "Vase",
              "Fourleg"]
FOLDS = {"kinds": 10, "shapes": 5}
TREES = 200
VARIANTS = ("mesh:0,mesh:1,mesh:2,mesh:3,points:0,surface:0,half:1,one_view:1,two_views:0,"
            "four_views:1,noisy_scan:0")


def category(models):
    run = (models.astype(int) - 1) // 20
    return np.where(run > 13, run - 1, run)


def feature_count(program):
    text = subprocess.run([program, "names"], check=True, capture_output=True, text=True).stdout
    return len(text.splitlines())


def read_samples(path, features):
    rows = np.fromfile(path, dtype=np.float32).reshape(-1, 3 + features)
    return rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3:]


def fold_of(models, protocol):
    kinds = category(models)
    if protocol == "kinds":
        return kinds % FOLDS[protocol]
    return ((models.astype(int) - 1) % 20 // 2 + kinds) % FOLDS[protocol]


def train(samples, chosen):
    """returns the trees for the log odds that people put the two regions of a merge together."""
    models, weights, targets, x = samples
    weights = weights[chosen] * (chosen.sum() / weights[chosen].sum())
    data = xgboost.DMatrix(x[chosen], label=targets[chosen], weight=weights)
    options = {"objective": "reg:logistic", "grow_policy": "lossguide", "max_depth": 0,
               "max_leaves": 12, "eta": 0.1, "lambda": 5, "min_child_weight": 2, "subsample": 0.5,
               "colsample_bytree": 0.3, "base_score": 0.5, "nthread": 1, "tree_method": "hist",
               "max_bin": 64}
    return xgboost.train(options, data, TREES)


def flat_tree(root):
    """returns (feature, child, value) of each node; the children of a node lie side by side."""
    nodes, queue = [None], [(0, root)]
    while queue:
        slot, node = queue.pop(0)
        if "leaf" in node:
            nodes[slot] = (-1, 0, node["leaf"])
            continue
        child = len(nodes)
        nodes += [None, None]
        below = next(c for c in node["children"] if c["nodeid"] == node["yes"])
        above = next(c for c in node["children"] if c["nodeid"] == node["no"])
        queue += [(child, below), (child + 1, above)]
        offset = child - slot if node["missing"] == node["yes"] else slot - child
        nodes[slot] = (int(node["split"][1:]), offset, node["split_condition"])
    return nodes


def flat_trees(booster):
    roots, nodes = [], []
    for text in booster.get_dump(dump_format="json"):
        roots.append(len(nodes))
        nodes += flat_tree(json.loads(text))
    return roots, nodes


def write_table(path, booster):
    roots, nodes = flat_trees(booster)
    with open(path, "w", encoding="ascii") as out:
        out.write(f"0 {len(roots)} {len(nodes)}\n" + " ".join(map(str, roots)) + "\n")
        for feature, child, value in nodes:
            out.write(f"{feature} {child} {value:.4g}\n")


def lines_of(items, width=98):
    line = ""
    for item in items:
        if len(line) + len(item) + 1 > width:
            yield line
            line = ""
        line += item + ","
    yield line


def short_literal(feature, value):
    """returns a float constant in as few characters as can be; without the suffix it would be a double,
    whose conversion is no constant expression under -frounding-math, which CGAL's users compile with"""
    text = f"{value:.3g}" if feature >= 0 else f"{value:.4f}".rstrip("0")
    text = text.replace("0.", ".", 1) if text.lstrip("-").startswith("0.") else text
    if text in (".", "-.", "0", "-0"):
        return "0.f"
    return text + ("f" if any(mark in text for mark in ".e") else ".f")


def short_node(feature, child, value):
    literal = short_literal(feature, value)
    return f"{{{literal}}}" if feature < 0 else f"{{{literal},{feature},{child}}}"


def write_header(path, booster, comment):
    roots, nodes = flat_trees(booster)
    guard = "CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_MERGING_LEARNED_COST_TABLE_H"
    with open(path, "w", encoding="ascii") as out:
        out.write("// Copyright (c) 2026  The Weakly_convex_segmentation authors.\n//\n"
                  "// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).\n"
                  "//\n// SPDX-License-Identifier: GPL-3.0-or-later\n//\n"
                  "// Author(s)     : The Weakly_convex_segmentation authors\n\n"
                  f"#ifndef {guard}\n#define {guard}\n\n"
                  "// Generated by benchmark/Weakly_convex_segmentation/fit/fit_merge_cost.py\n"
                  f"// {comment}\n"
                  "// Numbers alone: how they are used is in Learned_cost.h and Boosted_trees.h.\n\n"
                  "#include <CGAL/Weakly_convex_segmentation/internal/merging/Boosted_trees.h>\n\n"
                  "// clang-format off\n"
                  "namespace CGAL {\nnamespace Weakly_convex_segmentation {\n"
                  "namespace internal {\n\n"
                  "/// returns the trees of the default preset.\n"
                  "inline const Boosted_trees& learned_trees()\n{\n"
                  "  static constexpr std::uint16_t roots[] = {\n")
        out.write("\n".join(lines_of(map(str, roots))) + "};\n")
        out.write("  static constexpr Tree_node nodes[] = {\n")
        out.write("\n".join(lines_of(short_node(*node) for node in nodes)) + "};\n")
        out.write(f"  static constexpr Boosted_trees trees = {{nodes, roots, {len(roots)}, 0.}};\n"
                  "  return trees;\n}\n\n"
                  "} // namespace internal\n} // namespace Weakly_convex_segmentation\n"
                  "} // namespace CGAL\n// clang-format on\n\n"
                  f"#endif // {guard}\n")


def all_models(data):
    """returns the numbers of all models: of some no merge is uncertain, and they have no samples."""
    return np.array(sorted(int(path.stem) for path in (pathlib.Path(data) / "off").glob("*.off")))


def cross_validate(samples, models, protocol, folder):
    """writes a table of trees a fold, and which model is to be judged by which."""
    folder.mkdir(parents=True, exist_ok=True)
    fold = fold_of(samples[0], protocol)
    for k in range(FOLDS[protocol]):
        write_table(folder / f"{k}.txt", train(samples, fold != k))
    with open(folder / "folds.txt", "w", encoding="ascii") as out:
        for model, k in zip(models, fold_of(models, protocol)):
            out.write(f"{int(model)} {k}\n")


def call(options, task, variant, path):
    name, _, seed = variant.partition(":")
    subprocess.run([options.program, task, options.data, name, str(path), f"seed={seed or 0}"],
                   check=True)


def samples_of(options, variant, features):
    path = options.work / (variant.replace(":", "_") + ".bin")
    if not path.exists():
        options.work.mkdir(parents=True, exist_ok=True)
        unfinished = path.with_suffix(".part")
        call(options, "samples", variant, unfinished)
        unfinished.rename(path)
    return read_samples(path, features)


def joined(parts):
    models, weights, targets, x = (np.concatenate(arrays) for arrays in zip(*parts))
    known = np.isfinite(targets)
    return models[known], weights[known], targets[known], x[known]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("data")
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--header", type=pathlib.Path)
    parser.add_argument("--variants", default=VARIANTS)
    parser.add_argument("--protocols", default="kinds,shapes")
    parser.add_argument("--score", default="mesh:0,mesh:3", help="variants that are scored")
    options = parser.parse_args()
    features = feature_count(options.program)
    samples = joined([samples_of(options, v, features) for v in options.variants.split(",")])
    print(len(samples[0]), "samples", flush=True)
    for protocol in filter(None, options.protocols.split(",")):
        tables = options.work / f"tables_{protocol}"
        cross_validate(samples, all_models(options.data), protocol, tables)
        for variant in filter(None, options.score.split(",")):
            print(f"cross-validated over {protocol}, {variant}", flush=True)
            call(options, "score", variant, tables)
    if options.header:
        write_header(options.header, train(samples, np.ones(len(samples[0]), dtype=bool)),
                     f"from {len(samples[0])} merges of regions of labeled shapes.")


if __name__ == "__main__":
    main()
