"""Dependencies of another kind than their use, where somebody tells the kinds apart, and where nobody does."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
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


CASES = {
    "DEP201": (
        Example(bad={"package.xml": dep201.BAD, "my_pkg/node.py": "import rclpy\n"}, good={}),
        found("exec_depend"),
        found("test_depend", Dockerfile=IMAGE.format("--rosdistro humble")),
        found("exec_depend", Dockerfile=IMAGE.format("--dependency-types build")),
        found("exec_depend", build_sh=IMAGE.format("-t build -t buildtool")),
        found("exec_depend", build_sh="bloom-generate rosdebian --ros-distro humble\n"),
    ),
}
