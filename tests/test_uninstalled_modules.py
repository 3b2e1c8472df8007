"""Python modules of CMake packages that nothing installs: beside a script, and the package's own."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.testing import lint_files

PYTHON = "find_package(ament_cmake_python REQUIRED)\n"
SCRIPT = "install(PROGRAMS scripts/a.py DESTINATION lib/${PROJECT_NAME})\n"
BOTH = "install(PROGRAMS scripts/a.py scripts/b.py DESTINATION lib/${PROJECT_NAME})\n"
OWN = {"my_pkg/__init__.py": "", "my_pkg/words.py": ""}


def levels(lines: str, files: dict[str, str]) -> list[Severity]:
    package = {
        "package.xml": manifest("  <buildtool_depend>ament_cmake_python</buildtool_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
    }
    return [each.severity for each in lint_files({**package, **files}, ["CMK109"]).findings]


@pytest.mark.parametrize(
    ("lines", "code", "count"),
    [
        (SCRIPT, "import b", 1),
        (SCRIPT, "from b import c", 1),
        (SCRIPT, "import b\nimport b.c", 1),
        (SCRIPT, "import deep.c", 1),
        (SCRIPT, "import other", 0),
        (SCRIPT, "import json", 0),
        (SCRIPT, "from . import b", 0),
        (SCRIPT, "import sys\nsys.path.append('x')\nimport b", 0),
        (SCRIPT, "try:\n    import b\nexcept ImportError:\n    pass", 0),
        (BOTH, "import b", 0),
        (SCRIPT + "install(FILES scripts/b.py DESTINATION lib/${PROJECT_NAME})\n", "import b", 0),
        (SCRIPT + "install(DIRECTORY scripts/deep DESTINATION lib/${PROJECT_NAME})\n", "import deep.c", 0),
        (SCRIPT + "ament_python_install_module(scripts/b.py)\n", "import b", 0),
        (SCRIPT + "ament_environment_hooks(a.sh)\n", "import b", 0),
        (SCRIPT + "install(CODE b)\n", "import b", 0),
        (f"if(SOMETHING_ELSE)\n{SCRIPT}endif()\n", "import b", 0),
    ],
)
def test_a_module_beside_a_script(lines: str, code: str, count: int) -> None:
    modules = dict.fromkeys(("scripts/b.py", "scripts/json.py", "scripts/deep/__init__.py", "scripts/deep/c.py"), "")
    script = f"#!/usr/bin/env python3\n{code}\n"
    assert levels(lines, {"scripts/a.py": script, **modules}) == [Severity.WARNING] * count


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (PYTHON, [Severity.INFO]),
        ("", []),
        (f"if(SOMETHING_ELSE)\n{PYTHON}endif()\n", []),
        (f"{PYTHON}ament_python_install_package(my_pkg)\n", []),
        (f"{PYTHON}install(PROGRAMS my_pkg/words.py DESTINATION lib/${{PROJECT_NAME}})\n", []),
        (f"{PYTHON}install(CODE a)\n", []),
        (f"{PYTHON}include(${{WHEREVER}})\n", []),
        (f"{PYTHON}team_install(my_pkg)\n", []),
        (f"{PYTHON}ament_environment_hooks(a.sh)\n", []),
        (f"{PYTHON}pybind11_add_module(words a.cpp)\n", []),
        (f'{PYTHON}rosidl_generate_interfaces(my_pkg "msg/A.msg")\n', []),
        (f"{PYTHON}generate_parameter_module(words a.yaml)\n", []),
    ],
)
def test_the_package_of_the_packages_own_name(lines: str, expected: list[Severity]) -> None:
    assert levels(lines, OWN) == expected
    assert levels(lines, {"my_pkg/__init__.py": ""}) == []
    assert levels(lines, {path.replace("my_pkg", "other"): text for path, text in OWN.items()}) == []


def test_what_is_imported_too_is_told_once() -> None:
    files = {**OWN, "scripts/a.py": "#!/usr/bin/env python3\nimport my_pkg.words\n"}
    assert levels(PYTHON + SCRIPT, files) == [Severity.ERROR]


def test_a_module_beside_a_script_in_the_packages_own_folder() -> None:
    install = "install(PROGRAMS a.py DESTINATION lib/${PROJECT_NAME})\n"
    files = {"a.py": "#!/usr/bin/env python3\nimport b\n"}
    assert levels(install, {**files, "b.py": ""}) == [Severity.WARNING]
    assert levels(install, files) == []


def test_folders_of_data_whose_scripts_change_where_python_looks() -> None:
    data = "install(DIRECTORY trials DESTINATION share/${PROJECT_NAME})\n"
    files = {"trials/__init__.py": "", "trials/rates.py": "", "trials/first.py": "from trials.rates import x\n"}
    assert levels(data, files) == []
    script = {"scripts/a.py": "#!/usr/bin/env python3\nfrom trials.rates import x\n"}
    assert levels(SCRIPT, {**files, **script}) == [Severity.ERROR]
    able = {"scripts/b.py": "#!/usr/bin/env python3\nimport sys\nsys.path.append('x')\nfrom trials import first\n"}
    assert levels(BOTH, {**files, **script, **able}) == []


def test_interfaces_take_the_name_of_the_python_package() -> None:
    lines = f'{SCRIPT}rosidl_generate_interfaces(my_pkg "msg/A.msg")\n'
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        "scripts/a.py": "#!/usr/bin/env python3\nimport my_pkg.words\n",
        **OWN,
    }
    (found,) = lint_files(files, ["CMK109"]).findings
    assert found.message.endswith("the interfaces make a `my_pkg` of their own: move the modules to another package")
    assert (found.severity, found.fix) == (Severity.WARNING, None)


@pytest.mark.parametrize(
    ("path", "place", "level"),
    [
        ("scripts/a.py", "lib/${PROJECT_NAME}", Severity.ERROR),
        ("scripts/a.py", "share/${PROJECT_NAME}", Severity.INFO),
        ("launch/a.launch.py", "share/${PROJECT_NAME}", Severity.ERROR),
    ],
)
def test_who_imports_what_is_not_installed(path: str, place: str, level: Severity) -> None:
    kind = "PROGRAMS" if place.startswith("lib") else "FILES"
    files = {path: "#!/usr/bin/env python3\nfrom trials.rates import x\n", "trials/__init__.py": ""}
    files["trials/rates.py"] = "x = 1\n"
    assert levels(f"install({kind} {path} DESTINATION {place})\n", files) == [level]


IMPORTS = "from my_pkg import words\n"
LATE = "def late():\n    from my_pkg import words\n\n\ndef main():\n    print({})\n\n\nmain()\n"
DATA = "install(PROGRAMS scripts/a.py DESTINATION share/${PROJECT_NAME})\n"


@pytest.mark.parametrize(
    ("lines", "code", "page", "expected"),
    [
        (SCRIPT, IMPORTS, "", [Severity.ERROR]),
        (SCRIPT, "import rospy\n" + IMPORTS, "", [Severity.INFO]),
        (SCRIPT, IMPORTS + "import rospy\n", "", [Severity.ERROR]),
        (SCRIPT, "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    " + IMPORTS, "", []),
        (SCRIPT, LATE.format("late()"), "", [Severity.ERROR]),
        (SCRIPT, LATE.format("1"), "", [Severity.INFO]),
        (DATA, IMPORTS, "", [Severity.INFO]),
        (DATA, IMPORTS, "Run a.py, which lies in share.\n", [Severity.WARNING]),
    ],
)
def test_who_comes_to_the_import(lines: str, code: str, page: str, expected: list[Severity]) -> None:
    assert levels(lines, {"scripts/a.py": f"#!/usr/bin/env python3\n{code}", "README.md": page, **OWN}) == expected


def test_the_program_that_surely_ends_is_told_of() -> None:
    files = {"scripts/a.py": f"import rospy\n{IMPORTS}", "scripts/b.py": IMPORTS, **OWN}
    assert levels(BOTH, files) == [Severity.ERROR]


def test_a_module_beside_a_script_for_ros1() -> None:
    assert levels(SCRIPT, {"scripts/a.py": "import rospy\nimport b\n", "scripts/b.py": ""}) == [Severity.INFO]
    assert levels(SCRIPT, {"scripts/a.py": "import b\nimport rospy\n", "scripts/b.py": ""}) == [Severity.WARNING]


def test_a_python_package_beside_the_script_finds_its_own_modules() -> None:
    lines = "install(PROGRAMS src/a.py DESTINATION lib/${PROJECT_NAME})\n"
    below = "install(DIRECTORY src/my_pkg DESTINATION lib/${PROJECT_NAME})\n"
    own = {"src/my_pkg/__init__.py": "", "src/my_pkg/words.py": "", "src/my_pkg/a.py": "import my_pkg.words\n"}
    script = "#!/usr/bin/env python3\nfrom my_pkg import a\n"
    assert levels(lines + below, {"src/a.py": script, **own}) == []
    assert levels(lines + below.replace("lib/", "share/"), {"src/a.py": script, **own}) == [
        Severity.WARNING,
        Severity.ERROR,
    ]
