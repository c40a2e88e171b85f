#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every engine on every case and writes results.csv, scenes.csv, kernels.csv, machine.json,
then scoring.csv and scoring.json (--scoring: only these), markers.csv and markers.json (--markers),
hand_world.csv and hand_world.json (--hand), pads.csv and pads.json (--pads),
whole.csv and whole.json (--whole).

Each engine is a program of its own (bench/harness.hpp): one that aborts, hangs or diverges gets
that as its status and takes nobody with it. Errors are measured once, times in rounds that go
through all scenes and all engines, so that noise of the machine hits all alike.
"""

import argparse
import csv
import datetime
import glob
import json
import os
import pathlib
import platform
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

ROUNDS = 5
PATIENCE_S = 120
# Instructions are counted of methods up to this time a frame: callgrind is some 50 times slower.
COUNTED_NS = 10e3

OWN = ["isograsp", "baseline"]
PEERS = ["mujoco", "bullet", "ode", "dart", "simbody"]


START = time.monotonic()


def note(text):
    print(f"bench: {time.monotonic() - START:4.0f} s: {text}", file=sys.stderr, flush=True)


class Engine:
    """One program of the benchmark on one case."""

    def __init__(self, program, case, pin):
        self.program, self.case, self.pin = program, case, pin

    def run(self, mode, numbers=(), prefix=()):
        """Lines of the program, and why it ended if it did not end well."""
        command = [*prefix, str(self.program), str(self.case), mode, *map(str, numbers)]
        try:
            done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                  text=True, timeout=PATIENCE_S, cwd=self.case.parent)
        except subprocess.TimeoutExpired as late:
            out = late.stdout or ""
            return self.fields(out if isinstance(out, str) else out.decode()), "hung"
        if done.returncode < 0:
            return self.fields(done.stdout), f"aborted ({signal.Signals(-done.returncode).name})"
        return self.fields(done.stdout), "aborted" if done.returncode else None

    @staticmethod
    def fields(text):
        return [line.split("\t") for line in text.splitlines()]

    def methods(self):
        lines, trouble = self.run("list")
        if trouble:
            sys.exit(f"bench: {self.program}: cannot list its methods: {trouble}")
        return {int(number): dict(engine=engine, version=version, scene=self.case.stem,
                                  integrator=integrator, substeps=int(substeps), way=way,
                                  setup=setup)
                for _, number, engine, version, integrator, substeps, way, setup in lines}

    def each(self, mode, numbers, prefix=()):
        """Results by method number; a method that took the program down has its reason instead."""
        results, numbers = {}, list(numbers)
        while numbers:
            lines, trouble = self.run(mode, numbers, prefix)
            results.update({int(f[1]): f[2:] for f in lines if f[0] == mode})
            if not trouble:
                return results
            begun = [int(f[1]) for f in lines if f[0] == "begin"]
            guilty = begun[-1] if begun else numbers[0]
            results[guilty] = trouble
            numbers = [n for n in numbers if n > guilty]
        return results


def measure_errors(engine, table):
    for number, result in engine.each("error", table).items():
        row = table[number]
        if isinstance(result, str):
            row["status"] = result
            continue
        metres, radians, relative, drift = map(float, result[:4])
        row["status"] = result[4]
        if result[4] in ("ok", "lost"):
            row.update(error_position_m=metres, error_angle_rad=radians, error_relative=relative)
            if drift == drift:
                row["drift_relative"] = drift


def measure_times(engine, table):
    numbers = [n for n, row in table.items() if row["status"] in ("ok", "lost")]
    for number, result in engine.each("time", numbers, engine.pin).items():
        row = table[number]
        if isinstance(result, str):
            row["status"] = result
        else:
            row.setdefault("times", []).append(float(result[0]))


def count_instructions(engine, table, folder):
    numbers = [n for n, row in table.items() if "times" in row and (
        row["engine"] == "IsoGrasp" or statistics.median(row["times"]) < COUNTED_NS)]
    if not numbers:
        return
    out = folder / "callgrind"
    for old in glob.glob(f"{out}*"):
        os.remove(old)
    results = engine.each("count", numbers,
                          ["valgrind", "-q", "--tool=callgrind", "--instr-atstart=no",
                           f"--callgrind-out-file={out}"])
    for dump in glob.glob(f"{out}.*"):
        text = pathlib.Path(dump).read_text()
        trigger = re.search(r"desc: Trigger: Client Request: (\d+)", text)
        totals = re.search(r"^totals: (\d+)", text, re.MULTILINE)
        if trigger and totals:
            number = int(trigger[1])
            if isinstance(results.get(number), list):
                table[number]["instructions_per_frame"] = round(
                    int(totals[1]) / int(results[number][0]))


def text_of(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return ""


def machine(source, build, core, peers, counter):
    cache = (build / "CMakeCache.txt").read_text()

    def cached(name):
        found = re.search(rf"^{name}:[A-Z]+=(.*)$", cache, re.MULTILINE)
        return found[1] if found else ""

    lscpu = text_of(["lscpu"])

    def cpu(name):
        found = re.search(rf"^\s*{re.escape(name)}:\s*(.*)$", lscpu, re.MULTILINE)
        return found[1] if found else ""

    measured = ["core", "hand", "grasp_model", "virtual_hand", "hand_world", "bimanual", "statistics", "tasks", "bench", "CMakeLists.txt", "cmake"]
    git = ["git", "-C", str(source)]
    return {
        "processor": cpu("Model name"), "family_model_stepping":
            "/".join(cpu(n) for n in ("CPU family", "Model", "Stepping")),
        "processors": os.cpu_count(), "virtual": cpu("Hypervisor vendor"),
        "pinned_to": core, "system": platform.freedesktop_os_release()["PRETTY_NAME"],
        "kernel": platform.release(),
        "compiler": text_of([cached("CMAKE_CXX_COMPILER"), "--version"]).splitlines()[0],
        "flags": cached("CMAKE_CXX_FLAGS_RELEASE") + " -ffp-contract=off",
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d"),
        "commit": text_of([*git, "rev-parse", "--short", "HEAD"]),
        "changed": bool(text_of([*git, "status", "--porcelain", "--", *measured])),
        "rounds": ROUNDS, "peers": peers, "instructions": counter,
    }


def write_csv(path, columns, rows):
    with open(path, "w", newline="") as out:
        table = csv.DictWriter(out, columns, extrasaction="ignore", lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


def digits(value):
    return "" if value is None else f"{value:.4g}"


def google_benchmark(program, pin, least_s):
    """Median processor time of each benchmark, in its own unit."""
    done = json.loads(subprocess.run(
        [*pin, program, "--benchmark_format=json", f"--benchmark_min_time={least_s}",
         f"--benchmark_repetitions={ROUNDS}", "--benchmark_report_aggregates_only=true",
         "--benchmark_enable_random_interleaving=true"], stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL, text=True, check=True).stdout)["benchmarks"]
    return [(b["run_name"], digits(b["cpu_time"])) for b in done
            if b.get("aggregate_name") == "median"]


def measure_scoring(build, out, pin, described):
    note("scoring")
    load = f"{os.getloadavg()[0]:.1f}"
    times = google_benchmark(build / "bench/bench_scoring", pin, 0.2)
    write_csv(out / "scoring.csv", ["scoring", "ms"], [dict(scoring=n, ms=t) for n, t in times])
    (out / "scoring.json").write_text(json.dumps({**described, "load": load}, indent=2) + "\n")


def measure_markers(build, out, pin, described):
    """Medians of the times, and what each benchmark counts beside them."""
    note("markers")
    load = f"{os.getloadavg()[0]:.1f}"
    done = json.loads(subprocess.run(
        [*pin, build / "bench/bench_kinematics", "--benchmark_format=json", "--benchmark_min_time=0.1",
         f"--benchmark_repetitions={ROUNDS}", "--benchmark_report_aggregates_only=true"],
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True).stdout)["benchmarks"]
    columns = ["markers", "ns", "mm", "deg", "poses_%", "more_MB"]
    rows = [dict(markers=b["run_name"].split("/iterations")[0], ns=digits(b["cpu_time"]),
                 **{c: digits(b[c]) if c in b else "" for c in columns[2:]})
            for b in done if b.get("aggregate_name") == "median"]
    write_csv(out / "markers.csv", columns, rows)
    (out / "markers.json").write_text(json.dumps({**described, "load": load}, indent=2) + "\n")


def measure_hold(build, out, pin):
    """The hold of bench/hold_scene.hpp, by every engine that was built: medians of the times, the rest
    is the same in every round."""
    programs = [build / "bench/bench_hand_hold", *sorted((build / "bench/peers").glob("bench_*_hold"))]
    columns = ["engine", "digits", "ms", "slip_m", "turn_rad", "depth_m"]
    rounds = [[line.split("\t") for program in programs for line in subprocess.run(
        [*pin, program], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()]
        for _ in range(ROUNDS)]
    rows = [dict(zip(columns, cases[0]), ms=digits(statistics.median(float(case[2]) for case in cases)))
            for cases in zip(*rounds)]
    write_csv(out / "hand_hold.csv", columns, rows)


def measure_hand(build, out, pin, described):
    """Medians of the rounds, which the program makes one after the other."""
    note("hand and object")
    load = f"{os.getloadavg()[0]:.1f}"
    columns = ["case", "median_ns", "p99_ns", "sweeps", "residual_m_s", "error_m"]
    rounds = [[line.split("\t") for line in subprocess.run(
        [*pin, build / "bench/bench_hand_world"], stdout=subprocess.PIPE, text=True,
        check=True).stdout.splitlines()] for _ in range(ROUNDS)]
    rows = [dict(zip(columns, [cases[0][0]] + [
        digits(statistics.median(map(float, values))) if values[0] else ""
        for values in list(zip(*cases))[1:]])) for cases in zip(*rounds)]
    write_csv(out / "hand_world.csv", columns, rows)
    (out / "hand_world.json").write_text(json.dumps({**described, "load": load}, indent=2) + "\n")


def measure_pads(build, out, pin, described):
    """Medians of the rounds, ours and those of the peer in turns."""
    note("pads")
    load = f"{os.getloadavg()[0]:.1f}"
    columns = ["case", "rows", "median_ns", "p99_ns", "sweeps", "creep_m_s", "creep_rad_s"]
    programs = [build / "bench/bench_pads"]
    programs += [build / "bench/peers/bench_mujoco_pads"] if described["peers"] else []
    rounds = [[line.split("\t") for program in programs for line in subprocess.run(
        [*pin, program], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()]
        for _ in range(ROUNDS)]
    rows = []
    for cases in zip(*rounds):
        name, *values = zip(*cases)
        rows.append(dict(zip(columns, [name[0]] + [
            digits(statistics.median(map(float, v))) if "dropped" not in v else "dropped" for v in values])))
    write_csv(out / "pads.csv", columns, rows)
    (out / "pads.json").write_text(json.dumps({**described, "load": load}, indent=2) + "\n")


def processor_s(command):
    """Processor time of a whole program, that of the system included."""
    program = os.posix_spawn(command[0], [str(word) for word in command], os.environ)
    _, status, used = os.wait4(program, 0)
    if status:
        sys.exit(f"bench: {command} failed")
    return used.ru_utime + used.ru_stime


def measure_whole(source, build, out, pin, described):
    """An hour of forces, by the whole program and by what reads and writes alone, in turns."""
    note("the whole program")
    load = f"{os.getloadavg()[0]:.1f}"
    pin = [shutil.which(pin[0]), *pin[1:]] if pin else []
    given = source / "tests/data/dynamics"
    with tempfile.TemporaryDirectory(dir=build) as folder:
        folder = pathlib.Path(folder)
        tables = build / "bench/bench_tables"
        processor_s([tables, "hour", given / "forces.csv", folder / "in.csv", folder / "in.h5"])
        commands = {}
        for kind, ending in (("text", "csv"), ("HDF5", "h5")):
            ends = [folder / f"in.{ending}", folder / f"out.{ending}"]
            commands["alone", kind] = [*pin, tables, "alone", *ends]
            for scene in ("S1", "S2", "S3"):
                commands[scene, kind] = [*pin, build / "isograsp", "simulate", "--scene", given / f"{scene}.toml",
                                         "--forces", ends[0], "--out", ends[1]]
        times = [{case: processor_s(command) for case, command in commands.items()} for _ in range(ROUNDS)]
    rows = []
    for case, kind in commands:
        hour_s = statistics.median(turn[case, kind] for turn in times)
        rest_s = statistics.median(turn[case, kind] - turn["alone", kind] for turn in times)
        rows.append(dict(case=case, kind=kind, s=digits(hour_s), more_s="" if case == "alone" else digits(rest_s)))
    write_csv(out / "whole.csv", ["case", "kind", "s", "more_s"], rows)
    (out / "whole.json").write_text(json.dumps({**described, "load": load}, indent=2) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--peers", action="store_true")
    parser.add_argument("--scoring", action="store_true")
    parser.add_argument("--markers", action="store_true")
    parser.add_argument("--hand", action="store_true")
    parser.add_argument("--pads", action="store_true")
    parser.add_argument("--whole", action="store_true")
    options = parser.parse_args()
    build, out = options.build.resolve(), options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    cases = build / "bench_cases"
    cases.mkdir(exist_ok=True)
    core = max(os.sched_getaffinity(0))
    pin = ["taskset", "-c", str(core)] if shutil.which("taskset") else []
    if options.scoring:
        measure_scoring(build, out, pin, machine(options.source, build, core, False, ""))
        return
    if options.hand:
        measure_hand(build, out, pin, machine(options.source, build, core, True, ""))
        measure_hold(build, out, pin)
        return
    if options.pads:
        measure_pads(build, out, pin, machine(options.source, build, core, options.peers, ""))
        return
    if options.whole:
        measure_whole(options.source, build, out, pin, machine(options.source, build, core, False, ""))
        return
    if options.markers:
        measure_markers(build, out, pin, machine(options.source, build, core, False, ""))
        return

    note("wrenches and reference trajectories")
    scenes = [line.split("\t") for line in subprocess.run(
        [build / "bench/bench_prepare", cases], stdout=subprocess.PIPE, text=True,
        check=True).stdout.splitlines()]

    engines = []  # by scene, then by program
    for scene in scenes:
        peers = PEERS if options.peers and scene[2] == "1" else []
        programs = [build / f"bench/bench_{name}" for name in OWN]
        programs += [build / f"bench/peers/bench_{name}" for name in peers]
        engines += [Engine(p, cases / f"{scene[0]}.case", pin) for p in programs]
    tables = [engine.methods() for engine in engines]

    note("errors")
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(measure_errors, engines, tables))
    for turn in range(ROUNDS):
        note(f"times, round {turn + 1} of {ROUNDS}")
        for engine, table in zip(engines, tables):
            measure_times(engine, table)
    counter = "callgrind" if shutil.which("valgrind") else ""
    if counter:
        note("instructions")
        for engine, table in zip(engines, tables):
            count_instructions(engine, table, cases)
    else:
        note("no valgrind here: instructions are not counted")

    rows = []
    for table in tables:
        for row in table.values():
            times = row.get("times", [])
            row["ns_per_frame"] = digits(statistics.median(times) if times else None)
            row["ns_rounds"] = " ".join(map(digits, times))
            for name in ("error_position_m", "error_angle_rad", "error_relative",
                         "drift_relative"):
                row[name] = digits(row.get(name))
            rows.append(row)
    write_csv(out / "results.csv",
              ["engine", "version", "scene", "integrator", "substeps", "ns_per_frame",
               "error_position_m", "error_angle_rad", "error_relative", "status",
               "instructions_per_frame", "drift_relative", "way", "ns_rounds", "setup"], rows)
    write_csv(out / "scenes.csv",
              ["scene", "title", "peers", "frames", "excursion_m", "excursion_rad",
               "given_m", "given_rad"],
              [dict(zip(["scene", "title", "peers", "frames", "excursion_m", "excursion_rad",
                         "given_m", "given_rad"],
                        [*s[:4], digits(float(s[4])), digits(float(s[5])), *s[6:]]))
               for s in scenes])

    note("kernels")
    kernels = google_benchmark(build / "bench/bench_kernels", pin, 0.05)
    write_csv(out / "kernels.csv", ["kernel", "ns"], [dict(kernel=n, ns=t) for n, t in kernels])
    described = machine(options.source, build, core, options.peers, counter)
    (out / "machine.json").write_text(json.dumps(described, indent=2) + "\n")
    measure_whole(options.source, build, out, pin, described)
    measure_scoring(build, out, pin, described)
    measure_markers(build, out, pin, described)
    measure_hand(build, out, pin, described)
    if options.peers:  # else the table keeps what was measured beside them
        measure_hold(build, out, pin)
    measure_pads(build, out, pin, described)


if __name__ == "__main__":
    main()
