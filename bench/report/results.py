# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads what measure.py wrote, for the table (report.py) and the picture (plot.py)."""

import csv
import json
import statistics

OURS = ("IsoGrasp", "plan")


class Point:
    """One engine with one method on one scene."""

    def __init__(self, row):
        self.engine, self.version, self.scene = row["engine"], row["version"], row["scene"]
        self.integrator, self.substeps = row["integrator"], int(row["substeps"])
        self.status, self.setup = row["status"], row["setup"]
        self.parts = row["way"] == "parts"

        def number(name):
            return float(row[name]) if row[name] else None

        self.ns, self.relative = number("ns_per_frame"), number("error_relative")
        self.metres, self.radians = number("error_position_m"), number("error_angle_rad")
        self.drift, self.instructions = number("drift_relative"), number("instructions_per_frame")
        self.rounds = [float(t) for t in row["ns_rounds"].split()]
        # A body free of all forces is judged by what it must conserve.
        self.error = self.relative if self.drift is None else self.drift

    @property
    def ours(self):
        return (self.engine, self.integrator) == OURS

    @property
    def curve(self):
        """Ours with the default or a coarser tolerance."""
        return self.ours or (self.engine == OURS[0] and
                             self.integrator.startswith("plan, tolerance "))

    @property
    def by_hand(self):
        return self.engine == "by hand"

    @property
    def peer(self):
        return self.engine not in ("IsoGrasp", "by hand")

    @property
    def answers(self):
        """It came to the end, with an error smaller than the motion."""
        return self.status == "ok" and self.ns is not None and self.error <= 1

    @property
    def name(self):
        steps = f" ×{self.substeps}" if self.substeps else ""
        return f"{self.engine}, {self.integrator}{steps}"


def ratio(slow, fast):
    """How many times slower, as the median over the rounds of one run."""
    return statistics.median(s / f for s, f in zip(slow.rounds, fast.rounds))


class Results:
    def __init__(self, folder):
        with open(folder / "results.csv", newline="") as file:
            self.points = [Point(row) for row in csv.DictReader(file)]
        with open(folder / "scenes.csv", newline="") as file:
            self.scenes = list(csv.DictReader(file))
        with open(folder / "kernels.csv", newline="") as file:
            self.kernels = list(csv.DictReader(file))
        with open(folder / "scoring.csv", newline="") as file:
            self.scoring = list(csv.DictReader(file))
        self.scoring_machine = json.loads((folder / "scoring.json").read_text())
        with open(folder / "markers.csv", newline="") as file:
            self.markers = list(csv.DictReader(file))
        self.markers_machine = json.loads((folder / "markers.json").read_text())
        with open(folder / "hand_world.csv", newline="") as file:
            self.hand = list(csv.DictReader(file))
        with open(folder / "hand_hold.csv", newline="") as file:
            self.hold = list(csv.DictReader(file))
        self.hand_machine = json.loads((folder / "hand_world.json").read_text())
        with open(folder / "whole.csv", newline="") as file:
            self.whole = list(csv.DictReader(file))
        self.whole_machine = json.loads((folder / "whole.json").read_text())
        with open(folder / "pads.csv", newline="") as file:
            self.pads = list(csv.DictReader(file))
        self.pads_machine = json.loads((folder / "pads.json").read_text())
        self.machine = json.loads((folder / "machine.json").read_text())

    def of(self, scene):
        return [p for p in self.points if p.scene == scene]

    def ours(self, scene):
        return next(p for p in self.of(scene) if p.ours)

    def ours_within(self, scene, level):
        """The cheapest of our tolerances whose error is at most `level`."""
        fit = [p for p in self.of(scene) if p.curve and p.answers and p.error <= level]
        return min(fit, key=lambda p: p.ns, default=self.ours(scene))

    def compared(self):
        """Scenes that other engines run too."""
        return [s for s in self.scenes if s["peers"] == "1"]
