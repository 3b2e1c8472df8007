"""Files that are missing until a program of the repository has written them: LCH003 tells them as an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

PACKAGE = {
    "package.xml": manifest(
        "  <exec_depend>ament_index_python</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"
    ),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package",
        "install(DIRECTORY launch worlds config maps DESTINATION share/${PROJECT_NAME})\nament_package",
    ),
    "worlds/field.wbt": "",
    "config/other.txt": "",
    "maps/hall.pgm": "P5",
}
LAUNCH = """\
<launch>
  <node pkg="p" exec="e" args="-f $(find-pkg-share my_pkg)/{}"/>
</launch>
"""
START = """\
import os

from ament_index_python.packages import get_package_share_directory

share = get_package_share_directory('my_pkg')
"""
QUIET: list[str] = []


def levels(path: str, code: str, at: str = "scripts/make.py", **more: str) -> list[str]:
    """Return the levels of what is told of a path that a launch file names, beside some code."""
    found = lint_files({**PACKAGE, "launch/a.launch.xml": LAUNCH.format(path), at: code, **more}, ["LCH003"]).findings
    assert all(f"until `{at}` has written it" in each.message for each in found if each.severity.value == "info")
    return [each.severity.value for each in found]


FIELD = "worlds/modified_field.wbt"


@pytest.mark.parametrize(
    "code",
    [
        "path = os.path.join(share, 'worlds', 'modified_' + name())\nopen(path, 'w').write('')\n",
        "with open(f'{share}/worlds/modified_{name()}', mode='wb') as out:\n    out.write(b'')\n",
        "(get_package_share_path('my_pkg') / 'worlds' / f'modified_{name()}.wbt').write_text('')\n",
        "path = '/home/me/ws/src/my_pkg/worlds/modified_{}.wbt'.format(name())\nopen(path, 'w')\n",
        "path = os.path.expanduser('~/ws/src/my_pkg/worlds/modified_%s.wbt' % name())\nopen(path, 'w')\n",
        "class A:\n    def __init__(self):\n        self.out = folder() + '/modified_field.wbt'\n"
        "    def save(self):\n        open(self.out, 'w')\n",
        "node.declare_parameter('out', share + '/worlds/modified_field.wbt')\n"
        "open(node.get_parameter('out').get_parameter_value().string_value, 'w')\n",
        "node.declare_parameter('name', 'court.wbt')\n"
        "open(os.path.join(share, 'worlds', 'modified_' + node.get_parameter('name').value), 'w')\n",
        "def read():\n    path = share + '/worlds/field.wbt'\n    return open(path).read()\n\n"
        "path = share + '/worlds/modified_field.wbt'\nopen(path, 'w').write(read())\n",
        "out = node.declare_parameter('out', share + '/worlds/modified_field.wbt').value\nopen(out, 'w')\n",
        "shutil.move('/tmp/a.wbt', os.path.join(share, 'worlds', 'modified_field.wbt'))\n",
        "os.replace('/tmp/a.wbt', src=None, dst=os.path.join(here(), 'worlds', 'modified_field.wbt'))\n",
        "subprocess.run(['xacro', 'a.xacro', '-o', os.path.join(here(), 'worlds', 'modified_field.wbt')])\n",
        "os.system(f'xacro a.xacro > {here()}/worlds/modified_field.wbt')\n",
        "tree.write(os.path.join(here(), 'worlds', 'modified_field.wbt'))\n",
        "for each in names():\n    open(os.path.join(share, 'worlds', each + '.wbt'), 'w')\n",
    ],
)
def test_what_python_writes_under_a_name_that_it_puts_together(code: str) -> None:
    assert levels(FIELD, START + code) in (["info"], QUIET)


@pytest.mark.parametrize(
    "code",
    [
        "open(os.path.join(share, 'worlds', 'modified_' + name()))\n",
        "open(os.path.join(share, 'worlds', 'changed_' + name()), 'w')\n",
        "open(os.path.join(share, 'config', 'modified_' + name()), 'w')\n",
        "open(os.path.join(share, folder(), name() + '.wbt'), 'w')\n",
        "open(os.path.join(share, 'worlds', name()), 'w')\n",
        "open(name(), 'w')\n",
        "open('modified_field.wbt', 'w')\n",
        "open(os.path.join(get_package_share_directory('other'), 'worlds', 'modified_' + name()), 'w')\n",
        "world = open(os.path.join(share, 'worlds', 'modified_field.wbt')).read()\nopen(name(), 'w').write(world)\n",
        "shutil.copy(os.path.join(share, 'worlds', 'modified_field.wbt'), '/tmp')\n",
        "def read():\n    path = share + '/worlds/modified_field.wbt'\n    return open(path).read()\n\n"
        "path = share + '/worlds/field.wbt'\nopen(path, 'w').write(read())\n",
        "print('> worlds/modified_field.wbt')\n",
    ],
)
def test_what_python_reads_or_writes_elsewhere(code: str) -> None:
    assert levels(FIELD, START + code) == ["warning"]


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        ('std::ofstream out(share + "/config/poses.yaml");', ["info"]),
        ('const auto path = share + "/config/poses.yaml";\nstd::ofstream out{path};', ["info"]),
        ('path_ = folder / "poses.yaml";\nout.open(path_, std::ios::out);\nstd::ofstream out;', ["info"]),
        ('FILE * file = fopen("/home/me/ws/src/my_pkg/config/poses.yaml", "w");', ["info"]),
        ('FILE * file = fopen("/home/me/ws/src/my_pkg/config/poses.yaml", "r");', ["warning"]),
        ('auto path = share + "/config/poses.yaml";\nLoadFile(path);\nstd::ofstream out(other);', ["warning"]),
        ('std::ofstream out(share + "/config/all_poses.yaml");', ["warning"]),
        ('// std::ofstream out(share + "/config/poses.yaml");', ["warning"]),
    ],
)
def test_what_cpp_writes(code: str, expected: list[str]) -> None:
    assert levels("config/poses.yaml", code, "src/save.cpp") == expected


def test_what_another_package_of_the_repository_writes() -> None:
    launch = LAUNCH.format(FIELD).replace("my_pkg", "my_pkg")
    code = f"{START}open(os.path.join(share, 'worlds', 'modified_' + name()), 'w')\n"
    other = {"package.xml": manifest().replace("my_pkg", "maker"), "maker/make.py": code}
    files = {f"a/{path}": text for path, text in {**PACKAGE, "launch/a.launch.xml": launch}.items()}
    files |= {f"b/{path}": text for path, text in other.items()}
    assert [each.severity.value for each in lint_files(files, ["LCH003"]).findings] == ["info"]


def test_a_program_that_writes_any_file_of_a_folder_writes_none_whose_name_is_a_slip() -> None:
    code = f"{START}open(os.path.join(share, 'worlds', name() + '.wbt'), 'w')\n"
    assert levels("worlds/small.wbt", code) == ["info"]
    assert levels("worlds/fields.wbt", code) == ["warning"]
    assert levels("worlds/fields.wbt", code.replace("name() + '.wbt'", "name() + 's.wbt'")) == ["info"]


TEST = f"""{START}
import unittest

from launch import LaunchDescription


def generate_test_description():
    return LaunchDescription([]), {{}}


class TestSummary(unittest.TestCase):
    def test_summary(self):
        with open(os.path.join(share, 'summary.txt')) as found:
            assert found.read()
"""
RUN = f"{START}with open(os.path.join(share, 'summary.txt'), 'w') as out:\n    out.write('')\n"


@pytest.mark.parametrize(("code", "expected"), [(RUN, ["info"]), (RUN.replace(", 'w'", ""), ["warning"])])
def test_what_a_test_writes_for_another_test(code: str, expected: list[str]) -> None:
    cmake = PACKAGE["CMakeLists.txt"].replace(
        "ament_package", "add_launch_test(test/test_sum.launch.py)\nament_package"
    )
    files = {**PACKAGE, "CMakeLists.txt": cmake, "test/test_sum.launch.py": TEST, "test/run_all.py": code}
    assert [each.severity.value for each in lint_files(files, ["LCH003"]).findings] == expected


def test_what_a_test_writes_is_no_file_of_the_package() -> None:
    assert levels("summary.txt", RUN, "test/run_all.py") == ["warning"]
