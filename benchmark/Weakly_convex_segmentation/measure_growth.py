# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Time against the number of points: measure_growth.py BIN_DIR OUTCOME.json MOST_POINTS [SHAPE [PRESET]]

Clouds of one shape, from 1,000 points on, each about three times the one before, are segmented by
segment_shape on one thread; of three runs, the middle one counts.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

SIZES = [1000, 3000, 10000, 30000, 100000, 300000, 1000000, 3000000]


def measured(bin_dir, folder, size, shape, preset):
    make = [bin_dir / "make_shapes", "--cloud", "--points", str(size), shape]
    subprocess.run(make, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    stats = folder / "stats.json"
    run = [bin_dir / "segment_shape", folder / f"{shape}.ply", "--threads", "1", "--quiet"]
    run += ["--preset", preset]
    runs = []
    for _ in range(3):
        subprocess.run([*run, "--stats", stats], check=True)
        runs.append(json.loads(stats.read_text())["seconds"])
    middle = sorted(runs, key=lambda seconds: seconds["segmentation"])[1]
    return {"points": size, "seconds": middle["segmentation"], "stages": middle["stages"]}


def main():
    if len(sys.argv) not in (4, 5, 6) or not sys.argv[3].isdigit():
        sys.exit("measure_growth.py: give BIN_DIR OUTCOME.json MOST_POINTS [SHAPE [PRESET]]")
    bin_dir, outcome = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    shape, preset = [*sys.argv[4:], *["figure", "default"][len(sys.argv) - 4 :]]
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for size in SIZES:
            if size <= int(sys.argv[3]):
                try:
                    rows.append(measured(bin_dir, pathlib.Path(folder), size, shape, preset))
                except (OSError, subprocess.CalledProcessError) as error:
                    sys.exit(f"measure_growth.py: {error}")
                print(f"{size} points: {rows[-1]['seconds']:.3f} s", flush=True)
    outcome.write_text(json.dumps(rows))


if __name__ == "__main__":
    main()
