# SPDX-License-Identifier: GPL-3.0-or-later
"""Two hands that press together (docs/measures.md, Two hands)."""

import math

import numpy as np

from recorded import everything
from tools import differences, pearson, uniform, weighted_mean
from tracking import add_errors, lag_of

SUM = "target_sum_force_N"


def share(a, b):
    a, b = max(a, 0.0), max(b, 0.0)
    return 100 * a / (a + b) if a + b > 0 else None


def weighted_pearson(x, y, w):
    x, y = x - weighted_mean(x, w), y - weighted_mean(y, w)
    size = math.sqrt(np.sum(w * x * x) * np.sum(w * y * y))
    return float(np.sum(w * x * y) / size) if size > 0 else None


def synergy(t, left, right, target):
    if len(t) < 2:
        return None
    step, left, right, *target = uniform(t, left, right, *([] if target is None else [target]))
    k = np.arange(len(left)) - (len(left) - 1) / 2
    known = [np.ones(len(k)), k] + [part for T in target for part in (T, differences(T, step))]
    if len(k) <= len(known):
        return None
    basis = []  # Gram and Schmidt, twice
    for column in known:
        size, rest = np.linalg.norm(column), column
        for _ in range(2):
            for other in basis:
                rest = rest - other * np.dot(other, rest)
        if np.linalg.norm(rest) > 1e-12 * size:
            basis.append(rest / np.linalg.norm(rest))
    rests = []
    for force in (left, right):
        for _ in range(2):
            for other in basis:
                force = force - other * np.dot(other, force)
        rests.append(force)
    apart, together = np.mean((rests[0] - rests[1])**2) / 2, np.mean((rests[0] + rests[1])**2) / 2
    largest = max(np.max(np.abs(left)), np.max(np.abs(right)))
    if not apart + together > 1e-10 * largest**2:
        return None
    return float(2 * (apart - together) / (apart + together))


def score_two_hands(results, record, affected, maxima):
    """`maxima`: of the left and the right hand; None: not known."""
    other = "right" if affected == "left" else "left"
    force = {hand: record.column(f"{hand}_force_N") for hand in ("left", "right")}
    both = everything(record, ["left_force_N", "right_force_N"])
    rows = both.rows
    a, u, w, t = force[affected][rows], force[other][rows], record.hold[rows], record.t[rows]
    add = lambda name, value, selection=both: results.add(name, affected, value, selection)
    mean_a, mean_u = (weighted_mean(x, w) if len(rows) else 0.0 for x in (a, u))
    for hand, mean in ((affected, mean_a), (other, mean_u)):
        results.add("mean_force", hand, mean, both)
    of_affected = share(mean_a, mean_u)
    add("share_affected", of_affected)
    add("asymmetry", None if of_affected is None else share(mean_u, mean_a) - of_affected)
    add("effort_share_affected",
        share(mean_a / maxima[affected], mean_u / maxima[other]) if all(maxima.values()) else None)
    add("hand_correlation", weighted_pearson(a, u, w) if len(rows) else None)
    lag, r = lag_of(t, u, a)
    add("hand_lag", lag)
    add("hand_lag_correlation", None if lag is None else r)
    follow = record.has(SUM)
    chosen = everything(record, ["left_force_N", "right_force_N"] + ([SUM] if follow else []))
    at = chosen.rows
    add("hand_synergy", synergy(record.t[at], force["left"][at], force["right"][at],
                                record.column(SUM)[at] if follow else None), chosen)
    names = [f"{hand}_push_{axis}_N" for hand in ("left", "right") for axis in "xyz"]
    if all(record.has(name) for name in names):
        pushed = everything(record, names)
        push = np.array([record.column(name)[pushed.rows] for name in names])
        size = lambda p: np.sum(record.hold[pushed.rows] * np.sqrt(np.sum(p * p, axis=0)))
        each = size(push[:3]) + size(push[3:])
        add("cancelled_share", float(100 * (1 - size(push[:3] + push[3:]) / each)) if each > 0 else None, pushed)
    pairs = {"sum": (SUM, force["left"] + force["right"], ["left_force_N", "right_force_N"])}
    pairs |= {hand: (f"target_{hand}_force_N", force[hand], [f"{hand}_force_N"]) for hand in ("left", "right")}
    for channel, (target, actual, columns) in pairs.items():
        if record.has(target):
            add_errors(results, channel, ["rmse"], record, everything(record, [target] + columns),
                       record.column(target), actual)
