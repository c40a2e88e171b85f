# SPDX-License-Identifier: GPL-3.0-or-later
"""Two hands that press together (docs/measures.md, Two hands)."""

import math

import numpy as np

from handling import HANDLING, Pose, add_carried_ways, add_times, attempts_of
from record import ACTIVE, LEAD_IN, PAUSED, Selection
from recorded import everything
from strength import counting, window_of
from tools import differences, pearson, quantile, uniform, weighted_mean
from tracking import add_errors, lag_of

SUM = "target_sum_force_N"
SQUEEZE, FOLLOW = 2, 4  # cues


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


def score_two_hands(results, record, affected, maxima, resting=None, phases=None):
    """`affected`: a hand; None: not known. `maxima`: of the left and the right hand; None: not known. `resting`: taken
    off the forces for their shares; None: they are taken as they stand. `phases`: rows; None: all."""
    first = affected or "left"
    other = "right" if first == "left" else "left"
    chosen_rows = lambda columns: record.select(phases, columns) if phases else everything(record, columns)
    force = {hand: record.column(f"{hand}_force_N") for hand in ("left", "right")}
    both = chosen_rows(["left_force_N", "right_force_N"])
    own_t, rows = record.column("t_s"), both.rows
    a, u, w, t = force[first][rows], force[other][rows], record.hold[rows], own_t[rows]
    channel = affected or "both"
    add = lambda name, value, selection=both: results.add(name, channel, value, selection)
    above = {}
    for hand, values in ((first, a), (other, u)):
        mean = weighted_mean(values, w) if len(rows) else None
        results.add("mean_force", hand, mean, both)
        above[hand] = mean
        if resting is not None:
            above[hand] = None if mean is None or np.isnan(resting[hand]) else mean - resting[hand]
            results.add("force_above_rest", hand, above[hand], both)
    known = affected and None not in above.values()
    of_affected = share(above[first], above[other]) if known else None
    add("share_affected", of_affected)
    add("asymmetry", None if of_affected is None else share(above[other], above[first]) - of_affected)
    add("effort_share_affected", share(above[first] / maxima[first], above[other] / maxima[other])
        if known and all(maxima.values()) else None)
    add("hand_correlation", weighted_pearson(a, u, w) if len(rows) else None)
    lag, r = lag_of(t, u, a) if affected else (None, None)
    add("hand_lag", lag)
    add("hand_lag_correlation", None if lag is None else r)
    asked = lambda name: record.has(name) and (phases is None or not np.all(np.isnan(record.column(name))))
    follow = asked(SUM)
    chosen = chosen_rows(["left_force_N", "right_force_N"] + ([SUM] if follow else []))
    at = chosen.rows
    add("hand_synergy", synergy(own_t[at], force["left"][at], force["right"][at],
                                record.column(SUM)[at] if follow else None), chosen)
    names = [f"{hand}_push_{axis}_N" for hand in ("left", "right") for axis in "xyz"]
    if all(record.has(name) for name in names):
        pushed = chosen_rows(names)
        push = np.array([record.column(name)[pushed.rows] for name in names])
        size = lambda p: np.sum(record.hold[pushed.rows] * np.sqrt(np.sum(p * p, axis=0)))
        each = size(push[:3]) + size(push[3:])
        add("cancelled_share", float(100 * (1 - size(push[:3] + push[3:]) / each)) if each > 0.5 * np.sum(record.hold[pushed.rows]) else None, pushed)
    pairs = {"sum": (SUM, force["left"] + force["right"], ["left_force_N", "right_force_N"])}
    pairs |= {hand: (f"target_{hand}_force_N", force[hand], [f"{hand}_force_N"]) for hand in ("left", "right")}
    for name, (target, actual, columns) in pairs.items():
        if asked(target):
            add_errors(results, name, ["rmse"], record, chosen_rows([target] + columns), record.column(target), actual)


def constants(record, name):
    return {hand: record.first_value(f"{hand}_{name}") for hand in ("left", "right")}


def score_bilateral_tracking(results, _task, record):
    side = record.first_value("affected_hand")
    maxima = {hand: None if np.isnan(value) else value
              for hand, value in constants(record, "maximum_force_N").items()}
    score_two_hands(results, record, None if np.isnan(side) else "left" if side == 0 else "right", maxima,
                    constants(record, "resting_force_N"), [ACTIVE])


def score_bilateral_rest(results, _task, record):
    for hand in ("left", "right"):
        selection = record.select([ACTIVE], [f"{hand}_force_N"])
        rows = selection.rows
        results.add("resting_force", hand,
                    weighted_mean(record.column(f"{hand}_force_N")[rows], record.hold[rows]) if len(rows) else None,
                    selection)


def score_bilateral_maximum(results, task, record):
    squeezes = lambda part, hand: record.of_part(f"{hand}_cue", part) == SQUEEZE
    found = {}
    for hand, other in (("left", "right"), ("right", "left")):
        force = record.column(f"{hand}_force_N")
        for beside in (False, True):
            part = next((p for p in record.parts if p.phase == ACTIVE and squeezes(p, hand)
                         and squeezes(p, other) == beside), None)
            if part is None:
                found[hand, beside] = (None, None, record.select([ACTIVE], [f"{hand}_force_N"], 0, 0))
                continue
            total = window_of(record, part, force, counting(record, force), task["window_s"])
            resting = record.of_part(f"{hand}_resting_force_N", part)
            above = None if total is None or np.isnan(resting) else total - resting
            found[hand, beside] = (above, total, record.select([ACTIVE], [f"{hand}_force_N"], part.first, part.last))
        above, total, selection = found[hand, False]
        results.add("maximum_force", hand, above, selection)
        results.add("maximum_force_total", hand, total, selection)
        above, _, selection = found[hand, True]
        results.add("bilateral_force", hand, above, selection)
    sums = {}
    for beside in (False, True):
        values = [found[hand, beside][0] for hand in ("left", "right")]
        sums[beside] = None if None in values else sum(values)
    known = None not in sums.values() and sums[False] > 0
    results.add("bilateral_deficit", "both", 100 * sums[True] / sums[False] - 100 if known else None,
                record.select([ACTIVE], ["left_force_N", "right_force_N"]))


def score_bimanual_lift(results, task, record):
    add_times(results, record, attempts_of(record, task["lifts"]), task["time_limit_s"], until_let_go=False)
    drops = record.select(HANDLING, ["drops"])
    results.add("drops", "contact", float(np.max(record.column("drops")[drops.rows], initial=0)), drops)
    height = record.column("actual_y_m")
    up = height - record.first_value("actual_y_m") > 0.01

    def lifted(columns):
        selection = record.select(HANDLING, columns + ["actual_y_m"])
        return Selection(selection.rows[up[selection.rows]], selection.excluded)

    def mean(column, selection):
        return weighted_mean(record.column(column)[selection.rows], record.hold[selection.rows])

    tilted, angle = lifted(["actual_angle_rad"]), record.column("actual_angle_rad")
    rms = level = None
    if tilted.samples:
        rms = math.sqrt(weighted_mean(angle[tilted.rows]**2, record.hold[tilted.rows]))
        level = mean("actual_angle_rad", tilted)
    results.add("object_tilt", "angle", rms, tilted)
    results.add("object_tilt_mean", "angle", level, tilted)
    for hand in ("left", "right"):
        for name, column, q, factor in (("least_squeeze", "squeeze_N", 0.05, 1),
                                        ("friction_utilisation", "utilisation", 0.95, 100)):
            chosen = lifted([f"{hand}_{column}"])
            at = chosen.rows
            value = factor * quantile(record.column(f"{hand}_{column}")[at], record.hold[at], q) if len(at) else None
            results.add(name, hand, value, chosen)
    side = record.first_value("affected_hand")
    affected = None if np.isnan(side) else "left" if side == 0 else "right"
    first = affected or "left"
    other = "right" if first == "left" else "left"
    ends = {hand: [f"{hand}_end_{axis}_m" for axis in "xyz"] for hand in (first, other)}
    seen = lifted(ends["left"] + ends["right"])
    near = np.flatnonzero(np.diff(seen.rows) == 1)
    way = {}
    for hand in (first, other):
        place = np.array([record.column(name)[seen.rows] for name in ends[hand]])
        way[hand] = float(np.sum(np.linalg.norm(place[:, near + 1] - place[:, near], axis=0)))
    results.add("path_share_affected", affected or "both", share(way[first], way[other]) if affected else None, seen)
    begun = np.flatnonzero((record.phase != LEAD_IN) & (record.phase != PAUSED))
    before = begun[0] if len(begun) else record.size
    coupled = np.nan_to_num(record.first_value("platforms_coupled")) != 0
    for name, column in (("raise", "push_y_N"), ("squeeze", "squeeze_N")):
        columns = {hand: f"{hand}_{column}" for hand in ("left", "right")}
        works, rests = lifted(list(columns.values())), record.select([LEAD_IN], list(columns.values()), 0, before)
        above = {}
        for hand in ("left", "right"):
            above[hand] = None
            if works.samples and rests.samples:
                above[hand] = mean(columns[hand], works) - mean(columns[hand], rests)
            results.add(f"{name}_above_rest", hand, above[hand], works)
        known = affected and not coupled and None not in above.values()
        results.add(f"{name}_share_affected", affected or "both", share(above[first], above[other]) if known else None,
                    works)


def score_bimanual_pick_place(results, task, record):
    attempts = attempts_of(record, task["repetitions"] * len(task["target"]))
    add_times(results, record, attempts, task["time_limit_s"], until_let_go=True)
    fallen = record.select(HANDLING, ["drops"])
    results.add("drops", "contact", float(np.max(record.column("drops")[fallen.rows], initial=0)), fallen)
    add_carried_ways(results, record, Pose(record), attempts, np.nan_to_num(record.column("drops"), nan=0))

    def held(columns):
        selection = record.select(HANDLING, columns + ["grasp"])
        return Selection(selection.rows[record.column("grasp")[selection.rows] == 1], selection.excluded)

    for hand in ("left", "right"):
        chosen = held([f"{hand}_squeeze_N"])
        at = chosen.rows
        value = quantile(record.column(f"{hand}_squeeze_N")[at], record.hold[at], 0.05) if len(at) else None
        results.add("least_squeeze", hand, value, chosen)
    side = record.first_value("affected_hand")
    affected = None if np.isnan(side) else "left" if side == 0 else "right"
    points = {hand: [f"{hand}_{axis}_m" for axis in "xyz"] for hand in ("left", "right")}
    seen = held(points["left"] + points["right"])
    near = np.flatnonzero(np.diff(seen.rows) == 1)
    way = {}
    for hand in ("left", "right"):
        place = np.array([record.column(name)[seen.rows] for name in points[hand]])
        way[hand] = float(np.sum(np.linalg.norm(place[:, near + 1] - place[:, near], axis=0)))
    first = affected or "left"
    other = "right" if first == "left" else "left"
    known = affected and len(seen.rows)
    results.add("path_share_affected", affected or "both", share(way[first], way[other]) if known else None, seen)


def score_mirror(results, _task, record):
    follows = [hand for hand in ("left", "right") if any(record.of_part(f"{hand}_cue", p) == FOLLOW for p in record.parts)]
    active = follows[0] if follows else "left"
    still = "right" if active == "left" else "left"
    rise = {}
    for hand in (active, still):
        selection = record.select([ACTIVE], [f"{hand}_force_N"])
        rows, resting = selection.rows, record.first_value(f"{hand}_resting_force_N")
        mean = weighted_mean(record.column(f"{hand}_force_N")[rows], record.hold[rows]) if len(rows) else None
        rise[hand] = (None if mean is None or np.isnan(resting) else mean - resting, selection)
    works, rests = rise[active][0], rise[still][0]
    overflow = None
    if works is not None and rests is not None and works > 0.5:
        overflow = 100 * rests / works
    results.add("mirror_force", still, overflow, rise[still][1])
    for hand in (still, active):
        results.add("force_above_rest", hand, *rise[hand])
    target = f"target_{active}_force_N"
    add_errors(results, active, ["rmse"], record, record.select([ACTIVE], [target, f"{active}_force_N"]),
               record.column(target), record.column(f"{active}_force_N"))
