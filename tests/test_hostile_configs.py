"""Configs, baselines and lists of submodules that were made to break whoever reads them: one sentence, exit 2."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_process import run_here as rospkg

from rospkg_cli.config.file import MAX_TEXT, ConfigError, find_config
from rospkg_cli.engine.baseline import BaselineError, read_baseline
from rospkg_cli.engine.discovery.incomplete_workspace import missing_below

CONFIGS = {
    "lists": ("x = " + "[" * 100_000, "nested too deeply"),
    "tables": ("x = " + "{a=" * 100_000, "nested too deeply"),
    "dotted": ("a." * 20_000 + "b = 1", "rospkg.toml:1:1: a key of more than 100 parts is not read"),
    "dotted within": ("x = {y = 1, " + "a." * 20_000 + "b = 1}", "a key of more than 100 parts is not read"),
    "dotted table": ("\n[" + "a." * 20_000 + "b]", "rospkg.toml:2:1: a key of more than 100 parts is not read"),
    "dots": (f"# {'.' * 999}\nx = ['{'.' * 99}', '{'.' * 99}']", "there is no key `x`"),
    "headers": ("[" * 300_000 + "\nx = 1", "not valid TOML"),
    "number": (f"pedantic = {'1' * 10_000}", "not valid TOML: Exceeds the limit"),
    "size": ("#" * (MAX_TEXT + 1), "more than 1,000,000 characters is not read"),
    "no table": ("per-package = 5", "rospkg.toml:1:1: `per-package` must be a table"),
    "no table within": ('per-path = {"a/*" = 5}', "`a/*` must be a table"),
    "no table of new": ("new = [1]", "`new` must be a table"),
    "no list": ("select = 5", "`select` must be a list of strings"),
    "list of lists": ("select = [['XML101']]", "`select` must be a list of strings"),
    "date": ("fail-on = 2020-01-01", "`fail-on` must be one of"),
    "escapes": ('"\\u001b]0;owned\\u0007" = 1', r"there is no key `\x1b]0;owned\x07`"),
    "long key": (f"{'k' * 900_000} = 1", "there is no key `kkk"),
    "long key far down": ("[[" * 100_000 + "\n", "not valid TOML"),
}


@pytest.mark.parametrize("name", CONFIGS)
def test_a_hostile_config_is_one_sentence(tmp_path: Path, name: str) -> None:
    text, says = CONFIGS[name]
    (tmp_path / "rospkg.toml").write_text(text)
    with pytest.raises(ConfigError) as refused:
        find_config(tmp_path)
    said = str(refused.value)
    assert says in said
    assert said.isprintable()
    assert len(said) < 3_000


@pytest.mark.parametrize("text", ["tool = 5\n#[tool.rospkg", "[tool]\nrospkg = 5\n#[tool.rospkg"])
def test_a_project_without_a_table_for_us(tmp_path: Path, text: str) -> None:
    (tmp_path / "pyproject.toml").write_text(text)
    with pytest.raises(ConfigError, match=r"pyproject\.toml:\d+:1: `rospkg` must be a table"):
        find_config(tmp_path)


def test_a_place_is_found_in_steps_that_grow_with_the_text(tmp_path: Path) -> None:
    (tmp_path / "rospkg.toml").write_text("x = '''\n" + "[" * 300_000 + "\n'''\n")
    with pytest.raises(ConfigError, match="1:1: there is no key `x`"):
        find_config(tmp_path)


BASELINES = [
    '{"findings":' + "[" * 100_000,
    "[]",
    "5",
    "null",
    '{"findings": 5}',
    '{"findings": [5]}',
    '{"findings": [{"code": [], "path": {}, "message": 1, "count": 1}]}',
    '{"findings": [{"code": "a", "path": "b", "message": "c", "count": Infinity}]}',
    '{"findings": [{"code": "a", "path": "b", "message": "c", "count": NaN}]}',
    f'{{"findings": [{{"code": "a", "path": "b", "message": "c", "count": {"9" * 9999}}}]}}',
    '{"findings": [{"code": "a", "path": "b", "message": "c", "count": null}]}',
    "\udcff",
]


@pytest.mark.parametrize("text", BASELINES, ids=lambda text: ascii(text[-30:]))
def test_a_hostile_baseline_is_one_sentence(tmp_path: Path, text: str) -> None:
    (tmp_path / "baseline.json").write_bytes(text.encode("utf-8", "surrogateescape"))
    with pytest.raises(BaselineError, match="is not a baseline of rospkg; create one with"):
        read_baseline(tmp_path / "baseline.json")


@pytest.mark.parametrize("text", ["\n" * 300_000, "path" + " " * 300_000, " " * 300_000, "path = x\0y\n" * 9])
def test_lists_of_submodules_are_read_in_steps_that_grow_with_them(tmp_path: Path, text: str) -> None:
    (tmp_path / ".gitmodules").write_text(text)
    assert any(missing_below(tmp_path, tmp_path)) == ("\0" in text)


def test_a_lone_carriage_return_is_no_crash(tmp_path: Path, write, clean) -> None:
    """Python reads it as a line end, TOML does not: the config is read, and its keys can't be placed."""
    package = write(tmp_path / "my_pkg", clean)
    (package / "rospkg.toml").write_bytes(b'ignore = { XML301 = "we know" }\rpedantic = true\r')
    done = rospkg("lint", cwd=package)
    assert done.returncode in (0, 1, 2), done.stderr
    assert "RPK005" not in done.stdout


@pytest.mark.parametrize(
    "text",
    [
        "[" * 200_000,
        "a: &a [" * 50_000,
        "- " * 100_000,
        "repositories:\n" + "  ? [" * 90_000,
        "repositories: {}\n" + "#" * 1_000_000,
    ],
)
def test_a_hostile_list_of_repositories_may_name_anything(tmp_path: Path, text: str) -> None:
    (tmp_path / "a.repos").write_text(text)
    (found,) = missing_below(tmp_path, tmp_path)
    assert found.why == "`a.repos` lists repositories and can't be read"
