"""WSP001 duplicate-package-name."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Set

from ...checks.workspace.built_apart import are_of_two, why_apart
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Severity
from ...lazy_regex import regex
from ...package.file_role import is_set_aside
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...rule import rule

WORKSPACE = regex(r"(.+[_-])?(ws|workspace)\d*|extra_packages", re.IGNORECASE)
"""Folders that are built alone; in `extra_packages` micro-ROS looks for what it builds for a board."""
MARKED = manifest(build_type="ament_cmake").replace("<name>my_pkg", "<name>«my_pkg»")


@rule(
    "WSP001",
    "duplicate-package-name",
    over=Workspace,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "no `src` and no folder called `…_ws` is above one of them, or one is laid aside",
        Severity.INFO: "one of them is for ROS 1, lies outside of the workspace around the other, or their folders are "
        "called as for different distributions or, with no `src` above, numbered as steps or called as for a robot and "
        "for what is none, or for a task and its solution",
    },
    examples=(
        Example(
            on="",
            bad={
                "src/arm/my_pkg/package.xml": MARKED,
                "src/arm/my_pkg/CMakeLists.txt": CMAKE,
                "src/copy/my_pkg/package.xml": manifest(build_type="ament_cmake"),
                "src/copy/my_pkg/CMakeLists.txt": CMAKE,
                "LICENSE": "Apache License\n",
            },
            good={"src/copy/my_pkg/package.xml": manifest(build_type="ament_cmake", name="my_copy")},
        ),
    ),
)
def duplicate_package_name(workspace: Workspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages of one workspace that have the same name.

    ## Why is this bad?
    colcon refuses to build the whole workspace: "Duplicate package names not supported".

    ## When it is quiet
    Folders below an ignore marker (COLCON_IGNORE, AMENT_IGNORE, CATKIN_IGNORE) are no packages. Two workspaces side
    by side (`one_ws/src` and `other_ws`, `ws/one/src` and `ws/other/src`) are built apart; so is one within another
    where only the inner one is linted. Folders that are called as for different distributions (`humble/`, `jazzy/`)
    are built one at a time: an info. So are those that are numbered as the steps of a course (`week1/`, `week2/`;
    `17-publisher`, `21-interfaces`), or for a robot and what is none (`robot/` and `laptop/`, `real/` and `sim/`),
    or for a task and its solution (`exercises/` and `solutions/`, `start/` and `final/`, `lab1` and `lab1_solution`),
    unless a `src` or a folder called as a workspace is above them. So is a copy outside of the folder called as a
    workspace that the other one lies in: nothing shows that colcon is started above both. All packages of one name
    are one finding.
    """
    for facts, copies in ((each, same) for same in workspace.repeated for each in same):
        others = [each for each in copies if each is not facts and are_built_together(facts, each, workspace.selected)]
        earlier = [each for each in copies[: copies.index(facts)] if each in others]
        if facts.folder not in workspace.selected or any(each.folder in workspace.selected for each in earlier):
            continue
        if others:
            first = others[0].at("package.xml").lstrip("/")
            level = max((level_of(facts, each) for each in others), key=lambda each: each.rank)
            end = "colcon builds nothing" if level is Severity.ERROR else "a colcon that finds both builds nothing"
            if all(root_of(each.folder) != root_of(facts.folder) for each in others):
                end = "a colcon that is started above both, as nothing shows here, builds nothing"
            message = (
                f"`{first}` is called `{facts.name}` too: {end} (`Duplicate package names not "
                f"supported`); rename one, or put a COLCON_IGNORE into the copy"
            )
            if level is Severity.INFO:
                reasons = {why_apart(facts.folder, each.folder) for each in others}
                message += reasons.pop() if len(reasons) == 1 else ""
            related = tuple(Related(each.at("package.xml"), each.name_span, "the other one") for each in others)
            yield Hit(facts.at("package.xml"), facts.name_span, message, level, related=related)


def level_of(facts: PackageFacts, other: PackageFacts) -> Severity:
    """Return the level: an error where a workspace is above both and none between, so that colcon finds both."""
    if facts.is_for_ros1 != other.is_for_ros1 or root_of(facts.folder) != root_of(other.folder):
        return Severity.INFO
    one, two = (each.folder.split("/")[:-1] for each in (facts, other))
    shared = len(posixpath.commonprefix([one, two]))
    if are_of_two(*("/".join(each[shared:]) for each in (one, two))):
        return Severity.INFO
    is_one = any(map(is_root, one[:shared])) and not any(map(is_root, one[shared:] + two[shared:]))
    is_aside = any(is_set_aside(f"{each.folder}/") for each in (facts, other))
    if not is_one and why_apart(facts.folder, other.folder):
        return Severity.INFO
    return Severity.ERROR if is_one and not is_aside else Severity.WARNING


def is_root(name: str) -> bool:
    """Return whether a folder is a workspace or its sources, by its name."""
    return name == "src" or WORKSPACE.fullmatch(name) is not None


def are_built_together(facts: PackageFacts, other: PackageFacts, selected: Set[str]) -> bool:
    """Return whether a colcon that is started for the first of two packages finds the other too."""
    here, there = root_of(facts.folder), root_of(other.folder)
    if here == there:
        return True
    is_nested = f"{here}/".startswith(f"{there}/" if there else "") or f"{there}/".startswith(
        f"{here}/" if here else ""
    )
    return is_nested and other.folder in selected


def root_of(folder: str) -> str:
    """Return the outermost workspace around a package, by `src` in it or its name; the root of the run without one.

    A folder that is called a workspace and holds others with a `src` is none itself (`ros2_ws/arm/src`).
    """
    parts = folder.split("/")
    for at, part in enumerate(parts):
        if part == "src" or (WORKSPACE.fullmatch(part) and parts[at + 2 : at + 3] != ["src"]):
            return "/".join(parts[: at + (part != "src")])
    return ""
