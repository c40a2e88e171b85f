# SPDX-License-Identifier: GPL-3.0-or-later
"""The sessions that are made for the comparison, and the tasks that the library lacks."""

LIBRARY = """resting_force maximum_grip maximum_thumb maximum_index maximum_middle maximum_pinch maximum_opening
opening_thumb opening_index opening_middle comfortable_grip directional_maxima familiarisation grip_sine
grip_sine_short grip_sine_blind grip_sine_comfortable grip_sine_training grip_multi_sine grip_ramp grip_random_fresh
grip_random_repeated grip_rectangle grip_swept_sine grip_trapezoid grip_triangle grip_from_file index_sine pinch_sine
open_close steady_grip grip_steps let_go let_go_short open_on_cue force_sense fatigue individuation force_direction
two_target two_target_long two_target_soft two_target_rate two_target_mirrored two_target_training target_series
knob_turn knob_turn_rate elastic_block lift_weight pose_tracking_x pose_tracking_planar pose_steps pick_place
free_handling""".split()
ARM = """arm_familiarisation arm_follow arm_follow_half arm_follow_three_quarters arm_range_deviation arm_range_flexion arm_range_forearm arm_own_range arm_screw arm_screw_half
arm_screw_three_quarters arm_wrist""".split()
HAND = ["hand_opening", "virtual_place_first"]
PAIR = """two_hands_rest two_hands_maximum two_hands_sum two_hands_each two_hands_turns two_hands_affected_works_25
two_hands_affected_works_50 two_hands_other_works_25 two_hands_other_works_50 two_hands_lift
two_hands_carry""".split()
NOT_RUN = {"virtual_place": "its placements are long; virtual_pick_place is compared in five other tasks",
           "virtual_place_training": "likewise",
           "grip_sine_fixed": "needs maxima of two days; force_tracking is compared in 20 other tasks",
           **{f"two_hands_carry_{how}": "a patient carries in one way in a session; compared in two_hands_carry"
              for how in ("bubble", "bubble_pinch", "clutch", "clutch_pinch", "training")},
           "arm_drinking": "of another rig; drinking is compared in signals made by hand"}
ADAPTIVE = ("grip_sine_training", "two_target_training")  # their level stands in [chosen]

OWN = {
    "own_sum_sine": 'kind = "force_tracking"\nchannel = "sum"\nscale = "newton"\nleast_N = 2\nmost_N = 6\n'
                    'band_fraction = 0.25\nfrequency_Hz = 0.5\nduration_s = 34\nlead_in_s = 1\n',
    "own_mean_triangle": 'kind = "force_tracking"\nchannel = "grip_mean"\nscale = "newton"\nleast_N = 2\nmost_N = 5\n'
                         'band_fraction = 0.25\nwaveform = "triangle"\nforms = 3\nfrequency_Hz = 0.7\n'
                         'duration_s = 24\n',
    "own_sum_rectangle": 'kind = "force_tracking"\nchannel = "sum"\nscale = "newton"\nleast_N = 2\nmost_N = 5\n'
                         'band_fraction = 0.25\nwaveform = "rectangle"\nfrequency_Hz = 0.6\nduration_s = 27\n',
    "own_sideways": 'kind = "force_tracking"\nchannel = "thumb_+x"\nscale = "newton"\nleast_N = 1.5\nmost_N = 3\n'
                    'band_fraction = 0.3\nduration_s = 11\n',
    "own_levels": 'kind = "steadiness"\nscale = "newton"\nlevels_N = [2.5, 4]\nband_fraction = 0.2\nhold_s = 6.5\n'
                  'rise_s = 1\nrest_s = 1\n',
    "own_tenths": 'kind = "steadiness"\nchannel = "index"\nlevels_fractions = [0.07, 0.145]\nband_fraction = 0.5\n'
                  'hold_s = 3\nrise_s = 1\nrest_s = 1\n',
    "own_steps": 'kind = "step_response"\nchannel = "index"\nscale = "newton"\nfrom_N = 4\nto_N = [2, 6]\n'
                 'band_fraction = 0.3\nrepetitions = 2\nhold_s = 2.5\n',
    "own_let_go": 'kind = "grip_release"\nchannel = "middle"\nscale = "newton"\nlevel_N = 3\nband_fraction = 0.3\n'
                  'repetitions = 3\nafter_s = 3.7\n',
    # Ends in the middle of the window of residual_force: half of it is covered.
    "own_half_recorded": 'kind = "grip_release"\nscale = "newton"\nlevel_N = 3\nband_fraction = 0.3\nrepetitions = 2\n'
                         'after_s = 5\n',
    "own_sense": 'kind = "force_sense"\nchannel = "pinch"\nscale = "newton"\nlevel_N = 3\nband_fraction = 0.3\n'
                 'repetitions = 1\nwindow_s = 1.3\n',
    "own_fatigue": 'kind = "fatigue"\nchannel = "pinch"\nscale = "newton"\nlevel_N = 4\nband_fraction = 0.2\n'
                   'hold_s = 4.5\n',
    "own_two_digits": 'kind = "individuation"\nscale = "newton"\ndigits = ["thumb", "index"]\nlevels_N = [2, 3]\n'
                      'band_fraction = 0.3\nrepetitions = 1\n',
    "own_press": 'kind = "maximum"\nchannel = "pinch"\neffort = "comfortable"\nwindow_s = 0.333\n',
    "own_push": 'kind = "directional_maxima"\ndigits = ["index"]\ndirections = ["-z", "+y"]\nwindow_s = 0.25\n',
    "own_turn": 'kind = "pose_tracking"\nscene = "free_block"\nduration_s = 20\n[[axis]]\ndof = "ry"\n'
                'least_deg = -15\nmost_deg = 15\nfrequency_Hz = 0.1\n[[axis]]\ndof = "z"\nleast_m = 0\nmost_m = 0.02\n'
                'waveform = "multi_sine"\nfrequencies_Hz = [0.1, 0.25]\nseed = 3\n',
    "own_lean": 'kind = "pose_targets"\nscene = "free_block"\ntime_limit_s = 8\nangle_tolerance_deg = 40\n'
                'position_tolerance_m = 0.03\n[[target]]\nposition_m = [0.02, 0.02, 0.01]\nhold_s = 0.5\n'
                '[[target]]\nposition_m = [-0.02, 0, 0]\nangle_deg = 20\nhold_s = 0.5\nlevel = true\n',
}
POSES = 'kind = "pose_matching"\npostures = "screw"\n'
OWN_ARM = {
    "own_arm_flown_through": POSES + 'sequence = ["screw", "initial", "unscrew"]\nhold_s = 0\n'
                             'display_s = 0\ntime_limit_s = 8\n',
    # The object is there already, or stays there: entered at the cue.
    "own_arm_there": POSES + 'sequence = ["initial", "initial", "screw", "screw"]\nhold_s = 0\ndisplay_s = 0.5\n'
                     'time_limit_s = 8\n',
    "own_arm_stays": POSES + 'sequence = ["screw", "screw", "initial"]\nhold_s = 0.5\ndisplay_s = 0\n'
                     'time_limit_s = 6\n',
    "own_arm_never": POSES + 'sequence = ["screw", "initial"]\nrepeats = 2\nposition_tolerance_m = 0.001\n'
                     'angle_tolerance_deg = 0.1\nhold_s = 1\ntime_limit_s = 3\n',
    "own_arm_little": POSES + 'sequence = ["screw", "initial", "unscrew", "initial"]\nway_percent = 10\n'
                      'position_tolerance_m = 0.01\nangle_tolerance_deg = 5\ndisplay_s = 1\n',
    # Some are reached only at about the limit, some are not.
    "own_arm_hurry": POSES + 'sequence = ["unscrew", "initial", "screw", "initial"]\nway_percent = 80\n'
                     'scale = "length"\nhold_s = 0.5\ndisplay_s = 0.7\ntime_limit_s = 2\n',
    "own_arm_wide": 'kind = "pose_matching"\npostures = "forearm_and_wrist"\nsequence = ["extension", "flexion"]\n'
                    'repeats = 2\nscale = "length"\nposition_tolerance_m = 0.05\nangle_tolerance_deg = 30\n'
                    'hold_s = 1.5\ndisplay_s = 0\n',
    "own_arm_quick": 'kind = "pose_following"\npostures = "forearm_and_wrist"\nleg_s = 1.2\nrounds = 2\nlead_in_s = 0\n'
                     'sequence = ["flexion", "initial", "ulnar deviation"]\nscale = "length"\nway_percent = 70\n',
    # It moves too little for a lag.
    "own_arm_hardly": 'kind = "pose_following"\npostures = "screw"\nsequence = ["initial", "initial"]\nleg_s = 2\n'
                      'rounds = 1\nlead_in_s = 1\n',
    "own_arm_fingers": 'kind = "active_range"\nlink = "fingers"\nangle = 2\nlead_in_s = 0.5\nduration_s = 6\n'
                       'repetitions = 2\n',
    "own_arm_forearm": 'kind = "active_range"\nlink = "forearm"\nangle = 1\nlead_in_s = 1\nduration_s = 1\n'
                       'repetitions = 1\n',
}
OWN |= OWN_ARM
PLACING = 'kind = "virtual_pick_place"\n'
SLIM = '[[placement]]\nobject = "slim_cuboid"\ntarget = 1\n[[placement]]\nobject = "slim_cylinder"\ntarget = 4\n'
OWN_HAND = {
    "own_hand_quick": 'kind = "hand_opening"\nlead_in_s = 0\nrepetitions = 3\nopen_s = 0.8\nclose_s = 1.5\n',
    "own_hand_alone": PLACING + 'assistance = "off"\nlevel = 1\n' + SLIM,
    "own_hand_narrow": PLACING + 'assistance = "softer"\neases = true\nlevel = 2\n' + SLIM,
    "own_hand_small": PLACING + 'assistance = "full"\nlevel = 3\n[[placement]]\nobject = "small_cuboid"\n'
                      'target = 1\n',
}
OWN |= OWN_HAND
OWN_PAIR = {
    "own_pair_newtons": 'kind = "bilateral_tracking"\ngoal = "sum"\nfeedback = "both"\nscale = "newton"\nleast_N = 4\n'
                        'most_N = 12\nband_fraction = 0.3\nfrequency_Hz = 0.4\nduration_s = 11\nlead_in_s = 1\n',
    "own_pair_left": 'kind = "mirror"\nactive = "left"\nlevel_fraction = 0.4\nband_fraction = 0.2\nrepetitions = 2\n'
                     'hold_s = 3.3\nrest_s = 1\n',
    "own_pair_lift": 'kind = "bimanual_lift"\nscene = "tray_on_springs"\nlevel_fraction = 0.3\nheight_m = 0.05\n'
                     'position_tolerance_m = 0.02\nangle_tolerance_deg = 3\nlifts = 3\nhold_s = 1.3\n'
                     'time_limit_s = 4.7\nlead_in_s = 2\nrest_s = 3\nfetch_s = 1\n',
    "own_pair_carry": 'kind = "bimanual_pick_place"\nscene = "carried_box"\nedge_fraction = 0.12\nhold_s = 0.6\n'
                      'position_tolerance_m = 0.03\ntime_limit_s = 9\nrest_s = 1.5\nfetch_s = 1\nrepetitions = 2\n'
                      '[[target]]\nto_m = [0.07, 0, 0]\n[[target]]\nto_m = [0, 0.2, 0]\n',
    "own_pair_quick": 'kind = "bilateral_maximum"\nlead_in_s = 0.5\nsqueeze_s = 2\nrest_s = 3\nwindow_s = 0.333\n',
}
OWN |= OWN_PAIR
MAXIMA = ["resting_force", "maximum_grip", "maximum_thumb", "maximum_index", "maximum_middle"]
# One of each kind; a patient gets some of them.
CORE = ["grip_sine", "let_go_short", "two_target", "maximum_opening", "grip_trapezoid", "open_on_cue", "pick_place",
        "steady_grip", "own_let_go", "directional_maxima", "grip_steps", "own_sum_sine", "force_sense",
        "pose_tracking_planar", "fatigue", "own_levels", "individuation", "own_sense", "force_direction",
        "free_handling", "own_steps", "comfortable_grip"]
PATIENTS = ["mild", "moderate", "paretic", "severe", "spastic", "opening_loss", "direction_error", "arm_push",
            "sensory_loss", "inattention", "fatiguing", "submaximal", "slow_wander", "pain_stop"]


# Trials of more than four movements are refused.
REPEATED = {"own_arm_flown_through": 2, "own_arm_hurry": 3}


def of_arm(tasks):
    """Tasks of an arm, not of the platform."""
    return tasks[0] in ARM or tasks[0] in OWN_ARM


def of_hand(tasks):
    """Tasks of a tracked hand."""
    return tasks[0] in HAND or tasks[0] in OWN_HAND


def of_pair(tasks):
    """Tasks of both hands."""
    return tasks[0] in PAIR


def trials(tasks):
    """How many there are of these tasks."""
    return sum(REPEATED.get(task, 1) for task in tasks)


def sessions(seed):
    """Name, device, hand, tasks of every session. Arm and platform never share one."""
    arm = ARM + list(OWN_ARM)
    for k, (patient, hand) in enumerate((p, h) for p in ("healthy", "paretic") for h in ("right", "left")):
        # Each begins with other tasks: the first one of a kind is the one whose signals are damaged.
        device = f"sim://arm?patient={patient}&seed={seed + 20 + k}"
        yield f"arm_{patient}_{hand}", device, hand, arm[4 * k:] + arm[:4 * k]
    hand_tasks = HAND + list(OWN_HAND)
    for k, (user, hand) in enumerate((("healthy", "right"), ("paretic", "left"))):
        yield f"hand_{user}", f"sim://hand?user={user}&seed={seed + 40 + k}", hand, hand_tasks[k:] + hand_tasks[:k]
    # Rest and maxima come first: the others rest on them.
    for k, (pair, affected) in enumerate((("paretic_left", "left"), ("healthy", "right"))):
        yield f"pair_{pair}", f"sim://pair?file={pair}&seed={seed + 60 + k}", f"both {affected}", PAIR + list(OWN_PAIR)
    everything = LIBRARY + [task for task in OWN if task not in {**OWN_ARM, **OWN_HAND, **OWN_PAIR}]
    yield "everything", f"sim://healthy?seed={seed + 7}", "right", everything
    step = 4
    for k, patient in enumerate(PATIENTS):
        chosen = [CORE[(step * k + i) % len(CORE)] for i in range(step)]
        yield patient, f"sim://{patient}?seed={seed + 100 + k}", "left" if k % 2 else "right", MAXIMA + chosen


def complete(seed):
    """Names of the sessions in which every task has a trial: nobody is too weak for one."""
    return [name for name, *_, tasks in sessions(seed) if name in ("everything", "hand_healthy") or of_arm(tasks)
            or of_pair(tasks)]


def write_protocol(folder, name, tasks):
    """A protocol of these tasks, with the tasks of our own beside it."""
    first = "start_posture" if of_arm(tasks) else "hand_entry" if of_hand(tasks) else "instrument_zero"
    lines = ['format = "isograsp-protocol-1"', f'name = "{name}"', "[[step]]", f'kind = "{first}"']
    for task in tasks:
        lines += ["[[step]]", 'kind = "task"', f'task = "{task}.toml"']
        if of_arm(tasks):  # so many movements are no assessment of an arm, and it rests between them
            lines += ["practice = true", "rest_s = 60", f"repetitions = {REPEATED.get(task, 1)}"]
        if of_hand(tasks):  # help is training
            lines += ["practice = true", "rest_s = 60"]
        if task in ADAPTIVE:
            lines.append("adaptive = true")
        if task in OWN:
            text = f'format = "isograsp-task-1"\nname = "{task}"\ninstruction = "None."\n{OWN[task]}'
            (folder / f"{task}.toml").write_text(text, encoding="utf-8")
    path = folder / f"{name}.toml"
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path
