"""Where it is open how a package is built, that is told, and nothing that follows from it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

CPP, PYTHON = existing_files(BACKDROPS["ament_cmake"]), existing_files(BACKDROPS["ament_python"])
LAUNCH = "<launch>\n  <node pkg='my_pkg' exec='no_such'/>\n</launch>\n"
NEEDS = "  <exec_depend>ros2launch</exec_depend>\n"
COMPONENT = (
    "<launch>\n  <node_container pkg='rclcpp_components' exec='component_container' name='c' namespace=''>\n"
    "    <composable_node pkg='my_pkg' plugin='my_pkg::A' name='a'/>\n  </node_container>\n</launch>\n"
)


def second(text: str, build_type: str, condition: str = "") -> str:
    attribute = f' condition="{condition}"' if condition else ""
    return text.replace("  </export>", f"    <build_type{attribute}>{build_type}</build_type>\n  </export>")


def codes(files: dict[str, str]) -> list[str]:
    return sorted(
        {f.code for f in lint_files(files, ["LCH002", "LCH011", "IDL008", "XML303", "XML304", "XML307"]).findings}
    )


@pytest.mark.parametrize(
    "text, told",
    [
        (manifest(NEEDS, "ament_cmake"), ["LCH002"]),
        (second(manifest(NEEDS, "ament_cmake"), "ament_python"), ["XML303"]),
        (second(manifest(NEEDS, "ament_cmake"), "catkin", "$ROS_VERSION == 1"), ["LCH002"]),
        (manifest(NEEDS, "ament_python"), ["XML304"]),
        (manifest(NEEDS, "cmake"), ["LCH002", "XML304"]),
    ],
)
def test_executables_of_a_package_of_cmake(text: str, told: list[str]) -> None:
    cmake = CMAKE.replace(
        "ament_package()", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package()"
    )
    assert codes({**CPP, "package.xml": text, "CMakeLists.txt": cmake, "launch/a.launch.xml": LAUNCH}) == told


def test_components_and_interfaces_beside_another_build_type() -> None:
    files = {**CPP, "launch/a.launch.xml": COMPONENT, "msg/A.msg": "float32 x\n"}
    assert codes({**files, "package.xml": manifest(NEEDS, "ament_cmake")}) == ["LCH011"]
    assert codes({**files, "package.xml": manifest(NEEDS, "ament_python")}) == ["XML304"]
    assert codes({**files, "package.xml": second(manifest(NEEDS, "ament_cmake"), "ament_python")}) == ["XML303"]


def test_a_neighbour_concludes_nothing_either() -> None:
    """Facts that are collected on demand have the same doubts."""
    other = {"b/package.xml": manifest(NEEDS + "  <exec_depend>my_pkg</exec_depend>\n", "ament_cmake", "b")}
    other = {"b/package.xml": other["b/package.xml"].replace("<exec_depend>b<", "<exec_depend>my_pkg<")}
    other |= {"b/CMakeLists.txt": CMAKE.replace("my_pkg", "b"), "b/launch/a.launch.xml": LAUNCH}
    one = {f"a/{path}": text for path, text in CPP.items()}
    assert "LCH002" in codes({**one, **other})
    assert "LCH002" not in codes({**one, **other, "a/package.xml": second(manifest("", "ament_cmake"), "ament_python")})


ENTRIES = "'a = my_pkg.a:main', 'b = my_pkg.b:main', 'c = my_pkg.sub.c:main'"


def told_of_setup(packages: str) -> list[tuple[str, str, int]]:
    text = setup_py(scripts(ENTRIES.strip("'").replace("', '", "', '"))).replace(
        "packages=find_packages(exclude=['test'])", f"packages={packages}"
    )
    files = {**PYTHON, "setup.py": text, "my_pkg/sub/__init__.py": ""}
    files |= {f"my_pkg/{name}.py": "def main():\n    print(1)\n" for name in ("a", "b", "sub/c")}
    found = lint_files(files, ["SET105", "SET302"]).findings
    return [(f.code, f.message.partition(": ")[2], len(f.related)) for f in found]


def test_entry_points_of_one_package_are_one_finding() -> None:
    green = "the build is green, and "
    assert told_of_setup("[]") == [
        ("SET105", f"{green}`a` and 2 more raise ModuleNotFoundError; add `my_pkg` and `my_pkg.sub` to `packages`", 2),
    ]


def test_a_package_that_is_not_there_stops_the_build_before() -> None:
    assert told_of_setup("['my_pk']") == [("SET302", "setuptools stops; did you mean `my_pkg`?", 0)]
    assert told_of_setup("['my_pkg', 'other', 'my_pkg.sub']") == [
        ("SET302", "setuptools stops; list packages that are there", 0)
    ]


def test_a_package_itself_may_be_the_module_of_an_entry_point() -> None:
    text = setup_py(scripts("talker = my_pkg.__init__:main"))
    files = {**PYTHON, "setup.py": text, "my_pkg/__init__.py": "def main():\n    print(1)\n"}
    assert lint_files(files, ["SET101", "SET102", "SET105"]).findings == ()
    (found,) = lint_files(
        {**files, "setup.py": text.replace("find_packages(exclude=['test'])", "[]")}, ["SET105"]
    ).findings
    assert found.message.endswith("add `my_pkg` to `packages`")
