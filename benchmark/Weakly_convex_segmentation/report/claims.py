# Copyright (c) 2026  The Weakly_convex_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the paper claims, and when it holds: from what was measured to yes, partly or no.

The limits are constants, and their texts are made of them, so that the page says what was computed.
"""

import dataclasses
import math

YES, PARTLY, NO = "yes", "partly", "no"
PRESETS = ("paper", "default")


@dataclasses.dataclass
class Verdict:
    """What one preset shows, in words with figures, and whether the claim holds for it."""

    preset: str
    figures: str
    holds: str


@dataclasses.dataclass
class Section:
    """A figure, or a claim, of the paper. `body` is HTML, `numbers` what a machine wants to read."""

    figure: str
    title: str
    paper: str
    criterion: str
    verdicts: list
    body: list
    numbers: dict


def graded(whole, part=False):
    return YES if whole else PARTLY if part else NO


NEAR_COMPLETE, MOST_RISE = 0.02, 0.01
VIEWS_CRITERION = (
    f"With the most views 1 - RI is at most {NEAR_COMPLETE} above that of the complete shape on the same points, "
    f"and no number of views is more than {MOST_RISE} worse than a smaller one. Partly: one of the two."
)


def largest_rise(errors):
    """How much a later error is above an earlier one, at most."""
    rises = [b - a for i, a in enumerate(errors) for b in errors[i + 1 :]]
    return max(rises, default=0.0)


def convergence(errors, complete):
    """Errors from few views to many, and that of the complete shape on the points of the last."""
    near = errors[-1] - complete <= NEAR_COMPLETE
    steady = largest_rise(errors) <= MOST_RISE
    return graded(near and steady, near or steady)


TWICE = 2
STAGES_CRITERION = (
    f"Free lines of sight are at least {TWICE} times as frequent within components as between them, and there "
    "are fewer components than patches, and fewer segments than components. Partly: fewer at one step only, or "
    "lines that are not so frequent."
)


def stages(counts, free_within, free_between):
    """Numbers of patches, components and segments; shares of the lines that are free."""
    fewer = [counts[0] > counts[1], counts[1] > counts[2]]
    apart = free_within >= TWICE * free_between
    return graded(all(fewer) and apart, any(fewer))


FOUND = 0.5
GALLERY_CRITERION = (
    f"At least {FOUND:.0%} of the true parts are found (a segment and the part share half of their union), and on "
    "every cloud the segments are nearer to the true parts than one segment is. Partly: one of the two."
)


def gallery(found, worse_than_one):
    """The mean share of the parts that are found, and the number of clouds where one segment is better."""
    return graded(found >= FOUND and not worse_than_one, found >= FOUND or not worse_than_one)


NEAR_PEOPLE, FAR_FROM_PEOPLE = 0.05, 0.10
MESHES_CRITERION = (
    f"The mean 1 - RI of the meshes in the gallery is at most {NEAR_PEOPLE} above that of people against people "
    f"on the same meshes. Partly: at most {FAR_FROM_PEOPLE}."
)


def meshes(error, people):
    return graded(error - people <= NEAR_PEOPLE, error - people <= FAR_FROM_PEOPLE)


COMPARABLE = 0.02
METRICS_CRITERION = (
    f"In each of the metrics the preset is at most {COMPARABLE} above the best of the other methods that are "
    "measured here and of those that the paper compares with (published values: randomized cuts, shape diameter). "
    "Partly: in one of them at least."
)


def metrics(excess):
    """By metric, how far the preset is above the best of the others."""
    near = [value <= COMPARABLE for value in excess.values()]
    return graded(all(near), any(near))


RANKS_CRITERION = (
    "Among the preset and the other methods that are measured here, the preset has rank 1 overall, and rank 1 in "
    "more categories than any other method. Partly: one of the two."
)


def ranks(overall, firsts, most_firsts_of_others):
    most = firsts > most_firsts_of_others
    return graded(overall == 1 and most, overall == 1 or most)


CONVEXITY_CRITERION = (
    "The mean convexity rank (equation 1) of the segments is above that of the clustering's parts, with the number "
    "of parts that it finds and with the number that the preset finds, and above the former on at least three "
    "quarters of the meshes. Partly: the mean is above one of them."
)


def convexity(rank, others, share_of_meshes):
    above = [rank > other for other in others]
    return graded(all(above) and share_of_meshes >= 0.75, any(above))


ROOM_ERROR, ROOM_PURITY = 0.10, 0.9
ROOM_CRITERION = (
    f"Against the true objects 1 - RI is at most {ROOM_ERROR}, and at least {ROOM_PURITY:.0%} of the points belong to "
    "the object that most of their segment belongs to. Partly: one of the two."
)


def room(error, purity):
    return graded(
        error <= ROOM_ERROR and purity >= ROOM_PURITY, error <= ROOM_ERROR or purity >= ROOM_PURITY
    )


LIMITS_CRITERION = (
    "The limits that the paper names show here too: a chair leg that ends in several segments; a seat or a back of "
    "a chair that does; the body of a cup that does; and parts of a scan from one view that are more than "
    f"{NEAR_COMPLETE} worse than those of the complete shape. Partly: some of them. No is good news."
)


def limits(shown):
    return graded(all(shown), any(shown))


SIMILAR = 0.01
SENSITIVITY_CRITERION = (
    f"No change of a threshold by 3 % up or down changes the mean 1 - RI by more than {SIMILAR}. Partly: by no more "
    f"than {2 * SIMILAR}."
)


def sensitivity(largest):
    return graded(largest <= SIMILAR, largest <= 2 * SIMILAR)


PAPER_SECONDS, LINEAR = 180, 1.1
TIME_CRITERION = (
    f"10,000 points take no longer than the paper's {PAPER_SECONDS} s, and from 3,000 points on the time grows no "
    f"faster than linearly: its exponent is at most {LINEAR}. Partly: one of the two."
)


def exponent(sizes, seconds):
    """The slope of the line that fits the logarithms best."""
    x, y = [math.log(s) for s in sizes], [math.log(s) for s in seconds]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def time(seconds, growth):
    fast, linear = seconds <= PAPER_SECONDS, growth <= LINEAR
    return graded(fast and linear, fast or linear)
