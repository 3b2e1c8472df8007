"""Dependencies of another kind than their use, and tests that are always looked for: who meets that, who does not."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.cmake import cmk107_unguarded_test as cmk107
from rospkg_cli.rules.depends import dep201_wrong_dependency_kind as dep201

FOUND = CMAKE.replace("ament_package()", "find_package(nav2_core REQUIRED)\nament_package()")
IMAGE = "FROM ros:humble\nRUN rosdep update && rosdep install -y --from-paths src \\\n    {} --ignore-src\n"


def found(tag: str, **more: str) -> Example:
    """Return a package in `src`, with files of the repository around it by their names, `_` for a dot."""
    files = {
        "src/my_pkg/package.xml": manifest(f"  <{tag}>nav2_core</{tag}>\n", "ament_cmake"),
        "src/my_pkg/CMakeLists.txt": FOUND,
    }
    return Example(bad={**files, **{path.replace("_", "."): text for path, text in more.items()}}, good={}, on="")


TITLE = "Changelog for package {}\n======\n"
OTHER = manifest("", "ament_cmake", "other_pkg")
OTHER_CMAKE = CMAKE.replace("my_pkg", "other_pkg")


def with_changes(name: str, *, of_other: bool) -> Example:
    """Return a package with changes of some package beside another one, which may have some, too."""
    others = {"src/other/package.xml": OTHER, "src/other/CMakeLists.txt": OTHER_CMAKE}
    others |= {"src/other/CHANGELOG.rst": TITLE.format("other_pkg")} if of_other else {}
    example = found("exec_depend")
    return Example(bad={**example.bad, **others, "src/my_pkg/CHANGELOG.rst": TITLE.format(name)}, good={}, on="")


def always_tested(body: str = cmk107.BODY, **more: str) -> Example:
    """Return a package that looks for linters whether tests are built or not."""
    files = {
        "my_pkg/package.xml": manifest(body, "ament_cmake"),
        "my_pkg/CMakeLists.txt": CMAKE.replace("ament_package", cmk107.LINES + "ament_package"),
    }
    return Example(bad={**files, **{path.replace("_", "."): text for path, text in more.items()}}, good={}, on="")


CASES = {
    "CMK107": (
        always_tested(),
        always_tested(""),
        always_tested(build_sh="colcon build --cmake-args -DBUILD_TESTING=OFF\n"),
        always_tested(build_sh="colcon build --cmake-args -DBUILD_TESTING=ON\n"),
        always_tested(Dockerfile=IMAGE.format("--dependency-types build")),
    ),
    "DEP201": (
        Example(bad={"package.xml": dep201.BAD, "my_pkg/node.py": "import rclpy\n"}, good={}),
        found("exec_depend"),
        found("test_depend", Dockerfile=IMAGE.format("--rosdistro humble")),
        found("exec_depend", Dockerfile=IMAGE.format("--dependency-types build")),
        found("exec_depend", build_sh=IMAGE.format("-t build -t buildtool")),
        found("exec_depend", build_sh="bloom-generate rosdebian --ros-distro humble\n"),
        found("exec_depend", tracks_yaml="tracks: {}\n"),
        with_changes("my_pkg", of_other=True),
        with_changes("my_pkg", of_other=False),
        with_changes("their_pkg", of_other=True),
    ),
}
