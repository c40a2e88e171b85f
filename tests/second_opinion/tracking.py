# SPDX-License-Identifier: GPL-3.0-or-later
"""Following a target."""

import math

import numpy as np

from record import ACTIVE, EPSILON_S, Selection
from task import frequencies_of, number
from tools import best_shift, parabola, rate, stretches, uniform, weighted_mean


def add_errors(results, channel, names, record, selection, target, actual, band_fraction=0.05, noise=0.0):
    """rmse, relative_rmse, mae, constant_error, time_in_range: those of `names`."""
    rows = selection.rows
    if not len(rows):
        for name in names:
            results.add(name, channel, None, selection, "no samples")
        return
    w, wanted = record.hold[rows], target[rows]
    e = actual[rows] - wanted
    rmse, largest = math.sqrt(weighted_mean(e * e, w)), float(np.max(np.abs(wanted)))
    band = np.maximum(band_fraction * np.abs(wanted), 3 * noise)
    values = {"rmse": rmse, "relative_rmse": 100 * rmse / largest if largest > 0 else None,
              "mae": weighted_mean(np.abs(e), w), "constant_error": weighted_mean(e, w),
              "time_in_range": 100 * weighted_mean((np.abs(e) <= band).astype(float), w)}
    for name in names:
        results.add(name, channel, values[name], selection)


def lag_of(t, target, actual, range_s=1.5, least=0.35):
    """Shift in seconds with the largest correlation, and that correlation; None if there is no such peak."""
    step, target, actual = uniform(t, target, actual)
    if len(target) < 3:
        return None, None
    most = int(math.floor(range_s / step + 1e-9))
    r = best_shift(target, actual, most)
    peak = max(r, key=lambda shift: (r[shift], -shift))
    if r[peak] < least or peak - 1 not in r or peak + 1 not in r:
        return None, r[peak]
    return (peak + parabola(r[peak - 1], r[peak], r[peak + 1])) * step, r[peak]


def add_lag(results, channel, record, selection, target, actual):
    rows = selection.rows
    lag = lag_of(record.t[rows], target[rows], actual[rows])[0]
    results.add("lag", channel, lag, selection)


def sines(t, x, frequencies):
    """Amplitude and phase of every sine, all fitted together with a constant."""
    columns = [np.ones(len(t))]
    for f in frequencies:
        columns += [np.sin(2 * math.pi * f * t), np.cos(2 * math.pi * f * t)]
    found = np.linalg.lstsq(np.stack(columns, axis=1), x, rcond=None)[0]
    a, b = found[1::2], found[2::2]
    return np.hypot(a, b), np.arctan2(b, a)


def add_gains(results, channel, frequencies, record, selection, target, actual):
    """gain, phase and phase_lag of up to twenty sines."""
    if not frequencies:
        return
    rows = selection.rows
    t, wanted, got = record.t[rows], target[rows], actual[rows]
    length = t[-1] - t[0] + np.median(np.diff(t)) if len(t) > 1 else 0.0
    apart = np.diff(sorted(frequencies))
    slowest = min(frequencies[0] if len(frequencies) == 1 else min(frequencies), *apart, math.inf)
    enough = length * slowest >= 1 - 1e-6
    if enough:
        t = t - t[0]
        asked, phase_asked = sines(t, wanted, frequencies)
        made, phase_made = sines(t, got, frequencies)
    for k, f in enumerate(frequencies[:20]):
        name = channel if len(frequencies) == 1 else f"{channel}_{number(f)}_Hz"
        gain = phase = None
        if enough and asked[k] > 1e-12 * np.max(np.abs(wanted)):
            gain = made[k] / asked[k]
            phase = math.remainder(phase_made[k] - phase_asked[k], 2 * math.pi)
            phase = math.pi if phase == -math.pi else phase
        results.add("gain", name, gain, selection)
        results.add("phase", name, phase, selection)
        results.add("phase_lag", name, None if phase is None else -phase / (2 * math.pi * f), selection)


def halves(selection, target):
    """Counted rows in which the target rises, and falls, to the next one."""
    wanted = target[selection.rows]
    if len(wanted) < 2:
        return {"force_rise": selection, "force_fall": selection}
    least = 1e-9 * (np.max(wanted) - np.min(wanted))
    steps = np.diff(wanted)
    steps = np.append(steps, steps[-1])
    return {"force_rise": Selection(selection.rows[steps > least], selection.excluded),
            "force_fall": Selection(selection.rows[steps < -least], selection.excluded)}


def piece(record, columns, start, stop):
    """Rows of phase 1 that count with start <= u < stop, u the time since the first of them."""
    active = np.flatnonzero(record.phase == ACTIVE)
    u = record.t - (record.t[active[0]] if len(active) else math.nan)
    return record.select([ACTIVE], columns, within=(u >= start - EPSILON_S) & (u < stop - EPSILON_S))


def add_pauses(results, channel, record, selection, target, actual):
    """Stretches of a ramp in which the force hardly moves."""
    rows = selection.rows
    count = length = None
    if len(rows) >= 3:
        t, wanted = record.t[rows], target[rows]
        least = 0.4 * abs((wanted[-1] - wanted[0]) / (t[-1] - t[0]))
        step, _ = uniform(t, actual[rows])
        speeds = rate(t, actual[rows])
        if speeds is not None:
            grid = t[0] + np.arange(len(speeds)) * step
            found = stretches(grid, np.abs(speeds) < least, 0.15)
            count = float(len(found))
            lengths = [grid[b] - grid[a] + step for a, b in found]
            length = float(np.mean(lengths)) if found else None
    results.add("pauses", channel, count, selection)
    results.add("pause_length", channel, length, selection, "no pause")


def waveform_frequencies(task):
    return frequencies_of(task, task["duration_s"], task.factor["frequency"])
