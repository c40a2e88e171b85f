# SPDX-License-Identifier: GPL-3.0-or-later
"""How an object is held: contact, slip, margin, coupling of grip and load."""

import numpy as np

from record import DIGITS, EPSILON_S
from tools import best_shift, parabola, quantile, stretches, uniform, weighted_mean


class Grip:
    """Touch, normal and tangential forces in the counted rows of some phases."""

    def __init__(self, record, phases):
        self.record = record
        columns = [f"{d}_f{a}_N" for d in DIGITS for a in "xyz"] + [f"contact_{d}" for d in DIGITS]
        self.selection = record.select(phases, columns)
        touching = [f"{what}_{d}" for what in ("contact", "slip") for d in DIGITS]
        self.touched = record.select(phases, touching)  # what tells of touching alone needs no forces
        rows = self.selection.rows
        self.w, self.t = record.hold[rows], record.t[rows]
        self.touch = {d: record.column(f"contact_{d}")[rows] > 0.5 for d in DIGITS}
        self.any = self.touch["thumb"] | self.touch["index"] | self.touch["middle"]
        self.grasp = self.touch["thumb"] & (self.touch["index"] | self.touch["middle"])
        normal = {d: np.maximum(0, record.column(f"{d}_fz_N")[rows]) * self.touch[d] for d in DIGITS}
        self.tangential = {d: np.hypot(record.column(f"{d}_fx_N")[rows], record.column(f"{d}_fy_N")[rows])
                           for d in DIGITS}
        used = {d: np.where(self.touch[d], record.column(f"utilisation_{d}")[rows], 0) for d in DIGITS}
        self.used = np.max([used[d] for d in DIGITS], axis=0) if len(rows) else np.array([])
        self.force = sum(normal.values()) / 2
        self.needed = sum(normal[d] * used[d] for d in DIGITS) / 2
        self.load = sum(self.tangential[d] * self.touch[d] for d in DIGITS) / 2


def share_or_none(x, w):
    return weighted_mean(x, w) if len(x) else None


def touching(record, selection):
    """Rows in which any finger touches, in which any slips."""
    rows = selection.rows
    return (np.any([record.column(f"{what}_{d}")[rows] > 0.5 for d in DIGITS], axis=0)
            for what in ("contact", "slip"))


def add_contact_time(results, grip):
    touch, _ = touching(grip.record, grip.touched)
    results.add("contact_time", "contact", float(np.sum(grip.record.hold[grip.touched.rows][touch])), grip.touched)


def add_slip(results, grip):
    touch, slip = touching(grip.record, grip.touched)
    value = share_or_none(slip[touch].astype(float), grip.record.hold[grip.touched.rows][touch])
    results.add("slip", "contact", None if value is None else 100 * value, grip.touched)


def add_mean_grip(results, record, phases):
    selection = record.select(phases, ["actual_force_N"])
    value = share_or_none(record.column("actual_force_N")[selection.rows], record.hold[selection.rows])
    results.add("mean_grip", "grip", value, selection)


def add_grip(results, record, phases):
    """Everything that the handling of an object tells of the grip."""
    grip = Grip(record, phases)
    selection = grip.selection
    add_slip(results, grip)
    add_mean_grip(results, record, phases)
    add_coupling(results, grip)
    held, force, w = grip.grasp, grip.force[grip.grasp], grip.w[grip.grasp]
    variation = margin = None
    if len(force) and np.sum(w * force) > 0:
        mean = weighted_mean(force, w)
        variation = 100 * weighted_mean((force - mean)**2, w)**0.5 / mean
        firm = force > 0
        if np.any(grip.used > 0):
            spare = 100 * (force[firm] - grip.needed[held][firm]) / force[firm]
            margin = weighted_mean(spare, w[firm])
    results.add("grip_variation", "grip", variation, selection)
    impulse = float(np.sum((grip.w * grip.force)[grip.any]))
    results.add("impulse", "grip", impulse, selection)
    results.add("safety_margin", "grip", margin, selection)
    used = quantile(100 * grip.used[grip.any], grip.w[grip.any], 0.95) if np.any(grip.any) else None
    results.add("friction_utilisation", "contact", used, selection)
    for other in DIGITS[1:]:
        both = grip.touch["thumb"] & grip.touch[other]
        value = correlation(grip.tangential["thumb"][both], grip.tangential[other][both], grip.w[both])
        results.add("lateral_correlation", f"thumb_{other}", value, selection)


def correlation(x, y, w):
    """Weighted Pearson; None where one does not vary."""
    if len(x) < 2:
        return None
    x, y = x - weighted_mean(x, w), y - weighted_mean(y, w)
    size = (np.sum(w * x * x) * np.sum(w * y * y))**0.5
    return float(np.sum(w * x * y) / size) if size > 0 else None


def add_coupling(results, grip):
    """Over the longest grasp: correlation of grip and load, its lag, slope."""
    found = stretches(grip.t, grip.grasp, 0)
    r = lag = slope = None
    if found:
        longest = max(grip.t[b] - grip.t[a] for a, b in found)
        first, last = next((a, b) for a, b in found if grip.t[b] - grip.t[a] >= longest - EPSILON_S)
        rows = slice(first, last + 1)
        step, force, load = uniform(grip.t[rows], grip.force[rows], grip.load[rows])
        most = int(0.5 / step + 1e-9) if len(force) > 1 else 0
        if len(force) >= 2 * most + 3 and np.std(load) > 0 and np.std(force) > 0:
            shifts = best_shift(load, force, most)
            peak = max(shifts, key=lambda s: (shifts[s], -s))
            r = shifts[peak]
            if abs(peak) < most:
                lag = (peak + parabola(shifts[peak - 1], r, shifts[peak + 1])) * step
            slope = float(np.sum((load - np.mean(load)) * force) / np.sum((load - np.mean(load))**2))
    results.add("grip_load_correlation", "grip", r, grip.selection)
    results.add("grip_load_lag", "grip", lag, grip.selection, "the correlation has no peak")
    results.add("grip_load_slope", "grip", slope, grip.selection)
