#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""plot.py FOLDER: work-precision diagrams of results.csv, FOLDER/work_precision.svg."""

import pathlib
import re
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator  # noqa: E402

from results import Results  # noqa: E402

# Okabe and Ito: told apart with every kind of colour vision; each engine has its own marker too.
LOOK = {
    "MuJoCo": ("#0072B2", "o"),
    "Bullet": ("#E69F00", "s"),
    "ODE": ("#009E73", "^"),
    "DART": ("#CC79A7", "D"),
    "Simbody": ("#D55E00", "v"),
}
INK, GREY, PALE = "#222222", "#8A8A8A", "#E4E4E4"
HAND = {"explicit Euler": (0, (1, 1.5)), "semi-implicit Euler": (0, (4, 2)), "Runge-Kutta 4": "-"}
FLOOR = 1e-17  # an error of exactly zero is drawn here


def time_label(ns, _position):
    for unit, size in (("ms", 1e6), ("µs", 1e3), ("ns", 1)):
        if ns >= size:
            return f"{ns / size:.3g} {unit}"
    return ""


def curves(points):
    """Points of one method at growing cost, one curve per integrator."""
    names = {}
    for p in points:
        # Accuracies of one integrator form one curve as substeps do.
        names.setdefault((p.engine, p.integrator.split(", accuracy")[0]), []).append(p)
    return {name: sorted(group, key=lambda p: -p.error if not p.substeps else p.substeps) for name, group in names.items()}


def panel(axes, scene, points, ours):
    drawn = [p for p in points if p.answers]
    for (engine, integrator), group in curves(drawn).items():
        x, y = [p.ns for p in group], [max(p.error, FLOOR) for p in group]
        if engine == "by hand":
            axes.plot(x, y, color=GREY, linewidth=1.1, linestyle=HAND[integrator], zorder=2)
        elif engine in LOOK:
            color, marker = LOOK[engine]
            parts = group[0].parts
            axes.plot(x, y, color=color, linewidth=1.0, zorder=3, marker=marker,
                      markersize=4.2, linestyle=(0, (2, 1.5)) if parts else "-",
                      markerfacecolor="white" if parts else color, markeredgecolor=color,
                      markeredgewidth=0.9)
    at = ours.ns, max(ours.error, FLOOR)
    axes.axvline(at[0], color=INK, linewidth=0.7, alpha=0.35, zorder=1)
    axes.axhline(at[1], color=INK, linewidth=0.7, alpha=0.35, zorder=1)
    axes.plot(*at, marker="*", markersize=17, color=INK, markeredgecolor="white",
              markeredgewidth=1.0, zorder=5, linestyle="none")
    axes.annotate(f"{time_label(at[0], None)}, {ours.error:.0e}", at, xytext=(9, 7),
                  textcoords="offset points", fontsize=8, color=INK, zorder=6,
                  bbox=dict(facecolor="white", edgecolor="none", alpha=0.85, pad=0.8))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(1.5, 1e6)
    axes.set_ylim(3e-18, 30)
    axes.xaxis.set_major_locator(LogLocator(10, numticks=12))
    axes.yaxis.set_major_locator(LogLocator(1000, numticks=12))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(time_label))
    axes.grid(color=PALE, linewidth=0.7, zorder=0)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    for side in ("left", "bottom"):
        axes.spines[side].set_color(GREY)
    axes.tick_params(colors=INK, labelsize=8.5, length=3, color=GREY)
    title, _, more = scene["title"].partition(": ")
    if not more:
        title, _, more = scene["title"].partition(", ")
    axes.set_title(f"{scene['scene']}   {title}", loc="left", fontsize=10.5, color=INK,
                   fontweight="bold", pad=17)
    axes.text(0, 1.02, more, transform=axes.transAxes, fontsize=8.5, color="#555555",
              va="bottom")
    missing = sorted({p.engine for p in points if p.peer} - {p.engine for p in drawn})
    if missing:
        axes.text(0.99, 0.03, "no usable answer: " + ", ".join(missing), fontsize=8,
                  transform=axes.transAxes, ha="right", color="#555555")
    drift = ours.drift is not None
    axes.set_ylabel("energy or momentum drift" if drift else "largest error / excursion",
                    fontsize=9, color=INK)


def legend(figure, results, top):
    engines = {p.engine for p in results.points}
    versions = {p.engine: p.version for p in results.points}
    entries = [Line2D([], [], color=INK, marker="*", markersize=14, linestyle="none",
                      markeredgecolor="white",
                      label="IsoGrasp, from nine finger force components")]
    entries += [Line2D([], [], color=color, marker=marker, markersize=5, linewidth=1.2,
                       label=f"{engine} {versions[engine]}")
                for engine, (color, marker) in LOOK.items() if engine in engines]
    if any(p.parts for p in results.points):
        entries.append(Line2D([], [], color=INK, marker="o", markersize=4.5, linewidth=1.1,
                              markerfacecolor="white", linestyle=(0, (2, 1.5)),
                              label="… its inner functions called one by one"))
    entries += [Line2D([], [], color=GREY, linewidth=1.3, linestyle=style,
                       label=f"by hand: {name}") for name, style in HAND.items()]
    figure.legend(handles=entries, loc="upper center", ncol=3, frameon=False, fontsize=9,
                  bbox_to_anchor=(0.5, top), columnspacing=2.4, handlelength=2.4)


def rounded(attribute):
    return re.sub(r"-?\d+\.\d{2,}", lambda n: f"{float(n[0]):.1f}", attribute[0])


def main(folder):
    results = Results(folder)
    scenes = results.compared()
    rows = (len(scenes) + 1) // 2
    plt.rcParams.update({"font.family": ["DejaVu Sans", "sans-serif"], "svg.hashsalt": "isograsp", "svg.fonttype": "none"})
    head = 1.12  # height of title and legend [in]
    height = 3.2 * rows + head
    figure, grid = plt.subplots(rows, 2, figsize=(11, height))
    figure.suptitle("What a frame of 10 ms costs, and how far the object is off over 60 s",
                    fontsize=14, fontweight="bold", color=INK, y=1 - 0.12 / height, va="top")
    legend(figure, results, 1 - 0.38 / height)
    for axes, scene in zip(grid.flat, scenes):
        panel(axes, scene, results.of(scene["scene"]), results.ours(scene["scene"]))
    for axes in grid.flat[len(scenes):]:
        axes.remove()
    for axes in grid[-1]:
        axes.set_xlabel("time per frame, one core (left and down is better)", fontsize=9,
                        color=INK)
    figure.tight_layout(rect=(0, 0, 1, 1 - head / height), h_pad=1.6, w_pad=2.0)
    picture = folder / "work_precision.svg"
    figure.savefig(picture, metadata={"Date": None})
    plt.close(figure)
    # A tenth of a point is as fine as anybody sees; without the rest the file is half as large.
    text = re.sub(r'\b(d|x|y)="[^"]*"', rounded, picture.read_text())
    text = text.replace("; stroke-linejoin: miter", "")
    picture.write_text(re.sub(r"\n *", "\n", text))


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
