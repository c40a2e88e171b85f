# SPDX-License-Identifier: GPL-3.0-or-later
"""A tracked hand: hand_opening, virtual_pick_place (docs/measures.md, A tracked hand; docs/virtual_hand.md,
Placements)."""

import math

import numpy as np

from cues import CENSORED, LEFT_OUT, add_censored, mean_of
from record import ACTIVE, EPSILON_S, join

DIGITS = ("thumb", "index", "middle", "ring", "little")
LEVELS = ("full", "softer", "off")
OPEN, CLOSE = 8, 9  # cues
CLOCK_S = 1e-9  # times of a placement are equal within this
GAP = "thumb_index_gap_m"


def furthest_stood(record, rows, gap, sign):
    """The largest (1) or least (-1) gap that was there for 0.1 s on end; None: none was."""
    found = []
    for k in range(len(rows)):
        stood, hold = sign * gap[k], 0.0
        for j in range(k, -1, -1):
            if j < k and rows[j] != rows[j + 1] - 1:
                break
            stood, hold = min(stood, sign * gap[j]), hold + record.hold[rows[j]]
            if hold >= 0.1 - EPSILON_S:
                found.append(stood)
                break
    return sign * max(found) if found else None


def movement(record, part, sign):
    """Time of an opening (1) or closing (-1)."""
    rows = record.select([ACTIVE], [GAP], part.first, part.last).rows
    gap = record.column(GAP)[rows]
    furthest = furthest_stood(record, rows, gap, sign)
    if furthest is None:
        return LEFT_OUT
    change = sign * (furthest - gap[0])
    if change < 0.01:
        return CENSORED
    first = np.flatnonzero(sign * (gap - gap[0]) >= 0.9 * change)[0]
    return float(record.t[rows[first]] - record.t[part.first])


def add_range(results, record, digit):
    columns = [f"{digit}_flexion{k}_rad" for k in (1, 2, 3)]
    selection = record.select([ACTIVE], columns)
    rows = np.flatnonzero(record.phase == ACTIVE)
    t = record.t[rows]
    x = np.where(record.clean[rows], sum(record.column(c)[rows] for c in columns), np.nan)
    means = []
    for k in range(len(rows)):
        if t[k] - 0.1 < t[0] - CLOCK_S or t[k] + 0.1 > t[-1] + CLOCK_S:
            continue
        window = x[(t >= t[k] - 0.1 - CLOCK_S) & (t <= t[k] + 0.1 + CLOCK_S)]
        if not np.isnan(window).any():
            means.append(float(np.mean(window)))
    results.add("flexion_range", digit, max(means) - min(means) if means else None, selection)


def score_hand_opening(results, task, record):
    whole = record.select([ACTIVE], [GAP])
    furthest = []
    for cue, sign, word, limit in ((OPEN, 1, "opening", "open_s"), (CLOSE, -1, "closing", "close_s")):
        parts = [p for p in record.parts if p.phase == ACTIVE and (p.cue == OPEN) == (cue == OPEN)]
        times = [movement(record, p, sign) for p in parts]
        made = sum(isinstance(x, float) for x in times)
        results.add(f"hand_{word}s", "thumb_index", float(made), whole)
        add_censored(results, f"hand_{word}_time", "thumb_index", times, task[limit], whole)
        for part in parts:
            rows = record.select([ACTIVE], [GAP], part.first, part.last).rows
            furthest.append(furthest_stood(record, rows, record.column(GAP)[rows], 1))
    furthest = [x for x in furthest if x is not None]
    results.add("largest_gap", "thumb_index", max(furthest) if furthest else None, whole)
    for digit in DIGITS:
        add_range(results, record, digit)


def attitudes(record, side, rows):
    return np.stack([record.column(f"{side}_q{c}")[rows] for c in "wxyz"], axis=1)


def positions(record, side, rows):
    return np.stack([record.column(f"{side}_{axis}_m")[rows] for axis in "xyz"], axis=1)


def main_axis(q):
    w, x, y, z = q.T
    return np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)], axis=1)


def axis_angle(a, b):
    """An axis has no direction."""
    a, b = main_axis(a), main_axis(b)
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.abs(np.sum(a * b, axis=1)))


def whole_angle(a, b):
    dot = np.sum(a * b, axis=1)
    apart = b - np.sign(dot)[:, None] * a
    return 4 * np.arcsin(np.minimum(1, np.linalg.norm(apart, axis=1) / 2))


class Placement:
    """Rows first … last - 1 of one placement."""

    def __init__(self, record, first, last, task):
        self.selection = record.select([0, 1, 2, 3, 5], ["placement"], first, last)
        rows = np.arange(first, last)
        level = record.column("assistance")[first]
        self.channel = LEVELS[int(level)] + ("_eased" if record.column("eased")[first] == 1 else "")
        asked = rows[np.isin(record.column("pause_cause")[rows], (0, 4))]
        flagged = record.columns["sample_flags"][asked] != 0
        self.scored = len(asked) > 0 and np.sum(flagged) / len(asked) <= 0.1
        helped = np.flatnonzero(record.column("object_helped")[rows] == 1)
        self.helped = len(helped) > 0
        if self.helped:
            rows = rows[:helped[0]]
        rows = rows[record.clean[rows] & (record.phase[rows] != 4)]
        self.t = np.concatenate(([0.0], np.cumsum(record.hold[rows])[:-1])) if len(rows) else np.array([])
        true = lambda name: record.column(name)[rows] == 1
        self.held, self.supported = true("object_held"), true("object_supported")
        self.distance = np.linalg.norm(positions(record, "actual", rows) - positions(record, "target", rows), axis=1)
        of, to = attitudes(record, "actual", rows), attitudes(record, "target", rows)
        self.axis, self.angle = axis_angle(of, to), whole_angle(of, to)
        times = 4 - task["level"] if "chosen" not in task else task.factor["tolerance"]
        self.most = 0.01 * times, math.radians(10 + 5 * times)
        self.fails, self.trigger, self.done = self._follow()
        self.release, self.asked = self._letting_go(true("object_touched"), true("let_go_asked"))

    def _within(self, k, times):
        return self.distance[k] <= times * self.most[0] and self.axis[k] <= times * self.most[1]

    def _follow(self):
        """Drops, rows of the trigger and of the end of the hold that was completed."""
        fails, trigger, loose, before = 0, None, None, False
        for k, t in enumerate(self.t):
            if self.held[k]:
                loose = None
            elif before and not self.supported[k]:
                loose = t
            elif loose is not None and (self.supported[k] or t - loose >= 0.25 - CLOCK_S):
                fails, loose = fails + 1, None
            before = self.held[k]
            if trigger is not None and not (self.held[k] and self._within(k, 1.5)):
                trigger = None
            if trigger is not None and t - self.t[trigger] >= 1 - CLOCK_S:
                return fails, trigger, k
            if trigger is None and self.held[k] and self._within(k, 1):
                trigger = k
        return fails, None, None

    def _letting_go(self, touched, asked):
        if not np.any(asked):
            return LEFT_OUT, False
        first, free = np.flatnonzero(asked)[0], None
        for k in range(first + 1, len(self.t)):
            since = self.t[k] - self.t[first]
            if touched[k]:
                free = None
            elif free is None:
                free = since
            if free is not None and since - free >= 0.1 - EPSILON_S:
                return float(free), True
            if since >= 10 - EPSILON_S:
                break
        return CENSORED, True

    def mean(self, values):
        rows = slice(self.trigger, self.done)
        weights = np.diff(self.t[self.trigger:self.done + 1])
        return float(np.sum(weights * values[rows]) / (self.t[self.done] - self.t[self.trigger]))


def score_virtual_pick_place(results, task, record):
    numbers, level = record.column("placement"), record.column("assistance")
    starts = [0] + [k for k in range(1, record.size) if not numbers[k] == numbers[k - 1]] + [record.size]
    placements = [Placement(record, a, b, task) for a, b in zip(starts, starts[1:])
                  if numbers[a] >= 0 and level[a] in (0, 1, 2)]
    for channel in sorted({task["assistance"], *(p.channel for p in placements)}):
        mine = [p for p in placements if p.channel == channel]
        selection = join([p.selection for p in mine])
        scored = [p for p in mine if p.scored]
        held = [p for p in scored if p.done is not None]
        asked = [p for p in scored if p.asked]
        add = lambda name, value: results.add(name, channel, value, selection)
        add("placements_completed", float(len(held)))
        add("placement_fails", float(sum(p.fails for p in scored)))
        add("placements_not_scored", float(len(mine) - len(scored)))
        times = [float(p.t[p.trigger]) if p.done is not None else CENSORED for p in scored]
        add_censored(results, "manipulation_time", channel, times, 60, selection)
        add("placement_distance", mean_of([p.mean(p.distance) for p in held]))
        add("placement_axis_angle", mean_of([p.mean(p.axis) for p in held]))
        add("placement_angle", mean_of([p.mean(p.angle) for p in held]))
        add_censored(results, "object_release_time", channel, [p.release for p in asked], 10, selection)
        add("releases_helped", float(sum(p.helped for p in scored)))
