"""What is said of an executable that a launch file starts and that its package does not install (LCH002)."""

from __future__ import annotations

from ..checks.launch.executable_use import ExecutableUse, WellKnownUse
from ..checks.launch.without_package import PathUse
from ..package.package_facts import PackageFacts
from .offers import node_command


def not_offered(use: WellKnownUse) -> str:
    better = use.wrong.better
    raised = f" with \"executable '{use.name}' not found on the libexec directory\"" if "/" not in better else ""
    hint = f"; it is called `{better}` now" if use.wrong.is_removed and better else f"; did you mean `{better}`?"
    start = f"`{use.package}` has no executable `{use.name}`{' any more' if use.wrong.is_removed else ''}"
    return f"{start}: the launch stops{raised}{use.why and ', '}{use.why}{hint if better else ''}"


def without_package(use: PathUse) -> str:
    name, when = use.executable.literal, f", {use.why}" if use.why else ""
    ends = f"the launch stops with \"executable '{name}' not found on the PATH\"{when}"
    packages = " or ".join(f"`{each}`" for each in use.packages[:3])
    return f"the node has no package: {ends}; name the package: {packages}"


def hint(node: ExecutableUse, own: PackageFacts) -> str:
    if node.suggestion:
        return f"did you mean `{node.suggestion}`?"
    if node.in_folder:
        folder = f"lib/{node.facts.name}"
        return f"launch does not look into folders: install `{folder}/{node.in_folder}` into `{folder}` itself"
    if node.sister:
        return f"`{node.sister}` has one"
    there = ", ".join(f"`{name}`" for name in node.programs[:8])
    offered = node_command(node.facts, node.executable, own)
    return f"it installs {there or 'no executable at all'}" + (f"; `{offered}` writes one" if offered else "")
