"""Share directories that Python modules look in: what no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, SETUP_PY, Example, manifest
from rospkg_cli.rules.depends import dep113_missing_share_file as dep113

from .setups import python

HEAD = """\
import os
from os.path import join
from pathlib import Path
from ament_index_python.packages import get_package_prefix, get_package_share_directory, get_package_share_path
from launch_ros.substitutions import FindPackageShare

NAME = 'my_pkg'
"""
NEEDS = {
    "package.xml": manifest("  <exec_depend>ament_index_python</exec_depend>\n  <exec_depend>seldom</exec_depend>\n")
}
FILES = {**NEEDS, "names/people.txt": "Ada\n", "setup.py": dep113.INSTALLED}
YAML_ALONE = 'DIRECTORY config DESTINATION share/${PROJECT_NAME} FILES_MATCHING PATTERN "*.yaml"'
OWN = "get_package_share_directory('my_pkg')"


def lookup(*lines: str, **files: str | None) -> Example:
    paths = {name.replace("__", "/").replace("_DOT_", "."): each for name, each in files.items()}
    return python({**FILES, "my_pkg/talker.py": HEAD + "".join(f"{line}\n" for line in lines), **paths})


def in_cpp(*lines: str, path: str = "src/talker.cpp") -> Example:
    return python({**NEEDS, path: "".join(f"{line}\n" for line in lines)})


def opened_in_cpp(install: str, file: str) -> Example:
    """A node that reads a file which its package has and may not install."""
    share = 'ament_index_cpp::get_package_share_directory("my_pkg")'
    launch: dict[str, str | None] = {f"launch/{each}.launch.xml": "<launch/>\n" for each in "abc"}
    return Example(
        bad={
            "package.xml": manifest("  <depend>ament_index_cpp</depend>\n", "ament_cmake"),
            "CMakeLists.txt": CMAKE.replace(
                "ament_package", f"add_executable(talker src/a.cpp)\ninstall({install})\nament_package"
            ),
            "src/a.cpp": f'int main() {{read({share} + "/{file}");}}\n',
            "config/a.yaml": "a: 1\n",
            "config/words.txt": "a\n",
            **launch,
        },
        good={},
        on="ament_cmake",
    )


CASES = {
    "DEP112": (
        in_cpp(
            'auto a = ament_index_cpp::get_package_share_directory("my_pgk") + "/a";',
            'auto b = get_package_prefix( "sedlom" );',
            'auto c = get_package_share_path("my_pkg"), d = get_package_prefix("unlike_all");',
            '// get_package_share_path("my_pgk")',
            'auto e = get_package_share_directory(name), f = get_package_share_directory("my_pgk" + name);',
        ),
        in_cpp(
            "try {",
            '  get_package_prefix("my_pgk");',
            "} catch (const ament_index_cpp::PackageNotFoundError &) {",
            "}",
        ),
        in_cpp('auto a = get_package_share_directory("my_pgk");', path="test/talker.cpp"),
        lookup(
            "get_package_share_path('my_pgk')",
            "get_package_prefix(package_name='my_pkgg')",
            "FindPackageShare('sedlom')",
        ),
        lookup(
            "get_package_share_path('nav2_bringpu')", "get_package_share_path('nav2')", "get_package_share_path('tfx')"
        ),
        lookup("get_package_share_path('unlike_all')", "get_package_share_path(name)", "get_package_share_path('')"),
        lookup(
            "get_package_share_path('seldom')",
            "get_package_share_path(NAME)",
            "other('my_pgk')",
            "get_package_share_path()",
        ),
        lookup("try:", "    get_package_share_path('my_pgk')", "except PackageNotFoundError:", "    pass"),
        lookup("try:", "    get_package_share_path('my_pgk')", "except packages.PackageNotFoundError:", "    pass"),
        lookup("try:", "    get_package_share_path('my_pgk')", "except ValueError:", "    os.path.exists('a')"),
        lookup("", launch__a_DOT_py=HEAD + "get_package_share_path('my_pgk')\n"),
        lookup("", test__test_a_DOT_py=HEAD + "get_package_share_path('my_pgk')\n"),
        lookup("", tools__a_DOT_py=HEAD + "get_package_share_path('my_pgk')\n"),
    ),
    "DEP113": (
        lookup(f"join({OWN}, 'names', 'peopl.txt')", f"os.path.join({OWN}, 'names/people.txt')"),
        lookup(f"a = {OWN}", "b = join(a, 'names')", "c = Path(b) / 'peopl.txt'", "print(a, b, c)"),
        lookup(
            f"Path({OWN}).joinpath('names', 'peopl.txt')", "str(get_package_share_path(NAME) / 'names' / 'peopl.txt')"
        ),
        lookup(
            f"a = {OWN}",
            "print(f'{a}/names/peopl.txt', f'{a}names/peopl.txt', f'{x}/names/peopl.txt')",
            "a + '/names/peopl.txt'",
        ),
        lookup("FindPackageShare('my_pkg') / 'names' / 'peopl.txt'", "other('my_pkg') / 'names' / 'peopl.txt'"),
        lookup(
            f"a = {OWN}",
            "a = x",
            "join(a, 'names', 'peopl.txt')",
            f"join({OWN}, x, 'peopl.txt')",
            f"x({OWN}, 'peopl.txt')",
        ),
        lookup(f"def f(a):\n    a = {OWN}\n    return join(a, 'names', 'peopl.txt')"),
        lookup(
            f"join({OWN}, '/names', 'peopl.txt')", f"join({OWN}, 'names', 'unlike.csv')", f"join({OWN}, 'names', 'p')"
        ),
        lookup(
            f"join({OWN}, '..', 'names', 'peopl.txt')", f"join({OWN}, 'names', 'peopl.log')", f"join({OWN}, sep='a')"
        ),
        lookup(f"if os.path.exists({OWN}):\n    join({OWN}, 'names', 'peopl.txt')"),
        lookup(f"join({OWN}, 'names', 'peopl.txt')", _DOT_gitignore="peopl.txt\n"),
        lookup(f"join({OWN}, 'names', 'people.txt')", setup_DOT_py=SETUP_PY, _DOT_gitignore="*.txt\n"),
        lookup(f"join({OWN}, 'config', 'a.yaml')", config__a_DOT_yaml="a: 1\n"),
        lookup(f"join({OWN}, 'names', 'peopl.txt')", setup_DOT_py=SETUP_PY.replace("['package.xml']", "found()")),
        lookup("join(get_package_share_directory('other'), 'names', 'peopl.txt')"),
        lookup("", launch__a_DOT_py=HEAD + f"join({OWN}, 'names', 'peopl.txt')\n"),
        *(opened_in_cpp(install, file)
          for install, file in (
              (YAML_ALONE, "config/words.txt"),
              (YAML_ALONE, "config/a.yaml"),
              ("DIRECTORY config/ DESTINATION share/${PROJECT_NAME}", "config/a.yaml"),
              ("FILES config/a.yaml DESTINATION etc/${PROJECT_NAME}", "config/a.yaml"),
              ("DIRECTORY src DESTINATION share/${PROJECT_NAME}", "config/a.yaml"),
              ("FILES launch/a.launch.xml launch/b.launch.xml DESTINATION share/${PROJECT_NAME}/launch",
               "launch/c.launch.xml"),
          )),
    ),
}  # fmt: skip
