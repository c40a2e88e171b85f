# SPDX-License-Identifier: GPL-3.0-or-later
"""sparc, ldlj, sample entropy."""

import math

import numpy as np

from tools import speed, uniform


def sparc(step, v):
    """Spectral arc length of a speed."""
    if v is None or not np.max(np.abs(v)) > 0:
        return None
    length = 2**(math.ceil(math.log2(len(v))) + 4)
    size = np.abs(np.fft.rfft(v, length))
    size = size / np.max(size)
    f = np.arange(len(size)) / (length * step)
    size, f = size[f <= 10 + 1e-9], f[f <= 10 + 1e-9]
    loud = np.flatnonzero(size >= 0.05)
    size, f = size[loud[0]:loud[-1] + 1], f[loud[0]:loud[-1] + 1]
    if len(f) < 2:
        return None
    return -float(np.sum(np.hypot(np.diff(f) / (f[-1] - f[0]), np.diff(size))))


def ldlj(step, v):
    """Log dimensionless jerk of a speed."""
    if v is None or len(v) < 3 or not np.max(np.abs(v)) > 0:
        return None
    jerk = np.diff(v, 2) / step**2
    total = np.sum(jerk**2) * step
    if not total > 0:
        return None
    return -math.log((len(v) * step)**3 / np.max(np.abs(v))**2 * total)


def of_motion(t, *axes):
    """Both, of one stretch."""
    step, v = speed(t, *axes)
    return sparc(step, v), ldlj(step, v)


def of_force(t, force):
    """Both, of the size of dF/dt."""
    return of_motion(t, force)


def sample_entropy(t, x):
    """m = 2, r = 0.2 population SD; None without a match."""
    if len(x) < 4:
        return None
    _, x = uniform(t, x)
    n, r = len(x), 0.2 * float(np.std(x))
    if n < 4 or not r > 0:
        return None
    b = a = 0
    for k in range(n - 3):
        near = (np.abs(x[k + 1:n - 2] - x[k]) <= r) & (np.abs(x[k + 2:n - 1] - x[k + 1]) <= r)
        b += int(np.sum(near))
        a += int(np.sum(near & (np.abs(x[k + 3:n] - x[k + 2]) <= r)))
    return -math.log(a / b) if a and b else None
