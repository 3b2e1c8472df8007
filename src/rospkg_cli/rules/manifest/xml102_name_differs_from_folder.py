"""XML102 name-differs-from-folder."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePosixPath

from ...checks.manifest.manifest_inputs import ManifestInFolder
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import Profile, rule

CMAKE = "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
GOOD = manifest(build_type="ament_cmake")


@rule(
    "XML102",
    "name-differs-from-folder",
    over=ManifestInFolder,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            on="",
            bad={
                "LICENSE": "Apache License\n",
                "my_package/package.xml": GOOD.replace("my_pkg", "«my_pkg»"),
                "my_package/CMakeLists.txt": CMAKE,
            },
            good={
                "my_package/package.xml": None,
                "my_package/CMakeLists.txt": None,
                "my_pkg/package.xml": GOOD,
                "my_pkg/CMakeLists.txt": CMAKE,
            },
        ),
    ),
)
def name_differs_from_folder(package: ManifestInFolder) -> Iterator[Hit]:
    """
    ## What it does
    Finds a name in package.xml that differs from the name of the package's folder.
    The folder that is the root of the run is left out: a repository may be cloned under any name.

    ## Why is this bad?
    It is allowed, but confusing: `ros2 run` and `colcon build --packages-select` take the name, `cd` the folder.

    ## When it is quiet
    It runs with `--pedantic` alone. The folder that is the root of the run may have any name.

    ## References
    - [REP-149, name](https://ros.org/reps/rep-0149.html): "It may differ from the folder name into which it is checked
      out, but that is not recommended."
    """
    folder = PurePosixPath(package.facts.folder).name
    name = package.manifest.name
    if folder and name and folder != name:
        message = f"the package `{name}` is in a folder called `{folder}`; rename the folder, or the package"
        yield Hit(package.manifest.path, package.manifest.name_span, message)
