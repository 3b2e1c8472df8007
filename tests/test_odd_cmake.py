"""Odd CMake: commands without what they need, and names that CMake would not take. No rule may stumble over them."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.discovery.discover import packages_in
from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Safety
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

FILES = {"launch/a.launch.py": "def generate_launch_description():\n    return LaunchDescription()\n"}
FALLEN = "RPK005"


def package(lines: str, name: str = "my_pkg") -> dict[str, str]:
    cmake = CMAKE.replace("ament_package()", f"{lines}\nament_package()")
    return {"package.xml": manifest("", "ament_cmake", name), "CMakeLists.txt": cmake, **FILES}


def fallen(files: dict[str, str]) -> list[str]:
    """Return what rules broke on."""
    return [finding.message for finding in lint_files(files).findings if finding.code == FALLEN]


@pytest.mark.parametrize("items", ["", '""', "${nothing}"])
@pytest.mark.parametrize("kind", ["DIRECTORY", "FILES", "PROGRAMS", "TARGETS"])
def test_an_install_rule_may_have_no_item(kind: str, items: str) -> None:
    lines = f"add_library(l SHARED src/a.cpp)\ninstall({kind} {items} DESTINATION share/${{PROJECT_NAME}})"
    assert fallen(package(lines)) == []
    assert fallen(package(lines.replace("share", "lib"))) == []


HOSTILE = "a) message(hi"


def repaired(files: dict[str, str], *codes: str) -> dict[str, str]:
    """Return what all fixes of some rules change."""
    tree = MemoryTree.of(files)
    folders = packages_in(tree)
    session = Session(tree, Scope(tuple(folders), frozenset(folders), "my_pkg"), frozenset(codes))
    changes = fix_all(session, tuple(Safety)).changes
    return {path: entry.text.text for path, entry in changes.items() if entry}


@pytest.mark.parametrize("name", ["a b", HOSTILE, "${a}", "a;b", '"', "a#b"])
def test_a_project_is_only_renamed_to_what_is_a_name(name: str) -> None:
    files = package("", "my_pkg")
    files["package.xml"] = files["package.xml"].replace("my_pkg", name)
    assert repaired(files, "CMK001") == {}
    (finding,) = lint_files(files, ["CMK001"]).findings
    assert finding.fix is None
    assert f"project({name}" not in finding.message


@pytest.mark.parametrize("script", ["b c.py", "b;c.py", "$(c).py", "b) message(hi.py", "${X}.py"])
def test_a_script_goes_into_cmake_only_where_its_name_is_one_word(script: str) -> None:
    files = package("install(PROGRAMS scripts/a.py DESTINATION lib/${PROJECT_NAME})")
    code = "#!/usr/bin/env python3\nprint()\n"
    plain = {**files, "scripts/a.py": code, "scripts/b.py": code}
    assert "scripts/b.py" in repaired(plain, "CMK112")["CMakeLists.txt"]
    assert repaired({**files, "scripts/a.py": code, f"scripts/{script}": code}, "CMK112") == {}
