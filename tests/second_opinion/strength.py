# SPDX-License-Identifier: GPL-3.0-or-later
"""Strength: maxima, rates, co-flexion, net push, sharing, resting force."""

import numpy as np

from record import ACTIVE, DIGITS, EPSILON_S, HOLD, LEAD_IN, PAUSED
from tools import best_window, quantile, rate, sd, stretches, weighted_mean

COMPONENTS = ("fx_N", "fy_N", "fz_N", "tx_Nm", "ty_Nm", "tz_Nm")


def window_of(record, part, values, counts, length):
    """Best window of the rows of a part."""
    rows = slice(part.first, part.last)
    return best_window(values[rows], record.hold[rows], counts[rows], length)


def counting(record, *columns):
    """Rows in which all columns have a value, no flag is set and time runs."""
    return record.clean & (record.phase != PAUSED) & ~np.any([np.isnan(c) for c in columns], axis=0)


def add_resting(results, record):
    """Mean of the grip and of every component."""
    columns = [("grip", "actual_force_N")]
    columns += [(f"{d}_{c.split('_')[0]}", f"{d}_{c}") for d in DIGITS for c in COMPONENTS]
    for channel, name in columns:
        selection = record.select([ACTIVE], [name])
        rows = selection.rows
        value = weighted_mean(record.column(name)[rows], record.hold[rows]) if len(rows) else None
        results.add("resting_force", channel, value, selection)


def add_maximum(results, record, part, window_s, channel, name="maximum_force", all_three=True):
    """Best window above rest; with its total and the peak, of the only effort of a trial."""
    force = record.column("actual_force_N")
    selection = record.select_part(part, ["actual_force_N"])
    if all_three:
        selection = record.select([ACTIVE], ["actual_force_N"])
    total = window_of(record, part, force, counting(record, force), window_s) if selection.samples else None
    resting = record.of_part("resting_force_N", part)
    results.add(name, channel, None if total is None else total - resting, selection)
    if all_three:
        results.add(name + "_total", channel, total, selection)
        peak = float(np.max(force[selection.rows])) if selection.samples else None
        results.add("peak_force", channel, peak, selection)


def add_rates(results, record, part, channel):
    """peak_rate, early_rate of an effort."""
    force = record.column("actual_force_N")
    selection = record.select_part(part, ["actual_force_N"])
    rows = selection.rows
    peak = early = None
    speeds = rate(record.t[rows], force[rows]) if len(rows) else None
    if speeds is not None and np.max(speeds) > 0:
        peak = float(np.max(speeds))
    results.add("peak_rate", channel, peak, selection)
    before = record.select([LEAD_IN, ACTIVE], ["actual_force_N"], 0, part.first).rows
    if len(before) >= 2 and len(rows):
        resolution = np.nan_to_num(record.of_part("resolution_N", part))
        level = np.mean(force[before]) + max(3 * sd(force[before]), 2 * resolution)
        t, x = record.t[rows], force[rows]
        found = stretches(t, x > level, 0.05)
        if found:
            onset = t[found[0][0]]
            if onset + 0.2 <= t[-1] + EPSILON_S:
                early = float((np.interp(onset + 0.2, t, x) - x[found[0][0]]) / 0.2)
    results.add("early_rate", channel, early, selection, "the force never rose above rest")


def add_coflexion(results, record, part, window_s, channel):
    """Press of a digit while the hand should open."""
    forces = {d: record.column(f"{d}_fz_N") for d in DIGITS}
    names = [f"{d}_fz_N" for d in DIGITS]
    selection = record.select_part(part, names)
    first = part.first
    while first > 0 and record.phase[first - 1] == LEAD_IN:
        first -= 1
    rest = record.select([LEAD_IN], names, first, part.first).rows
    value = None
    if len(rest) and selection.samples:
        counts = counting(record, *forces.values())
        above = {d: f - weighted_mean(f[rest], record.hold[rest]) for d, f in forces.items()}
        pulls = sum(np.maximum(0, -f) for f in above.values())
        opened = window_of(record, part, pulls, counts, window_s)
        presses = [window_of(record, part, f, counts, window_s) for f in above.values()]
        if opened is not None and opened > 0:
            value = 100 * max(0.0, *presses) / opened
    results.add("coflexion", channel, value, selection)


def add_force_of_maximum(results, record):
    """Was the maximum one?"""
    force, resting = record.column("actual_force_N"), record.column("resting_force_N")
    maximum = record.column("maximum_force_N")
    if np.all(np.isnan(maximum)):
        return
    counts = counting(record, force, resting, maximum) & np.isin(record.phase, [ACTIVE, HOLD])
    selection = record.select([ACTIVE, HOLD], ["actual_force_N", "resting_force_N", "maximum_force_N"])
    with np.errstate(divide="ignore", invalid="ignore"):
        relative = 100 * (force - resting) / maximum
    value = best_window(relative, record.hold, counts, 0.5)
    results.add("force_of_maximum", record.parts[0].channel, value, selection)


def add_net_push(results, record):
    """Net force on the platform in relation to that of the channel."""
    names = ["net_fx_N", "net_fy_N", "net_fz_N", "actual_force_N"]
    selection = record.select([ACTIVE, HOLD], names)
    rows = selection.rows
    net = np.sqrt(sum(record.column(n)[rows]**2 for n in names[:3]))
    force, w = np.abs(record.column("actual_force_N")[rows]), record.hold[rows]
    felt = force > 0.5
    push = median = None
    if np.any(felt):
        percent = 100 * net[felt] / force[felt]
        median = quantile(percent, w[felt], 0.5)
        push = 100 * weighted_mean((percent > 20).astype(float), w[felt])
    results.add("net_push", "platform", median, selection)
    results.add("net_push_time", "platform", push, selection)


def add_sharing(results, record, phases=(ACTIVE,)):
    """sharing, thumb_opposition."""
    selection = record.select(phases, [f"{d}_fz_N" for d in DIGITS])
    rows = selection.rows
    shares = [None] * 3
    opposition = None
    if len(rows):
        means = [weighted_mean(record.column(f"{d}_fz_N")[rows], record.hold[rows]) for d in DIGITS]
        if sum(means) > 0:
            shares = [100 * m / sum(means) for m in means]
        if means[1] + means[2] > 0:
            opposition = means[0] / (means[1] + means[2])
    for digit, share in zip(DIGITS, shares):
        results.add("sharing", digit, share, selection)
    results.add("thumb_opposition", "digits", opposition, selection)
