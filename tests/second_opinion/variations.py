# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that no simulated session gives: flags, gaps, pauses, uneven time, early ends, unknown context."""

import random

import numpy as np

VALUES = ("thumb_f", "index_f", "middle_f", "actual_", "target_")


def has_object(columns):
    return "contact_thumb" in columns


def flagged(columns, chance):
    """Held, missing, saturated and overloaded samples, alone and in runs."""
    n = len(columns["t_s"])
    for _ in range(n // 150):
        first = chance.randrange(n)
        last = min(n, first + chance.choice((1, 1, 2, 7)))
        columns["sample_flags"][first:last] = chance.choice((1, 2, 4, 8, 3))


def emptied(columns, chance):
    """Rows without values, of all fingers or of one column."""
    n = len(columns["t_s"])
    names = [c for c in columns if c.startswith(VALUES)]
    for _ in range(n // 200):
        row = chance.randrange(n)
        for name in names if chance.random() < 0.5 else [chance.choice(names)]:
            columns[name][row] = np.nan


def paused(columns, chance):
    """Many pauses of the trial, as the program marks them, in all kinds of parts."""
    n = len(columns["t_s"])
    for k in range(10):
        first = (n - 40) * k // 10 + chance.randrange(n // 40)
        columns["phase"][first:first + chance.randrange(2, 20)] = 4


def uneven(columns, chance):
    """Rows left out: the grid is no longer regular."""
    n = len(columns["t_s"])
    kept = np.array([chance.random() > 0.02 for _ in range(n)])
    kept[[0, 1, 2, n - 2, n - 1]] = True
    for name in columns:
        columns[name] = columns[name][kept]


def jittered(columns, chance):
    """Every row a little early or late."""
    t = columns["t_s"]
    t += np.array([chance.uniform(-0.002, 0.002) for _ in t])


def cut(columns, chance):
    """The trial was ended early."""
    n = int(len(columns["t_s"]) * chance.uniform(0.3, 0.7))
    for name in columns:
        columns[name] = columns[name][:n]


def at_once(columns, chance):
    """Hardly begun."""
    for name in columns:
        columns[name] = columns[name][:max(5, len(columns[name]) // 50)]


def unknown(columns, chance):
    """Nothing is known of the session but the delay of the display."""
    for name in ("resting_force_N", "maximum_force_N", "noise_sd_N", "resolution_N", "device_delay_s"):
        columns[name][:] = np.nan
    columns["display_delay_s"][:] = 0.04


def displayed(columns, chance):
    """Somebody has measured the display; time begins at 0.1 s."""
    columns["display_delay_s"][:] = 0.04
    columns["t_s"] += 0.1


def weak(columns, chance):
    """Forces so small that they cannot be told from noise."""
    for name in columns:
        if name.endswith("_N") and name.split("_")[0] in ("thumb", "index", "middle", "actual"):
            columns[name] *= 0.01


def fading(columns, chance):
    """All forces go down to a third."""
    fade = np.linspace(1, 0.33, len(columns["t_s"]))
    for name in columns:
        if name.endswith("_N") and name.split("_")[0] in ("thumb", "index", "middle", "actual"):
            columns[name] *= fade


def huge(columns, chance):
    """Forces that cannot be squared."""
    for name in columns:
        if name.endswith("_N"):
            columns[name] *= 1e100


def tiny(columns, chance):
    """Forces whose squares are 0."""
    for name in columns:
        if name.endswith("_N"):
            columns[name] *= 1e-100


def bare(columns, chance):
    """No flags; no parts, where the channel is always the same."""
    del columns["sample_flags"]
    if len(set(columns.get("channel_digits", ()))) > 1:
        return
    for name in ("segment", "cue", "channel_digits", "channel_direction"):
        columns.pop(name, None)


def odd(columns, chance):
    """Phases and flags that are none."""
    n = len(columns["t_s"])
    for _ in range(6):
        columns["phase"][chance.randrange(n)] = chance.choice((np.nan, 2.5, 7, -1))
        columns["sample_flags"][chance.randrange(n)] = np.nan


def held(columns, chance):
    """The first samples of the scored time are held ones."""
    for first in np.flatnonzero(np.diff(columns["phase"], prepend=0) != 0):
        columns["sample_flags"][first:first + 2] = 1


VARIATIONS = (flagged, emptied, paused, uneven, jittered, cut, at_once, bare, odd, held, unknown, displayed, weak,
              fading, huge, tiny)


def vary(columns, variation, seed):
    """A copy of the columns with one variation."""
    columns = {name: values.copy() for name, values in columns.items()}
    variation(columns, random.Random(f"{variation.__name__} {seed}"))
    return columns


def write_columns(path, columns):
    """CSV with shortest decimals; NaN is an empty field."""
    texts = [["" if x != x else repr(x).removesuffix(".0") for x in values.tolist()] for values in columns.values()]
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        file.writelines(",".join(row) + "\n" for row in zip(*texts))
