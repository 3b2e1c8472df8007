"""XML301 missing-build-type."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.foreign_build import foreign_maker
from ...checks.manifest.manifest_and_cmake import ManifestAndCMake
from ...checks.repository.linked_build import merging_file
from ...edits.manifest import add_export
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

GOOD = manifest()
EXPORT = "  <export>\n    <build_type>ament_python</build_type>\n  </export>\n"


@rule(
    "XML301",
    "missing-build-type",
    over=ManifestAndCMake,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it has no programs but those of tests, or uninstalled ones next to a library, and no launch "
        "files, is not certainly of ament_cmake, or all is installed into one folder (`--merge-install`)",
        Severity.INFO: "plain CMake or another build system makes it, CMake builds and installs nothing, or there is "
        "nothing to build",
    },
    examples=(
        Example(
            bad={"package.xml": GOOD.replace(EXPORT, "").replace('<package format="3">', '«<package format="3">»')},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={
                "package.xml": manifest(build_type="ament_cmake")
                .replace("<build_type>ament_cmake</build_type>", "<x/>")
                .replace("<export>", "«<export>»")
            },
            good={
                "package.xml": manifest(build_type="ament_cmake").replace(
                    "<build_type>ament", "<x/>\n    <build_type>ament"
                )
            },
            fix=Safety.SAFE,
        ),
    ),
)
def missing_build_type(package: ManifestAndCMake) -> Iterator[Hit]:
    """
    ## What it does
    Finds manifests without a `<build_type>` (in `<export>`) that holds in ROS 2.
    Packages that depend on catkin and on no ament_cmake are ROS 1's, and left alone.

    ## Why is this bad?
    Without one the package counts as a catkin package. Of Python, the build stops with "does not appear to contain
    CMakeLists.txt". With CMake the build is green, and colcon does not put the package on AMENT_PREFIX_PATH: `ros2 run`
    and `ros2 launch` end with "Package 'my_pkg' not found", unless it was built with --merge-install.

    ## When it is quiet
    Packages that depend on catkin and on no ament_cmake are for ROS 1, and so are those whose CMakeLists.txt calls
    `catkin_package()` in one branch and `ament_package()` in none. A build type under a condition counts where the
    condition may hold for a target. It is an info for plain CMake, which is found by `find_package` alone, and where
    CMake builds and installs nothing, as in a folder that npm builds, where a macro that no file here defines makes the
    package (`add_acme_package(my_pkg …)`) and nothing of ament is called or declared, or where a folder without
    dependencies, code and launch files is marked for other tools. It is a warning where neither ament_cmake nor plain
    CMake is certain, or where nothing in it can be started: tests, which `ament_add_gtest()` and the like make or which
    lie in a folder of tests, and programs that a library does not install, are not for `ros2 run`, unless a page or a
    script runs one (`ros2 run my_pkg test_camera`).

    ## References
    - [REP-149, build_type](https://ros.org/reps/rep-0149.html): "If no build_type is provided, catkin is assumed."
    """
    manifest = package.manifest
    if any(manifest.build_types(package.targets)) or package.is_catkin or package.is_left_to_ros1:
        return
    export = manifest.first("export")
    span = export.open if export else manifest.root.open
    maker = foreign_maker(package)
    guess = "" if maker else package.likely_build_type
    advice = f"add `<build_type>{guess}</build_type>` to `<export>`" if guess else "name one in `<export>`"
    level, what_happens = made_elsewhere(maker) if maker else consequence(package)
    message = f"no `<build_type>` is named, so colcon takes this for a catkin package{what_happens}; {advice}"
    fix = None
    if guess:
        edit = add_export(manifest, f"<build_type>{guess}</build_type>")
        fix = Fix(f"Add the build type {guess}", (edit,))
    yield Hit(manifest.path, span, message, level=level, fix=fix)


def made_elsewhere(maker: str) -> tuple[Severity, str]:
    return Severity.INFO, f" of ROS 1; `{maker}`, which no file here defines, makes none of ROS 2"


def consequence(package: ManifestAndCMake) -> tuple[Severity, str]:
    """Return the level, and what happens: colcon-ros 0.5, task/catkin/build.py, sets no AMENT_PREFIX_PATH."""
    if not package.files.exists("CMakeLists.txt"):
        level = Severity.INFO if package.is_mark else Severity.ERROR
        return level, " and does not build it: it has no CMakeLists.txt"
    if package.likely_build_type == "cmake":
        return Severity.INFO, " of ROS 1, though it builds it"
    if package.does_nothing:
        return Severity.INFO, ": nothing of it is installed, so only `ros2 pkg list` lacks it"
    if package.likely_build_type and not package.may_be_started:
        return Severity.WARNING, ": the build is green, and no command of `ros2` finds it"
    not_found = f": the build is green, and `ros2 run` says \"Package '{package.manifest.name}' not found\""
    if merging := merging_file(package.files):
        return Severity.WARNING, f"{not_found}, but for `--merge-install` (`{merging}`)"
    return (Severity.ERROR if package.likely_build_type else Severity.WARNING), not_found
