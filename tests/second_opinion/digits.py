# SPDX-License-Identifier: GPL-3.0-or-later
"""Digits apart: individuation, enslaving, synergy; and the directions in which they push."""

import math

import numpy as np

from record import ACTIVE, DIGITS, EPSILON_S, join
from strength import add_coflexion, add_maximum, counting, window_of
from tools import quantile, weighted_mean

RELAX = 1  # cue
AXES = {"x": 0, "y": 1, "z": 2}
NORMAL = [f"{d}_fz_N" for d in DIGITS]


class Hold:
    """One hold of individuation: how far every digit rose from rest, and how far the others strayed."""

    def __init__(self, record, part):
        self.part, self.asked = part, DIGITS.index(part.digits)
        self.known = False
        index = next(i for i, p in enumerate(record.parts) if p is part)
        relaxed = next((p for p in reversed(record.parts[:index]) if p.cue == RELAX), None)
        if relaxed is None:
            return
        before, rows = record.select_part(relaxed, NORMAL).rows, record.select_part(part, NORMAL).rows
        if not len(before) or not len(rows):
            return
        self.known, w = True, record.hold[rows]
        rest = [weighted_mean(record.column(n)[before], record.hold[before]) for n in NORMAL]
        self.rise = [weighted_mean(record.column(n)[rows], w) - r for n, r in zip(NORMAL, rest)]
        others = [i for i in range(3) if i != self.asked]
        squares = sum(np.sum(w * (record.column(NORMAL[i])[rows] - rest[i])**2) for i in others)
        self.strayed = math.sqrt(squares / (2 * np.sum(w)))


def add_individuation(results, task, record):
    """Slope, index, enslaving of every pair."""
    selection = join([record.select_part(p, NORMAL) for p in record.parts if p.phase == ACTIVE])
    holds = [h for h in (Hold(record, p) for p in record.parts if p.phase == ACTIVE) if h.known]
    pressed = [(h.strayed, h.rise[h.asked]) for h in holds if h.rise[h.asked] > 0]
    slope = None
    if len(pressed) >= 3:
        strayed, rise = np.array(pressed).T
        slope = quantile(strayed / rise, rise, 0.5)
    results.add("individuation_index", "digits", -math.log(slope) if slope else None, selection)
    results.add("individuation_slope", "digits", slope, selection)
    least = 3 * np.nan_to_num(record.noise)
    for j in (DIGITS.index(d) for d in task["digits"]):
        for i in range(3):
            if i != j:
                add_pair(results, record, selection, holds, i, j, least)


def add_pair(results, record, selection, holds, i, j, least):
    """enslaving of digit i where j was asked."""
    channel = f"{DIGITS[j]}_to_{DIGITS[i]}"
    mine = [h for h in holds if h.asked == j]
    shares = [h.rise[i] / h.rise[j] for h in mine if h.rise[j] >= least and h.rise[j] > 0]
    results.add("enslaving", channel, float(np.mean(shares)) if shares else None, selection)
    maxima = [record.of_part("maximum_force_N", h.part) for h in holds if h.asked == i]
    value = None
    if mine and maxima and maxima[-1] > 0:
        value = float(np.mean([h.rise[i] for h in mine])) / maxima[-1]
    results.add("enslaving_of_maximum", channel, value, selection)


def angles(force, direction):
    """Between forces (rows) and one direction."""
    return np.arctan2(np.linalg.norm(np.cross(force, direction), axis=1), force @ direction)


def vector(record, digit, rows=slice(None), prefix=""):
    return np.stack([record.column(f"{prefix}{digit}_f{a}_N")[rows] for a in "xyz"], axis=1)


def names(digit, prefix=""):
    return [f"{prefix}{digit}_f{a}_N" for a in "xyz"]


def add_directional_maxima(results, task, record):
    """Per digit and direction: maximum_force, direction_error, opening: coflexion."""
    force = record.column("actual_force_N")
    for part in record.parts:
        if part.phase != ACTIVE:
            continue
        add_maximum(results, record, part, task["window_s"], part.channel, all_three=False)
        selection = record.select_part(part, names(part.digits))
        rows = selection.rows
        best = window_of(record, part, force, counting(record, force), task["window_s"])
        direction = np.zeros(3)
        direction[AXES[part.direction[1]]] = 1 if part.direction[0] == "+" else -1
        error = None
        if best is not None:
            pushed = vector(record, part.digits, rows)
            strong = np.linalg.norm(pushed, axis=1) > best / 2
            if np.any(strong):
                error = weighted_mean(angles(pushed[strong], direction), record.hold[rows][strong])
        results.add("direction_error", part.channel, error, selection)
        if part.direction == "-z":
            add_coflexion(results, record, part, task["window_s"], part.channel)


def mean_or_none(values):
    values = [v for v in values if v is not None]
    return float(np.mean(values)) if values else None


def add_force_direction(results, task, record):
    """Per digit: direction_error, projection_ratio, rmse; path_deviation."""
    parts = [p for p in record.parts if p.phase == ACTIVE]
    for digit in DIGITS:
        errors, ratios, sizes, selections = [], [], [], []
        for part in parts:
            target = vector(record, digit, slice(part.first, part.last), "target_")
            selection = record.select_part(part, names(digit))
            target = target[record.clean[part.first:part.last] & ~np.any(np.isnan(target), axis=1)]
            if not len(target):
                continue
            selections.append(selection)
            if not selection.samples:
                continue
            rows, w = selection.rows, record.hold[selection.rows]
            got, asked = vector(record, digit, rows), np.linalg.norm(target[0])
            direction = target[0] / asked
            size = np.linalg.norm(got, axis=1)
            strong = size > 3 * np.nan_to_num(record.of_part("noise_sd_N", part))
            if np.any(strong):
                errors.append(weighted_mean(angles(got[strong], direction), w[strong]))
            if np.sum(w * size) > 0:
                ratios.append(float(np.sum(w * (got @ direction)) / np.sum(w * size)))
            sizes.append(math.sqrt(weighted_mean((size - asked)**2, w)))
        if not selections:
            continue
        selection = join(selections)
        results.add("direction_error", digit, mean_or_none(errors), selection)
        results.add("projection_ratio", digit, mean_or_none(ratios), selection)
        results.add("rmse", digit, mean_or_none(sizes), selection)
    add_path_deviation(results, record, parts)


def add_path_deviation(results, record, parts):
    """Distance of the three forces from a straight line."""
    selections, values = [], []
    for part in parts:
        before = record.before(part)
        selection = record.select([before.phase, ACTIVE] if before else [ACTIVE], NORMAL,
                                  before.first if before else part.first, part.last)
        selections.append(selection)
        rows = selection.rows
        if len(rows) < 2:
            continue
        points = np.stack([record.column(n)[rows] for n in NORMAL], axis=1)
        along = points[-1] - points[0]
        if not np.linalg.norm(along) > 0:
            continue
        away = np.cross(points - points[0], along / np.linalg.norm(along))
        values.append(weighted_mean(np.linalg.norm(away, axis=1), record.hold[rows]))
    results.add("path_deviation", "digits", mean_or_none(values), join(selections))


def synergy(cycles):
    """cycles: T x phases x n digits -> index, z, within, across."""
    turns, _, n = cycles.shape
    apart = cycles - np.mean(cycles, axis=0)
    across = np.sum(apart, axis=2) / math.sqrt(n)
    rest = apart - across[:, :, None] / math.sqrt(n)
    v_ucm = np.sum(rest**2, axis=(0, 2)) / (turns - 1) / (n - 1)
    v_ort = np.sum(across**2, axis=0) / (turns - 1)
    v_tot = np.sum(apart**2, axis=(0, 2)) / (turns - 1) / n
    delta = (v_ucm - v_ort) / v_tot
    with np.errstate(divide="ignore", invalid="ignore"):
        z = np.log((n + delta) / (n / (n - 1) - delta)) / 2
    return float(np.mean(delta)), float(np.mean(z)), float(np.mean(v_ucm)), float(np.mean(v_ort))


def add_synergy(results, channel, t, forces, borders, selection):
    """borders: begin and end of every cycle."""
    values = [None] * 4
    if len(borders) >= 15:
        share = np.arange(100) / 100
        cycles = np.array([[np.interp(a + share * (b - a), t, f) for f in forces] for a, b in borders])
        values = synergy(cycles.transpose(0, 2, 1))
    for name, value in zip(("synergy_index", "synergy_index_z", "variance_within", "variance_across"), values):
        results.add(name, channel, value, selection)


def add_live_synergy(results, task, record):
    """Many cycles of a sum: the first is left out."""
    frequency = task["frequency_Hz"] * task.factor["frequency"]
    count = math.floor(task["duration_s"] * frequency + 1e-6)
    if task["waveform"] not in ("sine", "triangle", "rectangle") or count < 16:
        return
    if task["channel"] not in ("sum", "grip_mean"):
        return
    selection = record.select([ACTIVE], NORMAL)
    rows = selection.rows
    begin = record.t[np.flatnonzero(record.phase == ACTIVE)[0]]
    t = record.t[rows]
    step = float(np.median(np.diff(t)))
    borders = [(begin + c / frequency, begin + (c + 1) / frequency) for c in range(1, count)]
    borders = [(a, b) for a, b in borders if b <= t[-1] + 1.5 * step + EPSILON_S]
    add_synergy(results, "force", t, [record.column(n)[rows] for n in NORMAL], borders, selection)
