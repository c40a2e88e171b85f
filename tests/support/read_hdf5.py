# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints an HDF5 file as JSON, as h5py reads it: groups as objects, attributes under "@", numbers of
float64 datasets as the hexadecimal text of their eight bytes, so that nothing is lost."""

import json
import sys

import h5py
import numpy as np


def plain(value):
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, np.ndarray):
        return [plain(one) for one in value]
    if isinstance(value, np.void):
        return {name: plain(value[name]) for name in value.dtype.names}
    if isinstance(value, np.bool_):
        return bool(value)
    if isinstance(value, np.integer):
        return int(value)
    if isinstance(value, np.floating):
        return value.astype("<f8").tobytes().hex()
    return value


def content(node):
    out = {"@": {name: plain(value) for name, value in node.attrs.items()}}
    if isinstance(node, h5py.Dataset):
        if node.chunks:
            out["filters"] = [node.compression, node.shuffle, node.fletcher32]
        out["value"] = plain(node[()])
    else:
        for name, child in node.items():
            out[name] = content(child)
    return out


with h5py.File(sys.argv[1], "r") as file:
    json.dump(content(file), sys.stdout)
