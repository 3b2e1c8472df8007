"""A folder that is not installed: loud where its package, or another one that names it, opens a file of it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NEEDS = manifest("  <exec_depend>arm</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake", "user")
PACKAGE = {"arm/package.xml": manifest("", "ament_cmake", "arm"), "arm/CMakeLists.txt": CMAKE.replace("my_pkg", "arm")}
USER = {"user/package.xml": NEEDS, "user/CMakeLists.txt": CMAKE.replace("my_pkg", "user")}
NOTES, YAML = {"arm/config/base_to_arm.txt": "1 0 0\n"}, {"arm/config/joy.yaml": "rate: 1\n"}
LOOKS = "path = os.path.join(get_package_share_directory('{}'), 'config', {})\n"


def level(files: dict[str, str], text: str) -> str:
    told = lint_files({**PACKAGE, **USER, **files, "user/launch/a.launch.py": text}, ["CMK101"]).findings
    (found,) = [each for each in told if each.location.path.endswith("arm/CMakeLists.txt")]
    return found.severity.value


@pytest.mark.parametrize(
    ("files", "text", "expected"),
    [
        (NOTES, "PACKAGE = 'arm'\n", "info"),
        (NOTES, LOOKS.format("arm", "'base_to_arm.txt'"), "warning"),
        (NOTES, LOOKS.format("arm", "name"), "warning"),
        (YAML, LOOKS.format("arm", "'joy.yaml'"), "warning"),
        (YAML, LOOKS.format("user", "'joy.yaml'") + "OTHER = 'arm'\n", "info"),
        (YAML, LOOKS.format("arm", "f'{name}.yaml'"), "warning"),
        (YAML, "given = read('arm', 'joy.yaml')\n", "warning"),
        (YAML, "given = read(NAME, 'joy.yaml')\n", "warning"),
        ({**YAML, "user/config/joy.yaml": "a: 1\n"}, "given = read(NAME, 'joy.yaml')\n", "info"),
        (YAML, "given = read(NAME, 'other_joy.yaml')\n", "info"),
        ({**YAML, "user/config/joy.yaml": "a: 1\n"}, "given = read('alarm', 'joy.yaml')\n", "info"),
        (YAML, "# given = read('arm', 'joy.yaml')\n", "info"),
        (YAML, "MoveItConfigsBuilder('robot', package_name='arm')\n", "warning"),
        ({"arm/urdf/arm.xacro": "<robot/>\n"}, "MoveItConfigsBuilder('robot', package_name='arm')\n", "info"),
    ],
)
def test_who_opens_a_file_of_the_folder(files: dict[str, str], text: str, expected: str) -> None:
    assert level(files, text) == expected


def test_the_folder_of_another_package_is_another_one() -> None:
    looks = "name = 'nav2_bringup'\nshare = get_package_share_directory(name)\npath = share + '/config/'\n"
    files = {**PACKAGE, **YAML, "arm/launch/a.launch.py": looks}
    found = lint_files(files, ["CMK101"]).findings
    assert [each.severity.value for each in found if "config" in each.message] == ["info"]
    own = looks.replace("nav2_bringup", "arm")
    found = lint_files({**files, "arm/launch/a.launch.py": own}, ["CMK101"]).findings
    assert [each.severity.value for each in found if "config" in each.message] == ["error"]


MAPS = {"arm/maps/hall.yaml": "image: hall.pgm\n", "arm/maps/hall.pgm": "P5 1 1 1 0"}
COPIES = {"arm/config/hall.yaml": "image: hall.pgm\n", "arm/config/hall.pgm": "P5 1 1 1 0"}
SHARE = "share = get_package_share_directory('arm')\n"


@pytest.mark.parametrize(
    ("copies", "path", "expected"),
    [
        (COPIES, "os.path.join(share, 'config', 'hall.yaml')", "info"),
        (COPIES, "os.path.join(\n    share,\n    'config',\n    'hall.yaml',\n)", "info"),
        (COPIES, "share + '/config/hall.yaml'", "info"),
        (COPIES, "Path(share) / 'config' / 'hall.yaml'", "info"),
        ({}, "os.path.join(share, 'config', 'hall.yaml')", "warning"),
        (COPIES, "os.path.join(share, 'maps', 'hall.yaml')", "warning"),
        (COPIES, "os.path.join(share, folder, 'hall.yaml')", "warning"),
        (COPIES, "os.path.join(share, 'hall.yaml')", "warning"),
        ({**COPIES, "arm/hall.yaml": ""}, "os.path.join(share, 'hall.yaml')", "warning"),
        ({"arm/worlds/maps/hall.yaml": ""}, "share + '/worlds/maps/hall.yaml'", "warning"),
        (COPIES, "[share + '/config/hall.yaml', share + '/' + part + '/hall.pgm']", "warning"),
    ],
)
def test_a_file_of_that_name_in_another_folder_is_another_one(copies: dict[str, str], path: str, expected: str) -> None:
    files = {**PACKAGE, **USER, **MAPS, **copies, "user/launch/a.launch.py": f"{SHARE}path = {path}\n"}
    found = [each for each in lint_files(files, ["CMK101"]).findings if "`maps/`" in each.message]
    assert [each.severity.value for each in found] == [expected]


@pytest.mark.parametrize(
    ("path", "is_said"), [("/home/ada/ws/src/arm/maps/hall.yaml", True), ("/home/ada/ws/my_arm/maps/hall.yaml", False)]
)
def test_a_path_of_another_package_into_the_source(path: str, is_said: bool) -> None:
    files = {**PACKAGE, **USER, **MAPS, "user/launch/a.launch.py": f"PACKAGE, PATH = 'arm', '{path}'\n"}
    (found,) = [each for each in lint_files(files, ["CMK101"]).findings if "`maps/`" in each.message]
    assert found.severity.value == "info"
    assert ("only another package opens it, in the source folder" in found.message) is is_said
