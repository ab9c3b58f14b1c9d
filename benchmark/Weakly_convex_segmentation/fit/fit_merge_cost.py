#!/usr/bin/python3
# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Fits the merge cost of the `fitted` preset to labeled shapes and writes it as a header.

    fit_merge_cost.py PROGRAM DATA_DIR WORK_DIR [--header FILE] [--variants mesh,mesh:1,surface]

PROGRAM is build/bin/fit_merge_cost, DATA_DIR holds off/ and seg/ as the Princeton benchmark has
them. Needs Debian's python3-numpy and python3-xgboost. WORK_DIR keeps the analyzed models and the
samples: remove it after a change of the stages before the merging. A variant is a name that the
program knows, and with :N another seed of its patches and random choices.

Before the fit to all models, what it is worth is cross-validated twice (--protocols): `kinds` leaves
out whole categories, so that a model is only ever scored by trees that saw no shape of its kind;
`shapes` leaves out a fifth of each category, and tells what to expect on other shapes of these kinds.
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
BAGS = 5
BAGS_OF_FOLDS = 2  # for a figure in a fraction of the time
TREES = 70


def category(models):
    run = (models.astype(int) - 1) // 20
    return np.where(run > 13, run - 1, run)


def feature_names(program):
    text = subprocess.run([program, "names"], check=True, capture_output=True, text=True).stdout
    return [line.split() for line in text.splitlines()]


def read_samples(path, features):
    rows = np.fromfile(path, dtype=np.float32).reshape(-1, 3 + features)
    return rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 3:]


def fold_of(models, protocol):
    kinds = category(models)
    if protocol == "kinds":
        return kinds % FOLDS[protocol]
    return ((models.astype(int) - 1) % 20 // 2 + kinds) % FOLDS[protocol]


def train(samples, chosen, monotone, bags):
    """returns the boosters of all bags, trained on the chosen rows."""
    models, weights, targets, x = samples
    weights = weights[chosen] * (chosen.sum() / weights[chosen].sum())
    data = xgboost.DMatrix(x[chosen], label=targets[chosen], weight=weights)
    options = {"objective": "binary:logistic", "max_depth": 4, "eta": 0.1, "lambda": 5,
               "subsample": 0.3, "colsample_bytree": 0.3, "base_score": 0.5, "nthread": 1,
               "tree_method": "hist", "monotone_constraints": tuple(monotone)}
    return [xgboost.train({**options, "seed": bag}, data, TREES) for bag in range(bags)]


def flat_tree(root, scale):
    """returns (feature, child, value) of each node; the children of a node lie side by side."""
    nodes, queue = [None], [(0, root)]
    while queue:
        slot, node = queue.pop(0)
        if "leaf" in node:
            nodes[slot] = (-1, 0, node["leaf"] * scale)
            continue
        child = len(nodes)
        nodes += [None, None]
        below = next(c for c in node["children"] if c["nodeid"] == node["yes"])
        above = next(c for c in node["children"] if c["nodeid"] == node["no"])
        queue += [(child, below), (child + 1, above)]
        offset = child - slot if node["missing"] == node["yes"] else slot - child
        nodes[slot] = (int(node["split"][1:]), offset, node["split_condition"])
    return nodes


def flat_trees(boosters):
    roots, nodes = [], []
    for booster in boosters:
        for text in booster.get_dump(dump_format="json"):
            roots.append(len(nodes))
            nodes += flat_tree(json.loads(text), 1. / len(boosters))
    return roots, nodes


def write_table(path, boosters):
    roots, nodes = flat_trees(boosters)
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


def write_header(path, boosters, comment):
    roots, nodes = flat_trees(boosters)
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
                  "/// returns the trees of the `fitted` preset.\n"
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


def cross_validate(samples, monotone, protocol, folder):
    """writes a table of trees a fold, and which model is to be judged by which."""
    folder.mkdir(parents=True, exist_ok=True)
    fold = fold_of(samples[0], protocol)
    for k in range(FOLDS[protocol]):
        write_table(folder / f"{k}.txt", train(samples, fold != k, monotone, BAGS_OF_FOLDS))
    models = np.unique(samples[0])
    with open(folder / "folds.txt", "w", encoding="ascii") as out:
        for model, k in zip(models, fold_of(models, protocol)):
            out.write(f"{int(model)} {k}\n")


def saved_models(options, variant):
    """returns the folder of the analyzed models of a variant, made if there is none."""
    folder = options.work / variant.replace(":", "_")
    if not (folder / "complete").exists():
        name, _, seed = variant.partition(":")
        subprocess.run([options.program, "prepare", options.data, name, str(folder),
                        f"seed={seed or 0}"], check=True)
        (folder / "complete").touch()
    return folder


def samples_of(options, variant, features, tables=None):
    folder = saved_models(options, variant)
    path = folder / ("samples1.bin" if tables is None else "samples2.bin")
    if not path.exists():
        subprocess.run([options.program, "samples", str(folder), str(path),
                        *([str(tables)] if tables else [])], check=True)
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
    parser.add_argument("--passes", type=int, default=1, help="2: also pairs on the trees' own path")
    parser.add_argument("--variants", default="mesh,mesh:1,surface,four_views")
    parser.add_argument("--protocols", default="kinds,shapes")
    parser.add_argument("--score", default="mesh", help="variants that are scored")
    parser.add_argument("--thresholds", default="0.56,0.6,0.64,0.68")
    options = parser.parse_args()
    names = feature_names(options.program)
    monotone = [int(direction) for _, direction in names]
    variants = options.variants.split(",")
    parts = [samples_of(options, v, len(names)) for v in variants]
    if options.passes > 1:
        tables = options.work / "tables_path"
        cross_validate(joined(parts), monotone, "kinds", tables)
        parts += [samples_of(options, v, len(names), tables) for v in variants]
    samples = joined(parts)
    print(len(samples[0]), "samples", flush=True)
    for protocol in filter(None, options.protocols.split(",")):
        tables = options.work / f"tables_{protocol}"
        cross_validate(samples, monotone, protocol, tables)
        for variant in options.score.split(","):
            print(f"cross-validated over {protocol}, {variant}, borders refined", flush=True)
            subprocess.run([options.program, "score_cut", str(saved_models(options, variant)),
                            str(tables), *options.thresholds.split(",")], check=True)
    if options.header:
        boosters = train(samples, np.ones(len(samples[0]), dtype=bool), monotone, BAGS)
        write_header(options.header, boosters,
                     f"from {len(samples[0])} pairs of regions of labeled shapes.")


if __name__ == "__main__":
    main()
