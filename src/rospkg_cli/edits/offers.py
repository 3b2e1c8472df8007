"""Commands of `rospkg add` that make what is missing, for messages."""

from __future__ import annotations

import posixpath

from ..checks.enumeration import in_ticks
from ..lazy_regex import regex
from ..package.package_facts import PackageFacts
from ..ros.manifest import PACKAGE_NAME

MAX_ALIKE = 3
LAUNCH = regex(r"launch/(?P<name>[A-Za-z0-9][\w-]*[._]launch\.(?:py|xml|yaml))")
PARAMS = regex(r"(?P<name>(?:config|params?|cfg)/[A-Za-z0-9][\w-]*)\.yaml")


def how_to_have(facts: PackageFacts, path: str, own: PackageFacts) -> str:
    """Return what to do about a share file that a package does not have: where others of its name are, how it is made.

    `own` is the package in which a command is typed.
    """
    end = f"/{posixpath.basename(path)}"
    if alike := sorted(each for each in facts.share_files if each.endswith(end))[:MAX_ALIKE]:
        return f"correct the path: there {'are' if alike[1:] else 'is'} {in_ticks(alike)}"
    made = file_command(facts, path, own)
    return f"`{made}` adds it, or correct the path" if made else "add it, or correct the path"


def file_command(facts: PackageFacts, path: str, own: PackageFacts) -> str:
    """Return the command that makes a launch file or a file of parameters in a package; "" where none does.

    `own` is the package in which the command is typed.
    """
    if found := LAUNCH.fullmatch(path):
        return command(facts, f"launch {found['name']}", own)
    found = PARAMS.fullmatch(path)
    return command(facts, f"params {found['name']}", own) if found else ""


def node_command(facts: PackageFacts, executable: str, own: PackageFacts) -> str:
    """Return the command that makes a node of a package; "" for a name that no node has, or that a module has."""
    is_name = PACKAGE_NAME.fullmatch(executable) and executable != facts.name
    is_module = any(each.rpartition(".")[2] == executable for each in facts.modules)
    return command(facts, f"node {executable}", own) if is_name and not is_module else ""


def command(facts: PackageFacts, what: str, own: PackageFacts) -> str:
    if facts.build_type not in ("ament_python", "ament_cmake"):
        return ""
    return f"rospkg add {what}" + ("" if facts.name == own.name else f" --package {facts.name}")
