# SPDX-License-Identifier: GPL-3.0-or-later
"""Which measures docs/measures.md defines, and in which version."""

import re
from pathlib import Path

DOCUMENT = Path(__file__).resolve().parents[2] / "docs" / "measures.md"
DERIVED = ("_share", "_restricted")


def versions():
    """Name of the measure -> version, from the headings."""
    found = {}
    for line in DOCUMENT.read_text(encoding="utf-8").splitlines():
        heading = re.match(r"### (.*?) · version (\d+)", line)
        if heading:
            for name in heading.group(1).split(", "):
                found[name.split(" ")[0]] = int(heading.group(2))
    return found


VERSIONS = versions()


def version_of(name):
    """None: the document does not know the measure."""
    if name in VERSIONS:
        return VERSIONS[name]
    for ending in DERIVED:
        name = name.removesuffix(ending)
    return VERSIONS.get(name)
