"""WSP005 nested-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.workspace.nested_packages import NestedPackages
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...rule import rule
from ...source import Span

INNER = manifest().replace("<name>my_pkg</name>", "<name>my_driver</name>")


@rule(
    "WSP005",
    "nested-package",
    over=NestedPackages,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "all of them are for ROS 1, or in a hidden folder, so that nobody means colcon to build them"
    },
    examples=(
        Example(
            bad={"driver/package.xml": "«»" + INNER},
            good={"driver/package.xml": None},
        ),
    ),
)
def nested_package(nested: NestedPackages) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages inside of a package.
    The folder of a package holds another folder with a package.xml.

    ## Why is this bad?
    colcon does not look for packages below a package: `colcon list` does not show the inner one, and it is never built.

    ## When it is quiet
    Folders with an ignore marker (COLCON_IGNORE, AMENT_IGNORE, CATKIN_IGNORE), those that git ignores, those of tests,
    templates, examples and third parties, and a package.xml that is installed as data, are left alone. Packages for
    ROS 1, those in hidden folders, and those whose name a package has that colcon finds are an info.

    ## References
    colcon/colcon-recursive-crawl: package_discovery/recursive_crawl.py
    """
    found = list(nested.manifests())
    if not found:
        return
    first, *others = found
    folder = first.rpartition("/")[0]
    more = f" (and {len(others)} more)" if others else ""
    outer = nested.package.name
    message = (
        f"`{folder}`{more} is a package inside of `{outer}`: colcon does not look there, and never builds it; "
        f"move it next to `{outer}`, or remove its package.xml"
    )
    related = tuple(Related(path, Span(0, 0), "this one too") for path in others)
    level = None if any(map(nested.may_be_meant, found)) else Severity.INFO
    yield Hit(first, Span(0, 0), message, level, related=related)
