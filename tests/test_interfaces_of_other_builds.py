"""Interface files that another branch of CMakeLists.txt, another package or nothing at all generates."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, INTERFACES_CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

INTERFACES = existing_files(BACKDROPS["interfaces"])
BOTH = INTERFACES_CMAKE.replace(
    "find_package(ament_cmake REQUIRED)", "find_package(ament_cmake QUIET)\nif(ament_cmake_FOUND)"
)
BOTH += "elseif(CATKIN_DEVEL_PREFIX)\n  find_package(catkin REQUIRED)\n  LISTS\n  generate_messages()\nendif()\n"


def codes(files: dict[str, str], *wanted: str) -> list[str]:
    return [each.code for each in lint_files(files, wanted).findings]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("add_message_files(DIRECTORY msg FILES Link.msg)", []),
        ("set(FILES Link.msg)\n  add_message_files(FILES ${FILES})", []),
        ("add_message_files(FILES Other.msg)", ["IDL005"]),
        ("add_message_files(FILES OtherLink.msg)", ["IDL005"]),
    ],
)
def test_what_the_branch_of_catkin_lists(lines: str, expected: list[str]) -> None:
    files = {**INTERFACES, "CMakeLists.txt": BOTH.replace("LISTS", lines), "msg/Link.msg": "string uri\n"}
    assert codes(files, "IDL005") == expected


UNREAD = "project(my_pkg)\nfind_package(ament_cmake REQUIRED)\nadd_subdirectory(src/driver)\nament_package()\n"


@pytest.mark.parametrize(
    ("body", "cmake", "expected"),
    [
        ("  <depend>lidar_msg</depend>\n", UNREAD, []),
        ("  <depend>rosidl_default_generators</depend>\n", UNREAD, ["IDL002"]),
        ("  <member_of_group>rosidl_interface_packages</member_of_group>\n", UNREAD, ["IDL002"]),
        ("", UNREAD + "if(FALSE)\n  rosidl_generate_interfaces(a b.msg)\nendif()\n", ["IDL002"]),
        ("", UNREAD.replace("ament_package", "rosidl_generate_interfaces(a ${ALL})\nament_package"), ["IDL002"]),
    ],
)
def test_messages_beside_code_of_a_package_that_generates_none(body: str, cmake: str, expected: list[str]) -> None:
    files = {"package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": cmake}
    files |= {"src/msg/ros_msg/Packet.msg": "uint8[] data\n", ".gitmodules": '[submodule "a"]\n  path = src/driver\n'}
    assert codes(files, "IDL002") == expected
