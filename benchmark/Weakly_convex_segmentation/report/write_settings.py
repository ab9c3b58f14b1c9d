# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""What was measured, where and how long: write_settings.py SETTINGS.json SCRIPT JOBS SECONDS EXTENT"""

import json
import platform
import subprocess
import sys


def processor():
    try:
        with open("/proc/cpuinfo") as file:
            names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
            return names[0] if names else platform.machine()
    except OSError:
        return platform.machine()


def main():
    path, script, jobs, seconds, extent = sys.argv[1:]
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], capture_output=True, text=True)
    settings = {
        "command": f"{script} DATA_DIR OUT_DIR ({extent})",
        "extent": extent,
        "version": commit.stdout.strip() or "unknown",
        "processor": processor(),
        "models at once": jobs,
        "seconds of measuring": seconds,
    }
    with open(path, "w") as file:
        json.dump(settings, file)


if __name__ == "__main__":
    main()
