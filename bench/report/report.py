#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""report.py FOLDER PAGE: writes PAGE (docs/performance.md) from FOLDER/results.csv and friends.

The prose that does not depend on a measurement is in performance.md.in; every number is computed
here.
"""

import math
import pathlib
import statistics
import sys

from results import Results, ratio

LEVELS = [(1.0, "any answer"), (1e-1, "10 %"), (1e-2, "1 %"), (1e-4, "1e-4"), (1e-6, "1e-6"),
          (1e-8, "1e-8")]


def time(ns):
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if ns >= size:
            return f"{ns / size:.3g} {unit}"
    return f"{ns:.3g} ns"


def small(value):
    """An error: two digits are enough."""
    return "–" if value is None else "0" if value == 0 else f"{value:.1e}"


def times(value):
    return f"{value:.0f}×" if value >= 10 else f"{value:.1f}×" if value >= 1 else f"{value:.2f}×"


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def count(value):
    return "–" if value is None else f"{value:.0f}"


def machine(results):
    m = results.machine
    where = f" ({m['virtual']} guest)" if m["virtual"] else ""
    tree = " with uncommitted changes" if m["changed"] else ""
    return table(["", ""], [
        ["processor", f"{m['processor']}{where}, family/model/stepping "
                      f"{m['family_model_stepping']}, {m['processors']} cores; pinned to one"],
        ["system", f"{m['system']}, Linux {m['kernel']}"],
        ["compiler, flags", f"{m['compiler']}; `{m['flags']}`"],
        ["date, commit", f"{m['date']}, {m['commit']}{tree}"],
        ["times", f"median of {m['rounds']} rounds, every round through all scenes and engines"],
        ["instructions", m["instructions"] or "not counted: neither counter nor valgrind here"],
    ])


def noise(results):
    spreads = [max(p.rounds) / min(p.rounds) - 1 for p in results.points if p.rounds]
    return (f"Between the fastest and the slowest round of a method lie "
            f"{statistics.median(spreads):.0%} (median over all methods), "
            f"{statistics.quantiles(spreads, n=20)[-1]:.0%} at the 95th percentile: so noisy was "
            "the machine.")


def ours(results):
    rows = []
    for scene in results.scenes:
        p = results.ours(scene["scene"])
        same = {q.integrator: q for q in results.of(scene["scene"]) if q.engine == p.engine}
        recorded, motion = same["plan, recorded"], same["plan, motion alone"]
        drift = small(p.drift) if p.drift is not None else ""
        rows.append([scene["scene"], scene["title"], time(p.ns), time(recorded.ns),
                     time(motion.ns), count(p.instructions), small(p.metres), small(p.radians),
                     small(p.relative), drift])
    return table(["scene", "", "frame", "frame, recorded", "motion alone", "instructions",
                  "error [m]", "error [rad]", "relative", "drift"], rows)


def cheapest(points, level, parts):
    fit = [p for p in points if p.peer and p.answers and p.parts == parts and p.error <= level]
    return min(fit, key=lambda p: p.ns, default=None)


def cell(peer, own):
    if peer is None:
        return "none"
    return f"{times(ratio(peer, own))} ({peer.name}, {time(peer.ns)})"


def levels(results, parts):
    rows = []
    for scene in results.compared():
        points, own = results.of(scene["scene"]), results.ours(scene["scene"])
        row = [scene["scene"], f"{time(own.ns)}, {small(own.error)}"]
        before = None
        for level, _ in LEVELS:
            both = cheapest(points, level, parts), results.ours_within(scene["scene"], level)
            row.append("〃" if both[0] and both == before else cell(*both))
            before = both
        row.append(cell(cheapest(points, own.error, parts), own))
        rows.append(row)
    return table(["scene", "IsoGrasp", *(name for _, name in LEVELS), "as exact as IsoGrasp"],
                 rows)


def wins(results):
    """All peers' points that are not both slower and less exact than one of ours."""
    lines = []
    for scene in results.compared():
        points, own = results.of(scene["scene"]), results.ours(scene["scene"])
        mine = [p for p in points if p.curve]
        peers = [p for p in points if p.peer and p.answers and
                 not any(m.ns <= p.ns and m.error < p.error for m in mine)]
        faster = [p for p in peers if p.ns < own.ns]
        exacter = [p for p in peers if p.error <= own.error]
        if faster:
            best = min(faster, key=lambda p: p.error)
            lines.append(f"- **{scene['scene']}: cheaper, not more exact.** "
                         f"{len(faster)} settings cost less than our {time(own.ns)}; the most "
                         f"exact of them, {best.name}, takes {time(best.ns)} and is off by "
                         f"{small(best.error)}, where we are off by {small(own.error)}.")
        if exacter:
            best = min(exacter, key=lambda p: p.ns)
            lines.append(f"- **{scene['scene']}: more exact, not cheaper.** {best.name} is off by "
                         f"{small(best.error)} where we are off by {small(own.error)}; it takes "
                         f"{time(best.ns)}, {times(ratio(best, own))} our time.")
        both = [p for p in faster if p in exacter]
        if both:
            names = ", ".join(p.name for p in both)
            lines.append(f"- **{scene['scene']}: cheaper and more exact:** {names}.")
    if not lines:
        return "Nowhere: every setting of every engine is both slower and less exact than ours."
    clean = [s["scene"] for s in results.compared()
             if not any(f"**{s['scene']}:" in line for line in lines)]
    if clean:
        lines.append(f"- On {', '.join(clean)} every setting of every engine is both slower and "
                     "less exact than ours.")
    return "\n".join(lines)


def closest(results):
    """The claim in one line per scene."""
    rows = []
    for scene in results.compared():
        points, own = results.of(scene["scene"]), results.ours(scene["scene"])
        best = min((p for p in points if p.peer and p.answers), key=lambda p: p.error)
        row = [scene["scene"]]
        for level in (1.0, 1e-1, 1e-2):
            peer = cheapest(points, level, False)
            mine = results.ours_within(scene["scene"], level)
            row.append(times(ratio(peer, mine)) if peer else "none")
        row += [f"{best.name}: {small(best.error)} in {time(best.ns)}",
                f"{small(own.error)} in {time(own.ns)}"]
        rows.append(row)
    return table(["scene", "fastest peer / IsoGrasp", "… at 10 % error or better",
                  "… at 1 % or better", "most exact peer", "IsoGrasp"], rows)


def by_hand(results):
    rows = []
    for scene in results.compared():
        points, own = results.of(scene["scene"]), results.ours(scene["scene"])
        row = [scene["scene"]]
        for name in ("explicit Euler", "semi-implicit Euler", "Runge-Kutta 4"):
            one = next(p for p in points if p.by_hand and p.integrator == name and
                       p.substeps == 1)
            good = min((p for p in points if p.by_hand and p.integrator == name and p.answers),
                       key=lambda p: p.error, default=None)
            first = f"{small(one.error)} in {time(one.ns)}" if one.answers else one.status
            row.append(first)
            row.append(f"{small(good.error)} in {time(good.ns)}" if good else "none")
        row.append(f"{small(own.error)} in {time(own.ns)}")
        rows.append(row)
    return table(["scene", "explicit Euler ×1", "at its best", "semi-implicit ×1", "at its best",
                  "Runge-Kutta 4 ×1", "at its best", "IsoGrasp"], rows)


def hand_wins(results):
    """By hand the wrench is given: compare with the motion alone."""
    lines = []
    for scene in results.compared():
        points = results.of(scene["scene"])
        own = next(p for p in points if p.integrator == "plan, motion alone")
        faster = [p for p in points if p.by_hand and p.answers and p.ns < own.ns]
        if faster:
            best = min(faster, key=lambda p: p.error)
            lines.append(f"- {scene['scene']}: {best.integrator} ×{best.substeps} takes "
                         f"{time(best.ns)} and is off by {small(best.error)}; we take "
                         f"{time(own.ns)} and are off by {small(own.error)}.")
    return "\n".join(lines) or "- Nowhere."


def failures(results):
    kinds = {}
    for p in results.points:
        if p.peer and p.status not in ("ok", "too slow"):
            kinds.setdefault((p.engine, p.integrator, p.status), {}).setdefault(
                p.scene, []).append(str(p.substeps))
    rows = []
    for (engine, integrator, status), scenes in kinds.items():
        where = "; ".join(s if steps == ["0"] else f"{s} ×{', '.join(steps)}"
                          for s, steps in scenes.items())
        rows.append([engine, integrator, status, where])
    if not rows:
        return "None did."
    return table(["engine", "integrator", "status", "scene and substeps a frame"], sorted(rows))


def setups(results):
    kinds = {}
    for p in results.points:
        if p.peer:
            name = p.integrator.split(", accuracy")[0]
            kinds.setdefault((f"{p.engine} {p.version}", name, p.setup), {})[p.scene] = True
    return table(["engine", "integrator", "scenes", "springs, dampers, wrench"],
                 [[e, i, ", ".join(scenes), setup]
                  for (e, i, setup), scenes in sorted(kinds.items(), key=lambda k: k[0][0])])


def scenes(results):
    rows = []
    for s in results.scenes:
        given = "–"
        if s["given_rad"]:
            given = f"{small(float(s['given_m']))} m, {small(float(s['given_rad']))} rad"
        rows.append([s["scene"], s["title"], s["frames"], s["excursion_m"], s["excursion_rad"],
                     given])
    return table(["scene", "", "frames", "largest excursion [m]", "[rad]",
                  "our reference against the one that came with the scene"], rows)


def kernels(results):
    return table(["kernel", "median"],
                 [[k["kernel"].replace("/", ", ").replace("_", " "), time(float(k["ns"]))]
                  for k in sorted(results.kernels, key=lambda k: k["kernel"])])


def conditions(m):
    tree = " with uncommitted changes" if m["changed"] else ""
    return (f"{m['processor']}, {m['processors']} cores, one used; {m['date']}, {m['commit']}{tree}; "
            f"load {m['load']} before; median of {m['rounds']} rounds.")


def markers(results):
    def counted(row, column, form):
        return form.format(float(row[column])) if row[column] else ""
    rows = [[r["markers"].replace("/", ", ").replace("_", " "), time(float(r["ns"])),
             counted(r, "mm", "{:.3g} mm"), counted(r, "deg", "{:.3g}°"), counted(r, "poses_%", "{:.3g} %"),
             counted(r, "more_MB", "{:.3g} MB")] for r in results.markers]
    lines = table(["", "processor time", "position", "attitude", "rows with a pose", "more memory"], rows)
    return f"{conditions(results.markers_machine)}\n\n{lines}"


def hand(results):
    def counted(row, column, form, scale=1.0):
        return form.format(scale * float(row[column])) if row[column] else ""
    rows = [[r["case"], time(float(r["median_ns"])), time(float(r["p99_ns"])), counted(r, "sweeps", "{:.0f}"),
             counted(r, "residual_m_s", "{:.2g} µm/s", 1e6), counted(r, "error_m", "{:.2g} mm", 1e3)]
            for r in results.hand]
    lines = table(["", "median", "99th percentile", "sweeps", "residual, 99th percentile", "error of the step"], rows)
    return f"{conditions(results.hand_machine)}\n\n{lines}"


def hold(results):
    def told(row, column, form, scale):
        return form.format(scale * float(row[column])) if row[column] != "dropped" else "dropped"
    rows = [[r["engine"], {"2": "pinch", "3": "tripod"}[r["digits"]], time(1e6 * float(r["ms"])),
             told(r, "slip_m", "{:.2g} mm", 1e3), told(r, "turn_rad", "{:.2g}°", 180.0 / math.pi),
             told(r, "depth_m", "{:.2g} mm", 1e3)] for r in sorted(results.hold, key=lambda r: r["digits"])]
    return table(["", "grip", "time of a second", "slip", "turn", "depth"], rows)


def pads(results):
    def creep(row, column, form, scale):
        return "dropped" if row[column] == "dropped" else form.format(scale * float(row[column]))
    rows = [[r["case"], r["rows"], time(float(r["median_ns"])), time(float(r["p99_ns"])), r["sweeps"],
             creep(r, "creep_m_s", "{:.2g} µm/s", 1e6), creep(r, "creep_rad_s", "{:.2g} °/s", 180.0 / math.pi)]
            for r in results.pads]
    lines = table(["", "rows", "median", "99th percentile", "sweeps", "creeps", "turns"], rows)
    return f"{conditions(results.pads_machine)}\n\n{lines}"


def whole(results):
    """A row a case, text and HDF5 beside each other."""
    frames = 360_000
    cells = {(r["case"], r["kind"]): r for r in results.whole}
    rows = []
    for case in dict.fromkeys(r["case"] for r in results.whole):
        row = ["read and written alone" if case == "alone" else case]
        for kind in ("text", "HDF5"):
            one = cells[case, kind]
            row += [f"{float(one['s']):.2f} s",
                    time(float(one["more_s"]) / frames * 1e9) if one["more_s"] else ""]
        rows.append(row)
    lines = table(["", "text", "more, a frame", "HDF5", "more, a frame"], rows)
    return f"{conditions(results.whole_machine)}\n\n{lines}"


def scoring(results):
    lines = table(["", "processor time"],
                  [[s["scoring"].replace("/", ", ").replace("_", " "), time(float(s["ms"]) * 1e6)]
                   for s in sorted(results.scoring, key=lambda s: s["scoring"])])
    return f"{conditions(results.scoring_machine)}\n\n{lines}"


def main(folder, page):
    results = Results(folder)
    text = (pathlib.Path(__file__).parent / "performance.md.in").read_text()
    fields = dict(machine=machine(results), noise=noise(results), ours=ours(results),
                  scenes=scenes(results), kernels=kernels(results),
                  whole=whole(results), scoring=scoring(results), markers=markers(results), hand=hand(results), hold=hold(results), pads=pads(results), by_hand=by_hand(results),
                  hand_wins=hand_wins(results))
    if results.machine["peers"]:
        fields.update(closest=closest(results), levels=levels(results, False),
                      levels_parts=levels(results, True), wins=wins(results),
                      failures=failures(results), setups=setups(results))
    else:
        missing = "Not measured in this run: `scripts/bench --peers` does."
        fields.update(dict.fromkeys(
            ["closest", "levels", "levels_parts", "wins", "failures", "setups"], missing))
    for name, value in fields.items():
        text = text.replace("{{" + name + "}}", value)
    page.write_text(text)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
