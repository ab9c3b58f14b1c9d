# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# What the scripts beside this file share: source it. It goes to the root of the repository.
# shellcheck shell=bash

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
# shellcheck disable=SC2034 # used where this file is sourced
build_dir=${WCS_BUILD_DIR:-build}

export PYTHONDONTWRITEBYTECODE=1 # nothing but the build folder is written to

say() { printf '\n== %s\n' "$*"; }

# Number of parallel jobs: one a processor, but no more than there is memory for, at 2.5 GB a
# compiler. WCS_JOBS overrides.
number_of_jobs()
{
  local jobs memory limit
  jobs=$(nproc)
  memory=$(awk '/^MemAvailable:/ {print int($2 / 1024)}' /proc/meminfo)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || echo max)
  if [[ $limit =~ ^[0-9]+$ ]] && ((limit / 1048576 < memory)); then
    memory=$((limit / 1048576))
  fi
  if ((memory / 2560 < jobs)); then
    jobs=$((memory / 2560))
  fi
  echo "${WCS_JOBS:-$((jobs > 1 ? jobs : 1))}"
}

# The files whose layout .clang-format rules.
our_sources()
{
  find include tools examples test benchmark cmake \( -name '*.h' -o -name '*.cpp' \) -not -path '*/build*' |
    sort
}

# The Python to run: PYTHON, or the first that has these modules (a list for import); says so if there is none.
python_with()
{
  local candidate
  for candidate in ${PYTHON:+"$PYTHON"} python3 /usr/bin/python3; do
    if "$candidate" -c "import $1" 2>/dev/null; then
      echo "$candidate"
      return 0
    fi
  done
  echo "${0##*/}: matplotlib is missing; run scripts/setup.sh report" >&2
  return 1
}

# Ends the script unless the folder holds the benchmark.
check_benchmark_folder()
{
  if [[ ! -d $1/off || ! -d $1/seg ]]; then
    echo "${0##*/}: $1 does not hold off/ and seg/; give the folder of the benchmark" >&2
    exit 1
  fi
}

# Builds programs, and the one that takes PCL where PCL is installed.
build_with_pcl()
{
  local targets=("$@")
  cmake -S . -B "$build_dir"
  if [[ $(cmake --build "$build_dir" --target help) == *segment_by_pcl* ]]; then
    targets+=(segment_by_pcl)
  else
    echo "PCL (Debian: libpcl-dev) is not installed: its methods are skipped." >&2
  fi
  cmake --build "$build_dir" --target "${targets[@]}" -j "$(number_of_jobs)"
}
