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
