#!/usr/bin/env python3
# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""Checks the pieces of scripts/reproduce_paper: check_reproduction.py SOURCE_DIR BIN_DIR

Verdicts, scores of labels and the page on numbers that are known, and one section on a shape that is made
here; nothing takes the benchmark's data. The exit code is 77 where what draws the pictures is not installed.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE, PROGRAMS = map(pathlib.Path, sys.argv[1:3])
REPORT = SOURCE / "benchmark/Weakly_convex_segmentation/report"
sys.dont_write_bytecode = True
sys.path.insert(0, str(REPORT))

try:
    import matplotlib  # noqa: F401
    import numpy as np
    import PIL  # noqa: F401
except ImportError:
    others = pathlib.Path("/usr/bin/python3")
    if others.exists() and pathlib.Path(sys.executable).resolve() != others.resolve():
        sys.exit(subprocess.run([others, *sys.argv], check=False).returncode)
    print("matplotlib, numpy or PIL is not installed (scripts/setup.sh report)")
    sys.exit(77)

import pictures  # noqa: E402, F401  first: it finds the drawing code of the manual
import claims  # noqa: E402
import labelings  # noqa: E402
import made_sections  # noqa: E402
import reproduction_page  # noqa: E402
import views_section  # noqa: E402
from claims import NO, PARTLY, YES  # noqa: E402
from made_shapes import Made_shapes  # noqa: E402


class Claims(unittest.TestCase):
    def test_convergence(self):
        self.assertEqual(claims.convergence([0.2, 0.15, 0.11], 0.1), YES)
        self.assertEqual(claims.convergence([0.2, 0.15, 0.13], 0.1), PARTLY)  # too far off
        self.assertEqual(claims.convergence([0.09, 0.15, 0.11], 0.1), PARTLY)  # worse with more
        self.assertEqual(claims.convergence([0.09, 0.15, 0.13], 0.1), NO)

    def test_rises_are_found_over_any_distance(self):
        self.assertAlmostEqual(claims.largest_rise([0.2, 0.1, 0.106, 0.112]), 0.012)
        self.assertLess(claims.largest_rise([0.3, 0.2]), 0)

    def test_stages(self):
        self.assertEqual(claims.stages([90, 20, 8], 0.9, 0.2), YES)
        self.assertEqual(claims.stages([90, 20, 20], 0.9, 0.2), PARTLY)
        self.assertEqual(claims.stages([90, 90, 90], 0.9, 0.2), NO)

    def test_grades_of_scores(self):
        self.assertEqual([claims.meshes(e, 0.1) for e in (0.14, 0.19, 0.3)], [YES, PARTLY, NO])
        self.assertEqual([claims.room(e, p) for e, p in ((0.05, 0.95), (0.05, 0.5), (0.5, 0.5))], [YES, PARTLY, NO])
        self.assertEqual([claims.sensitivity(s) for s in (0.005, 0.015, 0.03)], [YES, PARTLY, NO])
        self.assertEqual(claims.metrics({"a": 0.01, "b": 0.1}), PARTLY)
        self.assertEqual(claims.convexity(0.8, [0.7, 0.85], 1.0), PARTLY)
        self.assertEqual(claims.ranks(1, 5, 5), PARTLY)
        self.assertEqual(claims.limits([False, False]), NO)

    def test_exponent_of_growth(self):
        self.assertAlmostEqual(claims.exponent([10, 100, 1000], [1, 20, 400]), 1.30103, places=4)
        self.assertEqual([claims.time(1, 1.0), claims.time(1, 1.3), claims.time(999, 1.3)], [YES, PARTLY, NO])


class Labelings(unittest.TestCase):
    def test_rand_error(self):
        self.assertEqual(labelings.rand_error([0, 0, 1, 1], [7, 7, 3, 3]), 0.0)
        self.assertAlmostEqual(labelings.rand_error([0, 0, 0, 0], [0, 0, 1, 1]), 4 / 6)

    def test_parts_that_are_found(self):
        truth = np.repeat([0, 1, 2], 10)
        self.assertEqual(labelings.share_found(truth, truth), 1.0)
        self.assertAlmostEqual(labelings.share_found(np.repeat([0, 1], [10, 20]), truth), 1.0)  # half is enough
        self.assertAlmostEqual(labelings.share_found(np.zeros(30), truth), 0.0)
        self.assertAlmostEqual(labelings.purity(np.zeros(30), truth), 1 / 3)
        self.assertEqual(labelings.pieces(np.arange(30) // 5, truth == 1), 2)

    def test_matched_labels_have_numbers_of_the_reference(self):
        reference = np.array([2, 2, 2, 0, 0, 1])
        self.assertEqual(labelings.matched([5, 5, 5, 9, 9, 7], reference).tolist(), reference.tolist())
        # the larger of two pieces is the part, the other is new
        self.assertEqual(labelings.matched([4, 4, 6, 9, 9, 9], reference).tolist(), [2, 2, 3, 0, 0, 0])


class Sections(unittest.TestCase):
    def test_curves_come_from_the_table_of_scans(self):
        rows = [
            {"condition": c, "method": m, "category": "Cup", "rand_error": e}
            for m, e in (("paper", "0.3"), ("paper, complete mesh", "0.1"), ("default", "0.2"))
            for c in ("1 view", "2 views", "4 views", "8 views", "16 views")
        ]
        found = views_section.curves(rows)
        self.assertEqual(found["paper"]["scan"], [0.3] * 5)
        self.assertEqual(found["paper"]["complete"], [0.1] * 5)

    def test_a_section_becomes_page_figures_and_table(self):
        verdicts = [claims.Verdict(p, "5 % <a|b>", h) for p, h in zip(claims.PRESETS, (PARTLY, YES))]
        section = claims.Section("Figure 0", "A title", "More & more", "x < 1", verdicts, ["<p>body</p>"], {"a": float("nan")})
        page = reproduction_page.page([section], {"version": "1"})
        for text in ("5 % &lt;a|b&gt;", "<p>body</p>", "x &lt; 1", "<td class=partly>partly</td>", "<li>version: 1"):
            self.assertIn(text, page)
        numbers = json.loads(json.dumps(reproduction_page.as_json([section], {}), allow_nan=False))
        self.assertEqual(numbers["sections"][0]["verdicts"][1]["holds"], YES)
        row = reproduction_page.fragment([section], {}).splitlines()[-1]
        self.assertEqual(row.replace("\\|", "").count("|"), 5)
        self.assertIn("5 \\% \\<a\\|b\\>", row)
        self.assertIn("`paper`: partly, `default`: yes", row)

    def test_a_room_is_made_scanned_and_segmented(self):
        with tempfile.TemporaryDirectory() as folder:
            section = made_sections.room_section(Made_shapes(PROGRAMS, folder))
            made = Made_shapes(PROGRAMS, folder)
            before = (pathlib.Path(folder) / "room.ply").stat().st_mtime_ns
            cloud = made.scan("room")
            self.assertEqual((pathlib.Path(folder) / "room.ply").stat().st_mtime_ns, before)  # it is kept
        self.assertEqual(len(np.unique(cloud.truth)), 8)
        self.assertEqual([v.preset for v in section.verdicts], list(claims.PRESETS))
        self.assertIn("data:image/jpeg", section.body[1])
        for scores in section.numbers.values():
            self.assertLess(scores["rand_error"], scores["one_segment"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
