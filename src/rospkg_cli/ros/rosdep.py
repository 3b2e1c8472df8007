"""How a rosdep key resolves on Ubuntu, by the rules of REP-111 and of rosdep's own lookup."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

CODENAMES = {"22.04": "jammy", "24.04": "noble", "26.04": "resolute"}
"""The Ubuntu releases of the supported distributions, and their names in rosdep's lists."""

INSTALLERS = ("apt", "pip", "gem", "npm", "source")
"""The installers that rosdep has for Ubuntu, in the order in which it looks for them; apt where none is named."""

NOT_THERE = "-"
"""A key that exists and has no rule for a release."""

ANY = "*"
"""Any operating system, or any release, that is not named."""


def rule(entry: object, codename: str) -> tuple[str, Any] | None:
    """Return the installer that serves one key on one release of Ubuntu and its arguments; None where none does.

    `entry` is what a list of rosdep says of the key: operating system to rule, a rule being a list of packages, an
    installer's mapping, or either of these by release.
    """
    if not isinstance(entry, Mapping):
        return None
    found: Any = entry["ubuntu"] if "ubuntu" in entry else entry.get(ANY)
    if "ubuntu" not in entry and not isinstance(found, Mapping):
        return None
    way = named_installer(found)
    if isinstance(found, Mapping) and way is None:
        found = found[codename] if codename in found else found.get(ANY)
        way = named_installer(found)
    if way is not None:
        found = found[way]
    return (way or "apt", found) if isinstance(found, Mapping | list | str) else None


def named_installer(found: object) -> str | None:
    return next((name for name in INSTALLERS if name in found), None) if isinstance(found, Mapping) else None


def installer(entry: object, codename: str) -> str:
    """Return the installer that serves one key on one release of Ubuntu, or `-` where none does."""
    found = rule(entry, codename)
    return found[0] if found else NOT_THERE


def packages(entry: object, codename: str) -> tuple[str, ...]:
    """Return the names that the installer of a key gets on one release of Ubuntu."""
    found = rule(entry, codename)
    listed: Any = found[1] if found else ()
    if isinstance(listed, Mapping):
        listed = listed.get("packages")
    if isinstance(listed, str):
        listed = listed.split()
    return tuple(str(name) for name in listed) if isinstance(listed, list) else ()


def pip_names(entry: object, codename: str) -> tuple[str, ...]:
    """Return the names on PyPI that a key installs on one release of Ubuntu."""
    return packages(entry, codename) if installer(entry, codename) == "pip" else ()


def apt_name(entry: object, codename: str) -> str | None:
    """Return the package of Ubuntu that a key installs alone on a release; None where it installs none or several."""
    found = packages(entry, codename) if installer(entry, codename) == "apt" else ()
    return found[0] if len(found) == 1 else None


def merged(lists: Iterable[Mapping[Any, Any]]) -> dict[str, dict[Any, Any]]:
    """Return the entries of several lists as rosdep merges them: for each operating system the first one holds."""
    found: dict[str, dict[Any, Any]] = {}
    for each in lists:
        for key, entry in each.items():
            if isinstance(key, str) and isinstance(entry, Mapping):
                found[key] = {**entry, **found.get(key, {})}
    return found
