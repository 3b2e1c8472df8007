"""WSP001 duplicate-package-name."""

from __future__ import annotations

from collections.abc import Iterator

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
    Folders below an ignore marker (COLCON_IGNORE, AMENT_IGNORE, CATKIN_IGNORE) are no packages.
    """
    by_name: dict[str, list[tuple[str, str]]] = {}
    for facts in workspace.packages:
        by_name.setdefault(facts.name, []).append((facts.folder, facts.at("package.xml")))
    for facts in workspace.packages:
        others = [path for folder, path in by_name[facts.name] if folder != facts.folder]
        if others and facts.folder in workspace.selected:
            first = others[0].lstrip("/")
            message = (
                f"`{first}` is called `{facts.name}` too: colcon builds nothing (`Duplicate package names not "
                f"supported`); rename one, or put a COLCON_IGNORE into the copy"
            )
            spans = {f.at("package.xml"): f.name_span for f in workspace.packages}
            related = tuple(Related(path, spans[path], "the other one") for path in others)
            yield Hit(facts.at("package.xml"), facts.name_span, message, related=related)
