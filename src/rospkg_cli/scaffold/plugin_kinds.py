"""The kinds of plugins: what each derives from, and what it needs on each distribution."""

from __future__ import annotations

import sys
from functools import cache
from typing import Any

from ..light_dataclasses import dataclass
from ..resources import resources

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


@dataclass(frozen=True)
class PluginKind:
    """A kind of plugin as a distribution has it."""

    name: str
    title: str
    """What it is, in a few words."""
    does: str
    """The end of the sentence "a plugin that …"."""
    base: str
    """The class it derives from, with `{package}` for its own namespace; "" where pluginlib has no part in it."""
    libraries: dict[str, str]
    """What it needs: package to target, "" for a package with headers alone."""
    api: str
    """The name of the form that its interface has there; "" for the newest."""


@cache
def plugin_rows() -> dict[str, dict[str, Any]]:
    data: dict[str, dict[str, Any]] = tomllib.loads(
        (resources("templates") / "_shared" / "plugins.toml").read_text("utf-8")
    )
    return data


def plugin_kinds() -> tuple[str, ...]:
    """Return the names of all kinds."""
    return tuple(plugin_rows())


def plugin_title(name: str) -> str:
    return str(plugin_rows()[name]["title"])


@cache
def plugin_kind(name: str, distro: str) -> PluginKind:
    """Return a kind by its name, for a distribution."""
    row = plugin_rows()[name]
    special = row.get("on", {}).get(distro, {})
    special = row["on"][special["as"]] if "as" in special else special
    libraries = special.get("libraries", row["libraries"])
    return PluginKind(name, row["title"], row["does"], row["base"], libraries, special.get("api", ""))
