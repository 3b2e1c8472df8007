"""What is wrong with a value in package.xml that its schema forbids, and where a missing tag goes (XML001)."""

from __future__ import annotations

from ...ros.manifest import REQUIRED


def faulty_value(tag: str, text: str) -> tuple[str, bool]:
    """Return what is wrong with a value, and whether colcon refuses it too."""
    if tag == "license":
        return "`<license>` is empty; name the license by its SPDX id, such as `Apache-2.0`", True
    if tag == "url":
        return f"`{text}` is no URL", False
    return f"`{text}` is no name of a group: REP-149 wants `a-z`, digits and single `_`, as for packages", False


def before(tag: str) -> str:
    """Return the required tag before one, in the schema's order."""
    place = REQUIRED.index(tag)
    return REQUIRED[place - 1] if place else "package"
