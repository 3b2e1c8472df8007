"""Nodes that Python modules describe (`Node(package=…)`) for launch files which they generate."""

from __future__ import annotations

from ...ros.implied_dependencies import IN_LAUNCH_FILES, implied_by
from ..launch.package_reference import NAME, PackageReference
from .undeclared_launch_packages import LaunchDependencies


def nodes_in_code(launch: LaunchDependencies, *, tests: bool = False) -> dict[str, list[PackageReference]]:
    """Return the undeclared packages of nodes that code alone describes, with the places: code of tests, or installed.

    Installed code may generate launch files for other packages, which declare what they start.
    """
    found: dict[str, list[PackageReference]] = {}
    roles = ("test",) if tests else ("run", "launch")
    if launch.declared.is_checked:
        there = implied_by(launch.declared.names, IN_LAUNCH_FILES) | launch.missing(tests=False).keys()
        if tests:
            there |= launch.missing(tests=True).keys() | nodes_in_code(launch).keys()
        known = (file for file in launch.launch_files if file.nodes or (file.is_complete and file.has_entry_point))
        launches = {file.path for file in known}
        for file in launch.python.files:
            for node in file.nodes if file.role in roles and file.path not in launches else ():
                if NAME.fullmatch(node.package) and not launch.declared.has([node.package]):
                    use = PackageReference(node.package, file.path, node.span, "describes a node of")
                    found.setdefault(node.package, []).append(use)
        there |= {name for name in found if tests and launch.unknown.has(name)}  # made up, often
        found = {name: uses for name, uses in found.items() if name not in there}
    return found
