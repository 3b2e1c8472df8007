"""How rules of other packages are loaded: what is refused, and which of their files the trace of a run holds."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from importlib.metadata import EntryPoint
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest

from rospkg_cli import disk_trace
from rospkg_cli.engine.run import rule_plugins
from rospkg_cli.engine.run.rule_plugins import (
    PluginError,
    load_plugins,
    note_folder,
    note_modules,
    note_package,
    refuse_linted,
    rules_of,
)
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.rule_table import rule_by_code


@pytest.fixture
def trace() -> Iterator[disk_trace.Trace]:
    yield disk_trace.start_trace()
    disk_trace.stop_trace()


def read(trace: disk_trace.Trace) -> set[str]:
    return {question[1:] for question in trace.answers if question[0] == "b"}


def point(value: str) -> EntryPoint:
    return EntryPoint("house", value, rule_plugins.GROUP)


@pytest.fixture
def site(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for path in ("house/__init__.py", "house/deep/x.py", "house/__pycache__/x.pyc", "alone.py", "other.py"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).touch()
    monkeypatch.syspath_prepend(str(tmp_path))
    return tmp_path


def test_the_sources_of_a_package_are_in_the_trace(site: Path, trace: disk_trace.Trace) -> None:
    note_package(point("house.deep.x:rules"))
    assert read(trace) == {str(site / "house/__init__.py"), str(site / "house/deep/x.py")}


def test_a_module_is_in_the_trace(site: Path, trace: disk_trace.Trace) -> None:
    for value in ("alone", "other:rules", "nowhere_at_all.rules", ":x"):
        note_package(point(value))
    assert read(trace) == {str(site / "alone.py"), str(site / "other.py")}


def test_without_a_trace_nothing_is_read(site: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rule_plugins, "read_limited", lambda path: 1 / 0)
    note_package(point("house.deep.x:rules"))
    note_modules(["token"])
    with pytest.raises(ZeroDivisionError):
        note_folder(str(site))


def test_loaded_modules_are_in_the_trace(site: Path, trace: disk_trace.Trace, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "house_x", SimpleNamespace(__file__=str(site / "alone.py")))
    note_modules({"house_x", "sys", "no_module_of_this_name"})
    assert str(site / "alone.py") in read(trace)


def test_what_is_no_module_of_rules(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(PluginError, match="plugins: `house` can't be loaded: ModuleNotFoundError: No module"):
        rules_of(point("nowhere_at_all"))
    with pytest.raises(PluginError, match="plugins: `house` offers no rules: its entry point must name a module"):
        rules_of(point("token"))
    module = ModuleType("house_rules")
    module.__dict__["ours"] = rule_by_code("XML104")
    monkeypatch.setitem(sys.modules, "house_rules", module)
    assert rules_of(point("house_rules")).keys() == {"XML104"}


def installed_at(folder: Path) -> EntryPoint:
    found = point("house.deep.x")
    vars(found)["dist"] = SimpleNamespace(locate_file=lambda _: folder)
    return found


def test_what_is_linted_is_not_loaded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "ws/site").mkdir(parents=True)
    linted = (tmp_path / "elsewhere", tmp_path / "ws")
    refuse_linted(point("house.deep.x"), linted)
    refuse_linted(installed_at(tmp_path / "site"), linted)
    with pytest.raises(PluginError, match="nothing of what is linted is run: install it where rospkg is installed"):
        refuse_linted(installed_at(tmp_path / "ws/site"), linted)
    monkeypatch.setattr(rule_plugins, "installed_folders", lambda: [str(tmp_path / "ws/site")])
    refuse_linted(installed_at(tmp_path / "ws/site"), linted)


@pytest.fixture
def plugins(monkeypatch: pytest.MonkeyPatch) -> Iterator[dict[str, str]]:
    """The codes of the rules that installed plugins have, by the plugin's name."""
    found: dict[str, str] = {}
    monkeypatch.setattr(rule_plugins, "LOADED_PLUGINS", set())
    points = lambda group: [EntryPoint(name, "house.rules", group) for name in found]  # noqa: E731
    monkeypatch.setattr(rule_plugins, "entry_points", points)
    monkeypatch.setattr(
        rule_plugins, "rules_of", lambda point: {found[point.name]: replace(rule_by_code("XML104"), code="OUR001")}
    )
    yield found
    rule_plugins.PLUGGED_IN.clear()
    rule_plugins.forget_rules()
    rule_plugins.codes_named.cache_clear()


@pytest.mark.parametrize(
    "there, says",
    [
        ((), "plugins: there is no plugin `house`; no plugin is installed: install it where rospkg is"),
        (("zoo", "horse"), r"no plugin `house` \(did you mean `horse`\?\); installed are horse, zoo: install it"),
    ],
)
def test_a_plugin_that_is_not_installed(plugins: dict[str, str], there: tuple[str, ...], says: str) -> None:
    plugins.update(dict.fromkeys(there, "OUR001"))
    with pytest.raises(PluginError, match=says):
        load_plugins(["house"])


@pytest.mark.parametrize(
    "code, says",
    [
        ("XML104", "has a rule `XML104`, and that code is that of the built-in rule `placeholder"),
        ("OUR01", "has a rule `OUR01`, and that code is not three uppercase letters and three digits"),
    ],
)
def test_a_code_that_is_taken_or_none(plugins: dict[str, str], code: str, says: str) -> None:
    plugins["house"] = code
    with pytest.raises(PluginError, match=says):
        load_plugins(["house"])
    assert not rule_plugins.LOADED_PLUGINS
    assert not rule_plugins.PLUGGED_IN


def test_a_plugin_is_loaded_once(plugins: dict[str, str], monkeypatch: pytest.MonkeyPatch) -> None:
    plugins["house"] = "OUR001"
    load_plugins(["house"])
    assert (rule_plugins.LOADED_PLUGINS, rule_plugins.PLUGGED_IN.keys()) == ({"house"}, {"OUR001"})
    monkeypatch.setattr(rule_plugins, "entry_points", lambda group: 1 / 0)
    load_plugins(["house"])
