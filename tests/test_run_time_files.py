"""Files that the code of a package writes into its share directory when it runs are not missing."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.rule import all_rules
from rospkg_cli.testing import lint_files

INSTALL = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch config urdf DESTINATION share/${PROJECT_NAME})\nament_package"
)
LAUNCH = '<launch>\n  <log message="$(find-pkg-share my_pkg)/{}"/>\n</launch>\n'
ROBOT = '<robot name="r">\n  <mesh filename="package://my_pkg/{}"/>\n</robot>\n'
CODE = """\
import os
import shutil
from pathlib import Path

from ament_index_python.packages import get_package_share_directory

share = get_package_share_directory('my_pkg')
folder = os.path.join(share, 'config', 'temp')
path = Path(folder) / 'made.yaml'
"""


def found(line: str, code: str, path: str = "config/temp/made.yaml", at: str = "scripts/make.py") -> list[str]:
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": INSTALL,
        "config/a.yaml": "a: 1\n",
        "launch/a.launch.xml": LAUNCH.format(path),
        "urdf/robot.urdf": ROBOT.format(path),
        at: f"{CODE}{line}\n",
    }
    return [each.message for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize("code", ["LCH003", "URD002"])
@pytest.mark.parametrize(
    "line",
    [
        "open(folder + '/made.yaml', 'w')",
        "open(os.path.join(folder, 'made.yaml'), mode='wb')",
        "open(path, 'a')",
        "open(path, 'x+')",
        "path.open('w')",
        "path.open(mode='w')",
        "path.write_text('a: 1')",
        "path.write_bytes(b'a: 1')",
        "shutil.copy('/etc/a.yaml', path)",
        "shutil.copy2('/etc/a.yaml', path)",
        "shutil.copyfile('/etc/a.yaml', path)",
        "open(share + '/config/../config/temp/made.yaml', 'w')",
    ],
)
def test_what_the_package_writes_is_not_missing(line: str, code: str) -> None:
    assert found(line, code) == []


@pytest.mark.parametrize("code", ["LCH003", "URD002"])
@pytest.mark.parametrize(
    "line",
    [
        "open(path)",
        "open(path, 'r')",
        "open(path, 'r+')",
        "open(path, which)",
        "open(path, 'wait')",
        "open()",
        "path.open()",
        "path.read_text()",
        "shutil.copy(path, '/etc/a.yaml')",
        "shutil.copy(path)",
        "print(path, 'w')",
        "open(folder + '/other.yaml', 'w')",
        "open('/tmp/config/temp/made.yaml', 'w')",
        "open(os.path.join(get_package_share_directory('other'), 'config/temp/made.yaml'), 'w')",
        "open(share + 'config/temp/made.yaml', 'w')",
    ],
)
def test_what_it_reads_or_writes_elsewhere_is_missing(line: str, code: str) -> None:
    (message,) = found(line, code)
    assert "config/temp" in message


@pytest.mark.parametrize("at", ["test/test_make.py", "docs/conf.py", "scripts/make.txt"])
def test_what_tests_write_is_missing(at: str) -> None:
    assert found("open(path, 'w')", "LCH003", at=at)


def test_another_package_may_read_it() -> None:
    files = {
        "maker/package.xml": manifest("", "ament_cmake", "my_pkg"),
        "maker/CMakeLists.txt": INSTALL,
        "maker/config/a.yaml": "a: 1\n",
        "maker/launch/b.launch.xml": "<launch/>\n",
        "maker/urdf/a.urdf": '<robot name="a"/>\n',
        "maker/scripts/make.py": f"{CODE}open(path, 'w')\n",
        "user/package.xml": manifest("  <exec_depend>my_pkg</exec_depend>\n", "ament_cmake", "user"),
        "user/CMakeLists.txt": CMAKE.replace("my_pkg", "user"),
        "user/launch/a.launch.xml": LAUNCH.format("config/temp/made.yaml"),
        "user/launch/b.launch.xml": LAUNCH.format("config/temp/mode.yaml"),
    }
    (finding,) = lint_files(files, ["LCH003"]).findings
    assert finding.location.path == "user/launch/b.launch.xml"


@pytest.mark.parametrize("line, count", [("", 1), ("(share / 'names/poeple.txt').write_text('Ada')\n", 0)])
def test_a_module_may_write_what_another_reads(line: str, count: int) -> None:
    example = next(rule for rule in all_rules() if rule.code == "DEP113").examples[1]
    code = (
        "from ament_index_python.packages import get_package_share_path\n\nshare = get_package_share_path('my_pkg')\n"
    )
    files = {**example.bad_files(), "my_pkg/maker.py": code + line}
    assert len(lint_files(files, ["DEP113"]).findings) == count
