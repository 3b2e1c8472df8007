"""`rospkg add plugin` and `remove plugin`."""

from __future__ import annotations

import pytest
from adding import added, cmake_package, comes_back, new_findings, python_package, taken, text
from planned import plan, texts
from test_add_to_cmake import AUTO, BARE, LOWER

from rospkg_cli.change import ChangeError


def test_plugins_can_be_added_and_removed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DISTRO", "lyrical")
    files = cmake_package(LOWER)
    for kind in ("costmap-layer", "bt-node", "hardware-interface"):
        draft = added(files, "plugin", f"thing:{kind}")
        assert new_findings(files, draft) == [], kind
        comes_back(files, draft, "plugin", "thing")


def test_the_distribution_chooses_the_form(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DISTRO", "jazzy")
    draft = added(cmake_package(BARE), "plugin", "thing:nav2-controller")
    assert "void setPlan(" in text(draft, "src/thing.cpp")
    cmake = text(draft, "CMakeLists.txt")
    assert "target_include_directories(my_pkg_thing PRIVATE ${nav2_core_INCLUDE_DIRS})\n" in cmake
    monkeypatch.setenv("ROS_DISTRO", "humble")
    comes_back(cmake_package(BARE), draft, "plugin", "thing")


@pytest.mark.parametrize("form", ["automatic", "our own"])
def test_target_export_and_rule_are_where_the_others_are(form: str) -> None:
    own = texts(plan("my_pkg", template="plugin", plugins=("first:pluginlib",), distro="lyrical"))
    files = {"automatic": cmake_package(AUTO), "our own": own}[form]
    draft = added(files, "plugin", "thing:pluginlib")
    cmake = text(draft, "CMakeLists.txt")
    assert "add_library(my_pkg_thing SHARED src/thing.cpp)\n" in cmake
    assert "pluginlib_export_plugin_description_file(my_pkg plugins/thing.xml)\n" in cmake
    assert ("my_pkg_base\n  pluginlib::pluginlib\n)\npluginlib_export_plugin_description_file(my_pkg" in cmake) == (
        form == "our own"
    )
    assert ("src/my_pkg/filter.hpp" in draft.changes) == (form != "our own")
    assert new_findings(files, draft) == []
    comes_back(files, draft, "plugin", "thing")


def test_two_share_the_base_class() -> None:
    files = cmake_package(LOWER)
    draft = added(files, "plugin", "one:pluginlib", "two:pluginlib")
    after, _ = taken(draft, "plugin", "one")
    assert after.entry("src/my_pkg/filter.hpp")
    last, _ = taken(after, "plugin", "two")
    assert last.entry("src/my_pkg/filter.hpp") is None


def test_what_can_not_be_there_is_refused() -> None:
    files = cmake_package(LOWER)
    with pytest.raises(ChangeError, match="libraries in C\\+\\+"):
        added(python_package("from setuptools import setup\nsetup(name='my_pkg')\n"), "plugin", "thing:pluginlib")
    with pytest.raises(ChangeError, match="no source of a plugin `thing`"):
        taken(added(files, "node", "idler:empty"), "plugin", "thing")
    taken_name = cmake_package(LOWER.replace("old src", "my_pkg_thing src").replace("TARGETS old", ""))
    with pytest.raises(ChangeError, match="a target `my_pkg_thing` already"):
        added(taken_name, "plugin", "thing:pluginlib")


def test_a_source_that_was_edited_is_kept() -> None:
    files = cmake_package(LOWER)
    draft = added(files, "plugin", "thing:controller")
    edited = {path: text(draft, path) for path in draft.tree.files()}
    edited["src/thing.cpp"] = edited["src/thing.cpp"].replace("joints", "axes")
    again = added(edited, "node", "other:empty")
    with pytest.raises(ChangeError, match=r"`thing` is not as `add` writes it; --force"):
        taken(again, "plugin", "thing")
    after, _ = taken(again, "plugin", "thing", force=True)
    assert after.entry("src/thing.cpp") is None
    assert after.entry("plugins/thing.xml") is None
    assert "thing" not in text(after, "CMakeLists.txt")
