"""SET307 pyproject-only."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.ament_python_files import AmentPythonFiles
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

BAD = manifest().replace("ament_python", "«ament_python»")
PYPROJECT = "[project]\nname = 'my_pkg'\nversion = '1.0.0'\n"


@rule(
    "SET307",
    "pyproject-only",
    over=AmentPythonFiles,
    severity=Severity.ERROR,
    examples=(
        Example(bad={"package.xml": BAD, "setup.py": None, "pyproject.toml": PYPROJECT}, good={"package.xml": None}),
    ),
)
def pyproject_only(build: AmentPythonFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds an ament_python package with a pyproject.toml and no setup.py.

    ## Why is this bad?
    colcon builds ament_python packages by running setup.py and does not read pyproject.toml yet. `data_files`, which
    install the marker, launch files and parameters, can't be declared there either. In addition to setup.py,
    pyproject.toml may hold the settings of tools.

    ## When it is quiet
    Where there is a setup.py, where the condition of the build type does not hold, and where pyproject.toml has a table
    for an extension of colcon, which builds the package from it (`[tool.colcon-poetry-ros.data-files]`).
    """
    if build.has_pyproject and not build.has_setup and not build.is_built_by_extension:
        for element in build.types:
            message = (
                "there is a pyproject.toml and no setup.py: colcon can't build an ament_python package from it yet; "
                "write a setup.py too"
            )
            yield Hit(build.manifest.path, build.manifest.span(element), message)
