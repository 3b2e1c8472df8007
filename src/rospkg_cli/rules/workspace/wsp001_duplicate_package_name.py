"""WSP001 duplicate-package-name."""

from __future__ import annotations

from collections.abc import Iterator, Set

from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Severity
from ...package.workspace import Workspace
from ...rule import rule

MARKED = manifest(build_type="ament_cmake").replace("<name>my_pkg", "<name>«my_pkg»")


@rule(
    "WSP001",
    "duplicate-package-name",
    over=Workspace,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="",
            bad={
                "arm/my_pkg/package.xml": MARKED,
                "arm/my_pkg/CMakeLists.txt": CMAKE,
                "copy/my_pkg/package.xml": MARKED,
                "copy/my_pkg/CMakeLists.txt": CMAKE,
                "LICENSE": "Apache License\n",
            },
            good={"copy/my_pkg/package.xml": manifest(build_type="ament_cmake", name="my_copy")},
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
    Folders below an ignore marker (COLCON_IGNORE, AMENT_IGNORE, CATKIN_IGNORE) are no packages. Two workspaces side by
    side (`one_ws/src`, `other_ws/src`) are built apart; so is one within another where only the inner one is linted.
    """
    by_name: dict[str, list[tuple[str, str]]] = {}
    for facts in workspace.packages:
        by_name.setdefault(facts.name, []).append((facts.folder, facts.at("package.xml")))
    for facts in workspace.packages:
        others = [
            path
            for folder, path in by_name[facts.name]
            if folder != facts.folder and are_built_together(facts.folder, folder, workspace.selected)
        ]
        if others and facts.folder in workspace.selected:
            first = others[0].lstrip("/")
            message = (
                f"`{first}` is called `{facts.name}` too: colcon builds nothing (`Duplicate package names not "
                f"supported`); rename one, or put a COLCON_IGNORE into the copy"
            )
            spans = {f.at("package.xml"): f.name_span for f in workspace.packages}
            related = tuple(Related(path, spans[path], "the other one") for path in others)
            yield Hit(facts.at("package.xml"), facts.name_span, message, related=related)


def are_built_together(folder: str, other: str, selected: Set[str]) -> bool:
    """Return whether a colcon that is started for the first of two packages finds the other too."""
    here, there = root_of(folder), root_of(other)
    if here == there:
        return True
    is_nested = f"{here}/".startswith(f"{there}/" if there else "") or f"{there}/".startswith(
        f"{here}/" if here else ""
    )
    return is_nested and other in selected


def root_of(folder: str) -> str:
    """Return the folder that holds the outermost `src` around a package; the root of the run where there is none."""
    parts = folder.split("/")
    return "/".join(parts[: parts.index("src")]) if "src" in parts else ""
