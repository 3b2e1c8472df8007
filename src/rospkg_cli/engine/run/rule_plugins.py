"""Rules of other installed packages, where the user's config names them.

A package offers a module of rules under a name, as an entry point of the group `rospkg_cli.rules`. A config can only
name what is installed, never a path: the config of a repository that is linted loads no code of that repository. What
PYTHONPATH makes of a repository's own folders is not installed.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from contextlib import suppress
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ...disk_trace import current_trace, read_limited, scan
from ...lazy_regex import regex
from ...rule import PLUGGED_IN, Rule, rules_in
from ...rule_table import forget_rules, rule_entries
from ...search_path import installed_folders
from ...suggest import did_you_mean
from ...user_error import UserError
from ..selection import codes_named

GROUP = "rospkg_cli.rules"
CODE = regex(r"[A-Z]{3}[0-9]{3}")

LOADED_PLUGINS: set[str] = set()
"""The names of the plugins whose rules are known."""


class PluginError(UserError):
    """A plugin that can't be used; the message says which and what to do."""


def load_plugins(names: Iterable[str], *linted: Path) -> None:
    """Make the rules of the named plugins known, once; raises PluginError, for one in a linted folder too."""
    for name in names:
        load_plugin(name, (Path.cwd(), *linted))


def load_plugin(name: str, linted: tuple[Path, ...]) -> None:
    if name in LOADED_PLUGINS:
        return
    there = {point.name: point for point in entry_points(group=GROUP)}
    if name not in there:
        known = f"; installed are {', '.join(sorted(there))}" if there else "; no plugin is installed"
        hint = did_you_mean(name, there)
        raise PluginError(
            f"plugins: there is no plugin `{name}`{hint}{known}: install it where rospkg is installed, or remove it"
        )
    refuse_linted(there[name], linted)
    before = set(sys.modules)
    note_package(there[name])
    found = rules_of(there[name])
    note_modules(set(sys.modules) - before)
    own = {rule.code: rule.name for rule in rule_entries().values()}
    for code in found:
        if code in own or not CODE.fullmatch(code):
            why = (
                f"is that of the built-in rule `{own[code]}`"
                if code in own
                else "is not three uppercase letters and three digits"
            )
            raise PluginError(f"plugins: `{name}` has a rule `{code}`, and that code {why}")
    LOADED_PLUGINS.add(name)
    PLUGGED_IN.update(found)
    forget_rules()
    codes_named.cache_clear()


def refuse_linted(point: EntryPoint, linted: Iterable[Path]) -> None:
    """Raise PluginError for a plugin that lies in a linted folder and was not installed there by the user."""
    if point.dist is None:
        return
    place = Path(str(point.dist.locate_file(""))).resolve()
    if place in {Path(folder).resolve() for folder in installed_folders()}:
        return
    for folder in linted:
        if place.is_relative_to(folder.resolve()):
            why = f"lies in `{place}`, below `{folder}`, and nothing of what is linted is run"
            raise PluginError(
                f"plugins: `{point.name}` {why}: install it where rospkg is installed, or take it out of PYTHONPATH"
            )


def note_package(point: EntryPoint) -> None:
    """Let the trace of the run hold the files of a plugin's package, before they are loaded."""
    top = point.value.partition(":")[0].partition(".")[0]
    spec = find_spec(top) if current_trace() is not None and top else None
    if spec is not None and spec.origin is not None and not spec.submodule_search_locations:
        note_file(spec.origin)
    for folder in (spec.submodule_search_locations or ()) if spec else ():
        note_folder(folder)


def note_folder(folder: str) -> None:
    for entry in scan(folder):
        if not entry.is_dir(follow_symlinks=False):
            note_file(entry.path)
        elif entry.name != "__pycache__":
            note_folder(entry.path)


def note_modules(names: Iterable[str]) -> None:
    """Let the trace hold the modules that a plugin has loaded, wherever they lie."""
    if current_trace() is not None:
        for name in sorted(names):
            note_file(str(getattr(sys.modules.get(name), "__file__", None) or ""))


def note_file(path: str) -> None:
    with suppress(OSError):
        read_limited(path)


def rules_of(point: EntryPoint) -> dict[str, Rule[Any]]:
    try:
        found = rules_in(point.load())
    except Exception as error:
        raise PluginError(f"plugins: `{point.name}` can't be loaded: {type(error).__name__}: {error}") from error
    if not found:
        raise PluginError(f"plugins: `{point.name}` offers no rules: its entry point must name a module that has some")
    return found
