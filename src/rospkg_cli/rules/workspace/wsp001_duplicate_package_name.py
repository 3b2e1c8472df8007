"""WSP001 duplicate-package-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...model.workspace import Workspace
from ...rule import rule


@rule(
    "WSP001",
    "duplicate-package-name",
    over=Workspace,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="",
            bad={
                "arm/package.xml": manifest(build_type="cmake").replace("my_pkg", "«my_pkg»"),
                "arm_copy/package.xml": manifest(build_type="cmake").replace("my_pkg", "«my_pkg»"),
            },
            good={"arm_copy/package.xml": manifest(build_type="cmake", name="my_copy")},
        ),
    ),
)
def duplicate_package_name(workspace: Workspace) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages of one workspace that have the same name. Folders below an ignore marker (COLCON_IGNORE) are no
    packages.

    ## Why is this bad?
    colcon refuses to build the whole workspace: "Duplicate package names not supported".
    """
    by_name: dict[str, list[tuple[str, str]]] = {}
    for facts in workspace.packages:
        by_name.setdefault(facts.name, []).append((facts.folder, facts.at("package.xml")))
    for facts in workspace.packages:
        others = [path for folder, path in by_name[facts.name] if folder != facts.folder]
        if others and facts.folder in workspace.given:
            first = others[0].lstrip("/")
            message = (
                f"`{first}` is called `{facts.name}` too: colcon refuses to build a workspace with two packages of one "
                f"name; rename one, or put a COLCON_IGNORE into the folder that is a copy"
            )
            spans = {f.at("package.xml"): f.name_span for f in workspace.packages}
            related = tuple(Related(path, spans[path], "the other one") for path in others)
            yield Hit(facts.at("package.xml"), facts.name_span, message, related=related)
