"""Tables of ROS knowledge say where they come from, and all of them are read."""

from __future__ import annotations

import re
import sys
from datetime import date
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

from bench import (
    debian_dependencies,
    exported_dependencies,
    interface_fields,
    known_defaults,
    launch_arguments,
    module_attributes,
    names,
    newer_parameters,
    rclpy_names,
    ros1_packages,
    runtime_dependencies,
    well_known,
    well_known_launch,
    well_known_parameters,
)
from bench.tables import Origin, Revision, header
from rospkg_cli.ros.read_table import FOLDER, lines, marked, pairs, phrases, rows, sets, unfolded, words

ROOT = Path(__file__).parents[1]
SOURCES = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "src").rglob("*.py"))
TABLES = sorted(path.name for path in FOLDER.iterdir())
FIELDS = ["source", "commit", "date", "license", "made by"]
GENERATED: dict[str, tuple[str, Origin]] = {
    name: (about, script.ORIGIN)
    for script in (
        debian_dependencies,
        exported_dependencies,
        interface_fields,
        known_defaults,
        launch_arguments,
        module_attributes,
        names,
        newer_parameters,
        rclpy_names,
        ros1_packages,
        runtime_dependencies,
        well_known,
        well_known_launch,
        well_known_parameters,
    )
    for name, about in script.ABOUT.items()
}


def head(table: str) -> tuple[str, dict[str, str]]:
    """Return what a table says that it holds, and the fields of its header."""
    text = (FOLDER / table).read_text(encoding="utf-8")
    comments = [line.removeprefix("# ") for line in re.match(r"(?:#[^\n]*\n)*", text)[0].splitlines()]
    said = [re.fullmatch(rf"({'|'.join(FIELDS)}): (.+)", line) for line in comments]
    about = " ".join(line for line, field in zip(comments, said, strict=True) if field is None)
    assert [field[1] for field in said[-len(FIELDS) :] if field] == FIELDS, f"{table}: {FIELDS} end its header"
    return about, {field[1]: field[2] for field in said if field}


@pytest.mark.parametrize("table", TABLES)
def test_the_header_of_a_table(table: str) -> None:
    about, fields = head(table)
    assert about.endswith(".")
    assert date.fromisoformat(fields["date"]) <= date.today()
    assert all(re.fullmatch(r"[A-Za-z0-9]+(-[A-Za-z0-9.]+)*", each) for each in fields["license"].split(", "))
    if fields["made by"] == "hand":
        assert table not in GENERATED
    else:
        assert (about, fields["made by"]) == (GENERATED[table][0], GENERATED[table][1].script)
        assert (ROOT / fields["made by"]).exists()


@pytest.mark.parametrize("table", GENERATED)
def test_the_header_of_a_generated_table_is_the_one_that_its_script_writes(table: str) -> None:
    about, origin = GENERATED[table]
    _, fields = head(table)
    written = header(about, origin, Revision(fields["commit"], fields["date"]))
    assert (FOLDER / table).read_text(encoding="utf-8").split("\n")[: len(written)] == written


@pytest.mark.parametrize("table", TABLES)
def test_a_table_has_rows_and_somebody_reads_them(table: str) -> None:
    assert any(line[0] != "[" for line in lines(table))
    assert f'"{table}"' in SOURCES


def test_rosdistro_is_named_with_its_license() -> None:
    notice = (ROOT / "NOTICE").read_text(encoding="utf-8")
    assert names.ORIGIN.source in notice
    assert names.ORIGIN.license in notice
    assert 'license-files = ["LICENSE", "NOTICE"]' in (ROOT / "pyproject.toml").read_text(encoding="utf-8")


def test_what_a_table_says(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rospkg_cli.ros.read_table.FOLDER", tmp_path)
    (tmp_path / "some.txt").write_text("# About.\na b\na c\nalone\n# why\n[two words]\nd e\n")
    assert rows("some.txt") == {"a": ("b", "c"), "alone": ()}
    assert sets("some.txt")["a"] == {"b", "c"}
    assert pairs("some.txt", "two words") == {"d": "e"}
    assert words("some.txt") == {"a", "b", "c", "alone"}
    assert marked("some.txt")["d e"] == ("two", "words")
    (tmp_path / "blanks.txt").write_text("# About.\nMIT | The MIT License | Expat\nISC\n")
    assert phrases("blanks.txt") == {"MIT": ("The MIT License", "Expat"), "ISC": ()}


def test_parts_of_rows_are_unfolded() -> None:
    parts = {"+node": ("name", "+action"), "+action": ("if",)}
    assert list(unfolded(["a", "+node", "b"], parts)) == ["a", "name", "if", "b"]
