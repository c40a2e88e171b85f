#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every measure of every task kind against the program: compare.py EXECUTABLE LIBRARY [SEED].

Makes sessions of virtual patients, recordings by hand and damaged signals in a temporary folder, computes all
measures anew from the signals and prints a table. Status 1 on any difference."""

import json
import math
import os
import random
import subprocess
import sys
import tempfile
import warnings
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import documented
import handmade
import scorer
import sessions
from record import read_columns
from task import Task
from variations import variations_of, vary, write_columns

# Sums of up to 12,000 terms in another order differ by some 1e-13; 1e-9 leaves room for differences of nearly equal
# numbers and is far below anything that a device resolves.
TOLERANCE = 1e-9
# The peak of a correlation is found from differences of its values, of 1e-6 and less for slow targets: their
# rounding moves it by some 1e-11 s. A nanosecond is a ten-millionth of a step.
LAG_TOLERANCE_S = 1e-9
# A mean of errors that cancel, a phase near 0, a turn from a pose to itself, a difference of equal variances is known in
# relation to what was added up.
ABSOLUTE = {"constant_error": 1e-13, "phase": 1e-12, "phase_lag": 1e-12, "fall": 1e-11, "resting_force": 1e-14,
            "fatigue_slope": 1e-12, "rotation": 1e-15, "hand_synergy": 1e-12}
# No measure uses them.
NOT_READ = ("_counts", "_flexion_N", "_radial_N", "_distal_N", "ness_s", "compute_s", "_residual_m", "_state")
TWO_HANDS = 60  # records
NOT_COMPARED = (
    "units and the words of reasons: compared are value or none, the value, samples, excluded and the version",)


def difference(name, ours, theirs):
    """Relative, 0 where the absolute one is within what rounding explains."""
    apart = abs(ours - theirs)
    if apart <= (LAG_TOLERANCE_S if "lag" in name and name != "phase_lag" else ABSOLUTE.get(name, 0.0)):
        return 0.0
    return apart / max(abs(ours), abs(theirs))


def compare(label, kind, theirs, score):
    """One trial: kind, number of measures, names of those with a value, largest difference, what is wrong."""
    warnings.simplefilter("error")
    wrong, worst, values = [], 0.0, []
    try:
        ours = score()
    except Exception as error:  # pylint: disable=broad-except
        return kind, len(theirs), [], math.inf, [f"{label}: the scorer failed: {error!r}"]
    count, theirs = len(theirs), {(m["name"], m["channel"]): m for m in theirs}
    if len(theirs) < count:
        wrong.append(f"{label}: the program gives two measures of one name and channel")
    for key in sorted({**theirs, **ours}):
        where = f"{label}: {key[0]} ({key[1]})"
        if key not in ours or key not in theirs:
            wrong.append(f"{where} is given by {'the program' if key in theirs else 'the scorer'} alone")
            continue
        mine, other = ours[key], theirs[key]
        if other["version"] != documented.version_of(key[0]):
            wrong.append(f"{where} program version {other['version']}, document {documented.version_of(key[0])}")
        if (mine.value is None) != (other["value"] is None):
            wrong.append(f"{where} program {other['value']} {other.get('reason')}, scorer {mine.value} {mine.reason}")
        elif mine.value is None:
            if not other.get("reason"):
                wrong.append(f"{where} has neither value nor reason")
        else:
            values.append(key[0])
            apart = difference(key[0], mine.value, other["value"])
            worst = max(worst, apart)
            if not apart <= TOLERANCE:
                wrong.append(f"{where} program {other['value']!r}, scorer {mine.value!r}, difference {apart:.2g}")
        if (mine.samples, mine.excluded) != (other["samples"], other["excluded"]):
            wrong.append(f"{where} program {other['samples']} samples, {other['excluded']} excluded, "
                         f"scorer {mine.samples}, {mine.excluded}")
    return kind, len(theirs), values, worst, wrong


class Program:
    """The executable."""

    def __init__(self, executable, library):
        self.executable = executable
        self.environment = {**os.environ, "ISOGRASP_LIBRARY": str(library)}

    def __call__(self, *words):
        done = subprocess.run([self.executable, *map(str, words)], env=self.environment, capture_output=True,
                              text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"{' '.join(map(str, words))}: {done.stderr.strip()}")
        return done.stdout

    def score(self, signals, task):
        words = ["score", "--signals", signals, "--json"] + (["--task", task] if task else [])
        return json.loads(self(*words))["measures"]


def make_session(program, folder, name, device, hand, tasks):
    """Runs and exports one session: base paths of its trials."""
    folder = folder / name
    folder.mkdir()
    protocol, database = sessions.write_protocol(folder, name, tasks), folder / "clinic.db"
    both, _, affected = hand.partition(" ")  # "left", or "both left"
    who = ["--device-left", device, "--device-right", device, "--affected", affected] if affected else [
        "--device", device, "--hand", both]
    program("run", "--protocol-file", protocol, "--db", database, "--patient", "OPINION-1", "--fast", *who)
    program("export", "--db", database, "--format", "csv", "--out", folder / "export")
    found = sorted((folder / "export").glob("patient_*/session_*/trial_*_signals.csv"))
    return [str(path).removesuffix("_signals.csv") for path in found]


def check_stored(base, name):
    """A trial of a session: the measures that were stored with it."""
    with open(base + ".json", encoding="utf-8") as file:
        trial = json.load(file)
    kind = trial["trial"]["task_kind"]
    label = f"{name}, {trial['trial']['task']}"
    return [compare(label, kind, trial["measures"], lambda: scorer.score(base + "_signals.csv", base + "_task.toml"))]


def check_varied(program, base, name, folder, seed):
    """A trial with damaged signals: the measures that `score` gives, variation by variation."""
    kind, task, found = Task(base + "_task.toml").kind, base + "_task.toml", []
    columns = {column: values for column, values in read_columns(base + "_signals.csv").items()
               if not column.endswith(NOT_READ) and not column.startswith("marker_")}
    for variation in variations_of(kind):
        signals = folder / f"{variation.__name__}_{name}_{seed}.csv"
        write_columns(signals, vary(columns, variation, seed))
        label = f"{variation.__name__} {name} {Path(base).name} {kind}"
        found.append(compare(label, kind, program.score(signals, task), lambda: scorer.score(signals, task)))
        signals.unlink()
    return found


def check_handmade(program, folder, name, columns, text):
    """Signals that were made by hand."""
    signals, task = folder / f"{name}.csv", None
    write_columns(signals, columns)
    if text:
        task = folder / f"{name}.toml"
        task.write_text(text, encoding="utf-8")
    kind = Task(task).kind if text else "without a task"
    return [compare(f"by hand, {name}", kind, program.score(signals, task), lambda: scorer.score(signals, task))]


def check_two_hands(program, folder, seed):
    """A record of two hands."""
    columns, affected, maxima = handmade.two_hands(random.Random(f"two hands {seed}"))
    signals = folder / f"two_hands_{seed}.csv"
    write_columns(signals, columns)
    words = ["--affected", affected]
    for hand, maximum in maxima.items():
        words += [f"--maximum-{hand}", repr(maximum)] if maximum else []
    theirs = json.loads(program("score", "--signals", signals, "--json", *words))["measures"]
    return [compare(f"two hands {seed}", "two hands", theirs,
                    lambda: scorer.score_two_hands(signals, affected, maxima))]


def jobs_of(pool, program, folder, seed, refused):
    """Everything that is compared, as it becomes known; in `refused` how many trials a session lacks."""
    for other in (seed + 1, seed + 2):
        for name, columns, text in handmade.cases(other):
            yield pool.submit(check_handmade, program, folder, f"{name}_{other}", columns, text)
    for k in range(TWO_HANDS):
        yield pool.submit(check_two_hands, program, folder, f"{k} {seed}")
    made = [(s[0], sessions.trials(s[-1]), pool.submit(make_session, program, folder, *s)) for s in sessions.sessions(seed)]
    varied, complete = set(), sessions.complete(seed)
    for name, asked, session in made:
        refused[name] = asked - len(session.result())
        for k, base in enumerate(session.result()):
            yield pool.submit(check_stored, base, name)
            kind = Task(base + "_task.toml").kind
            if name in complete and (name, kind) not in varied:
                varied.add((name, kind))
                yield pool.submit(check_varied, program, base, name, folder, seed + k)


def main(executable, library, seed=0):
    unknown = {p.stem for p in (Path(library) / "tasks").glob("*.toml")} - set(sessions.NOT_RUN)
    unknown -= {*sessions.LIBRARY, *sessions.ARM, *sessions.HAND, *sessions.PAIR}
    wrong = [f"task {name} of the library is in no session" for name in sorted(unknown)]
    table, valued, refused = defaultdict(lambda: [0, 0, 0, 0.0]), set(), {}
    with tempfile.TemporaryDirectory() as folder, ProcessPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        for job in list(jobs_of(pool, Program(executable, library), Path(folder), int(seed), refused)):
            for kind, measures, values, worst, found in job.result():
                row = table[kind]
                table[kind] = [row[0] + 1, row[1] + measures, row[2] + len(values), max(row[3], worst)]
                valued |= set(values)
                wrong += found
    print(f"{'task kind':20} {'trials':>7} {'measures':>9} {'values':>7}  largest relative difference")
    for kind, (trials, measures, values, worst) in sorted(table.items()):
        print(f"{kind:20} {trials:7} {measures:9} {values:7}  {worst:.1e}")
    for name, reason in sessions.NOT_RUN.items():
        print(f"not run: {name}: {reason}")
    for name, count in refused.items():
        if count:
            print(f"not run: {count} tasks of {name}: refused, the hand is too weak for them")
    wrong += [f"{refused[name]} tasks of the session {name} have no trial"
              for name in sessions.complete(int(seed)) if refused[name]]
    for line in NOT_COMPARED:
        print(f"not compared: {line}")
    missing = set(scorer.KINDS) - set(table)
    wrong += [f"no trial of kind {kind} was compared" for kind in sorted(missing)]
    wrong += [f"{name} had a value in no trial" for name in sorted(set(documented.VERSIONS) - valued)]
    for line in wrong:
        print(line, file=sys.stderr)
    print(f"{len(wrong)} differences")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit("usage: compare.py EXECUTABLE LIBRARY [SEED]")
    sys.exit(main(*sys.argv[1:]))
