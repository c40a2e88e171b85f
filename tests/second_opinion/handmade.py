# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals that no device made: recordings of others, and pairs without a task."""

import math
import random

import numpy as np

TASK = 'format = "isograsp-task-1"\nname = "Made by hand"\ninstruction = "None."\nkind = "recorded"\n'


def noise(chance, n, sd):
    return np.array([chance.gauss(0, sd) for _ in range(n)])


def fingers(chance):
    """Four fingers that press together, with a metronome."""
    rate, beats, period = 200, 41, 0.75
    n = int(rate * period * beats)
    t = np.arange(n) / rate
    columns = {"t_s": t}
    for k, name in enumerate(("index", "middle", "ring", "little")):
        press = 4 - 0.5 * k - (2 - 0.2 * k) * np.cos(2 * math.pi * t / (2 * period))
        columns[f"{name}_fz_N"] = press + np.interp(t, t[::40], noise(chance, len(t[::40]), 0.3))
    beat = np.zeros(n)
    beat[[min(n - 1, int(rate * period * b) + chance.randrange(4)) for b in range(beats)]] = 1
    return columns | {"beat": beat}


def corridor(chance):
    """Uneven rows; inside the corridor the error is exactly 0."""
    steps = np.array([chance.uniform(0.008, 0.015) for _ in range(400)])
    error = noise(chance, 400, 1)
    return {"t_s": np.cumsum(steps), "actual_force_N": 5 + error,
            "corridor_error_N": np.where(np.abs(error) < 0.5, 0, error)}


def tracking(chance, rate=100):
    """A pair with gaps, target and actual."""
    t = np.arange(12 * rate) / rate
    target = 5 + 2 * np.sin(2 * math.pi * 0.3 * t) + np.sin(2 * math.pi * 0.11 * t)
    late = 5 + 2 * np.sin(2 * math.pi * 0.3 * (t - 0.23)) + np.sin(2 * math.pi * 0.11 * (t - 0.23))
    columns = {"t_s": t, "target_force_N": target, "actual_force_N": 0.9 * late + noise(chance, len(t), 0.1)}
    columns["actual_force_N"][[7, 300, 301]] = np.nan
    columns["target_force_N"][[9, 300, 600]] = np.nan
    return columns


def motion(chance):
    """Two pairs of positions and one angle."""
    columns = tracking(chance)
    t = columns["t_s"]
    for axis, size in (("x", 0.1), ("y", 0.07), ("z", 0.01)):
        columns[f"target_{axis}_m"] = size * np.sin(0.9 * t)
        columns[f"actual_{axis}_m"] = size * np.sin(0.9 * (t - 0.1)) + noise(chance, len(t), 1e-4)
    columns["target_angle_rad"] = 0.2 * np.sin(1.3 * t)
    columns["actual_angle_rad"] = 0.2 * np.sin(1.3 * t + 0.2)
    return columns


def uneven(columns, chance):
    """Some rows left out."""
    kept = np.array([chance.random() > 0.03 for _ in columns["t_s"]])
    return {name: values[kept] for name, values in columns.items()}


def cases(seed):
    """Name, columns, text of the task (None: without a task)."""
    chance = random.Random(seed)
    recorded = lambda text: TASK + f"duration_s = 30\n{text}\n"
    names = 'fingers = ["index", "middle", "ring", "little"]\nmeasures = "finger_forces"\n'
    yield "fingers", fingers(chance), recorded(names + "beats_per_cycle = 2\ncycles_left_out = 1")
    yield "fingers_uneven", uneven(fingers(chance), chance), recorded(names)
    yield "few_cycles", {k: v[:3000] for k, v in fingers(chance).items()}, recorded(names + "beats_per_cycle = 2")
    yield "corridor", corridor(chance), recorded('measures = "corridor"')
    yield "window", corridor(chance), recorded('measures = "maximum"\nwindow_from_end_rows = [200, 50]')
    yield "tracking", tracking(chance), recorded('measures = "tracking"')
    yield "pair", tracking(chance), None
    yield "pair_uneven", uneven(tracking(chance), chance), None
    yield "motion", motion(chance), None
    yield "motion_uneven", uneven(motion(chance), chance), None
    paused = motion(chance)
    paused["phase"] = np.where(np.arange(len(paused["t_s"])) // 50 % 5 == 3, 4.0, 1.0)
    yield "motion_paused", paused, None
    still = tracking(chance)
    still["actual_force_N"][:] = 3.0
    yield "still", still, None
    yield "short", {k: v[:6] for k, v in tracking(chance).items()}, None
    for exponent in (-200, 100):
        sized = {k: v * (1 if k == "t_s" else 10.0**exponent) for k, v in tracking(chance).items()}
        yield f"size_{exponent}", sized, None
