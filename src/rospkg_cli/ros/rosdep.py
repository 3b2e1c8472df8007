"""How a rosdep key resolves on Ubuntu, by the rules of REP-111 and of rosdep's own lookup."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

CODENAMES = {"22.04": "jammy", "24.04": "noble", "26.04": "resolute"}
"""The Ubuntu releases that the supported distributions stand on; rosdep's lists go by these names."""

INSTALLERS = ("apt", "pip", "gem", "snap", "source")
"""The installers of Ubuntu, first the one that rosdep prefers."""

NOT_THERE = "-"
"""A key that exists and has no rule for a release."""


def installer(entry: object, codename: str) -> str:
    """Return the installer that serves one key on one release of Ubuntu, or `-` where none does.

    `entry` is what a list of rosdep says of the key: operating system to rule, a rule being a list of packages, an
    installer's mapping, or either of these by release, where `*` stands for every release that is not named.
    """
    if not isinstance(entry, Mapping):
        return NOT_THERE
    found: Any = entry.get("ubuntu")
    if isinstance(found, Mapping) and not any(name in found for name in INSTALLERS):
        found = found[codename] if codename in found else found.get("*")
    if isinstance(found, Mapping):
        return next((name for name in INSTALLERS if name in found), NOT_THERE)
    return NOT_THERE if found is None else "apt"


def pip_names(entry: object, codename: str) -> tuple[str, ...]:
    """Return the names on PyPI that a key installs on one release of Ubuntu."""
    if installer(entry, codename) != "pip":
        return ()
    assert isinstance(entry, Mapping)
    found: Any = entry["ubuntu"]
    if "pip" not in found:
        found = found[codename] if codename in found else found["*"]
    listed: Any = found["pip"]
    packages = listed.get("packages", ()) if isinstance(listed, Mapping) else listed
    return tuple(str(name) for name in packages or ())
