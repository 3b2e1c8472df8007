"""Texts of a package that get into new files: none of them is code there."""

from __future__ import annotations

import ast

import pytest
from adding import added, cmake_package, python_package, taken, text
from test_add_others import CMAKE, INTERFACES, SETUP, interfaces_package

from rospkg_cli.change import ChangeError


def test_names_that_no_code_can_hold() -> None:
    files = python_package(SETUP)
    files["package.xml"] = files["package.xml"].replace(">my_pkg<", ">my'pkg<")
    with pytest.raises(ChangeError, match="`my'pkg` is no name for a package"):
        added(files, "launch", "up")
    with pytest.raises(ChangeError, match="can't be a node to start"):
        added(python_package(SETUP), "launch", "up", nodes=("a/b'",))
    files = python_package(SETUP.replace("[package_name]", "['my-pkg']")) | {"my-pkg/__init__.py": ""}
    with pytest.raises(ChangeError, match="`my-pkg` is no name that Python can import"):
        added(files, "node", "idler:empty")
    with pytest.raises(ChangeError, match="is no name that Python can import"):
        added(
            cmake_package(CMAKE.replace("add_e", "ament_python_install_package(a-b)\nadd_e")),
            "node",
            "x_node:empty:python",
        )


def test_executables_with_odd_names_are_not_started() -> None:
    draft = added(python_package(SETUP.replace("'old =", "\"o'ld =").replace(":main']", ':main"]')), "launch", "up")
    assert "executable=" not in text(draft, "launch/up.launch.py")


@pytest.mark.parametrize("name", ["coding: utf-7", "A\u202eda", "x" * 300, '"""\\N', "{{ name }}"])
def test_maintainers_are_only_a_comment(name: str) -> None:
    files = python_package(SETUP)
    files["package.xml"] = files["package.xml"].replace(">Ada<", f">{name}<")
    source = text(added(files, "node", "idler:empty"), "my_pkg/idler.py")
    assert "utf-7" not in source
    assert ast.parse(source)


def test_interfaces_that_were_edited_are_kept() -> None:
    files = interfaces_package(INTERFACES) | {"msg/Able.msg": "# by hand\nint32   a\n"}
    draft = added(files, "msg", "Status")
    with pytest.raises(ChangeError, match=r"`msg/Able.msg` is not as `add` writes it"):
        taken(draft, "msg", "Able")
    after, _ = taken(draft, "msg", "Able", force=True)
    assert after.entry("msg/Able.msg") is None
    assert "Able" not in text(after, "CMakeLists.txt")


def test_a_header_that_differs_is_none_of_its_business() -> None:
    draft = added(python_package(SETUP), "node", "idler:empty")
    files = {path: text(draft, path) for path in draft.tree.files()}
    files["my_pkg/idler.py"] = files["my_pkg/idler.py"].replace("Copyright 2026 Ada", "Copyright 2020 Bob")
    after, _ = taken(added(files, "node", "other:empty"), "node", "idler")
    assert after.entry("my_pkg/idler.py") is None
