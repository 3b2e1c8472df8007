"""WSP005 nested-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.workspace.nested_packages import NestedPackages, Way
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...rule import rule
from ...source import Span

INNER = manifest().replace("<name>my_pkg</name>", "<name>my_driver</name>")
SENTENCES: dict[Way, str] = {
    "none": ": colcon does not look there, and never builds it; move it next to `{0}`, or remove its package.xml",
    "idle": ": colcon does not look there, and never builds it, and nothing here is known to need it: distributions "
    "have it, or nothing depends on it, uses it in code, or builds or runs it by its name; move it next to `{0}`, or "
    "remove its package.xml",
    "started": ": colcon finds it only where it is started below `{0}`, as a page or a script does here; move it next "
    "to `{0}`",
    "carried": ": colcon finds it only where it is linked, copied or named on its own, as a page or a script does "
    "here; move it next to `{0}`",
    "by hand": ": colcon does not look there, and a page or a script builds it by itself; declare what it needs in the "
    "package.xml of `{0}`, or move it next to `{0}`",
    "built": ", which builds it itself: nothing fails, but colcon and rosdep read no package.xml there; declare what "
    "it needs in that of `{0}`",
}
"""What is said of packages inside of one, by the way in which they get built."""


@rule(
    "WSP005",
    "nested-package",
    over=NestedPackages,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "distributions have them, or nothing depends on one, or builds, runs, imports or looks for it; "
        "all of them are for ROS 1, in a hidden folder, or built by the outer one; or a page or a script has colcon "
        "started below the outer one, brings them to another place, or builds them without colcon"
    },
    examples=(
        Example(
            bad={"driver/package.xml": "«»" + INNER, "README.md": "`ros2 run my_driver driver`\n"},
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
    templates, examples and third parties, and a package.xml that is installed as data, are left alone. Those that
    nothing is known to need are an info: no package depends on one, no launch file, code or CMake names it, and no page
    or script next to it builds or runs it (`ros2 run my_driver`, `--packages-select my_driver`). So are copies of what
    distributions have, which may be installed, unless a page or script builds one. So are packages for ROS 1, those in
    hidden folders, and those whose name a package has that colcon finds. So are those that colcon finds where a README,
    a script or a container starts it (`cd driver && colcon build`), as one shows, too, that takes what this leaves
    (`source driver/install/setup.bash`), those that one links, copies or mounts into a workspace (`ln -s`, `cp -r`,
    `COPY`), those that one builds without colcon (`cd serial && mkdir build && cd build && cmake ..`, `pip install
    ./serial`), and those whose folder the CMake of the outer package names: `add_subdirectory`, `ExternalProject_Add`,
    a target with their sources, a command of its own or of another package (`add_interfaces(my_msgs)`), or any other
    one with a path: only their package.xml is not read.

    ## References
    colcon/colcon-recursive-crawl: package_discovery/recursive_crawl.py
    """
    found = nested.ways()
    for way, sentence in SENTENCES.items():
        if way in found:
            message = f"is a package inside of `{nested.package.name}`{sentence.format(nested.package.name)}"
            yield of_all(found[way], message, None if way == "none" else Severity.INFO)


def of_all(found: list[str], message: str, level: Severity | None) -> Hit:
    first, *others = found
    folder = first.rpartition("/")[0]
    more = f" (and {len(others)} more)" if others else ""
    related = tuple(Related(path, Span(0, 0), "this one too") for path in others)
    return Hit(first, Span(0, 0), f"`{folder}`{more} {message}", level, related=related)
