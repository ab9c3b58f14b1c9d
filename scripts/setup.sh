#!/usr/bin/env bash
# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the Debian (or Ubuntu) packages that are missing, and does nothing if none is.
#
#   scripts/setup.sh [GROUP...]      groups: build test doc report pcl view;
#                                  without any: build test
#
# build: compiler and libraries, among them two that only read files (glTF, 3MF, DAE, FBX and .gz; 31 MB,
# may be missing); test: what scripts/test needs besides; doc: the tool that makes the manual;
# report: what scripts/report, scripts/scan_report and scripts/reproduce_paper draw with; pcl: a library whose
# methods the benchmark compares with (large); view: npm, with which the page of segment_shape --view is made,
# and a browser that tests it.

set -euo pipefail

build=(g++ make cmake libcgal-dev libboost-dev libboost-program-options-dev libeigen3-dev
       libspectra-dev libtbb-dev libpng-dev nlohmann-json3-dev libassimp-dev libboost-iostreams-dev)
test=(libbenchmark-dev clang-14 clang-format-14 python3)
doc=(doxygen)
report=(python3-matplotlib python3-pil)
pcl=(libpcl-dev)
view=(chromium)
if ! command -v npm >/dev/null; then
  view+=(nodejs npm)
fi

if (($# == 0)); then
  set -- build test
fi

wanted=()
for group in "$@"; do
  case $group in
    build) wanted+=("${build[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    doc) wanted+=("${doc[@]}") ;;
    report) wanted+=("${report[@]}") ;;
    pcl) wanted+=("${pcl[@]}") ;;
    view) wanted+=("${view[@]}") ;;
    *)
      echo "setup.sh: there is no group '$group': build, test, doc, report, pcl, view" >&2
      exit 1
      ;;
  esac
done

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup.sh: no Debian here; make sure that you have what these packages hold: ${wanted[*]}" >&2
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  if [[ $status != installed ]]; then
    missing+=("$package")
  fi
done

if ((${#missing[@]} == 0)); then
  echo "All ${#wanted[@]} Debian packages are there ($*)."
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "setup.sh: neither root nor sudo; as root, run: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing: ${missing[*]}"
install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet
         --no-install-recommends "${missing[@]}")
if ! { "${as_root[@]}" apt-get update --quiet && "${install[@]}"; }; then
  echo "setup.sh: apt-get could not install: ${missing[*]}" >&2
  exit 1
fi
