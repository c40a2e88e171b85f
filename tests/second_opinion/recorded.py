# SPDX-License-Identifier: GPL-3.0-or-later
"""Recordings of others, and signals without a task."""

import math

import numpy as np

import holding
import smoothness
import tracking
from digits import add_synergy
from record import PAUSED
from tools import spectrum, uniform, weighted_mean

UNITS = ("_Nm", "_N", "_m", "_rad", "_deg", "_s", "_percent")


def everything(record, columns):
    """All rows but paused ones."""
    return record.select([p for p in range(6) if p != PAUSED], columns)


def add_corridor(results, record):
    selection = everything(record, ["corridor_error_N"])
    d, w = np.abs(record.column("corridor_error_N")[selection.rows]), record.hold[selection.rows]
    values = [None] * 3
    if len(d):
        values = [math.sqrt(weighted_mean(d * d, w)), weighted_mean(d, w),
                  100 * weighted_mean((d == 0).astype(float), w)]
    for name, value in zip(("corridor_rms", "corridor_distance", "time_in_corridor"), values):
        results.add(name, "force", value, selection)


def add_maximum(results, task, record):
    first, last = task["window_from_end_rows"]
    selection = record.select([p for p in range(6) if p != PAUSED], ["actual_force_N"], max(0, record.size - first), record.size - last)
    rows = selection.rows
    value = weighted_mean(np.abs(record.column("actual_force_N")[rows]), record.hold[rows]) if len(rows) else None
    results.add("maximum_window_mean", "force", value, selection)


def rhythm_of(t, x):
    """Highest line of the spectrum between 0.1 and 5 Hz, refined."""
    step, x = uniform(t, x)
    found = spectrum(step, x)
    if found is None or 0.5 / step < 5:
        return None
    f, p = found
    lines = np.flatnonzero((f >= 0.1 - 1e-9) & (f < 5 - 1e-9))
    k = lines[np.argmax(p[lines])]
    if not p[k - 1] < p[k] >= p[k + 1]:
        return None
    b, a = math.log(p[k - 1] / p[k]), math.log(p[k + 1] / p[k])
    return (k + (b - a) / (2 * (b + a))) * f[1]


def add_fingers(results, task, record):
    fingers = task["fingers"]
    names = [f"{f}_fz_N" for f in fingers]
    selection = everything(record, names)
    rows = selection.rows
    t, forces = record.t[rows], [record.column(n)[rows] for n in names]
    rhythm = rhythm_of(t, sum(forces)) if len(rows) > 1 else None
    results.add("rhythm", "force", rhythm, selection)
    means = [weighted_mean(f, record.hold[rows]) for f in forces] if len(rows) else [0]
    for finger, mean in zip(fingers, means):
        results.add("sharing", finger, 100 * mean / sum(means) if sum(means) > 0 else None, selection)
    beats = t[np.nan_to_num(record.column("beat")[rows]) > 0.5][::task["beats_per_cycle"]]
    borders = list(zip(beats, beats[1:]))[task["cycles_left_out"]:]
    add_synergy(results, "force", t, forces, borders, selection)


def score_recorded(results, task, record):
    if task["measures"] == "corridor":
        add_corridor(results, record)
    elif task["measures"] == "maximum":
        add_maximum(results, task, record)
    elif task["measures"] == "finger_forces":
        add_fingers(results, task, record)
    else:
        columns = ["target_force_N", "actual_force_N"]
        names = ["rmse", "relative_rmse", "mae", "constant_error", "time_in_range"]
        tracking.add_errors(results, "force", names, record, everything(record, columns),
                            *(record.column(c) for c in columns))


def without_unit(name):
    return next((name[:-len(unit)] for unit in UNITS if name.endswith(unit)), name)


def score_untasked(results, record):
    """All pairs of target_X and actual_X, then the motion."""
    for name in record.columns:
        pair = name.removeprefix("target_")
        if pair == name or not record.has("actual_" + pair):
            continue
        channel, target, actual = without_unit(pair), record.column(name), record.column("actual_" + pair)
        selection = everything(record, [name, "actual_" + pair])
        tracking.add_errors(results, channel, ["rmse", "mae", "constant_error", "time_in_range"], record, selection,
                            target, actual)
        alone = everything(record, ["actual_" + pair])
        t, x = record.t[alone.rows], actual[alone.rows]
        results.add("cv", channel, holding.cv_of(t, x)[0], alone)
        results.add("sample_entropy", channel, smoothness.sample_entropy(t, x), alone)
        tracking.add_lag(results, channel, record, selection, target, actual)
    names = [f"actual_{a}_m" for a in "xyz" if record.has(f"actual_{a}_m")]
    if len(names) >= 2:
        selection = everything(record, names)
        rows = selection.rows
        sparc, ldlj = smoothness.of_motion(record.t[rows], *(record.column(n)[rows] for n in names))
        results.add("sparc", "position", sparc, selection)
        results.add("ldlj", "position", ldlj, selection)
