#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the seals of rows cost: builds bench/seals.cpp with this tree and with a commit of format 8,
which has none, runs both in turns, and writes the table of docs/storage.md between its marks.
--demo FILE: a demonstration clinic (isograsp demo --clinic FILE) whose copy is opened and checked."""
import argparse
import datetime
import os
import platform
import re
import shutil
import subprocess
import tempfile

BEGIN = "<!-- made by bench/report/seals.py -->"
END = "<!-- end -->"


def run(command, **more):
    return subprocess.run(command, check=True, text=True, **more)


def values(program, *arguments):
    out = run([program, *arguments], stdout=subprocess.PIPE).stdout
    return {name: float(value) for name, value in (line.split() for line in out.splitlines())}


def build_before(source, commit, folder):
    """The same program where rows have no seals."""
    tree = os.path.join(folder, "tree")
    if not os.path.isdir(tree):
        os.makedirs(tree)
        archive = os.path.join(folder, "tree.tar")
        run(["git", "-C", source, "archive", "-o", archive, commit])
        run(["tar", "-xf", archive, "-C", tree])
        os.remove(archive)
    shutil.copy(os.path.join(source, "bench/seals.cpp"), os.path.join(tree, "bench/storage.cpp"))
    build = os.path.join(folder, "build")
    run(["cmake", "--preset", "release", "-S", tree, "-B", build, "-DISOGRASP_BENCH=ON"], cwd=tree,
        stdout=subprocess.DEVNULL)
    run(["cmake", "--build", build, "--target", "bench_storage", "-j1"], stdout=subprocess.DEVNULL)
    return os.path.join(build, "bench/bench_storage")


def machine():
    with open("/proc/cpuinfo") as info:
        model = re.search(r"model name\s*: (.*)", info.read())
    return f"{os.cpu_count()} virtual cores ({model.group(1).strip() if model else platform.machine()})"


def best_of(rounds):
    """What other programs take comes on top."""
    return {name: min(one[name] for one in rounds) for name in rounds[0]}


def ms(value):
    return f"{value:,.2f} ms" if value < 100 else f"{value:,.0f} ms" if value < 10_000 else f"{value / 1e3:,.1f} s"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--source", default=".")
    parser.add_argument("--build", required=True, help="release build with ISOGRASP_BENCH")
    parser.add_argument("--before", default="8d00d2d9", help="commit of format 8")
    parser.add_argument("--gigabytes", default="1")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--demo", help="a demonstration clinic of this program")
    parser.add_argument("--out", required=True, help="docs/storage.md")
    options = parser.parse_args()

    now = os.path.join(options.build, "bench/bench_seals")
    folder = os.path.join(options.build, "before-seals")
    os.makedirs(folder, exist_ok=True)
    before = build_before(os.path.abspath(options.source), options.before, os.path.abspath(folder))

    load = os.getloadavg()[1]
    rounds = {now: [], before: []}
    for _ in range(options.rounds):
        for program in (before, now):
            with tempfile.TemporaryDirectory(dir=options.build) as place:
                rounds[program].append(values(program, "record", place))
    a, b = best_of(rounds[before]), best_of(rounds[now])
    rows = []
    for name, words in (("closing", "closing a trial of five minutes"),
                        ("closing_short", "closing a trial of 20 seconds"),
                        ("ending", "ending a session of six trials")):
        for kind in ("plain", "protected"):
            one, other = a[f"{name}_{kind}_processor_ms"], b[f"{name}_{kind}_processor_ms"]
            rows.append((f"{words}, {kind}: processor", ms(one), ms(other),
                         f"{100 * (other / one - 1):+.1f} %"))
            one, other = a[f"{name}_{kind}_ms"], b[f"{name}_{kind}_ms"]
            rows.append((f"the same, on the clock", ms(one), ms(other),
                         f"{100 * (other / one - 1):+.1f} %"))
    for kind in ("plain", "protected"):
        one, other = a[f"kilobytes_a_minute_{kind}"], b[f"kilobytes_a_minute_{kind}"]
        rows.append((f"file for a minute of recording, {kind}", f"{one:,.1f} kB", f"{other:,.1f} kB",
                     f"{100 * (other / one - 1):+.1f} %"))

    with tempfile.TemporaryDirectory(dir=options.build) as place:
        one = values(before, "clinic", place)
    with tempfile.TemporaryDirectory(dir=options.build) as place:
        other = values(now, "clinic", place)
    for name, words in (
            ("opening_plain", "opening a clinic of 2,000 sessions, plain"),
            ("opening_protected", "opening it protected, logged in"),
            ("first_change_plain", "its first change after opening, plain"),
            ("first_change_protected", "the same, protected"),
            ("login_of_nothing", "login to an empty clinic (Argon2id)"),
            ("login", "login to that of 2,000 sessions"),
            ("check_plain", "`db check` of it, plain"),
            ("check_protected", "`db check` of it, protected")):
        x, y = one[name + "_ms"], other[name + "_ms"]
        rows.append((words, ms(x), ms(y), f"{y - x:+,.0f} ms"))

    with tempfile.TemporaryDirectory(dir=options.build) as place:
        path = os.path.join(place, "large.db")
        values(before, "make", path, options.gigabytes)
        done = values(now, "migrate", path)
        rows.append((f"migrating {done['file_bytes'] / 1e9:.2f} GB from format 8", "–",
                     ms(done["migrate_ms"]), f"{done['migrate_processor_ms'] / 1e3:,.1f} s of processor"))
    if options.demo:
        with tempfile.TemporaryDirectory(dir=options.build) as place:
            path = shutil.copy(options.demo, os.path.join(place, "demo.db"))
            done = values(now, "open", path)
            size = os.path.getsize(path) / 1e6
            rows.append((f"opening the demonstration clinic ({size:.0f} MB)", "–",
                         ms(done["opening_file_ms"]), ""))
            rows.append(("`db check` of it", "–", ms(done["check_file_ms"]), ""))

    commit = run(["git", "-C", options.source, "describe", "--always", "--dirty=+"],
                 stdout=subprocess.PIPE).stdout.strip()
    date = datetime.date.today().strftime("%-d %B %Y")
    table = [f"`scripts/bench --seals`, {date}, {commit} (with seals) and {options.before} (format 8, "
             f"without), release builds, {machine()}; the best of {options.rounds} rounds in turns, of medians; load of "
             f"the machine by others {load:.1f}.", "",
             "| what | without seals | with seals | difference |", "|---|---|---|---|"]
    table += ["| " + " | ".join(row) + " |" for row in rows]
    with open(options.out) as page:
        text = page.read()
    head, rest = text.split(BEGIN)
    tail = rest.split(END, 1)[1]
    with open(options.out, "w") as page:
        page.write(head + BEGIN + "\n" + "\n".join(table) + "\n" + END + tail)
    print("\n".join(table))


if __name__ == "__main__":
    main()
