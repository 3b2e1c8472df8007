"""DEP118: paths that name no file, and scripts that nothing installs as programs, starts or names, are infos."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

HOME = "/home/ada/ws/src/my_pkg"
NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"
INSTALLS = "install(DIRECTORY config launch maps DESTINATION share/${PROJECT_NAME})\n"
SETTINGS = "node:\n  ros__parameters:\n    place: {}\n"
LAUNCH = (
    '<launch>\n  <node pkg="my_pkg" exec="node">\n    <param from="$(find-pkg-share my_pkg)/config/a.yaml"/>\n'
    '    <param name="{}" value="{}"/>\n  </node>\n</launch>\n'
)
SCRIPT = f"import glob\n\nclass Trainer:\n    images = glob.glob('{HOME}/maps')\n"


def found(files: dict[str, str], lines: str = "") -> list[str]:
    base = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{NODE}{INSTALLS}{lines}ament_package"),
        "src/node.cpp": 'int main() {node->declare_parameter("place", "");}\n',
        "maps/office.yaml": "image: office.pgm\n",
        "maps/office.pgm": "",
    }
    return [each.severity.value for each in lint_files({**base, **files}, ["DEP118"]).findings]


@pytest.mark.parametrize(
    ("place", "level"),
    [
        ("maps/office", "info"),
        ("maps/nowhere", "info"),
        ("maps", "warning"),
        ("maps/office.yaml", "warning"),
        ("maps/nowhere.yaml", "warning"),
    ],
)
def test_a_path_without_a_suffix_that_names_no_file(place: str, level: str) -> None:
    launch = {"launch/a.launch.xml": LAUNCH.format("other", 1)}
    in_yaml = "info" if "nowhere" in place else level
    assert found({"config/a.yaml": SETTINGS.format(f"{HOME}/{place}"), **launch}) == [in_yaml]
    assert found({"launch/a.launch.xml": LAUNCH.format("place", f"{HOME}/{place}")}) == [level]


@pytest.mark.parametrize(("place", "level"), [("data", "warning"), ("lost", "info")])
def test_a_folder_of_another_package(place: str, level: str) -> None:
    other = {"other/package.xml": manifest("", "ament_cmake", "other"), "other/data/a.txt": ""}
    cmake = CMAKE.replace("ament_package", "install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package")
    files = {"my_pkg/package.xml": manifest("", "ament_cmake"), "my_pkg/CMakeLists.txt": cmake, **other}
    files["my_pkg/launch/a.launch.xml"] = LAUNCH.format("place", f"/home/ada/ws/src/other/{place}")
    assert [each.severity.value for each in lint_files(files, ["DEP118"]).findings] == [level]


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("", "info"),
        ("include(more.cmake)\n", "info"),
        ("find_package(strange REQUIRED)\nstrange_install_all()\n", "info"),
        ("install(PROGRAMS scripts/train.py DESTINATION lib/${PROJECT_NAME})\n", "warning"),
        ("# scripts/train.py\n", "info"),
    ],
)
def test_a_script_among_the_data(lines: str, level: str) -> None:
    assert found({"scripts/train.py": SCRIPT}, lines) == [level]


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("README.md", "Run `python3 scripts/train.py`.\n", "warning"),
        ("README.md", "    rosdep install --from-train src\n", "info"),
        ("src/talk.py", "import os\n", "info"),
        ("src/node.cpp", 'int main() {return system("python3 scripts/train.py");}\n', "warning"),
        ("launch/a.launch.py", "CMD = ['python3', share + '/scripts/train.py']\n", "warning"),
        ("scripts/other.py", "import train\n", "info"),
    ],
)
@pytest.mark.parametrize("installs", ["", "install(DIRECTORY scripts DESTINATION share/${PROJECT_NAME})\n"])
def test_a_script_that_something_names(path: str, text: str, level: str, installs: str) -> None:
    assert found({"scripts/train.py": SCRIPT, path: text}, installs) == [level]
