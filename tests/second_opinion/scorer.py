# SPDX-License-Identifier: GPL-3.0-or-later
"""All measures of one trial, from its signals and its task file alone."""

import numpy as np

import arm
import cues
import digits
import drinking
import hand
import handling
import holding
import recorded
import smoothness
import strength
import tracking
import two_hands
from record import ACTIVE, Record, read_columns
from result import Results
from task import CLOSED, Task, number, percent
from tools import weighted_mean

FORCES = ["target_force_N", "actual_force_N"]


def score_rest(results, task, record):
    strength.add_resting(results, record)


def score_maximum(results, task, record):
    effort = next((p for p in record.parts if p.phase == ACTIVE), None)
    comfortable, channel = task["effort"] == "comfortable", task["channel"]
    name = "comfortable_force" if comfortable else "maximum_force"
    if effort is None:
        nothing = record.select([ACTIVE], [])
        for each in (name, name + "_total", "peak_force"):
            results.add(each, channel, None, nothing)
        return
    strength.add_maximum(results, record, effort, task["window_s"], channel, name)
    if not comfortable:
        strength.add_rates(results, record, effort, channel)
        if channel in CLOSED:
            strength.add_sharing(results, record)
        if channel.endswith("opening"):
            strength.add_coflexion(results, record, effort, task["window_s"], channel)
        if task.several_digits:
            strength.add_net_push(results, record)


def add_common(results, task, record, maximum=True, sharing=True):
    """What most force tasks share."""
    if sharing and task["channel"] in CLOSED:
        strength.add_sharing(results, record)
    if maximum:
        strength.add_force_of_maximum(results, record)
    if task.several_digits:
        strength.add_net_push(results, record)


def score_force_tracking(results, task, record):
    target, actual = (record.column(c) for c in FORCES)
    selection, noise = record.select([ACTIVE], FORCES), np.nan_to_num(record.noise)
    rows = selection.rows
    everything = ["rmse", "relative_rmse", "mae", "constant_error", "time_in_range"]
    errors = lambda channel, chosen, names: tracking.add_errors(
        results, channel, names, record, chosen, target, actual, task.band_fraction, noise)
    errors("force", selection, everything)
    tracking.add_lag(results, "force", record, selection, target, actual)
    results.corrected("lag", "force", record, selection)
    tracking.add_gains(results, "force", tracking.waveform_frequencies(task), record, selection, target, actual)
    if task["waveform"] in ("sine", "triangle"):
        for channel, half in tracking.halves(selection, target).items():
            errors(channel, half, ["rmse", "time_in_range"])
    if task["waveform"] in ("ramp", "trapezoid"):
        score_pieces(results, task, record, errors, noise)
    sparc, ldlj = smoothness.of_force(record.t[rows], actual[rows])
    results.add("sparc", "force_rate", sparc, selection)
    results.add("ldlj", "force_rate", ldlj, selection)
    entropy = smoothness.sample_entropy(record.t[rows], actual[rows])
    results.add("sample_entropy", "force", entropy, selection)
    add_common(results, task, record)
    digits.add_live_synergy(results, task, record)


def score_pieces(results, task, record, errors, noise):
    """Rise of a ramp; rise, hold and fall of a trapezoid."""
    target, actual = (record.column(c) for c in FORCES)
    rise = task["rise_s"]
    ramps = {"force_rise": (0, rise)}
    if task["waveform"] == "trapezoid":
        top = rise + task["hold_s"]
        ramps["force_fall"] = (top, top + task["fall_s"])
        hold = tracking.piece(record, FORCES, rise + 1, top)
        errors("force_hold", hold, ["rmse", "time_in_range"])
        holding.add_steadiness(results, "force_hold", record, hold, actual, record.noise)
    for channel, (start, stop) in ramps.items():
        ramp = tracking.piece(record, FORCES, start, stop)
        errors(channel, ramp, ["rmse", "time_in_range"])
        tracking.add_pauses(results, channel, record, ramp, target, actual)


def score_steadiness(results, task, record):
    target, actual = (record.column(c) for c in FORCES)
    newton = task["scale"] == "newton"
    levels = task["levels_N"] if newton else task.get("levels_fractions", [0.05, 0.25])
    holds = [p for p in record.parts if p.phase == ACTIVE]
    for part, level in zip(holds, levels):
        channel = f"force_{number(level)}_N" if newton else f"force_{percent(level)}_percent"
        selection = record.select_part(part, FORCES)
        noise = record.of_part("noise_sd_N", part)
        holding.add_steadiness(results, channel, record, selection, actual, noise)
        tracking.add_errors(results, channel, ["constant_error", "time_in_range"], record, selection, target,
                            actual, task.band_fraction, np.nan_to_num(noise))
        rows = selection.rows
        results.add("sample_entropy", channel, smoothness.sample_entropy(record.t[rows], actual[rows]), selection)
        holding.add_powers(results, channel, record, selection, actual)
    add_common(results, task, record)


def score_step_response(results, task, record):
    cues.add_steps(results, task, record)
    add_common(results, task, record, sharing=False)


def score_grip_release(results, task, record):
    cues.add_releases(results, task, record)
    add_common(results, task, record, maximum=False, sharing=False)


def score_force_sense(results, task, record):
    cues.add_force_sense(results, task, record)
    add_common(results, task, record, maximum=False, sharing=False)


def score_fatigue(results, task, record):
    target, actual = (record.column(c) for c in FORCES)
    channel = task["channel"]
    effort = next((p for p in record.parts if p.phase == ACTIVE), None)
    if effort is not None:
        selection = record.select_part(effort, FORCES)
        rows = selection.rows
        holding.add_fatigue(results, channel, record, selection, actual)
        tracking.add_errors(results, channel, ["rmse", "time_in_range"], record, selection, target, actual,
                            task.band_fraction, np.nan_to_num(record.noise))
        mean = weighted_mean(actual[rows], record.hold[rows]) if len(rows) else None
        results.add("mean_force", channel, mean, selection)
    add_common(results, task, record, sharing=False)


def score_directional_maxima(results, task, record):
    digits.add_directional_maxima(results, task, record)


def score_individuation(results, task, record):
    digits.add_individuation(results, task, record)


def score_force_direction(results, task, record):
    digits.add_force_direction(results, task, record)


KINDS = {name[len("score_"):]: function for name, function in list(globals().items()) if name.startswith("score_")}
del KINDS["pieces"]
KINDS |= {name: getattr(handling, "score_" + name)
          for name in ("pose_targets", "pose_tracking", "pick_place", "observe")}
KINDS |= {name: getattr(arm, "score_" + name) for name in ("pose_matching", "pose_following", "active_range")}
KINDS["drinking"] = drinking.score_drinking
KINDS |= {name: getattr(hand, "score_" + name) for name in ("hand_opening", "virtual_pick_place")}
KINDS |= {name: getattr(two_hands, "score_" + name)
          for name in ("bilateral_rest", "bilateral_maximum", "bilateral_tracking", "bimanual_lift", "bimanual_pick_place",
                       "mirror")}
KINDS["recorded"] = recorded.score_recorded


def score(signals, task=None):
    """Measures of a CSV of signals by name and channel; `task`: path of its task file."""
    results = Results()
    columns = read_columns(signals)
    if task is None:
        recorded.score_untasked(results, Record(columns, by_task=False))
    else:
        task = Task(task)
        KINDS[task.kind](results, task, Record(columns, task.kind != "recorded"))
    return results.measures


def score_two_hands(signals, affected, maxima):
    """Measures of a record of two hands."""
    results = Results()
    two_hands.score_two_hands(results, Record(read_columns(signals), False), affected, maxima)
    return results.measures
