# SPDX-License-Identifier: GPL-3.0-or-later
"""The drinking task from markers (docs/measures.md, Drinking task; docs/markers.md, Motion without its noise)."""

import math

import numpy as np

from record import DONE, PAUSED, Selection

CLOCK_S = 1e-9  # times are equal within this
PARTS = ("hand", "glass", "face", "trunk", "shoulder", "elbow", "wrist")
PHASES = ("reaching", "forward_transport", "drinking", "back_transport", "returning")
CUTOFF_HZ = 6.0


class Unknown(Exception):
    """Why the phases are not known."""


def usual_step(t):
    """Mean of the steps of at most 1.5 times their median (of an even number the upper one)."""
    steps = np.diff(t)
    return float(np.mean(steps[steps <= 1.5 * np.sort(steps)[len(steps) // 2]]))


def runs_of(t, p):
    """Rows first … last - 1 without a hole."""
    usual, runs, first = usual_step(t), [], None
    for k in range(len(t) + 1):
        seen = k < len(t) and not np.isnan(p[k]).any()
        if first is not None and (not seen or t[k] - t[k - 1] > 1.5 * usual):
            runs.append((first, k))
            first = None
        if seen and first is None:
            first = k
    return runs


def butterworth(rate):
    """Coefficients of one pass of which both together leave -3 dB at the cut-off."""
    w = math.tan(math.pi * CUTOFF_HZ / rate) / (math.sqrt(2) - 1)**0.25
    a0 = 1 + math.sqrt(2) * w + w * w
    return w * w / a0, 2 * (w * w - 1) / a0, (1 - math.sqrt(2) * w + w * w) / a0


def one_pass(b, a1, a2, x):
    u1 = u2 = y1 = y2 = x[0]
    out = np.empty(len(x))
    for k, u in enumerate(x):
        y = b * (u + 2 * u1 + u2) - a1 * y1 - a2 * y2
        u1, u2, y1, y2 = u, u1, y, y1
        out[k] = y
    return out


def low_pass(t, p):
    """Positions without their noise, run by run."""
    out = np.full(p.shape, np.nan)
    for first, last in runs_of(t, p):
        if last - first == 1:
            out[first] = p[first]
            continue
        rate = (last - first - 1) / (t[last - 1] - t[first])
        b, a1, a2 = butterworth(rate)
        margin = math.ceil(2 * rate)
        for axis in range(3):
            x = p[first:last, axis]
            before = after = margin
            while before or after:
                own = len(x) - 1
                left, right = min(before, own), min(after, own)
                x = np.concatenate((2 * x[0] - x[left:0:-1], x, 2 * x[-1] - x[-2:-right - 2:-1]))
                before, after = before - left, after - right
            y = one_pass(b, a1, a2, one_pass(b, a1, a2, x)[::-1])[::-1]
            out[first:last, axis] = y[margin:margin + last - first]
    return out


def speeds(t, p):
    """Central differences, one-sided at the ends of runs."""
    v = np.full(len(t), np.nan)
    for first, last in runs_of(t, p):
        if last - first < 2:
            continue
        step = (t[last - 1] - t[first]) / (last - first - 1)
        for k in range(first, last):
            a, b = max(k - 1, first), min(k + 1, last - 1)
            v[k] = math.sqrt(float(np.sum((p[b] - p[a])**2))) / ((b - a) * step)
    return v


def away(p):
    """Rows further than 30 mm from the first place that is seen."""
    seen = np.flatnonzero(~np.isnan(p).any(axis=1))
    if not len(seen):
        return seen
    return np.flatnonzero(np.sqrt(np.sum((p - p[seen[0]])**2, axis=1)) > 0.03)


def rises(v, at, least):
    """First row of the stretch of at least `least` in which row `at` lies."""
    while True:
        if np.isnan(v[at]):
            raise Unknown("gap")
        if v[at] < least:
            return at + 1
        if at == 0:
            raise Unknown("the start is not in the record")
        at -= 1


def falls(v, at, least):
    while at < len(v):
        if np.isnan(v[at]):
            raise Unknown("gap")
        if v[at] < least:
            return at
        at += 1
    raise Unknown("the end is not in the record")


class Drink:
    """Markers behind the low-pass, and the rows at which phases begin."""

    def __init__(self, t, parts):
        self.t, self.p = t, {name: low_pass(t, p) for name, p in parts.items()}
        self.v_hand, self.v_glass = speeds(t, self.p["hand"]), speeds(t, self.p["glass"])
        self.near = np.sqrt(np.sum((self.p["face"] - self.p["glass"])**2, axis=1))
        self.rows = self._phases()

    def _phases(self):
        rate = 1 / usual_step(self.t)
        if not 49.5 <= rate <= 505:
            raise Unknown("the rate is not 50 to 500 Hz")
        glass = self.p["glass"]
        forth, back = away(glass), len(self.t) - 1 - away(glass[::-1])
        if not len(forth) or not len(back):
            raise Unknown("the glass was not lifted, or not seen")
        lift, rest = rises(self.v_glass, forth[0], 0.015), falls(self.v_glass, back[0], 0.010)
        if lift >= rest:
            raise Unknown("the phases are not in their order")
        between = self.near[lift:rest + 1]
        if np.isnan(between).all():
            raise Unknown("the face was not seen")
        close = lift + np.flatnonzero(between <= 1.15 * np.nanmin(between))
        first, last = close[0], close[-1]
        if not self._seen_beside(first, -1) or not self._seen_beside(last, 1):
            raise Unknown("gap")
        left, home = away(self.p["hand"]), len(self.t) - 1 - away(self.p["hand"][::-1])
        reaching, returning = self.v_hand[:lift], self.v_hand[rest:]
        if not len(left) or not len(home) or np.isnan(reaching).all() or np.isnan(returning).all():
            raise Unknown("the hand did not move")
        self.peak = int(np.nanargmax(reaching))
        start = rises(self.v_hand, left[0], 0.02 * self.v_hand[self.peak])
        end = falls(self.v_hand, home[0], 0.02 * np.nanmax(returning))
        rows = [start, lift, first, last, rest, end]
        if rows != sorted(rows) or start > self.peak:
            raise Unknown("the phases are not in their order")
        return rows

    def _seen_beside(self, row, step):
        k = row + step
        while 0 <= k < len(self.t) and abs(self.t[k] - self.t[row]) <= 0.1 + CLOCK_S:
            if not np.isnan(self.near[k]):
                return True
            k += step
        return False

    def units(self, first, last):
        """Movement units of the hand, or None in a hole."""
        t, v = self.t[first:last + 1], self.v_hand[first:last + 1]
        if np.isnan(v).any() or np.any(np.diff(t) > 1.5 * usual_step(self.t)):
            return None
        tops, k = [], 0
        while k + 1 < len(v):
            while k + 1 < len(v) and v[k + 1] <= v[k]:
                k += 1
            low = top = k
            while k + 1 < len(v) and v[k + 1] >= v[k]:
                k += 1
                top = k if v[k] > v[top] else top
            if k + 1 == len(v):
                break
            if v[top] - v[low] >= 0.02 and (not tops or t[top] - t[tops[-1]] >= 0.15 - CLOCK_S):
                tops.append(top)
        return float(len(tops))

    def seen(self, first, last, names):
        """Rows of a movement that show all of these markers, or None."""
        rows = np.arange(first, last + 1)
        rows = rows[np.all([~np.isnan(self.p[n][rows]).any(axis=1) for n in names], axis=0)]
        t = self.t
        if not len(rows) or t[rows[0]] - t[first] > 0.05 + CLOCK_S or t[last] - t[rows[-1]] > 0.05 + CLOCK_S:
            return None
        return None if np.any(np.diff(t[rows]) > 0.1 + CLOCK_S) else rows

    def elbow(self, rows):
        up, down = (self.p[n][rows] - self.p["elbow"][rows] for n in ("shoulder", "wrist"))
        return np.arctan2(np.sqrt(np.sum(np.cross(up, down)**2, axis=1)), np.sum(up * down, axis=1))


def values_of(drink, parts):
    """All values by name and channel."""
    t, rows = drink.t, drink.rows
    values = {("total_movement_time", "task"): t[rows[5]] - t[rows[0]]}
    for k, phase in enumerate(PHASES):
        values["phase_time", phase] = t[rows[k + 1]] - t[rows[k]]
    values["peak_velocity", "reaching"] = drink.v_hand[drink.peak]
    values["time_to_peak_velocity", "reaching"] = 100 * (t[drink.peak] - t[rows[0]]) / (t[rows[1]] - t[rows[0]])
    forward, back = drink.units(rows[0], rows[2]), drink.units(rows[3], rows[5])
    values["movement_units", "reaching_forward"], values["movement_units", "back_returning"] = forward, back
    values["movement_units", "total"] = None if forward is None or back is None else forward + back
    if "trunk" in parts:
        whole, reaching = drink.seen(rows[0], rows[5], ["trunk"]), drink.seen(rows[0], rows[1], ["trunk", "hand"])
        trunk = drink.p["trunk"]
        if whole is not None:
            moved = np.sqrt(np.sum((trunk[whole] - trunk[whole[0]])**2, axis=1))
            values["trunk_displacement", "trunk"] = np.max(moved)
        if reaching is not None:
            values["reach", "trunk"] = np.max(np.sqrt(np.sum((drink.p["hand"] - trunk)[reaching]**2, axis=1)))
    if all(name in parts for name in ("shoulder", "elbow", "wrist")):
        reaching = drink.seen(rows[0], rows[1], ["shoulder", "elbow", "wrist"])
        if reaching is not None:
            angle, when = drink.elbow(reaching), t[reaching]
            values["elbow_extension", "reaching"] = np.max(angle)
            if len(angle) >= 3:
                rise = (angle[2:] - angle[:-2]) / (when[2:] - when[:-2])
                values["elbow_extension_rate", "reaching"] = max(0.0, float(np.max(rise)))
    return values


NAMES = ([("total_movement_time", "task")] + [("phase_time", phase) for phase in PHASES] +
         [("peak_velocity", "reaching"), ("time_to_peak_velocity", "reaching")] +
         [("movement_units", channel) for channel in ("reaching_forward", "back_returning", "total")] +
         [("trunk_displacement", "trunk"), ("reach", "trunk"), ("elbow_extension", "reaching"),
          ("elbow_extension_rate", "reaching")])


def score_drinking(results, task, record):
    done = np.flatnonzero(record.phase == DONE)
    rows = np.arange(done[0] if len(done) else record.size)
    running = record.phase[rows] != PAUSED
    parts = {}
    for part in PARTS:
        names = [f"marker_{task[part + '_marker']}_{axis}_m" for axis in "xyz"]
        if all(record.has(n) for n in names):
            p = np.stack([record.column(n)[rows] for n in names], axis=1)
            p[~running | np.isnan(p).any(axis=1)] = np.nan
            parts[part] = p
    whole = running & np.all([~np.isnan(parts[n]).any(axis=1) for n in PARTS[:3]], axis=0)
    selection, values = Selection(rows[whole], int(np.sum(~whole))), {}
    try:
        if selection.samples:
            drink = Drink(record.columns["t_s"][rows], parts)
            values = {name: None if x is None else float(x) for name, x in values_of(drink, parts).items()}
    except Unknown:
        pass
    for name, channel in NAMES:
        results.add(name, channel, values.get((name, channel)), selection)
