# SPDX-License-Identifier: GPL-3.0-or-later
"""Answering a cue: steps, releases."""

import math

import numpy as np

from record import ACTIVE, EPSILON_S, join
from tools import best_window, crossing, kaplan_meier, rate, sd, stretches, weighted_mean

LEFT_OUT, CENSORED = "left out", "censored"  # outcomes beside a time


class Repetition:
    """A part of phase 1 and the part before it: counted rows, cue, the level held before."""

    def __init__(self, record, part, force):
        self.part, self.before = part, record.before(part)
        self.cue = record.t[part.first]
        held = record.select([self.before.phase], [force], self.before.first, self.before.last).rows
        asked = record.select([part.phase], [force], part.first, part.last).rows
        rows = np.concatenate((held, asked))
        self.t, self.force, self.hold = record.t[rows], force[rows], record.hold[rows]
        self.answering = self.t >= self.cue - EPSILON_S
        self.held = self.force[~self.answering & (self.t >= self.cue - 1 - EPSILON_S)]
        resolution = np.nan_to_num(record.of_part("resolution_N", part))
        self.margin = max(3 * sd(self.held), 2 * resolution) if len(self.held) > 1 else math.nan

    def reaction(self, sign):
        """Time from the cue to the change that lasts; CENSORED: it never came; LEFT_OUT: no level before."""
        if len(self.held) < 2:
            return LEFT_OUT
        beyond = sign * (self.force - np.mean(self.held)) > self.margin
        for first, last in stretches(self.t, beyond, 0.05):
            if self.t[last] >= self.cue - EPSILON_S:
                return float(self.t[first] - self.cue)
        return CENSORED


def of_parts(record, columns):
    """Counted rows of all parts of phase 1."""
    return join([record.select_part(p, columns) for p in record.parts if p.phase == ACTIVE])


def repetitions_of(record, force):
    """All parts of phase 1 that have one before them."""
    return [Repetition(record, p, force) for p in record.parts
            if p.phase == ACTIVE and record.before(p) is not None]


def add_censored(results, name, channel, outcomes, limit, selection):
    """NAME, NAME_share, NAME_restricted."""
    waits = [(limit, False) if x == CENSORED else (x, True) for x in outcomes if x != LEFT_OUT]
    median = restricted = share = None
    if waits:
        median, restricted, _ = kaplan_meier(waits, limit)
        share = 100 * sum(came for _, came in waits) / len(waits)
    results.add(name, channel, median, selection, "longer than the limit")
    results.add(name + "_restricted", channel, restricted, selection)
    results.add(name + "_share", channel, share, selection)


def without_anticipations(reactions):
    """Reactions of at least 0.1 s, the others left out; how many they are."""
    early = [isinstance(x, float) and x < 0.1 - EPSILON_S for x in reactions]
    return [LEFT_OUT if e else x for e, x in zip(early, reactions)], sum(early)


def first_reach(t, z, answering, level):
    """First crossing of a level from the cue on; LEFT_OUT: there already; CENSORED: never."""
    above = np.flatnonzero(answering & (z >= level))
    if not len(above):
        return CENSORED
    k = above[0]
    if k == np.flatnonzero(answering)[0]:
        return LEFT_OUT
    return crossing(t, z, k, level)


def mean_of(values):
    """Mean of the repetitions that have a value."""
    values = [x for x in values if isinstance(x, (int, float))]
    return float(np.mean(values)) if values else None


def add_steps(results, task, record):
    """All measures of step_response."""
    force, channel = record.column("actual_force_N"), task["channel"]
    columns = ["target_force_N", "actual_force_N"]
    selection = of_parts(record, columns[1:])  # the levels of a step are constants of its parts
    reactions, t63, settling, rises, overshoots, errors = [], [], [], [], [], []
    for repetition in repetitions_of(record, force):
        start = record.of_part("target_force_N", repetition.before)
        stop = record.of_part("target_force_N", repetition.part)
        if math.isnan(start) or math.isnan(stop) or start == stop or not np.any(repetition.answering):
            continue
        t, z = repetition.t, (repetition.force - start) / (stop - start)
        reactions.append(repetition.reaction(math.copysign(1, stop - start)))
        reach = {x: first_reach(t, z, repetition.answering, x) for x in (0.1, 1 - math.exp(-1), 0.9)}
        t63.append(shifted(reach[1 - math.exp(-1)], repetition.cue))
        after = repetition.answering
        still = stretches(t[after], np.abs(z[after] - 1) <= 0.05, 0.2)
        settling.append(float(t[after][still[0][0]] - repetition.cue) if still else CENSORED)
        if isinstance(reach[0.1], float) and isinstance(reach[0.9], float):
            rises.append(reach[0.9] - reach[0.1])
        overshoots.append(max(0.0, 100 * (np.max(z[after]) - 1)))
        rows = record.select_part(repetition.part, columns).rows
        e = force[rows] - record.column("target_force_N")[rows]
        errors.append(math.sqrt(weighted_mean(e * e, record.hold[rows])) if len(rows) else None)
    reactions, anticipations = without_anticipations(reactions)
    limit = task["hold_s"]
    add_censored(results, "reaction_time", channel, reactions, limit, selection)
    results.corrected("reaction_time", channel, record, selection)
    results.add("anticipations", channel, float(anticipations), selection)
    add_censored(results, "t63", channel, t63, limit, selection)
    add_censored(results, "settling_time", channel, settling, limit, selection)
    results.add("rise_time", channel, mean_of(rises), selection)
    results.add("overshoot", channel, mean_of(overshoots), selection)
    results.add("rmse", channel, mean_of(errors), of_parts(record, columns))


def shifted(outcome, cue):
    return outcome - cue if isinstance(outcome, float) else outcome


def mean_around(repetition, centre):
    """Mean force from 0.1 s before to 0.1 s after; every row holds two median steps at most."""
    t, step = repetition.t, float(np.median(np.diff(repetition.t)))
    ends = np.append(np.minimum(t[1:], t[:-1] + 2 * step), t[-1] + step)
    first, last = centre - 0.1, centre + 0.1
    w = np.maximum(0, np.minimum(ends, last) - np.maximum(t, first))
    if np.sum(w) < 0.1 - EPSILON_S:
        return None
    return float(np.sum(w * repetition.force) / np.sum(w))


def release_time(repetition, resting):
    """Cue to the end of the release."""
    if math.isnan(resting) or not len(repetition.held):
        return LEFT_OUT
    level = resting + 0.1 * (np.max(repetition.held) - resting)
    t, x = repetition.t, repetition.force
    after = np.flatnonzero(repetition.answering)
    found = stretches(t[after], x[after] <= level, 0.05)
    if not found:
        return CENSORED
    if found[0][0] == 0:
        return LEFT_OUT
    k = after[found[0][0]]
    end = crossing(t, x, k, level) if x[k - 1] > level else t[k]
    return float(end - repetition.cue)


def add_releases(results, task, record):
    """All measures of grip_release."""
    channel = task["channel"]
    force = record.column("actual_force_N").copy()
    if task["open"]:
        for part in record.parts:
            if part.phase == ACTIVE:
                force[part.first:part.last] *= -1
    selection = of_parts(record, ["actual_force_N"])
    begins, ends, residuals, fastest, openings, missed = [], [], [], [], [], 0
    for repetition in repetitions_of(record, force):
        part, held = repetition.part, repetition.held
        after = repetition.answering
        if task["open"]:
            opened = -repetition.force[after]
            openings.append(best_window(opened, repetition.hold[after], np.full(len(opened), True), 0.5))
        resting = record.of_part("resting_force_N", repetition.before)
        floor = 0.0 if math.isnan(resting) else resting
        if len(held) < 2:
            continue
        asked = record.of_part("target_force_N", repetition.before)
        least = max((asked - floor) / 2, 3 * np.nan_to_num(record.of_part("noise_sd_N", part)),
                    2 * np.nan_to_num(record.of_part("resolution_N", part)))
        risen = np.mean(held) - floor
        if risen <= 0 or risen < least:
            missed += 1
            continue
        begins.append(repetition.reaction(-1))
        ends.append(release_time(repetition, resting))
        residual = mean_around(repetition, repetition.cue + 5)
        residuals.append(None if residual is None else residual - resting)
        speeds = rate(repetition.t[after], repetition.force[after])
        fastest.append(None if speeds is None else float(np.max(-speeds)))
    begins, anticipations = without_anticipations(begins)
    add_censored(results, "release_initiation", channel, begins, task["after_s"], selection)
    results.corrected("release_initiation", channel, record, selection)
    add_censored(results, "release_time", channel, ends, task["after_s"], selection)
    results.corrected("release_time", channel, record, selection)
    results.add("anticipations", channel, float(anticipations), selection)
    results.add("grips_missed", channel, float(missed), selection)
    results.add("residual_force", channel, mean_of(residuals), selection)
    results.add("fastest_release", channel, mean_of(fastest), selection)
    if task["open"]:
        results.add("opening_force", "opening", mean_of(openings), selection)


def add_force_sense(results, task, record):
    """constant_error, absolute_error, variable_error of the forces made again."""
    columns = ["target_force_N", "actual_force_N"]
    selection = of_parts(record, columns)
    errors = []
    for part in record.parts:
        rows = record.select_part(part, columns).rows if part.phase == ACTIVE else []
        if not len(rows):
            continue
        late = rows[record.t[rows] >= record.end_of(part) - task["window_s"] - EPSILON_S]
        if len(late):
            w = record.hold[late]
            mean = np.sum(w * record.column("actual_force_N")[late]) / np.sum(w)
            errors.append(float(mean - record.column("target_force_N")[rows[0]]))
    channel = task["channel"]
    results.add("constant_error", channel, mean_of(errors), selection)
    results.add("absolute_error", channel, mean_of([abs(e) for e in errors]), selection)
    results.add("variable_error", channel, sd(errors) if len(errors) > 1 else None, selection)
