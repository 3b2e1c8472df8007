"""What wins where two things that the user said of one rule differ."""

from __future__ import annotations

from pathlib import Path

import pytest

from rospkg_cli.config.file import find_config
from rospkg_cli.config.hierarchy import ConfigTree
from rospkg_cli.engine.config_filter import ConfigFilter
from rospkg_cli.engine.discovery.exclusions import Exclusions
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.selection import Selection
from rospkg_cli.engine.suppression.config_rule_names import rule_name_events
from rospkg_cli.finding import Finding, Severity
from rospkg_cli.package.run_events import UnknownRuleName
from rospkg_cli.testing import lint_files


@pytest.fixture
def finding(clean) -> Finding:
    files = {**clean, "package.xml": clean["package.xml"].replace("Apache-2.0", "TODO")}
    [found] = lint_files(files, ["XML104"]).findings
    return found


@pytest.mark.parametrize(
    "select, ignore, runs",
    [
        ("XML104", "XML104", False),
        ("XML104", "placeholder-metadata", False),
        ("XML104", "XML1", True),
        ("XML1", "XML104", False),
        ("XML", "XML1", False),
        ("XML1", "XML", False),
        ("SET", "", False),
    ],
)
def test_a_rule_named_in_full_is_ignored_first_and_selected_next(select: str, ignore: str, runs: bool) -> None:
    codes = Selection(select=(select,), ignore=(ignore,) if ignore else ()).codes()
    assert ("XML104" in codes) is runs


def config_filter(folder: Path) -> ConfigFilter:
    configs = ConfigTree(find_config(folder))
    return ConfigFilter(configs, folder, Scope(("",), frozenset({""})), Exclusions(configs))


def level(finding: Finding, folder: Path, *sections: str) -> Severity:
    (folder / "rospkg.toml").write_text("".join(f"[{each}]\nXML104 = {value}\n" for each, value in pairs(sections)))
    return config_filter(folder).apply(finding).severity


def pairs(sections: tuple[str, ...]) -> list[tuple[str, str]]:
    return [(name, f'"{value}"') for name, _, value in (each.rpartition(" ") for each in sections)]


def test_of_two_severities_for_a_path_the_later_holds(finding: Finding, tmp_path: Path) -> None:
    loud, mild = 'per-path."*.xml".severity error', 'per-path."package.xml".severity info'
    assert level(finding, tmp_path, loud, mild) is Severity.INFO
    assert level(finding, tmp_path, mild, loud) is Severity.ERROR


def test_what_is_off_is_set_aside_with_a_reason(finding: Finding, tmp_path: Path) -> None:
    (tmp_path / "rospkg.toml").write_text('[severity]\nXML = "off"\n')
    judged = config_filter(tmp_path).apply(finding)
    assert judged.suppressed == "severity is off in the config"
    assert judged.external
    (tmp_path / "rospkg.toml").write_text('[severity]\nXML = "off"\nXML104 = "error"\n')
    judged = config_filter(tmp_path).apply(finding)
    assert (judged.severity, judged.suppressed) == (Severity.ERROR, None)


def test_a_severity_for_a_path_holds_over_that_for_a_package_and_both_over_that_for_all(
    finding: Finding, tmp_path: Path
) -> None:
    path, package = 'per-path."*.xml".severity error', 'per-package."my_*".severity info'
    assert level(finding, tmp_path, path, package) is Severity.ERROR
    assert level(finding, tmp_path, "severity error", package) is Severity.INFO
    assert level(finding, tmp_path, "severity error") is Severity.ERROR


@pytest.mark.parametrize("table", ["ignore", "severity"])
def test_an_unknown_rule_is_shown_where_its_key_is(table: str, tmp_path: Path) -> None:
    text = f'# XML999 is gone\n[{table}]\nXML104 = "info"\n[per-path."*.xml".{table}]\nXML999 = "info"\n'
    (tmp_path / "rospkg.toml").write_text(text)
    [found] = rule_name_events(find_config(tmp_path), "rospkg.toml", text, set(), frozenset())
    assert isinstance(found, UnknownRuleName)
    assert text[: found.span.start].count("\n") == 4
