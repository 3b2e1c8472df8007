"""What a repository installs by apt, conda or vcpkg is there without package.xml: an info (DEP101 to DEP116)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

LINES = """\
find_package(PkgConfig REQUIRED)
pkg_check_modules(SDL2 REQUIRED sdl2)
add_executable(node src/node.cpp)
target_link_libraries(node ${SDL2_LIBRARIES})
install(TARGETS node DESTINATION lib/${PROJECT_NAME})
"""
INSTALLS = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
XACRO = "<launch><let name='a' value=\"$(command 'xacro a.xacro')\"/></launch>\n"


def launching(text: str) -> dict[str, str]:
    cmake = CMAKE.replace("ament_package()", f"{INSTALLS}ament_package()")
    return {"src/my_pkg/launch/a.launch.xml": text, "src/my_pkg/CMakeLists.txt": cmake}


def level_with(code: str, name: str, files: dict[str, str], on: str = "ament_cmake") -> str:
    package = {f"src/my_pkg/{path}": text for path, text in existing_files(BACKDROPS[on]).items()}
    found = lint_files({**package, "src/my_pkg/package.xml": manifest("", on), **files}, [code]).findings
    (only,) = (each for each in found if each.message.startswith(f"`{name}`") or f"requires `{name}`" in each.message)
    assert ("this repository installs it" in only.message) == (only.severity.value == "info"), only.message
    return only.severity.value


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("util/ubuntu-packages.txt", "# for the joystick\nlibsdl2-dev\n", "info"),
        ("util/ubuntu-packages.txt", "# libsdl2-dev\n", "warning"),
        ("docker/Dockerfile", "FROM ros:jazzy\nRUN apt-get update && apt-get install -y \\\n    libsdl2-dev\n", "info"),
        (".github/workflows/ci.yml", "jobs:\n  a:\n    steps:\n      - run: sudo apt install libsdl2-dev\n", "info"),
        (".github/actions/setup/action.yml", "runs:\n  steps:\n  - run: apt install libsdl2-dev\n", "info"),
        (".circleci/config.yml", "jobs:\n  a:\n    steps:\n    - run: apt install libsdl2-dev\n", "info"),
        ("azure-pipelines.yml", "steps:\n- script: apt install libsdl2-dev\n", "info"),
        ("Earthfile", "build:\n  RUN apt install -y libsdl2-dev\n", "info"),
        ("Taskfile.yml", "tasks:\n  deps:\n    cmds:\n    - apt install libsdl2-dev\n", "info"),
        ("debian/control", "Source: x\nBuild-Depends: debhelper, libsdl2-dev\n", "info"),
        ("cloud/user-data", "#cloud-config\npackages:\n  - libsdl2-dev\n", "info"),
        ("config/robot.yml", "packages:\n  - libsdl2-dev\n", "warning"),
        ("README.md", "    sudo apt-get -y install libsdl2-dev\n", "warning"),
        ("README.md", "It needs no libsdl2-dev.\n", "warning"),
        ("install.sh", "PACKAGES=(libsdl2-dev)\nsudo apt install ${PACKAGES[@]}\n", "info"),
        ("install.sh", "# PACKAGES=(libsdl2-dev)\n", "warning"),
        ("environment.yml", "dependencies:\n  - sdl2\n", "info"),
        ("vcpkg.json", '{"dependencies": ["sdl2"]}\n', "info"),
        ("shell.nix", "mkShell { buildInputs = [ SDL2 ]; }\n", "info"),
        ("Brewfile", 'brew "sdl2"\n', "info"),
        ("docs/notes.txt", "libsdl2-dev\n", "warning"),
        ("src/my_pkg/src/node.hpp", "// apt install libsdl2-dev\n", "warning"),
    ],
)
def test_libraries(path: str, text: str, level: str) -> None:
    cmake = CMAKE.replace("ament_package()", f"{LINES}ament_package()")
    node = {"src/my_pkg/src/node.cpp": "int main() {return 0;}\n", "src/my_pkg/CMakeLists.txt": cmake, path: text}
    assert level_with("DEP115", "sdl2", node) == level


@pytest.mark.parametrize(
    ("text", "level"),
    [
        ("apt install libboost-all-dev\n", "info"),
        ("apt install libboost-system-dev\n", "info"),
        ("apt install libeigen3-dev\n", "warning"),
    ],
)
def test_what_comes_with_them(text: str, level: str) -> None:
    cmake = CMAKE.replace("ament_package()", "find_package(Boost REQUIRED COMPONENTS system)\nament_package()")
    assert level_with("DEP104", "Boost", {"src/my_pkg/CMakeLists.txt": cmake, "setup.sh": text}) == level


@pytest.mark.parametrize("path", ["README.md", "setup.sh", "util/ubuntu-packages.txt"])
def test_packages_of_ros_are_found_by_the_manifest(path: str) -> None:
    files = {**launching(XACRO), path: "sudo apt install ros-jazzy-xacro\n"}
    assert level_with("DEP103", "xacro", files) == "warning"


@pytest.mark.parametrize("path", ["README.md", "setup.sh", ".github/workflows/ci.yml"])
def test_where_rosdep_is_run_it_installs_what_is_declared(path: str) -> None:
    cmake = CMAKE.replace("ament_package()", "find_package(Boost REQUIRED COMPONENTS system)\nament_package()")
    files = {"src/my_pkg/CMakeLists.txt": cmake, "apt.txt": "libboost-all-dev\n"}
    assert level_with("DEP104", "Boost", files) == "info"
    run = "rosdep update\nrosdep install --from-paths src -y\n"
    assert level_with("DEP104", "Boost", {**files, path: run}) == "warning"


@pytest.mark.parametrize(
    ("text", "level"),
    [("apt install python3-serial\n", "info"), ("apt install libserial-dev\n", "warning")],
)
def test_libraries_of_python(text: str, level: str) -> None:
    files = {"src/my_pkg/my_pkg/node.py": "import serial\n", "setup.sh": text}
    assert level_with("DEP101", "python3-serial", files, "ament_python") == level


def test_a_release_is_installed_without_them() -> None:
    files = {"src/my_pkg/my_pkg/node.py": "import serial\n", "setup.sh": "apt install python3-serial\n"}
    assert level_with("DEP101", "python3-serial", {**files, "tracks.yaml": ""}, "ament_python") == "warning"


def test_another_repository_beside_it() -> None:
    other = {"other/.git/HEAD": "", "other/package.xml": manifest().replace("my_pkg", "other")}
    files = {"src/.git/HEAD": "", "src/my_pkg/my_pkg/node.py": "import serial\n", **other}
    for path, level in (("other/setup.sh", "warning"), ("src/setup.sh", "info")):
        given = {**files, path: "apt install python3-serial\n"}
        assert level_with("DEP101", "python3-serial", given, "ament_python") == level
