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


def turn(axis, angle):
    """Quaternion (w, x, y, z)."""
    axis = np.array(axis) / np.linalg.norm(axis)
    return np.concatenate(([math.cos(angle / 2)], math.sin(angle / 2) * axis))


def put(columns, frame, poses):
    for k, name in enumerate(("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz")):
        columns[f"{frame}_{name}"] = poses[:, k]


def lose(columns, chance, frame, times):
    """Gaps around 50 ms and 0.1 s, and long ones."""
    n = len(columns["t_s"])
    for _ in range(times):
        first = chance.randrange(n)
        last = first + chance.choice((1, 2, 4, 5, 6, 7, 10, 11, 12, 30))
        for name in (c for c in columns if c.startswith(frame + "_")):
            columns[name][first:last] = np.nan


def wandering(chance, n, references):
    """An object that goes to one reference after the other, at any time, quickly or slowly, and misses it a little."""
    poses, pose = np.empty((n, 7)), references[0].copy()
    goal, left, share = pose, 0, 1
    for k in range(n):
        if not left:
            goal = chance.choice(references) + np.array([chance.gauss(0, 0.01) for _ in range(3)] +
                                                        [chance.gauss(0, 0.05) for _ in range(4)])
            left, share = chance.randrange(1, 60), chance.choice((1, 0.3, 0.05))
        pose = pose + share * (goal - pose)
        pose[3:] /= np.linalg.norm(pose[3:])
        poses[k] = pose
        left -= 1
    return poses


def arm(chance):
    """Columns and task: targets that are reached and lost, by chance, with all borders of the automaton."""
    n, count = chance.choice((60, 300, 700)), chance.choice((1, 2, 3, 5, 8))
    t = np.arange(n) / 100
    if chance.random() < 0.3:
        t = np.cumsum([chance.choice((0.005, 0.01, 0.01, 0.02, 0.05, 0.051)) for _ in range(n)])
    references = [np.concatenate(([chance.uniform(-0.2, 0.2) for _ in "xyz"],
                                  turn([chance.gauss(0, 1) for _ in "xyz"], chance.uniform(0, 1.5))))
                  for _ in range(chance.choice((1, 2, count)))]
    index = np.sort([chance.randrange(count) for _ in range(n)])
    phase = np.array([chance.choice((2, 2, 2, 2, 1, 3, 0)) for _ in range(n)], float)
    columns = {"t_s": t, "phase": phase, "sample_flags": np.zeros(n), "target_index": index.astype(float)}
    put(columns, "reference", np.array([references[i % len(references)] for i in index]))
    put(columns, "object", wandering(chance, n, references))
    for frame in ("elbow", "forearm", "dorsum"):
        size, pace, axis = chance.choice((0.02, 0.3, 1, 1.7)), chance.uniform(0.2, 2), chance.choice(np.eye(3) + 0.01)
        begin = chance.uniform(0, 6)
        put(columns, frame, np.array([np.concatenate(([0.1, 0, 0], turn(axis, size * math.sin(pace * s + begin))))
                                      for s in t]))
    for frame in ("object", "elbow", "forearm", "dorsum"):
        lose(columns, chance, frame, chance.choice((0, 0, 1, 3, 8)))
    for _ in range(chance.choice((0, 0, 3))):
        first = chance.randrange(n)
        phase[first:first + chance.choice((1, 4, 5, 6, 30))] = 4
    phase[-1] = chance.choice((2, 5))
    task = ('format = "isograsp-task-1"\nname = "Made by hand"\ninstruction = "None."\nkind = "pose_matching"\n'
            f'postures = "screw"\nsequence = [{", ".join(count * [chr(34) + "screw" + chr(34)])}]\n'
            f"position_tolerance_m = {chance.choice((0.01, 0.03, 0.2))}\n"
            f"angle_tolerance_deg = {chance.choice((5, 15, 60))}\nhold_s = {chance.choice((0, 0.01, 0.05, 0.1, 0.3))}\n"
            f"display_s = {chance.choice((0, 0.02, 0.1, 0.5))}\ntime_limit_s = {chance.choice((1, 1.5, 2, 3))}\n")
    return columns, task


def gone(t, start, length):
    """Share of a movement with least jerk that is over."""
    s = np.clip((t - start) / length, 0, 1)
    return s**3 * (10 - 15 * s + 6 * s**2)


def drinking(chance):
    """Columns and task: one drink, fast or slow, as cameras see it; sometimes with holes, pauses, an early end."""
    pace, rate = chance.uniform(0.8, 2), chance.choice((100, 100, 120, 60))
    t = np.arange(int((7.5 * pace + 0.5) * rate)) / rate
    move = lambda start: gone(t, start * pace, pace)
    reach, carried = move(0.6) - move(5.4), move(1.9) - move(4.1)
    if chance.random() < 0.3:  # halts on the way
        reach = 0.5 * gone(t, 0.6 * pace, 0.5 * pace) + 0.5 * gone(t, 1.3 * pace, 0.5 * pace) - move(5.4)
    still = lambda *p: np.tile(np.array(p, float), (len(t), 1))
    along = lambda share, *p: share[:, None] * np.array(p, float)
    glass = still(0.02, 0.3, 0) + along(carried, 0, -0.15, 0.32)
    elbow = np.radians(90 + 60 * reach)
    places = {"GLASS": glass, "HAND": along(reach, 0, 0.3, 0) + glass - still(0.02, 0.3, 0),
              "FACE": still(0, 0.11, 0.35), "TRUNK": still(0, -0.2, 0.2) + along(reach, 0, chance.uniform(0, 0.1), 0),
              "SHOULDER": still(-0.2, -0.2, 0.2), "ELBOW": still(-0.2, -0.2, -0.1),
              "WRIST": still(-0.2, -0.2, -0.1) + 0.25 * np.stack((0 * t, np.sin(elbow), np.cos(elbow)), axis=1)}
    if chance.random() < 0.1:
        places["GLASS"] = still(0.02, 0.3, 0)
    columns = {"t_s": t, "phase": (t >= 0.5).astype(float)}
    for name, p in places.items():
        if name in ("TRUNK", "SHOULDER", "WRIST") and chance.random() < 0.15:
            continue
        for axis in range(3):
            columns[f"marker_{name}_{'xyz'[axis]}_m"] = p[:, axis] + noise(chance, len(t), 2e-4)
        lose(columns, chance, f"marker_{name}", chance.choice((0, 0, 0, 0, 0, 1, 2)))
    if chance.random() < 0.15:
        first = chance.randrange(len(t))
        columns["phase"][first:first + chance.randrange(1, 30)] = 4
    last = len(t) if chance.random() < 0.85 else chance.randrange(10, len(t))
    columns = {name: values[:last] for name, values in columns.items()}
    columns["phase"][-1] = 5
    return columns, 'format = "isograsp-task-1"\nname = "Made by hand"\ninstruction = "None."\nkind = "drinking"\n'


def unseen_end():
    """One target reached after 0.3 s, one sought until the object is lost; the clock stands still 50 ms later."""
    n, there = 81, turn((1, 0, 0), 0)
    columns = {"t_s": np.arange(n) / 100, "phase": np.full(n, 2.0), "sample_flags": np.zeros(n),
               "target_index": (np.arange(n) > 30).astype(float)}
    put(columns, "reference", np.tile(np.concatenate((np.zeros(3), there)), (n, 1)))
    put(columns, "object", np.array([np.concatenate(([float(k != 30), 0, 0], there)) for k in range(n)]))
    for name in (c for c in columns if c.startswith("object_")):
        columns[name][51:] = np.nan
    return columns, ('format = "isograsp-task-1"\nname = "Made by hand"\ninstruction = "None."\n'
                     'kind = "pose_matching"\npostures = "screw"\nsequence = ["screw", "screw"]\n'
                     "hold_s = 0\ndisplay_s = 0\ntime_limit_s = 1\n")


def lose_sight(columns, chance, share):
    """Rows in which a tracker holds the hand, or does not see it."""
    n, row = len(columns["t_s"]), 0
    while row < n:
        row += 1 + int(chance.expovariate(share))
        columns["sample_flags"][row:row + chance.choice((1, 3, 20))] = chance.choice((1, 2))


def hand_opening(chance):
    """Three openings and closings of a hand that does not always move."""
    t = np.arange(int(100 * (0.5 + 3 * (2.0 + 1.7)))) / 100
    into = np.maximum(t - 0.5, 0)
    part = np.where(t < 0.5, 0, 1 + 2 * (into // 3.7) + (into % 3.7 >= 2.0))
    goal = np.where(part % 2 == 1, 0.09, 0.02) * np.where(np.isin(part, chance.sample(range(1, 7), 2)), 0.3, 1)
    gap = np.convolve(np.append(np.full(60, goal[0]), goal), np.ones(61) / 61, "valid")
    columns = {"t_s": t, "phase": np.where(part > 0, 1.0, 0.0), "sample_flags": np.zeros(len(t)), "segment": part,
               "cue": np.where(part == 0, 1.0, np.where(part % 2 == 1, 8.0, 9.0)),
               "thumb_index_gap_m": gap + noise(chance, len(t), 3e-4)}
    for digit in ("thumb", "index", "middle", "ring", "little"):
        for k in (1, 2, 3):
            columns[f"{digit}_flexion{k}_rad"] = 1.5 - 10 * gap + noise(chance, len(t), 0.02)
    lose_sight(columns, chance, 0.01)
    return columns, ('format = "isograsp-task-1"\nname = "Opening"\ninstruction = "None."\nkind = "hand_opening"\n'
                     "lead_in_s = 0.5\nrepetitions = 3\nopen_s = 2\nclose_s = 1.7\n")


def placements(chance):
    """Objects that are carried, dropped, held at their target and let go, or are not; or for the hand, at a key."""
    levels, rows = ("full", "softer", "off"), []
    own = chance.randrange(3)
    for number in range(6):
        level, eased = (own, 0) if number < 4 else (chance.randrange(3), 1)
        target, held, asked, helped = np.array([chance.uniform(-0.1, 0.1), 0.2, 0]), 0, 0, 0
        place, leave = np.array([0, 0.11, 0]), chance.choice((0.3, 0.8, 20))
        reach, falls, wait = chance.choice((0.5, 1.2, 30)), chance.random() < 0.4, 0.0
        key = chance.choice((math.inf, math.inf, 0.2, reach + 1.3))
        for k in range(int(100 * (reach + 1.4 + min(leave, 12)))):
            t = k / 100
            loose = falls and 0.3 < t < 0.62
            held = 0.1 < t and not loose
            share = min(1.0, max(0.0, (t - 0.62) / (reach - 0.2))) if falls else min(1.0, t / reach)
            away = (1 - share) * np.array([0.1, -0.09, 0]) + np.array([chance.gauss(0, 5e-4) for _ in range(3)])
            asked = reach + 1.2 < t
            wait = wait + 0.01 if asked else 0.0
            touched = held and wait < leave and wait < 10.5
            helped = wait >= 10 or t >= key
            tilt = (1 - share) * 0.5
            rows.append([1.0 if asked else 2.0, number, level, eased, asked, helped, held and touched, touched,
                         k < 10 or (loose and t > 0.45), *(target + away), *target, math.cos(tilt / 2), math.sin(tilt / 2), 0, 0,
                         1, 0, 0, 0])
    names = ["phase", "placement", "assistance", "eased", "let_go_asked", "object_helped", "object_held",
             "object_touched", "object_supported", *(f"{side}_{a}_m" for side in ("actual", "target") for a in "xyz"),
             *(f"{side}_q{c}" for side in ("actual", "target") for c in "wxyz")]
    values = np.array(rows, float)
    columns = {"t_s": np.arange(len(values)) / 100, "sample_flags": np.zeros(len(values)),
               "pause_cause": np.zeros(len(values))} | {name: values[:, k].copy() for k, name in enumerate(names)}
    lose_sight(columns, chance, chance.choice((0.002, 0.01)))
    for _ in range(3):  # pauses, out of sight or of the therapist
        first = chance.randrange(len(values))
        span = slice(first, first + chance.choice((20, 150)))
        columns["phase"][span], columns["pause_cause"][span] = 4, chance.choice((1, 4))
        columns["sample_flags"][span] = 2
    return columns, ('format = "isograsp-task-1"\nname = "Placing"\ninstruction = "None."\nkind = "virtual_pick_place"\n'
                     f'assistance = "{levels[own]}"\nlevel = {chance.choice((1, 2, 3))}\n[[placement]]\n'
                     'object = "slim_cuboid"\ntarget = 1\n')


def two_hands(chance):
    """Columns, affected hand, maxima: hands that share a target, late, with noise of their own and of both."""
    n = chance.choice((40, 400, 1600))
    t = np.arange(n) / 100
    target = 6 + 2 * np.sin(1.3 * t) + np.sin(2.9 * t + 1)
    share, late = chance.uniform(0, 1), chance.choice((0, 7, 13, -4, 160))
    drift = lambda sd: np.convolve(noise(chance, n + 30, sd), np.ones(31) / 31, "valid")
    common, apart, rest = drift(chance.choice((0, 1))), drift(chance.choice((0, 1, 2))), chance.choice((-8, 0, 0, 0.5))
    columns = {"t_s": t, "left_force_N": share * np.roll(target, late) + common + apart + rest,
               "right_force_N": (1 - share) * target + common - apart + noise(chance, n, 0.02)}
    if chance.random() < 0.7:
        columns["target_sum_force_N"] = target if chance.random() < 0.8 else np.full(n, 6.0)
    if chance.random() < 0.5:
        columns |= {"target_left_force_N": share * target, "target_right_force_N": (1 - share) * target}
    if chance.random() < 0.5:
        columns |= {f"{hand}_push_{axis}_N": drift(2) + chance.uniform(-2, 2)
                    for hand in ("left", "right") for axis in "xyz"}
    if chance.random() < 0.5:
        columns["phase"] = np.ones(n)
        first = chance.randrange(n)
        columns["phase"][first:first + chance.choice((3, 20))] = 4
    for name in chance.sample(sorted(set(columns) - {"t_s", "phase"}), 2):
        columns[name][[chance.randrange(n) for _ in range(chance.choice((0, 3)))]] = np.nan
    if chance.random() < 0.3:
        columns = uneven(columns, chance)
    known = chance.random() < 0.8
    return columns, chance.choice(("left", "right")), {hand: known and chance.uniform(5, 60) for hand in ("left", "right")}


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
    for k in range(20):
        yield f"arm_{k}", *arm(random.Random(f"arm {k} {seed}"))
    yield "arm_unseen_end", *unseen_end()
    for k in range(20):
        yield f"drinking_{k}", *drinking(random.Random(f"drinking {k} {seed}"))
    for k in range(12):
        yield f"hand_opening_{k}", *hand_opening(random.Random(f"hand {k} {seed}"))
        yield f"placements_{k}", *placements(random.Random(f"placing {k} {seed}"))
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
