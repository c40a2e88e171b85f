# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects and their targets: pose_targets, pose_tracking, pick_place, observe."""

import math

import numpy as np

import grip
import smoothness
import tracking
from record import ACTIVE, EPSILON_S, HOLD, PAUSED, TRANSPORT, Selection, join
from task import frequencies_of
from tools import kaplan_meier, sd, weighted_mean

HANDLING = (TRANSPORT, HOLD)


class Pose:
    """Positions and attitudes of object and target, all rows."""

    def __init__(self, record, both=True):
        axes = [a for a in "xyz" if record.has(f"actual_{a}_m") and (not both or record.has(f"target_{a}_m"))]
        self.names = [f"actual_{a}_m" for a in axes]
        self.target_names = [f"target_{a}_m" for a in axes]
        self.actual = np.stack([record.column(n) for n in self.names], axis=1)
        self.target = np.stack([record.column(n) for n in self.target_names], axis=1)
        quaternion = record.has("actual_qw") and record.has("target_qw")
        self.attitude_names = ([f"{s}_q{c}" for s in ("actual", "target") for c in "wxyz"] if quaternion
                               else ["actual_angle_rad", "target_angle_rad"])
        self.q, self.q_target = (self._attitude(record, s, quaternion) for s in ("actual", "target"))

    @staticmethod
    def _attitude(record, side, quaternion):
        if quaternion:
            return np.stack([record.column(f"{side}_q{c}") for c in "wxyz"], axis=1)
        half = record.column(f"{side}_angle_rad") / 2
        return np.stack([np.cos(half), 0 * half, 0 * half, np.sin(half)], axis=1)

    def distance(self, rows):
        return np.linalg.norm(self.actual[rows] - self.target[rows], axis=1)

    def angle(self, rows):
        a, b = self.q[rows], self.q_target[rows]
        w = np.sum(a * b, axis=1)
        v = a[:, :1] * b[:, 1:] - b[:, :1] * a[:, 1:] - np.cross(a[:, 1:], b[:, 1:])
        return 2 * np.arctan2(np.linalg.norm(v, axis=1), np.abs(w))

    @staticmethod
    def main_axis(q):
        """Object z in the world."""
        w, x, y, z = q.T
        return np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z], axis=1)

    def axis_angle(self, rows):
        a, b = self.main_axis(self.q[rows]), self.main_axis(self.q_target[rows])
        return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.sum(a * b, axis=1))


class Attempt:
    """At one target: rows, whether and where it was reached."""

    def __init__(self, record, index):
        rows = np.flatnonzero(np.isin(record.phase, HANDLING) & (record.column("target_index") == index))
        self.index, self.appeared = index, len(rows) > 0
        self.reached = False
        if not self.appeared:
            return
        self.first, self.last = rows[0], rows[-1]
        count = np.nan_to_num(record.column("targets_reached"), nan=0)
        before = np.max(count[:self.first], initial=0)
        self.reached = bool(np.max(count[rows]) > before)
        self.hold = self.last
        for k in range(self.last - 1, self.first - 1, -1):
            if record.phase[k] == PAUSED:
                continue
            if record.phase[k] != HOLD:
                break
            self.hold = k
        self.end = record.t[self.last] + record.hold[self.last]


def attempts_of(record, count):
    return [Attempt(record, i) for i in range(count)]


def add_times(results, record, attempts, limit, until_let_go):
    """completion_time of every target, median, restricted mean, targets_reached."""
    whole = record.select(HANDLING, [])
    results.add("targets_reached", "targets", float(sum(a.reached for a in attempts)), whole)
    waits = []
    for a in attempts:
        if not a.appeared:
            results.add("completion_time", f"target_{a.index + 1}", None, Selection(np.array([]), 0), "ended earlier")
            continue
        begin = record.t[a.first]
        selection = record.select(HANDLING, [], a.first, a.last + 1)
        time = float(record.t[a.last if until_let_go else a.hold] - begin) if a.reached else None
        results.add("completion_time", f"target_{a.index + 1}", time, selection, "not reached")
        tried = a.end - begin
        waits.append((time, True) if a.reached else (limit if abs(tried - limit) < EPSILON_S else tried, False))
    median = restricted = None
    if waits:
        median, restricted, left = kaplan_meier(waits, limit)
        if left > 0 and not any(t >= limit * (1 - 1e-9) for t, _ in waits):
            restricted = None
    results.add("median_completion_time", "targets", median, whole, "longer than the limit")
    results.add("restricted_mean_time", "targets", restricted, whole)


def add_hold_errors(results, record, pose, attempts):
    """Errors of position, attitude and axis during the holds that reached their target."""
    held = [(a.hold, a.last) for a in attempts if a.reached]
    for name, channel, columns, error in (
            ("hold_error_position", "position", pose.names + pose.target_names, pose.distance),
            ("hold_error_angle", "angle", pose.attitude_names, pose.angle),
            ("hold_error_axis", "angle", pose.attitude_names, pose.axis_angle)):
        selection = join([record.select([HOLD], columns, first, last) for first, last in held])
        rows = selection.rows
        if name == "hold_error_axis" and not np.any(pose.q[rows][:, 1:3]) and not np.any(pose.q_target[rows][:, 1:3]):
            continue
        value = weighted_mean(error(rows), record.hold[rows]) if len(rows) else None
        results.add(name, channel, value, selection)


def path_of(points):
    return float(np.sum(np.linalg.norm(np.diff(points, axis=0), axis=1)))


def add_path_length(results, record, phases):
    pose = Pose(record, both=False)
    selection = record.select(phases, pose.names)
    value = path_of(pose.actual[selection.rows]) if selection.samples else None
    results.add("path_length", "position", value, selection)


def add_efficiency(results, pose, ways):
    """ways: selections of rows."""
    length = sum(path_of(pose.actual[w.rows]) for w in ways)
    straight = sum(float(np.linalg.norm(pose.actual[w.rows[-1]] - pose.actual[w.rows[0]])) for w in ways)
    results.add("path_efficiency", "position", 100 * straight / length if length > 0 else None, join(ways))


def way_of(record, pose, attempt, tolerance):
    """From the appearance of a target to its hold; None where there is no way to go."""
    way = record.select(HANDLING, pose.names + pose.target_names, attempt.first, attempt.hold + 1)
    if way.samples < 2 or pose.distance(way.rows)[0] <= tolerance:
        return None
    return way


def add_fitts(results, record, pose, attempts, targets, tolerance):
    """index_of_difficulty, throughput."""
    distances, ends, times, selections = [], [], [], []
    for a in attempts:
        if not a.reached or not targets[a.index].get("hold_s", 0) > 0:
            continue
        way = way_of(record, pose, a, tolerance)
        held = record.select([HOLD], pose.names + pose.target_names, a.hold, a.last)
        if way is None or not held.samples:
            continue
        start = pose.actual[way.rows[0]]
        goal = pose.target[way.rows[0]]
        distance = np.linalg.norm(goal - start)
        end = np.mean((pose.actual[held.rows] - start) @ (goal - start)) / distance
        distances.append(distance)
        ends.append(end)
        times.append(record.t[a.hold] - record.t[a.first])
        selections.append(way)
    difficulty = throughput = None
    if distances:
        difficulty = float(np.mean(np.log2(np.array(distances) / (2 * tolerance) + 1)))
    if len(distances) >= 10 and max(distances) - min(distances) <= 2 * tolerance:
        width = 4.133 * sd(np.array(ends) - np.array(distances))
        throughput = math.log2(np.mean(ends) / width + 1) / float(np.mean(times)) if width > 0 else None
    selection = join(selections)
    results.add("index_of_difficulty", "position", difficulty, selection)
    results.add("throughput", "position", throughput, selection)


def add_transports(results, record, pose, attempts, targets):
    """sparc, ldlj of the ways to level targets, motion and force."""
    level = [a for a in attempts if targets[a.index].get("level", False)]
    level = [a for a in (level or attempts) if a.reached]
    for channel, columns, axes in (("transport", pose.names, pose.actual.T),
                                   ("force_rate", ["actual_force_N"], [record.column("actual_force_N")])):
        stretches = [record.select(HANDLING, columns, a.first, a.hold + 1) for a in level]
        both = [smoothness.of_motion(record.t[s.rows], *(x[s.rows] for x in axes)) for s in stretches if s.samples > 1]
        for name, values in (("sparc", [v[0] for v in both]), ("ldlj", [v[1] for v in both])):
            values = [v for v in values if v is not None]
            results.add(name, channel, float(np.mean(values)) if values else None, join(stretches))


def add_drops(results, record):
    """Losses of the last contact in transport."""
    touch = np.any([record.column(f"contact_{d}") > 0.5 for d in ("thumb", "index", "middle")], axis=0)
    missing = np.nan_to_num(record.column("sample_flags"), nan=2).astype(int) & 2 > 0
    drops = sum(1 for k in range(1, record.size)
                if record.phase[k] == TRANSPORT and record.phase[k - 1] in HANDLING and touch[k - 1]
                and not touch[k] and not missing[k] and not missing[k - 1])
    results.add("drops", "contact", float(drops), record.select(HANDLING, []))


def score_pose_targets(results, task, record):
    targets, pose = task["target"], Pose(record)
    tolerance = task["position_tolerance_m"] * task.factor["tolerance"]
    attempts = attempts_of(record, len(targets))
    add_times(results, record, attempts, task["time_limit_s"], until_let_go=False)
    add_hold_errors(results, record, pose, [a for a in attempts if targets[a.index].get("hold_s", 0) > 0])
    tilts = [record.select([TRANSPORT], pose.attitude_names, a.first, a.last + 1) for a in attempts
             if a.appeared and targets[a.index].get("level", False)]
    selection = join(tilts)
    rows = selection.rows
    tilt = math.sqrt(weighted_mean(pose.angle(rows)**2, record.hold[rows])) if len(rows) else None
    results.add("tilt_in_transport", "angle", tilt, selection, "no level transport")
    add_path_length(results, record, HANDLING)
    ways = [way_of(record, pose, a, tolerance) for a in attempts if a.reached]
    add_efficiency(results, pose, [w for w in ways if w is not None])
    add_drops(results, record)
    add_transports(results, record, pose, attempts, targets)
    add_fitts(results, record, pose, attempts, targets, tolerance)
    grip.add_grip(results, record, HANDLING)


def add_carried_ways(results, record, pose, attempts, drops):
    """path_efficiency of the ways that ended at a target, each from the last fetching on."""
    ways = []
    for a in (a for a in attempts if a.reached):
        dropped = [k for k in range(a.first + 1, a.hold + 1) if drops[k] > drops[k - 1]]
        first = (dropped[-1] if dropped else a.first) + 1
        ways.append(record.select(HANDLING, pose.names, first, a.hold + 1))
    add_efficiency(results, pose, [w for w in ways if w.samples > 1])


def score_pick_place(results, task, record):
    pose = Pose(record)
    attempts = attempts_of(record, len(task["item"]))
    add_times(results, record, attempts, task["time_limit_s"], until_let_go=True)
    drops = np.nan_to_num(record.column("drops"), nan=0)
    results.add("drops", "contact", float(np.max(drops)), record.select(HANDLING, []))
    add_carried_ways(results, record, pose, attempts, drops)
    add_hold_errors(results, record, pose, attempts)
    grip.add_grip(results, record, HANDLING)


def score_observe(results, task, record):
    grip.add_mean_grip(results, record, [ACTIVE])
    selection = record.select([ACTIVE], ["actual_force_N"])
    force = record.column("actual_force_N")[selection.rows]
    results.add("peak_force", "grip", float(np.max(force)) if len(force) else None, selection)
    add_path_length(results, record, [ACTIVE])
    grip.add_contact_time(results, grip.Grip(record, [ACTIVE]))


def turns(q, axis):
    """Angle about one axis, made continuous."""
    return np.unwrap(2 * np.arctan2(q[:, 1 + axis], q[:, 0]))


def score_pose_tracking(results, task, record):
    pose = Pose(record)
    for axis in task["axis"]:
        dof = axis["dof"]
        if dof[0] == "r":
            selection = record.select([ACTIVE], pose.attitude_names)
            rows, k = selection.rows, "xyz".index(dof[1])
            target, actual = np.full(record.size, np.nan), np.full(record.size, np.nan)
            target[rows], actual[rows] = turns(pose.q_target[rows], k), turns(pose.q[rows], k)
            away = actual[rows[0]] - target[rows[0]] if len(rows) else 0
            actual -= 2 * math.pi * round(away / (2 * math.pi))
        else:
            selection = record.select([ACTIVE], [f"target_{dof}_m", f"actual_{dof}_m"])
            target, actual = record.column(f"target_{dof}_m"), record.column(f"actual_{dof}_m")
        tracking.add_errors(results, dof, ["rmse", "mae", "constant_error"], record, selection, target, actual)
        tracking.add_lag(results, dof, record, selection, target, actual)
        results.corrected("lag", dof, record, selection)
        frequencies = frequencies_of(axis, task["duration_s"])
        tracking.add_gains(results, dof, frequencies, record, selection, target, actual)
    for channel, columns, error in (("position", pose.names + pose.target_names, pose.distance),
                                    ("attitude", pose.attitude_names, pose.angle)):
        selection = record.select([ACTIVE], columns)
        rows = selection.rows
        value = math.sqrt(weighted_mean(error(rows)**2, record.hold[rows])) if len(rows) else None
        results.add("rmse", channel, value, selection)
    add_path_length(results, record, [ACTIVE])
    for channel, columns, axes in (("position", pose.names, pose.actual.T),
                                   ("force_rate", ["actual_force_N"], [record.column("actual_force_N")])):
        selection = record.select([ACTIVE], columns)
        sparc, ldlj = smoothness.of_motion(record.t[selection.rows], *(x[selection.rows] for x in axes))
        results.add("sparc", channel, sparc, selection)
        results.add("ldlj", channel, ldlj, selection)
    grip.add_grip(results, record, [ACTIVE])
