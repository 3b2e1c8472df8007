"""Packages whose files installed code looks for (DEP116): what declares them, and what is told elsewhere."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.looked_up_packages import may_be_elsewhere
from rospkg_cli.checks.lookups_for_users import THEIRS, UNUSED
from rospkg_cli.example import SETUP_CFG, SETUP_PY, SETUP_PY_FOR_ALL, manifest, scripts, setup_py
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.name_index import Index, dump
from rospkg_cli.ros.names import FetchedNames
from rospkg_cli.testing import lint_files

HEAD = "from ament_index_python import get_package_prefix, get_package_share_directory\n"
LOOKUP = "get_package_share_directory('nav2_bringup')\n"
NEEDS = "  <exec_depend>ament_index_python</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n"
PROGRAM = setup_py(scripts("talker = my_pkg.talker:main"))
MARKER = {"resource/my_pkg": "", "my_pkg/__init__.py": "", "setup.cfg": SETUP_CFG, "setup.py": PROGRAM}


def told(text: str, depends: str = "", path: str = "my_pkg/talker.py", **more: str) -> list[tuple[str, str]]:
    files = {**MARKER, "package.xml": manifest(NEEDS + depends), path: HEAD + text, **more}
    return [(f.severity.value, f.message.split("`")[1]) for f in lint_files(files, ["DEP116"]).findings]


@pytest.mark.parametrize("text", [LOOKUP, LOOKUP + LOOKUP, "get_package_prefix('nav2_bringup')\n"])
def test_a_package_whose_files_are_looked_for_is_told_once(text: str) -> None:
    assert told(text) == [("warning", "nav2_bringup")]
    assert told(text, "  <exec_depend>nav2_bringup</exec_depend>\n") == []


@pytest.mark.parametrize(
    "text, path",
    [
        (LOOKUP, "test/test_talker.py"),
        ("get_package_share_directory('my_pkg')\n", "my_pkg/talker.py"),
        ("get_package_share_directory('nobodys_package')\n", "my_pkg/talker.py"),
        ("get_package_share_directory(name)\n", "my_pkg/talker.py"),
        (f"try:\n    {LOOKUP}except PackageNotFoundError:\n    pass\n", "my_pkg/talker.py"),
        (f"import nav2_bringup\n{LOOKUP}", "my_pkg/talker.py"),
    ],
)
def test_what_may_be_absent_or_is_told_elsewhere(text: str, path: str) -> None:
    assert told(text, path=path) == []


@pytest.mark.parametrize(
    "name, is_complete, found",
    [("acme_arm", False, True), ("acme_arm", True, False), ("Acme's", False, False), ("a", False, False)],
)
def test_a_package_that_a_repository_may_have_that_is_not_here(name: str, is_complete: bool, found: bool) -> None:
    index = FetchedNames(dump(Index("", "", tuple(each.name for each in DISTROS), {}, {})))
    around = Workspace((PackageFacts("a", "a"),), frozenset({"a"}), is_complete, index=index)
    assert may_be_elsewhere(around, name) == found


def test_what_a_launch_file_needs_as_well_is_told_there() -> None:
    launch = (
        "from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='nav2_bringup', executable='x')])\n"
    )
    assert told(LOOKUP, **{"launch/a.launch.py": launch}) == []


def test_what_comes_with_others_is_an_info() -> None:
    text = "get_package_share_directory('rviz_common')\n"
    assert told(text, "  <exec_depend>rviz2</exec_depend>\n") == [("info", "rviz_common")]
    assert [level for level, _ in told(LOOKUP, "  <!-- <exec_depend>nav2_bringup</exec_depend> -->\n")] == ["info"]


LIBRARY = """\
from ament_index_python import get_package_share_directory


def share():
    return get_package_share_directory('arm')


def limits():
    return share() + '/limits.yaml'


def name():
    return 'arm'
"""
LAUNCH = "from lib.helpers import {}\n\n\ndef generate_launch_description():\n    pass\n"


def python_package(name: str, depends: str = "", **files: str) -> dict[str, str]:
    own = {f"{name}/__init__.py": "", f"resource/{name}": "", "setup.cfg": SETUP_CFG, "setup.py": SETUP_PY, **files}
    texts = {path: text.replace("my_pkg", name) for path, text in own.items()}
    return {f"{name}/{path}": text for path, text in {**texts, "package.xml": manifest(depends, name=name)}.items()}


def from_library(users: dict[str, tuple[str, str]], **more: str) -> list[tuple[str, str]]:
    """Return level and end of what is said of a library, by what others import of it and declare."""
    above = {path.removeprefix("../"): more.pop(path) for path in [*more] if path.startswith("../")}
    files = {**python_package("arm"), **python_package("lib", NEEDS, **{"lib/helpers.py": LIBRARY, **more}), **above}
    for name, (taken, depends) in users.items():
        files |= python_package(name, depends, **{"launch/a.launch.py": LAUNCH.format(taken)})
    found = lint_files(files, ["DEP116"]).findings
    return [(each.severity.value, each.message.rpartition("; ")[2]) for each in found]


HAS_ARM = "  <exec_depend>arm</exec_depend>\n"
NOBODY, THEIRS_IT_IS = UNUSED.removeprefix("; "), THEIRS.removeprefix("; ")
UNSHOWN = "comes to this line"
ADD = "add <exec_depend>arm</exec_depend>"


@pytest.mark.parametrize(
    ("users", "level", "end"),
    [
        ({"arm": ("limits", "")}, "info", "would make a circle: let those declare it who call this"),
        ({"arm": ("name", "")}, "info", UNSHOWN),
        ({"one": ("limits", HAS_ARM), "two": ("name", "")}, "info", "has that one itself"),
        ({"one": ("limits", HAS_ARM), "two": ("share", "")}, "warning", ADD),
        ({"one": ("name", HAS_ARM)}, "info", UNSHOWN),
        ({}, "info", UNSHOWN),
    ],
)
def test_what_a_library_looks_for_in_the_name_of_its_users(
    users: dict[str, tuple[str, str]], level: str, end: str
) -> None:
    ((found, said),) = from_library(users)
    assert (found, said.endswith(end)) == (level, True), said


def test_a_library_with_a_program_of_its_own_looks_for_itself() -> None:
    program = "from .helpers import limits\n\n\ndef main():\n    print(limits())\n"
    setup = setup_py(scripts("show = lib.show:main"))
    ((level, _),) = from_library({"one": ("limits", HAS_ARM)}, **{"lib/show.py": program, "setup.py": setup})
    assert level == "warning"


@pytest.mark.parametrize(("taken", "level"), [("name", "info"), ("share", "warning"), ("*", "warning")])
def test_a_library_may_use_what_else_the_module_has(taken: str, level: str) -> None:
    more = {"lib/builder.py": f"from lib.helpers import {taken}\n", "lib/other.py": ""}
    users = {"one": ("limits", HAS_ARM), "two": ("name", "")}
    ((found, _),) = from_library(users, **more)
    assert found == level
    ((found, _),) = from_library({"one": ("limits", HAS_ARM)}, **more)
    assert found == "info", "each package that uses any part of the library has it"


@pytest.mark.parametrize(
    ("middle", "level"),
    [(HAS_ARM, "info"), (HAS_ARM.replace("exec_", "test_"), "warning"), ("", "warning")],
)
def test_a_user_has_what_comes_with_what_it_declares(middle: str, level: str) -> None:
    needs = "  <exec_depend>app</exec_depend>\n"
    ((found, _),) = from_library({"one": ("limits", needs), "app": ("name", middle)})
    assert found == level


def test_a_user_has_what_comes_with_a_released_package() -> None:
    lookup = {"lib/helpers.py": LIBRARY.replace("'arm'", "'rviz_common'")}
    for needs, level in (("rviz2", "info"), ("rclpy", "warning")):
        depend = f"  <exec_depend>{needs}</exec_depend>\n"
        ((found, _),) = from_library({"one": ("limits", depend)}, **lookup)
        assert found == level


AT_ONCE = f"{HEAD}ARM = get_package_share_directory('arm')\n\n\ndef limits():\n    return ARM\n"
BY_PATH = "\n\nif __name__ == '__main__':\n    limits()\n"


@pytest.mark.parametrize(
    ("more", "end"),
    [
        ({}, NOBODY),
        ({"launch/a.launch.py": LAUNCH.format("limits")}, ADD),
        ({"setup.py": setup_py("entry_points={'ros2cli.verb': ['a = lib.helpers:limits']},")}, ADD),
        ({"config/tools.yaml": "tool: lib.helpers\n"}, ADD),
        ({"../README.md": "    colcon build --packages-select lib\n"}, ADD),
        ({"README.md": "    from lib.helpers import limits\n"}, ADD),
        ({"README.md": "It is no import from lib, it is\n"}, NOBODY),
        ({"../scripts/show.py": "import lib.helpers\n"}, ADD),
        ({"lib/helpers.py": AT_ONCE + BY_PATH, "README.md": "Run `python3 lib/helpers.py`.\n"}, ADD),
    ],
)
def test_what_a_library_that_nothing_uses_looks_for_is_an_info(more: dict[str, str], end: str) -> None:
    ((level, said),) = from_library({}, **{"lib/helpers.py": AT_ONCE, **more})
    assert (level, said) == ("warning" if end == ADD else "info", end)


IN_CPP = """\
#include "lib/share.hpp"

#include <ament_index_cpp/get_package_share_directory.hpp>

std::string share() { return ament_index_cpp::get_package_share_directory("arm"); }
"""
OF_LIB = """\
cmake_minimum_required(VERSION 3.20)
project(lib)
find_package(ament_cmake REQUIRED)
find_package(ament_index_cpp REQUIRED)
add_library(share SHARED src/share.cpp)
target_link_libraries(share ament_index_cpp::ament_index_cpp)
install(TARGETS share EXPORT lib_targets DESTINATION lib)
install(DIRECTORY include/ DESTINATION include)
ament_package()
"""
OF_USER = """\
cmake_minimum_required(VERSION 3.20)
project(user)
find_package(ament_cmake REQUIRED)
find_package(lib REQUIRED)
add_executable(user src/user.cpp)
ament_package()
"""
TAKES = "  <depend>lib</depend>\n"
PROGRAM_HERE = "add_executable(show src/show.cpp)\ninstall(TARGETS show DESTINATION lib/lib)\n"
LOADS = "\nGZ_REGISTER_MODEL_PLUGIN(Share)\n"


def in_cpp(name: str, depends: str, **files: str) -> dict[str, str]:
    texts = {"package.xml": manifest(depends, name=name, build_type="ament_cmake"), **files}
    return {f"{name}/{path}": text for path, text in texts.items()}


@pytest.mark.parametrize(
    ("users", "own", "end"),
    [
        ({}, {}, NOBODY),
        ({"user": TAKES}, {}, ADD),
        ({"user": TAKES + HAS_ARM}, {}, THEIRS_IT_IS),
        ({"user": TAKES + HAS_ARM, "app": TAKES}, {}, ADD),
        ({"app": HAS_ARM, "user": f"{TAKES}  <depend>app</depend>\n"}, {}, THEIRS_IT_IS),
        ({}, {"CMakeLists.txt": OF_LIB.replace("ament_pack", f"{PROGRAM_HERE}ament_pack")}, ADD),
        ({}, {"src/share.cpp": IN_CPP + LOADS}, ADD),
    ],
)
def test_what_a_library_of_cpp_looks_for_is_the_matter_of_those_who_link_it(
    users: dict[str, str], own: dict[str, str], end: str
) -> None:
    lib = {"CMakeLists.txt": OF_LIB, "src/share.cpp": IN_CPP, "include/lib/share.hpp": "#include <string>\n", **own}
    files = {**python_package("arm"), **in_cpp("lib", "  <depend>ament_index_cpp</depend>\n", **lib)}
    for name, depends in users.items():
        build = OF_USER.replace("(user", f"({name}") if TAKES in depends else OF_USER.replace("find_package(lib", "#")
        code = '#include "lib/share.hpp"\n\nint main() { share(); }\n'
        files |= in_cpp(name, depends, **{"CMakeLists.txt": build, "src/user.cpp": code if TAKES in depends else ""})
    (found,) = lint_files(files, ["DEP116"]).findings
    assert (found.severity.value, found.message.rpartition("; ")[2]) == ("warning" if end == ADD else "info", end)


@pytest.mark.parametrize(("starts", "level"), [("arm", "info"), ("other", "warning")])
def test_a_user_that_starts_what_the_library_looks_for_needs_it_anyway(starts: str, level: str) -> None:
    files = {**python_package("arm"), **python_package("lib", NEEDS, **{"lib/helpers.py": LIBRARY})}
    user = {"launch/a.launch.py": LAUNCH.format("limits"), "launch/b.launch.xml": STARTS.format(starts)}
    files |= python_package("one", "", **user)
    (only,) = lint_files(files, ["DEP116"]).findings
    assert only.severity.value == level


STARTS = "<launch>\n  <node pkg='{}' exec='talker'/>\n</launch>\n"


@pytest.mark.parametrize(("starts", "level"), [("my_pkg", "info"), ("nav2_bringup", "warning")])
def test_a_package_that_starts_this_ones_programs_is_not_to_be_declared_by_it(starts: str, level: str) -> None:
    lookup = f"{HEAD}A = get_package_share_directory('app')"
    own = {**MARKER, "package.xml": manifest(NEEDS), "my_pkg/talker.py": lookup}
    other = {"package.xml": manifest().replace("my_pkg<", "app<", 1), "launch/app.launch.xml": STARTS.format(starts)}
    other |= {"resource/app": "", "setup.py": SETUP_PY_FOR_ALL.replace("my_pkg", "app")}
    files = {f"one/{path}": text for path, text in own.items()} | {f"app/{path}": text for path, text in other.items()}
    (only,) = lint_files(files, ["DEP116"]).findings
    assert only.severity.value == level
    assert ("circle" in only.message) == (only.fix is None) == (level == "info")
