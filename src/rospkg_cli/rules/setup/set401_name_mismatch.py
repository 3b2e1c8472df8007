"""SET401 name-mismatch."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...edits.setup_py import replace_text
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.setup.python_install_table import MARKERS
from ...ros.share_layout import LAUNCH
from ...rule import rule

BAD = SETUP_PY.replace("name=package_name", "name='«your_pkg»'")


@rule(
    "SET401",
    "name-mismatch",
    over=PythonPackage,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "no launch file goes to the other name, or launch files or marker and setup.cfg use that"
    },
    examples=(
        Example(
            bad={"setup.py": BAD},
            good={"setup.py": SETUP_PY.replace("name=package_name", "name='my_pkg'")},
            fix=Safety.SAFE,
        ),
    ),
)
def name_mismatch(package: PythonPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds a name in setup.py that differs from the one in package.xml.

    ## Why is this bad?
    colcon goes by package.xml, setuptools by setup.py: the metadata of the installed package carry the other name,
    `importlib.metadata` does not find it, and where the name is used for destinations too, the marker and the launch
    files of one package are installed as another's.

    ## When it is quiet
    Where the names differ only in `-`, `_`, `.` or case, which setuptools takes for one, and where the name can't be
    evaluated. It is a warning where no launch file is installed under the other name, since colcon adds marker and
    package.xml itself, and where a marker of that name is there, by which `ros2 launch` finds it. Where launch files
    start nodes by the name in setup.py, or marker and setup.cfg have that one alone, package.xml is to be changed.

    ## Fix safety
    Where the name is held by a variable that is used elsewhere, other things change with it.
    """
    said = package.setup.setup_text("name")
    if said is None or same(said.text, package.name):
        return
    used = package.setup.used_elsewhere(said)
    edits = replace_text(said, package.name)
    safety = Safety.UNSAFE if used else Safety.SAFE
    fix = Fix(f"write `{package.name}`", edits, safety) if edits else None
    related = (Related(package.manifest.path, package.manifest.name_span, "the name in package.xml"),)
    end, level = what_ends(package, said.text) if used else ("its metadata have the other name", Severity.WARNING)
    message = (
        f"setup.py calls the package `{said.text}`, package.xml `{package.name}`: ROS goes by package.xml, and {end}; "
        f"write `{package.name}`"
    )
    if user := who_means(package, said.text):
        message = (
            f"setup.py calls the package `{said.text}`, as {user} do, package.xml `{package.name}`: colcon and rosdep "
            f"go by package.xml; write `{said.text}` there"
        )
        yield Hit(said.path, said.shown, message, Severity.WARNING, related=related)
        return
    yield Hit(said.path, said.shown, message, level, related=related, fix=fix)


def who_means(package: PythonPackage, name: str) -> str:
    """Return what has the name in setup.py, and not the other one: launch files, marker and setup.cfg; "" for none."""
    if package.workspace.named(name) is not None:
        return ""
    if is_started(package, name):
        return "launch files"
    is_marked = package.files.exists(f"resource/{name}") and not package.files.exists(f"resource/{package.name}")
    return "marker and setup.cfg" if is_marked and f"/lib/{name}" in package.files.readable_text("setup.cfg") else ""


def is_started(package: PythonPackage, name: str) -> bool:
    """Return whether launch files of the workspace start nodes of the name in setup.py, and none of the other's."""
    started = {each for facts in package.workspace.packages for each, _ in facts.started_nodes}
    return name in started and package.name not in started


def what_ends(package: PythonPackage, name: str) -> tuple[str, Severity | None]:
    """Return what the name in setup.py does where it is used for destinations too, and the level; None for an error.

    By a marker of that name `ros2 launch` finds the launch files; one that is not there stops the build.
    """
    installed = {each.destination: each.source or "" for each in package.setup.data_files}
    marker = installed.get(f"{MARKERS}/{name}")
    if marker == f"resource/{name}" and package.setup.kind(marker) is None:
        return f"the build stops, since there is no `{marker}`", None
    starts = (posixpath.basename(file) for path, file in installed.items() if path.startswith(f"share/{name}/"))
    is_felt = marker is None and any(map(LAUNCH.fullmatch, starts))
    return "its files go to share/ of the other name", None if is_felt else Severity.WARNING


def same(a: str, b: str) -> bool:
    """Return whether two names are one for setuptools."""
    return a.lower().replace("-", "_").replace(".", "_") == b.lower().replace("-", "_")
