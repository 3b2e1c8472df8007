"""Commands of `rospkg add` that make what is missing, for messages."""

from __future__ import annotations

from ..lazy_regex import regex
from ..package.package_facts import PackageFacts
from ..ros.manifest import PACKAGE_NAME

LAUNCH = regex(r"launch/(?P<name>[A-Za-z0-9][\w-]*[._]launch\.(?:py|xml|yaml))")
PARAMS = regex(r"(?P<name>(?:config|params?|cfg)/[A-Za-z0-9][\w-]*)\.yaml")


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
