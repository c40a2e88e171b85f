# SPDX-License-Identifier: GPL-3.0-or-later
"""An arm seen by markers: pose_matching, pose_following, active_range (docs/measures.md, Moving an arm;
docs/markers.md)."""

import math

import numpy as np

import tracking
from record import ACTIVE, HOLD, PAUSED, TRANSPORT, Selection
from tools import kaplan_meier, weighted_mean

CLOCK_S = 1e-9  # times of the automaton are equal within this
STAND_IN_S = 0.05
GAP_S = 0.1
LEAST_TURN = math.radians(5)
LINKS = {"forearm": ("elbow", "forearm"), "wrist": ("forearm", "dorsum"), "fingers": ("dorsum", "object")}


def names_of(frame):
    return [f"{frame}_{axis}_m" for axis in "xyz"] + [f"{frame}_q{axis}" for axis in "wxyz"]


class Frame:
    """Poses of one frame, all rows; `whole` where all seven fields have a value."""

    def __init__(self, record, frame):
        values = np.stack([record.column(n) for n in names_of(frame)], axis=1)
        self.whole = ~np.isnan(values).any(axis=1)
        self.p, self.q = values[:, :3], values[:, 3:]


def inverse_times(a, b):
    """conj(a) b of quaternions (w, x, y, z), row by row."""
    aw, ax, ay, az = a[..., 0], -a[..., 1], -a[..., 2], -a[..., 3]
    bw, bx, by, bz = b[..., 0], b[..., 1], b[..., 2], b[..., 3]
    return np.stack([aw * bw - ax * bx - ay * by - az * bz, aw * bx + ax * bw + ay * bz - az * by,
                     aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw], axis=-1)


def angle_between(a, b):
    d = inverse_times(a, b)
    return 2 * np.arctan2(np.sqrt(np.sum(d[..., 1:]**2, axis=-1)), np.abs(d[..., 0]))


class Event:
    """What became of one target: rows of the record, None where it did not come to that."""

    def __init__(self, cue, clock):
        self.cue, self.clock = cue, clock
        self.enter = self.entered = self.done = self.finished = None
        self.time = None
        self.errors = []


class PoseTask:
    """The automaton, from the rows that are not paused."""

    def __init__(self, record, task):
        self.t, self.object = record.columns["t_s"], Frame(record, "object")
        self.rows = np.flatnonzero(record.phase != PAUSED)
        self.references = self._references(record)
        self.distance, self.angle = task["position_tolerance_m"], math.radians(task["angle_tolerance_deg"])
        self.hold, self.display, self.limit = task["hold_s"], task["display_s"], task["time_limit_s"]
        self.events, self.sought = [], None
        self._run()

    def _references(self, record):
        index, reference, found = record.column("target_index")[self.rows], Frame(record, "reference"), []
        while True:
            rows = self.rows[index == len(found)]
            rows = rows[reference.whole[rows]]
            if not len(rows):
                return found
            found.append((reference.p[rows[0]], reference.q[rows[0]]))

    def _errors(self, target):
        """Distance and angle to a reference, all rows."""
        p, q = self.references[target]
        return np.stack([np.sqrt(np.sum((self.object.p - p)**2, axis=1)), angle_between(self.object.q, q)], axis=1)

    def _run(self):
        errors = [self._errors(target) for target in range(len(self.references))]
        target, last, pauses, event = 0, None, 0.0, None
        for k in self.rows:
            t, real = self.t[k], bool(self.object.whole[k])
            if real:
                away = 0.0 if last is None else t - self.t[last]
                if away > STAND_IN_S + CLOCK_S:
                    pauses += away - STAND_IN_S
                    if event and event.done is None:
                        event.enter = None
                last = k
            elif last is None or t - self.t[last] > STAND_IN_S + CLOCK_S:
                continue
            c = t - pauses
            if event is None:
                if target >= len(self.references):
                    return
                event = Event(k, c)
            if event.done is not None and c - event.finished >= self.display - CLOCK_S:
                self.events.append(event)
                target, event = target + 1, None
                if target >= len(self.references):
                    return
                event = Event(k, c)
            if event.done is None:
                if errors[target][last, 0] <= self.distance and errors[target][last, 1] <= self.angle:
                    if event.enter is None:
                        event.enter, event.entered = k, c
                    if c - event.entered >= self.hold - CLOCK_S:
                        event.done, event.finished, event.time = k, c, event.entered - event.clock
                else:
                    event.enter = None
            if event.done is not None:
                if real:
                    event.errors.append(errors[target][k])
            elif c - event.clock >= self.limit - CLOCK_S:
                event.time = self.limit
                self.events.append(event)
                target, event = target + 1, None
                if target >= len(self.references):
                    return
                event = Event(k, c)
        if event is None:
            return
        if event.done is not None:
            self.events.append(event)
            return
        end = min(self.t[self.rows[-1]], self.t[last] + STAND_IN_S) - pauses
        self.sought = min(max(end - event.clock, 0.0), self.limit)


class Turn:
    """How far one link has turned, from the cue to the entry: angle θ(t) of its valid rows, or why there is none."""

    def __init__(self, t, rows, event, frames):
        self.reason, self.cue = None, t[event.cue]
        rows = rows[(rows >= event.cue) & (rows <= event.enter)]
        rows = rows[np.all([f.whole[rows] for f in frames], axis=0)]
        self.t = t[rows]
        if not len(rows) or self.t[0] - self.cue > STAND_IN_S + CLOCK_S:
            self.reason = "no valid sample at the cue"
        elif t[event.enter] - self.t[-1] > STAND_IN_S + CLOCK_S:
            self.reason = "no valid sample at the match"
        elif np.any(np.diff(self.t) > GAP_S + CLOCK_S):
            self.reason = "gap"
        if self.reason:
            return
        q = frames[-1].q[rows] if len(frames) == 1 else inverse_times(frames[0].q[rows], frames[1].q[rows])
        self.theta = angle_between(q[0], q)
        self.whole = float(self.theta[-1])

    def ratio(self):
        """θ(t) / θ(T), or None."""
        if self.reason or self.whole < LEAST_TURN:
            self.reason = self.reason or "too little rotation"
            return None
        return self.theta / self.whole

    def passes(self, level):
        """When the ratio passes a level for the first time, in the record's time."""
        r = self.ratio()
        if r is None:
            return None
        k = int(np.argmax(r >= level))
        return self.t[k - 1] + (level - r[k - 1]) / (r[k] - r[k - 1]) * (self.t[k] - self.t[k - 1])

    def ratio_at(self, when):
        r = self.ratio()
        return None if r is None or when is None else float(np.interp(when, self.t, r))


def median(values):
    return float(np.median(values)) if values else None


def score_pose_matching(results, task, record):
    run = PoseTask(record, task)
    columns = ["target_index"] + names_of("object") + names_of("reference")
    phases = [ACTIVE, TRANSPORT, HOLD]
    whole = record.select(phases, columns, least=0)
    reached = [e for e in run.events if e.done is not None]
    results.add("targets_reached", "targets", float(len(reached)), whole)
    waits = [(e.time, e.done is not None) for e in run.events]
    for i in range(len(task["sequence"]) * task["repeats"]):
        own = np.flatnonzero((record.phase != PAUSED) & (record.column("target_index") == i))
        computable = whole.samples or whole.excluded
        if computable and len(own) and i < len(run.events) + (run.sought is not None):
            selection = record.select(phases, [], own[0], own[-1] + 1)
        else:
            selection = Selection(own[:0], 0)
        time = run.events[i].time if i < len(run.events) and run.events[i].done is not None else None
        results.add("completion_time", f"target_{i + 1}", time, selection, "not reached")
    if run.sought is not None:
        waits.append((run.sought, False))
    middle = restricted = None
    if waits:
        middle, restricted, left = kaplan_meier(waits, run.limit)
        if left > 0 and not any(t >= run.limit * (1 - 1e-9) for t, _ in waits):
            restricted = None
    results.add("median_completion_time", "targets", middle, whole, "longer than the limit")
    results.add("restricted_mean_time", "targets", restricted, whole)
    for k, name in enumerate(("position_error", "angle_error")):
        means = [float(np.mean([error[k] for error in e.errors])) for e in reached if e.errors]
        results.add(name, "object", float(np.mean(means)) if means else None, whole)
    add_times(results, run, reached, whole)
    add_rotations(results, record, run, reached, whole)
    asked = np.isin(record.phase, [ACTIVE, TRANSPORT, HOLD, PAUSED])
    time = float(np.sum(record.hold[asked]))
    seen = 100 * float(np.sum(record.hold[asked & run.object.whole])) / time if time > 0 else None
    results.add("seen", "object", seen, whole)


def add_times(results, run, reached, whole):
    """Recognition until a tenth of the object's turn, movement from there on."""
    recognitions, movements, reasons = [], [], []
    for event in reached:
        turn = Turn(run.t, run.rows, event, [run.object])
        tenth = turn.passes(0.1)
        if tenth is None:
            reasons.append(turn.reason)
            continue
        recognitions.append(tenth - run.t[event.cue])
        movements.append(run.t[event.enter] - tenth)
    reason = reasons[0] if reasons else "no target was reached"
    results.add("recognition_time", "object", median(recognitions), whole, reason)
    results.add("movement_time", "object", median(movements), whole, reason)


def add_rotations(results, record, run, reached, whole):
    """Rotation, share, t10 and t63 of each link."""
    frames = {name: Frame(record, name) for name in ("elbow", "forearm", "dorsum")} | {"object": run.object}
    turns = {link: [Turn(run.t, run.rows, e, [frames[f] for f in both]) for e in reached]
             for link, both in LINKS.items()}
    for link, own in turns.items():
        rotations = [turn.whole for turn in own if not turn.reason]
        shares = [turn.ratio_at(forearm.passes(1 - math.exp(-1))) for turn, forearm in zip(own, turns["forearm"])]
        tenths, others = ([turn.passes(level) - turn.cue for turn in own if turn.ratio() is not None]
                          for level in (0.1, 1 - math.exp(-1)))
        for name, values in (("rotation", rotations), ("relative_rotation", [x for x in shares if x is not None]),
                             ("rotation_t10", tenths), ("rotation_t63", others)):
            results.add(name, link, median(values), whole)


def rotation_vectors(q):
    """Of unit quaternions, row by row."""
    v, w = q[:, 1:], q[:, 0]
    size = np.sqrt(np.sum(v**2, axis=1))
    angle = 2 * np.arctan2(size, np.abs(w)) * np.where(w < 0, -1, 1)
    return v * np.where(size > 0, angle / np.where(size > 0, size, 1), 0)[:, None]


def lag_along(t, reference, actual, least):
    """Lag of one vector behind another along the furthest way of the reference."""
    sizes = np.sqrt(np.sum(reference**2, axis=1))
    if not len(sizes) or np.max(sizes) < least:
        return None
    way = reference[np.argmax(sizes >= (1 - 1e-6) * np.max(sizes))]
    return tracking.lag_of(t, reference @ way, actual @ way)[0]


def score_pose_following(results, task, record):
    selection = record.select([ACTIVE], names_of("object") + names_of("reference"), least=0)
    rows, where, goal = selection.rows, Frame(record, "object"), Frame(record, "reference")
    asked = np.isin(record.phase, [ACTIVE, TRANSPORT, HOLD, PAUSED])
    time = float(np.sum(record.hold[asked]))
    seen = 100 * float(np.sum(record.hold[asked & where.whole])) / time if time > 0 else None
    values = dict.fromkeys([("rmse", "position"), ("rmse", "attitude"), ("lag", "position"), ("lag", "attitude")])
    if len(rows) and seen >= 50:
        w, p, p_goal, q, q_goal = record.hold[rows], where.p[rows], goal.p[rows], where.q[rows], goal.q[rows]
        values["rmse", "position"] = math.sqrt(weighted_mean(np.sum((p - p_goal)**2, axis=1), w))
        values["rmse", "attitude"] = math.sqrt(weighted_mean(angle_between(q_goal, q)**2, w))
        values["lag", "position"] = lag_along(record.t[rows], p_goal - p_goal[0], p - p_goal[0], 0.01)
        turns = [rotation_vectors(inverse_times(q_goal[:1], x)) for x in (q_goal, q)]
        values["lag", "attitude"] = lag_along(record.t[rows], *turns, LEAST_TURN)
    for (name, channel), value in values.items():
        results.add(name, channel, value, selection)
    results.add("seen", "object", seen, selection)


def score_active_range(results, task, record):
    column = f"{task['link']}_a{task['angle']}_rad"
    selection = record.select([ACTIVE], [column])
    rows = np.flatnonzero(record.phase == ACTIVE)
    least = largest = None
    if selection.samples:
        t, x = record.t[rows], record.column(column)[rows]
        x = np.where(record.clean[rows], x, np.nan)
        means = []
        for k in range(len(rows)):
            if t[k] - 0.1 < t[0] - CLOCK_S or t[k] + 0.1 > t[-1] + CLOCK_S:
                continue
            window = x[(t >= t[k] - 0.1 - CLOCK_S) & (t <= t[k] + 0.1 + CLOCK_S)]
            if not np.isnan(window).any():
                means.append(float(np.mean(window)))
        if means:
            least, largest = min(means), max(means)
    for name, value in (("least_angle", least), ("largest_angle", largest),
                        ("active_range", None if least is None else largest - least)):
        results.add(name, task["link"], value, selection, "no window without a gap")
