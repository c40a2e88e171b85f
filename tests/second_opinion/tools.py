# SPDX-License-Identifier: GPL-3.0-or-later
"""The mathematics that measures share (docs/measures.md, Exact rules)."""

import math

import numpy as np

from record import EPSILON_S, holds_of


def weighted_mean(x, w):
    return float(np.sum(w * x) / np.sum(w))


def line(t, x):
    """Least-squares line without weights: slope, and SD (n - 1) of what is left."""
    centred = t - np.mean(t)
    slope = np.sum(centred * (x - np.mean(x))) / np.sum(centred**2)
    rest = x - np.mean(x) - slope * centred
    return float(slope), float(math.sqrt(np.sum(rest**2) / (len(x) - 1)))


def sd(x):
    """SD of n - 1, without weights."""
    return float(np.std(x, ddof=1))


def best_window(x, hold, counts, length):
    """Largest mean over an uninterrupted `length`; None where no window fits. All rows of a part."""
    if not len(x):
        return None
    ends = np.cumsum(hold)
    starts = ends - hold
    area = np.concatenate(([0.0], np.cumsum(np.where(counts, hold * x, 0.0))))
    broken = np.concatenate(([0], np.cumsum(~counts)))
    first = np.arange(len(x))
    last = np.searchsorted(ends, starts + length * (1 - 1e-9))
    fits = last < len(x)
    first, last = first[fits], last[fits]
    whole = broken[last + 1] == broken[first]
    first, last = first[whole], last[whole]
    reach = np.minimum(starts[first] + length - starts[last], hold[last])
    means = (area[last] - area[first] + reach * x[last]) / length
    return float(np.max(means)) if len(means) else None


def stretches(t, condition, least):
    """Stretches in which the condition lasts at least so long: first and last row (inclusive) of each."""
    if len(t) < 2:
        return []
    step = float(np.median(np.diff(t)))
    found, first = [], None
    for k in range(len(t) + 1):
        goes_on = k < len(t) and condition[k] and (first is None or t[k] - t[k - 1] <= 2.5 * step)
        if goes_on:
            first = k if first is None else first
            continue
        if first is not None and t[k - 1] - t[first] + step >= least - EPSILON_S:
            found.append((first, k - 1))
        first = k if k < len(t) and condition[k] else None
    return found


def crossing(t, x, k, level):
    """Time at which the line from row k - 1 to row k reaches the level."""
    return float(t[k - 1] + (level - x[k - 1]) / (x[k] - x[k - 1]) * (t[k] - t[k - 1]))


def uniform(t, *columns):
    """Columns on a uniform grid, and its step."""
    if len(t) < 2:
        return (math.nan, *columns)
    if holds_of(t)[1]:
        return (t[1] - t[0], *columns)
    step = float(np.median(np.diff(t)))
    count = int(math.floor((t[-1] - t[0]) / step + 1e-9)) + 1
    grid = t[0] + np.arange(count) * step
    return (step, *(np.interp(grid, t, x) for x in columns))


def differences(x, step):
    """Central differences, one-sided at the ends."""
    d = np.empty(len(x))
    d[1:-1] = (x[2:] - x[:-2]) / (2 * step)
    d[0], d[-1] = (x[1] - x[0]) / step, (x[-1] - x[-2]) / step
    return d


def low_pass(x, step):
    """Butterworth of second order, 5 Hz, forward and backward."""
    w = math.tan(5 * math.pi * step)
    a0 = 1 + math.sqrt(2) * w + w * w
    b, a1, a2 = w * w / a0, 2 * (w * w - 1) / a0, (1 - math.sqrt(2) * w + w * w) / a0
    m = min(math.ceil(math.log(1e-6) / math.log(math.sqrt(a2))), len(x) - 1)
    x = np.concatenate((2 * x[0] - x[m:0:-1], x, 2 * x[-1] - x[-2:-m - 2:-1]))

    def one_pass(x):
        u1 = u2 = y1 = y2 = x[0]
        out = []
        for u in x:
            y = b * (u + 2 * u1 + u2) - a1 * y1 - a2 * y2
            u1, u2, y1, y2 = u, u1, y, y1
            out.append(y)
        return out

    y = one_pass(one_pass(x.tolist())[::-1])[::-1]
    return np.array(y[m:len(y) - m])


def rate(t, x):
    """dF/dt of the low-passed force on its uniform grid; None where there are too few samples."""
    step, x = uniform(t, x)
    if len(x) < 3 or 1 / step <= 10:
        return None
    return differences(low_pass(x, step), step)


def speed(t, *axes):
    """Step, and size of the velocity on the uniform grid."""
    step, *axes = uniform(t, *axes)
    if len(axes[0]) < 2:
        return step, None
    return step, np.sqrt(sum(differences(x, step)**2 for x in axes))


def quantile(x, w, q):
    """Smallest value with at least q of the whole weight at or below it."""
    order = np.argsort(x, kind="stable")
    reached = np.cumsum(w[order]) >= (q - 1e-9) * np.sum(w)
    return float(x[order][np.argmax(reached)])


def kaplan_meier(times, limit):
    """Waits (time, came) -> median or None, restricted mean or None."""
    times = sorted(times, key=lambda x: x[0])
    moments = sorted({t for t, _ in times})
    s, median, area, last = 1.0, None, 0.0, 0.0
    for moment in moments:
        trying = sum(1 for t, event in times if t >= (moment if event else moment - 1e-6))
        came = sum(1 for t, event in times if event and t == moment)
        upto = min(moment, limit)
        area += s * (upto - last)
        last = upto
        s *= 1 - came / trying
        if median is None and s <= 0.5 + 1e-12:
            median = moment
    return median, area + s * (limit - last), s


def pearson(x, y):
    """Correlation, 0 where one of the two does not vary."""
    x, y = x - np.mean(x), y - np.mean(y)
    size = math.sqrt(np.sum(x * x) * np.sum(y * y))
    return float(np.sum(x * y) / size) if size > 0 else 0.0


def best_shift(reference, signal, most):
    """Correlation of reference(k) and signal(k + shift) at every whole shift of -most … most (dict)."""
    n, r = len(reference), {}
    for shift in range(-most, most + 1):
        first, last = max(0, -shift), min(n, n - shift)
        if last - first >= 3:
            r[shift] = pearson(reference[first:last], signal[first + shift:last + shift])
    return r


def parabola(before, at, after):
    """Where between two neighbours the peak lies, in steps."""
    bend = before - 2 * at + after
    return 0.0 if bend == 0 else (before - after) / (2 * bend)


def spectrum(step, x):
    """Welch's estimate of x minus its line: frequencies, density; None if it is too short."""
    n = round(4 / step)
    if n < 8 or len(x) < n:
        return None
    k = np.arange(len(x)) - (len(x) - 1) / 2
    x = x - np.mean(x) - k * (np.sum(k * x) / np.sum(k * k))
    window = 0.5 - 0.5 * np.cos(2 * math.pi * np.arange(n) / n)
    length = 2 * 2**math.ceil(math.log2(n))
    starts = range(0, len(x) - n + 1, n // 2)
    power = sum(np.abs(np.fft.rfft(x[i:i + n] * window, length))**2 for i in starts)
    density = 2 * step * power / (len(starts) * np.sum(window**2))
    return np.arange(length // 2 + 1) / (length * step), density


def power_between(f, density, low, high):
    """Integral of the density: every line is a bar of its own width."""
    half = f[1] / 2
    width = np.minimum(f + half, high) - np.maximum(f - half, low)
    return float(np.sum(density * np.maximum(width, 0)))
