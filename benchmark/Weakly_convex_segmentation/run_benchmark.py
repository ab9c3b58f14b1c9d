# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Drives the programs of the benchmark over many shapes; Python's standard library is enough.

    run_benchmark.py scores DATA_DIR OUT_DIR        benchmark_shape on the models of DATA_DIR
    run_benchmark.py sensitivity DATA_DIR OUT_DIR   benchmark_sensitivity on the same
    run_benchmark.py corpus FOLDER OUT_DIR          segment_shape on every shape in FOLDER
    run_benchmark.py merge OUT_DIR                  only merge what other machines have made

Every shape is one call of a program, with an exit code and a JSON file in a folder of OUT_DIR. A shape
whose file is there and newer than the programs is not run again: an interrupted run goes on where it
stopped. With --methods the file is one of its own: of all files of a model the newest outcome of each
method counts. For other options give another OUT_DIR. Afterwards all files are merged to OUT_DIR/scores.json
and scores.csv, sensitivity.json, or corpus.json and corpus.csv.
"""

import argparse
import concurrent.futures
import csv
import json
import os
import pathlib
import subprocess
import sys
import time

SHAPE_ENDINGS = {".off", ".ply", ".obj", ".stl", ".xyz", ".pwn"}
SCORES = [
    "rand_error",
    "hamming",
    "missing_rate",
    "false_alarm_rate",
    "gce",
    "lce",
    "gce_area",
    "lce_area",
    "cut_discrepancy",
    "segments",
    "convexity_rank",
    "cpu_seconds",
    "peak_megabytes",
    "parent_megabytes",
    "failure",
]


def fail(message):
    sys.exit(f"run_benchmark.py: {message}")


def write_whole(path, text):
    """A file that is there as a whole or not at all."""
    part = path.with_name(path.name + f".{os.getpid()}.tmp")
    part.write_text(text)
    part.replace(path)


def benchmark_models(options):
    """Numbers of the wanted models in DATA_DIR, at most so many of each run of 20: the smallest."""
    if options.models:
        return [int(m) for m in options.models.split(",")]
    folder, count = options.input / "off", options.per_category
    sizes = {int(p.stem): p.stat().st_size for p in folder.glob("*.off") if p.stem.isdigit()}
    if not sizes:
        fail(f"there are no models in {folder}; give the folder that holds off/ and seg/")
    if not count:
        return sorted(sizes)
    categories = {}
    for model in sorted(sizes, key=sizes.get):
        categories.setdefault((model - 1) // 20, []).append(model)
    return sorted(model for members in categories.values() for model in members[:count])


class Job:
    """One shape: the command that makes `outcome`."""

    def __init__(self, name, command, outcome, programs):
        self.name = name
        self.command = command
        self.outcome = outcome
        self.programs = programs

    def is_done(self):
        if not self.outcome.exists():
            return False
        made = self.outcome.stat().st_mtime
        return all(p.stat().st_mtime <= made for p in self.programs if p.exists())

    def run(self, seconds):
        """Returns a message if it failed."""
        try:
            done = subprocess.run(
                self.command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=seconds
            )
        except subprocess.TimeoutExpired:
            return f"stopped after {seconds} s"
        except OSError as error:
            return str(error)
        if done.returncode < 0:
            return f"ended by signal {-done.returncode}"
        if done.returncode > 0:
            lines = done.stderr.decode(errors="replace").strip().splitlines()
            return lines[-1] if lines else f"exit code {done.returncode}"
        return None


def run_jobs(jobs, options):
    """Runs what has no outcome yet; prints progress and returns failures by name."""
    waiting = [job for job in jobs if not job.is_done()]
    if len(waiting) < len(jobs):
        print(f"{len(jobs) - len(waiting)} of {len(jobs)} shapes are done already", flush=True)
    failures = {}
    begin = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        running = {pool.submit(job.run, options.seconds): job for job in waiting}
        for count, done in enumerate(concurrent.futures.as_completed(running), 1):
            job = running[done]
            message = done.result()
            if message is None and not job.is_done():
                message = "it wrote no outcome"
            if message:
                failures[job.name] = message
            spent = time.monotonic() - begin
            left = spent / count * (len(waiting) - count)
            print(
                f"{count}/{len(waiting)} {job.name}: {message or 'done'} "
                f"({spent:.0f} s, {left:.0f} s left)",
                flush=True,
            )
    return failures


def read_outcomes(folder):
    """The JSON files of a folder, oldest first, and failures of those that can't be read."""
    outcomes, failures = [], {}
    for path in sorted(folder.glob("*.json"), key=lambda p: (p.stat().st_mtime, p.name)):
        try:
            outcomes.append(json.loads(path.read_text()))
        except ValueError as error:
            failures[path.stem] = f"{path} is no JSON ({error}); remove it and run again"
    return outcomes, failures


def write_csv(path, columns, rows):
    part = path.with_name(path.name + ".tmp")
    with open(part, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)
    part.replace(path)


def joined_by_model(outcomes):
    """Of files of the same model the outcomes of the methods of all, the last file's before others'."""
    models = {}
    for outcome in outcomes:
        known = models.setdefault(outcome["model"], outcome)
        known["methods"].update(outcome["methods"])
    return [models[number] for number in sorted(models)]


def merge_scores(out, failures):
    outcomes, unreadable = read_outcomes(out / "scores")
    failures = {**unreadable, **failures}
    outcomes = joined_by_model(outcomes)
    write_whole(out / "scores.json", json.dumps({"models": outcomes, "failures": failures}))
    rows = [
        {"model": o["model"], "category": o["category"], "faces": o["faces"], "method": m, **values}
        for o in outcomes
        for m, values in o["methods"].items()
    ]
    write_csv(out / "scores.csv", ["model", "category", "faces", "method"] + SCORES, rows)
    print_overall(rows)
    return failures


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else float("nan")


def overall(rows, method, score):
    """Over a category's models, then over the categories, as the benchmark averages."""
    of_category = {}
    for row in rows:
        if row["method"] == method and row.get(score) is not None:
            of_category.setdefault(row["category"], []).append(row[score])
    return mean(mean(values) for values in of_category.values())


def print_overall(rows):
    columns = ["rand_error", "hamming", "cut_discrepancy", "segments", "convexity_rank"]
    print(f"{'':20}" + "".join(f"{c[:15]:>17}" for c in columns) + "    failed")
    for method in dict.fromkeys(row["method"] for row in rows):
        failed = sum(1 for r in rows if r["method"] == method and r.get("failure"))
        numbers = "".join(f"{overall(rows, method, c):17.4f}" for c in columns)
        print(f"{method:20}{numbers}{failed:10}")


def merge_sensitivity(out, failures):
    outcomes, unreadable = read_outcomes(out / "sensitivity")
    failures = {**unreadable, **failures}
    write_whole(out / "sensitivity.json", json.dumps({"models": outcomes, "failures": failures}))
    return failures


def merge_corpus(out, failures):
    outcomes, unreadable = read_outcomes(out / "corpus")
    failures = {**unreadable, **failures}
    write_whole(out / "corpus.json", json.dumps({"shapes": outcomes, "failures": failures}))
    rows = [
        {
            "shape": o["input"],
            "kind": o["kind"],
            "points": o["number_of_points"],
            "faces": o["number_of_faces"],
            "parts": o["number_of_segments"],
            "seconds": o["seconds"]["segmentation"],
        }
        for o in outcomes
    ]
    rows += [{"shape": name, "failure": message} for name, message in failures.items()]
    columns = ["shape", "kind", "points", "faces", "parts", "seconds", "failure"]
    write_csv(out / "corpus.csv", columns, rows)
    print(f"{len(outcomes)} shapes, {len(failures)} failures")
    return failures


def score_jobs(options):
    folder = options.out / "scores"
    folder.mkdir(parents=True, exist_ok=True)
    program = options.bin / "benchmark_shape"
    for model in benchmark_models(options):
        methods = "_" + options.methods.replace(",", "_") if options.methods else ""
        outcome = folder / f"{model}{methods}.json"
        command = [program, options.input, str(model), "--json", outcome]
        command += ["--pictures", options.out / "pictures"]
        if options.labels:
            command += ["--labels", options.out / "labels"]
        if options.methods:
            command += ["--methods", options.methods]
        programs = [program, options.bin / "segment_by_pcl"]
        yield Job(f"model {model}", command, outcome, programs)


def sensitivity_jobs(options):
    folder = options.out / "sensitivity"
    folder.mkdir(parents=True, exist_ok=True)
    program = options.bin / "benchmark_sensitivity"
    for model in benchmark_models(options):
        outcome = folder / f"{model}.json"
        command = [program, options.input, str(model), outcome]
        if options.merging_only:
            command.append("--merging-only")
        yield Job(f"model {model}", command, outcome, [program])


def corpus_jobs(options):
    """Labels and a picture first: the statistics are the outcome that says that all is done."""
    for name in ("corpus", "labels", "pictures"):
        (options.out / name).mkdir(parents=True, exist_ok=True)
    shapes = sorted(
        p for p in options.input.rglob("*") if p.suffix.lower() in SHAPE_ENDINGS and p.is_file()
    )
    if not shapes:
        fail(f"there are no shapes in {options.input}; it reads {' '.join(sorted(SHAPE_ENDINGS))}")
    for shape in shapes:
        name = "_".join(shape.relative_to(options.input).parts)
        stats = options.out / "corpus" / f"{name}.json"
        labels = options.out / "labels" / f"{name}.seg"
        unfinished = stats.with_suffix(".unfinished")
        script = (
            '"$1" "$2" --threads 1 --quiet --labels "$3" --stats "$4" && '
            '"$5" "$2" "$3" "$6" && mv "$4" "$7"'
        )
        command = ["/bin/sh", "-c", script, "sh", options.bin / "segment_shape", shape, labels]
        command += [unfinished, options.bin / "draw_labels"]
        command += [options.out / "pictures" / f"{name}.png", stats]
        programs = [options.bin / "segment_shape"]
        yield Job(str(shape.relative_to(options.input)), command, stats, programs)


KINDS = {
    "scores": (score_jobs, merge_scores),
    "sensitivity": (sensitivity_jobs, merge_sensitivity),
    "corpus": (corpus_jobs, merge_corpus),
}


def read_options():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("kind", choices=[*KINDS, "merge"])
    parser.add_argument("folders", nargs="+", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--bin", type=pathlib.Path, default=pathlib.Path("build/bin"))
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="shapes at once")
    parser.add_argument("--seconds", type=float, default=1800, help="most time for a shape")
    parser.add_argument("--per-category", type=int, default=0, help="so many small models; 0: all")
    parser.add_argument("--models", help="only these of the benchmark, as 1,3,21")
    parser.add_argument("--methods", help="passed to benchmark_shape")
    parser.add_argument("--labels", action="store_true", help="scores: keep the labels of all methods")
    parser.add_argument("--merging-only", action="store_true", help="sensitivity: no analysis anew")
    options = parser.parse_args()
    if len(options.folders) != (1 if options.kind == "merge" else 2):
        parser.error("give OUT_DIR after merge, else the folder of the shapes and OUT_DIR")
    options.input, options.out = options.folders[0].resolve(), options.folders[-1].resolve()
    options.bin = options.bin.resolve()
    return options


def main():
    options = read_options()
    if options.kind == "merge":
        for kind, (_, merge) in KINDS.items():
            if (options.out / kind).is_dir():
                merge(options.out, {})
        return
    if not options.input.is_dir():
        fail(f"there is no folder {options.input}")
    make_jobs, merge = KINDS[options.kind]
    failures = merge(options.out, run_jobs(list(make_jobs(options)), options))
    for name, message in failures.items():
        print(f"{name}: {message}", file=sys.stderr)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
