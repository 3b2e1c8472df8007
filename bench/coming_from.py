"""docs/coming-from.md: what other tools find, by running them on the faults of coming_from.toml.

    python -m bench.coming_from FOLDER

The folder holds their commands: `package-xml-validator`, `check-launch-tree` and `catkin_lint`, as pip installs them
(the first two from their repository), and rosdep; `ament_xmllint` is on the path. rosdep is given a rosdistro of a few
names, and nothing comes from the network. A row is well where the tool says what is written there of the fault, and
does not say it of the faultless package.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from rospkg_cli.example import Example

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

DATA: dict[str, Any] = tomllib.loads((Path(__file__).parent / "coming_from.toml").read_text("utf-8"))
ROWS: list[tuple[str, dict[str, Any]]] = [(tool, row) for tool in DATA["tools"] for row in DATA[tool]]
KNOWN = ("ament_cmake", "launch", "launch_ros", "nav_msgs", "rclpy", "rosidl_default_generators", "std_msgs")
CATKIN = """\
cmake_minimum_required(VERSION 3.0.2)
project(my_pkg)
find_package(catkin REQUIRED COMPONENTS roscpp)
catkin_package()
include_directories(${catkin_INCLUDE_DIRS})
add_executable(node src/node.cpp)
target_link_libraries(node ${catkin_LIBRARIES})
install(TARGETS node RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
"""
OF_CATKIN = """\
<package format="2">
  <name>{name}</name>
  <version>1.0.0</version>
  <description>Drives my robot</description>
  <maintainer email="ada@example.org">Ada</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
{body}</package>
"""
OF_ITSELF = "  <buildtool_depend>catkin</buildtool_depend>\n"


def faultless(base: str) -> dict[str, str]:
    """Return the files of a package without faults: of catkin, or a backdrop of the rules' examples."""
    if base == "catkin":
        package = OF_CATKIN.format(name="my_pkg", body="  <depend>roscpp</depend>\n")
        return {"package.xml": package, "CMakeLists.txt": CATKIN, "src/node.cpp": "int main() {}\n"}
    return Example(bad={}, good={}, on=base).bad_files()


def faulty(row: Mapping[str, Any], base: str = "ament_python") -> dict[str, str]:
    """Return the files of the row's package. Raises ValueError where an edit changes nothing."""
    files = faultless(row.get("base", base))
    for path, pattern, text in row.get("replace", ()):
        edited = re.sub(pattern, text, files[path], count=1)
        if edited == files[path]:
            raise ValueError(f"{row['row']}: {pattern} is not in {path}")
        files[path] = edited
    return {**files, **row.get("add", {})}


def packages(tool: str, row: Mapping[str, Any]) -> dict[str, dict[str, str]]:
    """Return a row's package, and one without its fault."""
    base = "catkin" if tool == "catkin_lint" else row.get("base", "ament_python")
    return {"faulty": faulty(row, base), "faultless": faultless(base)}


def said(tool: str, row: Mapping[str, Any], files: Mapping[str, str], programs: Path, home: Path) -> str:
    """Return what a tool says of a package, which lies in a workspace of its own."""
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder) / "src" / "my_pkg"
        for path, text in files.items():
            (package / path).parent.mkdir(parents=True, exist_ok=True)
            (package / path).write_text(text, "utf-8")
            (package / path).chmod(0o755 if text.startswith("#!") else 0o644)
        for name in ("catkin", "roscpp", "message_generation", "pluginlib") if tool == "catkin_lint" else ():
            (package.parent / name).mkdir()
            text = OF_CATKIN.format(name=name, body="").replace(OF_ITSELF if name == "catkin" else "", "")
            (package.parent / name / "package.xml").write_text(text, "utf-8")
        place = package / "package.xml" if tool == "ament_xmllint" else package
        done = subprocess.run(
            [*command(tool, row, programs, package.parent), str(place)],
            env={**os.environ, **rosdep(home)},
            capture_output=True,
            text=True,
            check=False,
            timeout=60,
        )
        return done.stdout + done.stderr


def command(tool: str, row: Mapping[str, Any], programs: Path, src: Path) -> list[str]:
    if tool == "ament_xmllint":
        return ["ament_xmllint"]
    if tool == "catkin_lint":
        return [str(programs / "catkin_lint"), "-W2", "--strict", "--json", "--package-path", str(src)]
    options = ["--check-only", "--compare-with-cmake", "--verbose"] if "command" not in row else []
    return [str(programs / row.get("command", "package-xml-validator")), *options]


def rosdep(home: Path) -> dict[str, str]:
    """Return the variables with which rosdep knows a few names and asks nobody."""
    return {
        "HOME": str(home),
        "ROS_HOME": str(home / "ros"),
        "ROSDEP_SOURCE_PATH": str(home / "sources"),
        "ROSDISTRO_INDEX_URL": (home / "index-v4.yaml").as_uri(),
        "ROS_OS_OVERRIDE": "ubuntu:24.04:noble",
        "ROS_DISTRO": "jazzy",
        "ROS_PYTHON_VERSION": "3",
    }


def begin_rosdep(home: Path, programs: Path) -> None:
    """Write a rosdistro of a few names, and let rosdep read it."""
    names = "".join(f"      - {name}\n" for name in KNOWN)
    released = f"release:\n      packages:\n{names}      tags: {{release: x}}\n      url: https://example.org/x.git\n"
    head = "%YAML 1.1\n---\ntype: distribution\nversion: 2\nrelease_platforms: {ubuntu: [noble]}\nrepositories:\n"
    (home / "distribution.yaml").write_text(f"{head}  things:\n    {released}      version: 1.0.0-1\n")
    index = "distributions:\n  jazzy: {distribution: [distribution.yaml], distribution_type: ros2, python_version: 3}\n"
    (home / "index-v4.yaml").write_text(f"%YAML 1.1\n---\ntype: index\nversion: 4\n{index}")
    (home / "keys.yaml").write_text("python3-pytest: {ubuntu: [python3-pytest]}\n")
    (home / "sources").mkdir()
    (home / "sources" / "20-names.list").write_text(f"yaml {(home / 'keys.yaml').as_uri()}\n")
    update = [str(programs / "rosdep"), "update"]
    subprocess.run(update, env={**os.environ, **rosdep(home)}, check=True, stdout=subprocess.DEVNULL)


def main(words: list[str]) -> int:
    programs, unfound = Path(words[0]).resolve(), 0
    with tempfile.TemporaryDirectory() as folder:
        begin_rosdep(Path(folder), programs)
        for tool, row in ROWS:
            told = {kind: said(tool, row, files, programs, Path(folder)) for kind, files in packages(tool, row).items()}
            well = row["says"] in told["faulty"] and (row["says"] not in told["faultless"] or row.get("quiet", False))
            unfound += not well
            print(f"{'found' if well else 'NOT FOUND'}: {tool}: {row['row']}", flush=True)
            if not well and "-v" in words:
                print(told["faulty"], told["faultless"], sep="\n--- faultless:\n")
    print(f"{len(ROWS) - unfound} of {len(ROWS)} rows are as the page says")
    return 1 if unfound else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
