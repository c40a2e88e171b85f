# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scorer hands out."""

import math
from dataclasses import dataclass


@dataclass
class Measure:
    """A value, or the reason why there is none."""

    name: str
    channel: str
    value: float | None
    samples: int
    excluded: int
    reason: str = ""


class Results:
    """All measures of a trial, by name and channel."""

    def __init__(self):
        self.measures = {}

    def add(self, name, channel, value, selection, reason="cannot be computed"):
        """`selection`: what tells samples and excluded."""
        if not selection.samples:
            value, reason = None, "no samples"
        if value is not None and not math.isfinite(value):
            value = None
        self.measures[name, channel] = Measure(name, channel, value, selection.samples, selection.excluded,
                                               "" if value is not None else reason)

    def corrected(self, name, channel, record, selection):
        """NAME_corrected: the same minus the known delays; no value while that of the sensors is not known."""
        value, delay = self.measures[name, channel].value, record.first_value("device_delay_s")
        display = record.first_value("display_delay_s")
        if value is not None:
            value -= delay + (0 if math.isnan(display) else display)
        self.add(name + "_corrected", channel, value, selection, "the delay is not known")
