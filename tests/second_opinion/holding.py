# SPDX-License-Identifier: GPL-3.0-or-later
"""Holding a force: steadiness, fatigue, spectra."""

import math

import numpy as np

from record import EPSILON_S
from tools import line, power_between, spectrum, stretches, uniform, weighted_mean

BANDS = {"power_0.1_0.3_Hz": (0.1, 0.3), "power_0.5_0.8_Hz": (0.5, 0.8), "power_2_8_Hz": (2, 8),
         "power_8_12_Hz": (8, 12)}


def cv_of(t, x):
    """cv [%], SD beside the line, its slope, mean; None where there are too few rows."""
    if len(x) < 3:
        return None, None, None, None
    slope, s = line(t, x)
    mean = float(np.mean(x))
    usable = abs(mean) > 1e-12 * float(np.max(np.abs(x)))
    return (100 * s / mean if usable else None), s, slope, (mean if usable else None)


def add_steadiness(results, channel, record, selection, force, noise):
    """cv, its noise floor, force_sd, fall of one hold."""
    rows = selection.rows
    t, x = record.t[rows], force[rows]
    cv, s, slope, mean = cv_of(t, x)
    floor = fall = None
    if mean is not None:
        floor = None if math.isnan(noise) else 100 * noise / abs(mean)
        fall = -100 * slope * (t[-1] - t[0]) / mean
        if floor is not None and floor > abs(cv) / 3:
            cv = None
    results.add("cv", channel, cv, selection)
    results.add("cv_noise_floor", channel, floor, selection)
    results.add("force_sd", channel, s, selection)
    results.add("fall", channel, fall, selection)


def add_powers(results, channel, record, selection, force):
    """Share of four bands in the power of the hold."""
    rows = selection.rows
    step, x = uniform(record.t[rows], force[rows]) if len(rows) > 1 else (1, force[rows])
    found = spectrum(step, x)
    for name, (low, high) in BANDS.items():
        value = None
        if found and high <= 0.5 / step + 1e-9:
            whole = power_between(*found, 0, found[0][-1])
            value = 100 * power_between(*found, low, high) / whole if whole > 0 else None
        results.add(name, channel, value, selection)


def add_fatigue(results, channel, record, selection, force):
    """fatigue_slope, endurance."""
    rows = selection.rows
    t, x = record.t[rows], force[rows]
    slope = endurance = None
    begin = t < t[0] + 5 - EPSILON_S if len(t) else np.zeros(0, bool)
    if len(t) > 2 and not np.all(begin):
        steps = np.diff(t[begin])
        first = weighted_mean(x[begin], np.append(steps, steps[-1]))
        if abs(first) > 1e-12 * np.max(np.abs(x[begin])):
            slope = 100 * line(t, x)[0] / first
            below = stretches(t, x / first < 0.8, 1)
            endurance = float(t[below[0][0]] - t[0]) if below else None
    results.add("fatigue_slope", channel, slope, selection)
    results.add("endurance", channel, endurance, selection, "the force stayed above 80 %")
