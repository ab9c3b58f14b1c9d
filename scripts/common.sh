# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# What the scripts beside this file share: source it. It goes to the root of the repository.
# shellcheck shell=bash

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
# shellcheck disable=SC2034 # used where this file is sourced
build_dir=${WCS_BUILD_DIR:-build}

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
