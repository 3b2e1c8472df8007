"""Names that a class body binds: its statements, decorators and defaults see them, the bodies of its methods don't."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

TEST = """\
import unittest

from launch import LaunchDescription


def generate_{entry}_description():
    return LaunchDescription([])


class TestTalker(unittest.TestCase):
    bus = (True, 'no bus')

{lines}
"""


def found(lines: str, entry: str = "test") -> list[str]:
    text = TEST.format(lines=lines, entry=entry)
    files = {"package.xml": manifest(), "test/test_talker.launch.py": text}
    return [each.message for each in lint_files(files, ["LCH013"]).findings]


@pytest.mark.parametrize(
    "method",
    [
        "    @unittest.skipUnless(bus[0], bus[1])\n    def test_it(self):\n        pass",
        "    def test_it(self, which=bus):\n        pass",
        "    def test_it(self, *, which=bus):\n        pass",
        "    async def test_it(self, which=bus):\n        pass",
        "    @unittest.skipUnless(bus[0], bus[1])\n    class Inner:\n        pass",
    ],
)
def test_what_stands_in_the_class_body_sees_its_names(method: str) -> None:
    assert found(method) == []


@pytest.mark.parametrize(
    "method, name",
    [
        ("    def test_it(self):\n        print(bus)", "bus"),
        ("    @unittest.skipUnless(wire, 'none')\n    def test_it(self):\n        pass", "wire"),
        ("    def test_it(self, which=wire):\n        pass", "wire"),
    ],
)
def test_what_the_class_does_not_bind_is_undefined(method: str, name: str) -> None:
    (message,) = found(method)
    assert message.startswith(f"`{name}` is defined nowhere: the test stops with NameError")


def test_methods_see_their_class_and_arguments() -> None:
    assert found("    def test_it(self):\n        print(__class__, self)") == []


def test_what_stops_is_the_launch_or_the_test() -> None:
    method = "    def test_it(self):\n        print(wire)"
    assert found(method, "launch") == ["`wire` is defined nowhere: the launch stops with NameError"]
    assert found("    if bus:\n        print(wire)") == [
        "`wire` is defined nowhere: the test stops with NameError where it gets here"
    ]


def test_a_test_description_is_called() -> None:
    lines = "def helper():\n    return wire\n\n\ndef generate_test_description():\n    return helper()"
    assert found(lines) == ["`wire` is defined nowhere: the test stops with NameError"]


def test_late_names_and_wrong_imports_stop_the_test() -> None:
    late = "    def test_it(self):\n        print(wire)\n        wire = 1"
    assert found(late) == [
        "`wire` is used here and assigned in line 15: the test stops with UnboundLocalError; assign it first"
    ]
    (message,) = found("from launch import LogInfo")
    assert message.startswith("`launch` has no `LogInfo`: the test stops with ImportError; import it from")
