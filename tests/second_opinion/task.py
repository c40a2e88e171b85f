# SPDX-License-Identifier: GPL-3.0-or-later
"""A task file with its defaults (docs/file_formats.md)."""

import math
import tomllib

DEFAULTS = {
    "rest": {},
    "maximum": {"window_s": 0.5, "squeeze_s": 3, "effort": "maximum"},
    "directional_maxima": {"window_s": 0.5, "push_s": 3, "digits": ["thumb", "index", "middle"]},
    "force_tracking": {"waveform": "sine", "duration_s": 30, "frequency_Hz": 0.2, "last_frequency_Hz": 1,
                       "rise_s": 5, "hold_s": 15, "fall_s": 5, "bandwidth_Hz": 0.5, "forms": 1},
    "steadiness": {"hold_s": 12},
    "step_response": {"hold_s": 4, "repetitions": 3},
    "grip_release": {"after_s": 6, "repetitions": 5, "open": False},
    "force_sense": {"window_s": 2, "repetitions": 3},
    "fatigue": {"hold_s": 30},
    "individuation": {"hold_s": 2, "repetitions": 3, "digits": ["thumb", "index", "middle"]},
    "force_direction": {"hold_s": 3},
    "pose_targets": {"position_tolerance_m": 0.02, "angle_tolerance_deg": 15, "time_limit_s": 60},
    "pose_tracking": {"lead_in_s": 2, "duration_s": 30},
    "pick_place": {"position_tolerance_m": 0.02, "angle_tolerance_deg": 15, "time_limit_s": 30, "hold_s": 1,
                   "drop_distance_m": 0.02},
    "observe": {},
    "bilateral_rest": {},
    "bilateral_maximum": {"window_s": 0.5},
    "bilateral_tracking": {},
    "bimanual_lift": {"lifts": 4, "time_limit_s": 20},
    "bimanual_pick_place": {"repetitions": 1, "time_limit_s": 30},
    "mirror": {},
    "active_range": {"lead_in_s": 2, "duration_s": 15, "repetitions": 3},
    "pose_matching": {"repeats": 1, "way_percent": 100, "scale": "none", "position_tolerance_m": 0.015,
                      "angle_tolerance_deg": 10, "hold_s": 0.3, "display_s": 2, "time_limit_s": 15},
    "pose_following": {"leg_s": 4, "rounds": 3, "way_percent": 100, "scale": "none", "lead_in_s": 3},
    "drinking": {"lead_in_s": 2, "duration_s": 20} | {
        f"{part}_marker": part.upper() for part in ("hand", "glass", "face", "trunk", "shoulder", "elbow", "wrist")},
    "hand_opening": {"lead_in_s": 2, "repetitions": 5, "open_s": 4, "close_s": 4},
    "virtual_pick_place": {"eases": False, "level": 3, "table_m": 0.1},
    "recorded": {"beats_per_cycle": 1, "cycles_left_out": 0},
}
CLOSED = ("grip", "grip_mean", "sum")  # channels in which all three digits press towards each other


class Task(dict):
    """Keys of a task file; what is not written has its default."""

    def __init__(self, path):
        with open(path, "rb") as file:
            keys = tomllib.load(file)
        super().__init__({"channel": "grip", "scale": "maximum", "band_fraction": 0.05,
                          **DEFAULTS[keys["kind"]], **keys})
        self.factor = {"tolerance": 1.0, "distance": 1.0, "frequency": 1.0, "level": 1.0}
        if "chosen" in keys:
            d, level = keys["difficulty"], keys["chosen"]["level"]
            self.factor[d["factor"]] = d["easiest"] + level * (d["hardest"] - d["easiest"])

    @property
    def kind(self):
        return self["kind"]

    @property
    def several_digits(self):
        """More than one digit is asked: they press against each other."""
        return self["channel"] in ("grip", "grip_mean", "pinch", "sum", "opening")

    @property
    def band_fraction(self):
        return self["band_fraction"] * self.factor["tolerance"]


def frequencies_of(keys, duration_s, factor=1.0):
    """Of a target that is a sum of sines; none of any other."""
    waveform = keys.get("waveform", "sine")
    if waveform == "sine":
        return [keys.get("frequency_Hz", 0.2) * factor]
    if waveform == "multi_sine":
        return [f * factor for f in keys["frequencies_Hz"]]
    if waveform == "random":
        most = math.floor(keys.get("bandwidth_Hz", 0.5) * factor * duration_s + 1e-9)
        return [k / duration_s for k in range(1, min(most, 200) + 1)]
    return []


def number(x):
    """As in names of channels: the shortest decimal that reads back to the same number."""
    return repr(float(x)).removesuffix(".0")


def percent(fraction):
    """A level in names of channels: rounded to a tenth of a percent."""
    return number(math.floor(1000 * fraction + 0.5) / 10)
