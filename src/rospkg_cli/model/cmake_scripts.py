"""Executables of Python packages that CMake installs: the entry points that setup.cfg gives them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from .cmake.call import flags_and_values
from .cmake.installs import below_prefix
from .cmake.project import CMake
from .install import Installed, InstallTable, NotKnown
from .setup.cfg import SetupCfg
from .setup.entry_points import EntryPoint, parse_entry_point

SINGLES = ("VERSION", "PACKAGE_DIR", "SETUP_CFG", "DESTINATION", "SCRIPTS_DESTINATION")


def python_scripts(cmake: CMake, cfg: SetupCfg | None) -> InstallTable:
    """Return what `ament_python_install_package` makes of `[options.entry_points]`: programs, in bin/ if unsaid."""
    rows: list[Installed] = []
    unknown: list[NotKnown] = []
    for call in cmake.named("ament_python_install_package"):
        _, values, _ = flags_and_values(call.words, ("SKIP_COMPILE",), SINGLES, ())
        other = next(iter(values.get("SETUP_CFG", [])), None)
        if other is not None and posixpath.basename(other.text) != "setup.cfg":
            unknown.append(NotKnown("executable", f"`{other.text}` may name executables", call.path, other.span))
            continue
        place = next((below_prefix(word.text) for word in values.get("SCRIPTS_DESTINATION", [])), "bin")
        for entry in scripts_in(cfg) if cfg is not None and not call.folder else ():
            if place is None:
                unknown.append(NotKnown("executable", "where scripts go can't be told", call.path, call.command.span))
                break
            code = f"{entry.module}:{entry.attribute}"
            rows.append(Installed("executable", f"{place}/{entry.name}", "", code, entry.path, entry.span))
    return InstallTable(tuple(rows), tuple(unknown))


def scripts_in(cfg: SetupCfg) -> Iterator[EntryPoint]:
    for option in cfg.options("options.entry_points"):
        entries = (parse_entry_point(option.key, line) for line in option.value.lines())
        yield from (entry for entry in entries if entry.script and entry.name and not entry.fault)
