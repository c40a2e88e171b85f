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
    known = ("resting_force_N", "maximum_force_N", "noise_sd_N", "resolution_N", "device_delay_s")
    for name in columns:
        if name in known or name.endswith(known[:2]) or name == "affected_hand":
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


FRAMES = ("object", "elbow", "forearm", "dorsum", "reference")


def of_frame(columns, frame):
    ends = ("_x_m", "_y_m", "_z_m", "_qw", "_qx", "_qy", "_qz")
    return [name for name in columns if name.startswith(frame + "_") and name.endswith(ends)]


def hidden(columns, chance, frames, longest):
    """Frames that are not seen for a while, of one row to so many; sometimes one field alone."""
    n = len(columns["t_s"])
    for _ in range(n // 100):
        first, names = chance.randrange(n), of_frame(columns, chance.choice(frames))
        for name in names if chance.random() < 0.9 else [chance.choice(names)]:
            columns[name][first:first + chance.choice((1, 2, 4, 5, 6, 7, longest))] = np.nan


def object_hidden(columns, chance):
    """The object alone: around 50 ms, and long."""
    hidden(columns, chance, ("object",), 25)


def frames_hidden(columns, chance):
    """Any frame and the reference; angles of the links as well."""
    hidden(columns, chance, FRAMES, 12)
    n = len(columns["t_s"])
    for name in (c for c in columns if c.endswith("_rad")):
        for _ in range(3):
            first = chance.randrange(n)
            columns[name][first:first + chance.choice((1, 5))] = np.nan


def seldom_hidden(columns, chance):
    """Few gaps of links, below and above 0.1 s: some movements keep their measures."""
    n = len(columns["t_s"])
    for frame in ("elbow", "forearm", "dorsum", "object"):
        for length in (8, 9, 10, 11):
            first = chance.randrange(n)
            for name in of_frame(columns, frame):
                columns[name][first:first + length] = np.nan


def never_seen(columns, chance):
    """No pose of the object."""
    for name in of_frame(columns, "object"):
        columns[name][:] = np.nan


def late_start(columns, chance):
    """The first poses are missing; time begins at 0.1 s."""
    for name in of_frame(columns, "object"):
        columns[name][:37] = np.nan
    columns["t_s"] += 0.1


def fewer_columns(columns, chance):
    """No flags, no clock of the task, no frames but those of the chain."""
    gone = [c for c in columns if c.startswith(("brace_", "trunk_"))]
    for name in gone + ["sample_flags", "task_time_s", "matched", "targets_reached"]:
        columns.pop(name, None)


def no_reference(columns, chance):
    """Not known to what the object was to be brought, from the second target on."""
    later = np.nan_to_num(columns.get("target_index", np.zeros(len(columns["t_s"])))) > 0
    for name in of_frame(columns, "reference"):
        columns[name][later] = np.nan


def no_index(columns, chance):
    """Not known which target it was, in places."""
    if "target_index" in columns:
        n = len(columns["t_s"])
        for _ in range(5):
            first = chance.randrange(n)
            columns["target_index"][first:first + chance.choice((1, 30))] = np.nan


def unphased(columns, chance):
    """No column of phases: all is active."""
    del columns["phase"]


def far_away(columns, chance):
    """Metres that cannot be squared, angles as well."""
    for name in columns:
        if name.endswith(("_m", "_rad")):
            columns[name] *= 1e100


def near_zero(columns, chance):
    """Metres whose squares are 0, angles as well."""
    for name in columns:
        if name.endswith(("_m", "_rad")):
            columns[name] *= 1e-100


ARM_VARIATIONS = (flagged, object_hidden, frames_hidden, seldom_hidden, never_seen, late_start, fewer_columns,
                  no_reference, no_index, paused, uneven, jittered, cut, at_once, unphased, odd, held, far_away,
                  near_zero)
VARIATIONS = (flagged, emptied, paused, uneven, jittered, cut, at_once, bare, odd, held, unknown, displayed, weak,
              fading, huge, tiny)


HAND_VARIATIONS = (flagged, emptied, paused, uneven, jittered, cut, odd, held)


def variations_of(kind):
    if kind in ("hand_opening", "virtual_pick_place"):
        return HAND_VARIATIONS
    return ARM_VARIATIONS if kind in ("pose_matching", "pose_following", "active_range") else VARIATIONS


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
