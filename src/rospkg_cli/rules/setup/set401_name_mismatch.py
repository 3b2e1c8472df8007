"""SET401 name-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...edits.setup_py import replace_text
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

BAD = SETUP_PY.replace("name=package_name", "name='«your_pkg»'")


@rule(
    "SET401",
    "name-mismatch",
    over=PythonPackage,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "nothing but metadata goes to the other name, or launch files use that"},
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
    evaluated. A package without entry points that installs nothing but its marker and package.xml is a warning: colcon
    adds these two itself. So is one whose nodes launch files start by the name in setup.py: then package.xml is to be
    changed.

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
    end = "marker, launch files and parameters go to the other name" if used else "its metadata have the other name"
    message = (
        f"setup.py calls the package `{said.text}`, package.xml `{package.name}`: ROS goes by package.xml, and {end}; "
        f"write `{package.name}`"
    )
    is_felt = used and installs_more(package)
    if is_used(package, said.text):
        told = f"setup.py calls the package `{said.text}`, as launch files do, package.xml `{package.name}`"
        message = f"{told}: colcon and rosdep go by package.xml; write `{said.text}` there"
        yield Hit(said.path, said.shown, message, Severity.WARNING, related=related)
        return
    yield Hit(said.path, said.shown, message, None if is_felt else Severity.WARNING, related=related, fix=fix)


def is_used(package: PythonPackage, name: str) -> bool:
    """Return whether launch files of the workspace start nodes of the name in setup.py, and none of the other's."""
    started = {each for facts in package.workspace.packages for each, _ in facts.started_nodes}
    return name in started and package.name not in started and package.workspace.named(name) is None


def installs_more(package: PythonPackage) -> bool:
    """Return whether the package starts or installs more than marker and package.xml, which colcon adds itself."""
    sources = {file.source or "" for file in package.setup.data_files}
    more = {path for path in sources if path != package.manifest.path and not path.startswith("resource/")}
    return bool(more or package.setup.entry_points) or "data_files" in package.setup.unknown


def same(a: str, b: str) -> bool:
    """Return whether two names are one for setuptools."""
    return a.lower().replace("-", "_").replace(".", "_") == b.lower().replace("-", "_")
