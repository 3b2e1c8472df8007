"""What opens a file that setup.py leaves out: live text that joins it to the package's own share directory."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, setup_py
from rospkg_cli.testing import lint_files

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
GLOBS = (
    "        ('share/' + package_name + '/config', glob('config/*.yaml')),\n"
    "        ('share/' + package_name + '/launch', glob('launch/*.launch.py')),\n"
    "        ('share/' + package_name + '/urdf', glob('urdf/*.urdf')),\n"
    "        ('share/' + package_name + '/maps', glob('maps/*.yaml')),\n"
)
PACKAGE = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + GLOBS),
    "config/a.yaml": "a: 1\n",
    "launch/a.launch.py": "A = 1\n",
    "urdf/a.urdf": "<robot/>\n",
    "maps/a.yaml": "image: a.png\n",
}
LOOKS = "share = get_package_share_directory({})\n"
TREE, LAUNCH = {"config/tree.xml": "<root/>\n"}, {"launch/arm_launch.py": "B = 1\n"}
OTHER = {"other/package.xml": manifest("", "ament_python", "other"), "other/setup.py": ""}


def level(files: dict[str, str], others: dict[str, str] | None = None) -> str:
    own = {f"own/{path}": text for path, text in {**PACKAGE, **files}.items()}
    (found,) = lint_files({**own, **OTHER, **(others or {})}, ["SET207"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x = os.path.join(get_package_share_directory('my_pkg'), 'config', 'tree.xml')\n", "warning"),
        ("x = PathJoinSubstitution([FindPackageShare('my_pkg'), 'config', 'tree.xml'])\n", "warning"),
        (LOOKS.format("'my_pkg'") + "x = os.path.join(share, 'config', 'tree.xml')\n", "warning"),
        (LOOKS.format("'my_pkg'") + "c = os.path.join(share, 'config')\nx = f'{c}/tree.xml'\n", "warning"),
        ("name = 'my_pkg'\n" + LOOKS.format("name") + "x = share + '/config/tree.xml'\n", "warning"),
        ("share = os.path.join(\n    get_package_share_directory('my_pkg'))\nx = share + '/tree.xml'\n", "warning"),
        (LOOKS.format("'my_pkg'") + "# x = os.path.join(share, 'config', 'tree.xml')\n", "info"),
        (LOOKS.format("'nav2_bt_navigator'") + "x = os.path.join(share, 'config', 'tree.xml')\n", "info"),
        ("name = 'nav2_bt_navigator'\n" + LOOKS.format("name") + "x = share + '/tree.xml'\n", "info"),
        (LOOKS.format("'my_pkg'") + "x = [share + '/config/a.yaml', 'tree.xml']\n", "info"),
        (LOOKS.format("'my_pkg'") + "y = 'tree.xml'\n", "info"),
        (LOOKS.format("'my_pkg'") + "x = os.path.join(share, 'config', 'old_tree.xml')\n", "info"),
        ("x = 'config/tree.xml'\n", "info"),
    ],
)
def test_what_code_joins(text: str, expected: str) -> None:
    assert level({**TREE, "my_pkg/a.py": text}) == expected


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("config/a.yaml", "tree: package://my_pkg/config/tree.xml\n", "warning"),
        ("config/a.yaml", "# tree: package://my_pkg/config/tree.xml\n", "info"),
        ("config/a.yaml", "tree: package://nav2_bt_navigator/config/tree.xml\n", "info"),
        ("config/a.yaml", "tree: tree.xml\n", "info"),
        ("launch/b.launch.xml", "<let name='a' value='$(find-pkg-share my_pkg)/config/tree.xml'/>\n", "warning"),
        ("src/a.cpp", 'auto a = get_package_share_directory("my_pkg") + "/config/tree.xml";\n', "warning"),
        ("src/a.cpp", '// auto a = get_package_share_directory("my_pkg") + "/config/tree.xml";\n', "info"),
        ("README.md", "Change tree.xml\n", "info"),
    ],
)
def test_what_other_files_say(path: str, text: str, expected: str) -> None:
    files = {**PACKAGE, **TREE, path: text}
    found = lint_files(files, ["SET207"]).findings
    assert [each.severity.value for each in found if "tree.xml" in each.message] == [expected]


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({}, "info"),
        ({"README.md": "`ros2 launch my_pkg arm_launch.py sim:=true`\n"}, "warning"),
        ({"run.sh": "ros2 launch --debug my_pkg arm_launch.py\n"}, "warning"),
        ({"README.md": "`launch/arm_launch.py` starts the arm\n"}, "info"),
        ({"README.md": "`ros2 launch arm_bringup arm_launch.py`\n"}, "info"),
        ({"launch/a.launch.py": "x = os.path.join(here, 'arm_launch.py')\n"}, "warning"),
        ({"launch/a.launch.py": "# x = os.path.join(here, 'arm_launch.py')\n"}, "info"),
        ({"launch/a.launch.py": LOOKS.format("'nav2_bringup'") + "x = share + '/launch/arm_launch.py'\n"}, "info"),
    ],
)
def test_what_starts_a_launch_file(files: dict[str, str], expected: str) -> None:
    assert level({**LAUNCH, **files}) == expected


def test_what_another_package_opens() -> None:
    line = "x = get_package_share_directory('{}') + '/config/tree.xml'\n"
    for name, expected in (("my_pkg", "warning"), ("third", "info")):
        assert level(TREE, {"other/other/a.py": line.format(name)}) == expected


def test_what_lies_beside_what_is_installed() -> None:
    robot = "<robot><xacro:include filename='{}'/></robot>\n"
    for name, expected in (("arm.xacro", "warning"), ("../urdf/arm.xacro", "warning"), ("in/arm.xacro", "info")):
        assert level({"urdf/arm.xacro": "<robot/>\n", "urdf/a.urdf": robot.format(name)}) == expected
    assert level({"maps/a.png": "p"}) == "warning"
    assert level({"maps/a.png": "p", "maps/a.yaml": "title: a.png\n"}) == "info"
