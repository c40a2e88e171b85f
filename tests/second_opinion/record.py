# SPDX-License-Identifier: GPL-3.0-or-later
"""One trial: its rows and columns, what counts, its parts (docs/measures.md, Exact rules)."""

import csv
from dataclasses import dataclass

import numpy as np

LEAD_IN, ACTIVE, TRANSPORT, HOLD, PAUSED, DONE = range(6)
EPSILON_S = 1e-6  # times are equal within this
DIGITS = ("thumb", "index", "middle")
CONSTANTS = ("t_s", "resting_force_N", "maximum_force_N", "noise_sd_N", "resolution_N", "device_delay_s",
             "display_delay_s")
CHANNEL_DIGITS = ("grip", "grip_mean", "pinch", "sum") + DIGITS
CHANNEL_DIRECTIONS = ("+x", "-x", "+y", "-y", "+z", "-z")


def read_columns(path):
    """Name of the column -> values; an empty field is NaN."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        names = next(rows)
        values = np.array([[float(x) if x else np.nan for x in row] for row in rows if row])
    return {name: values[:, k] for k, name in enumerate(names)}


def holds_of(t):
    """How long each row holds, and whether the grid is regular."""
    steps = np.diff(t)
    ulp = np.spacing(max(abs(t[0]), abs(t[-1])))
    regular = len(t) < 3 or bool(np.all(np.abs(steps - steps[0]) <= 4 * ulp))
    if regular:
        return np.full(len(t), steps[0]), True
    return np.append(steps, steps[-1]), False


@dataclass
class Part:
    """Rows first … last - 1 of one instruction."""

    first: int
    last: int
    phase: int
    cue: int
    digits: str
    direction: str

    @property
    def channel(self):
        """Name of the channel as in measures."""
        if self.direction == "+z":
            return self.digits
        if self.direction == "-z":
            return "opening" if self.digits == "grip" else self.digits + "_opening"
        return self.digits + "_" + self.direction


@dataclass
class Selection:
    """Rows that count, how many of the range do not."""

    rows: np.ndarray
    excluded: int

    @property
    def samples(self):
        return len(self.rows)


class Record:
    """Columns of a trial with task time, holds and parts."""

    def __init__(self, columns, by_task=True):
        self.columns = columns
        self.size = len(columns["t_s"])
        phase = columns.get("phase", np.full(self.size, float(ACTIVE)))
        known = np.isfinite(phase) & (phase == np.floor(phase)) & (phase >= 0) & (phase <= 5)
        self.phase = np.where(known, phase, PAUSED).astype(int)
        flags = columns.get("sample_flags", np.zeros(self.size))
        self.clean = flags == 0  # NaN is not 0
        constants = [columns[n] for n in CONSTANTS if n in columns]
        self.refused = any(np.nanmax(np.abs(c), initial=0) > 1e60 for c in constants)
        own = columns["t_s"]
        self.hold, regular = holds_of(own)
        if not by_task:
            self.t = own
            return
        running = self.phase != PAUSED
        if regular:
            self.t = np.concatenate(([0], np.cumsum(running)[:-1])) * self.hold[0]
        else:
            self.t = np.concatenate(([0.0], np.cumsum(np.where(running, self.hold, 0.0))[:-1]))
        self.parts = self._parts()

    def column(self, name):
        """The column, all empty if there is none."""
        return self.columns.get(name, np.full(self.size, np.nan))

    def has(self, name):
        return name in self.columns

    def first_value(self, name, rows=slice(None)):
        """First value that is not empty, or NaN."""
        values = self.column(name)[rows]
        values = values[~np.isnan(values)]
        return values[0] if len(values) else np.nan

    def of_part(self, name, part):
        return self.first_value(name, slice(part.first, part.last))

    @property
    def noise(self):
        return self.first_value("noise_sd_N")

    def select(self, phases, columns, first=0, last=None, within=None, least=1e-60):
        """Rows of first … last - 1 in these phases that count. `within`: only rows that are true there. `least`: below
        this a column is too small to compute with."""
        last = self.size if last is None else last
        rows = np.arange(first, last)
        if within is not None:
            rows = rows[within[rows]]
        paused = np.sum(self.phase[rows] == PAUSED)
        rows = rows[np.isin(self.phase[rows], list(phases))]
        counts = self.clean[rows].copy()
        for name in columns:
            values = name if isinstance(name, np.ndarray) else self.column(name)
            counts &= ~np.isnan(values[rows])
        if self.refused or not all(self._computable(name, rows[counts], least) for name in columns):
            return Selection(rows[:0], 0)
        return Selection(rows[counts], int(np.sum(~counts) + paused))

    def _computable(self, name, rows, least):
        """Neither so large nor so small that squares and products are no numbers."""
        values = name if isinstance(name, np.ndarray) else self.column(name)
        largest = np.max(np.abs(values[rows]), initial=0)
        return largest == 0 or least <= largest <= 1e60

    def select_part(self, part, columns):
        return self.select([part.phase], columns, part.first, part.last)

    def _parts(self):
        """Consecutive rows of one segment, without the row after the end."""
        done = np.flatnonzero(self.phase == DONE)
        end = done[0] if len(done) else self.size
        key = self.columns["segment"] if self.has("segment") else self.phase
        parts, current = [], None
        for k in range(end):
            if self.phase[k] == PAUSED:
                if parts:
                    parts[-1].last = k + 1
                continue
            if not parts or key[k] != current:
                current = key[k]
                parts.append(self._part(k))
            parts[-1].last = k + 1
        return parts

    def _part(self, k):
        digits, direction = self.column("channel_digits")[k], self.column("channel_direction")[k]
        cue = self.column("cue")[k]
        return Part(k, k + 1, int(self.phase[k]), -1 if np.isnan(cue) else int(cue),
                    "grip" if np.isnan(digits) else CHANNEL_DIGITS[int(digits)],
                    "+z" if np.isnan(direction) else CHANNEL_DIRECTIONS[int(direction)])

    def end_of(self, part):
        """Task time at which the part ends."""
        running = [k for k in range(part.first, part.last) if self.phase[k] != PAUSED]
        return self.t[running[-1]] + self.hold[running[-1]]

    def before(self, part):
        """The part before this one, or None."""
        k = next(i for i, other in enumerate(self.parts) if other is part)
        return self.parts[k - 1] if k else None


def join(selections):
    """All rows of several selections."""
    rows = np.concatenate([s.rows for s in selections]) if selections else np.array([], int)
    return Selection(rows, sum(s.excluded for s in selections))
