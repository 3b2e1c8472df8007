"""`rospkg format`: what it changes on disk, what it says, and what it leaves alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.format.run import format_manifests
from rospkg_cli.edits.format_manifest import format_text
from rospkg_cli.example import manifest

SORTED = manifest("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>tf2_ros</exec_depend>\n")
UNSORTED = manifest("  <exec_depend>tf2_ros</exec_depend>\n  <exec_depend>rclpy</exec_depend>\n")


def package(folder: Path, text: str) -> Path:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.xml").write_text(text)
    return folder / "package.xml"


def test_conditions_and_comments_travel() -> None:
    before = manifest(
        '  <exec_depend condition="$ROS_VERSION == 2">b</exec_depend> <!-- two -->\n'
        "  <!-- why a -->\n  <exec_depend>a</exec_depend>\n  <depend>z</depend>\n"
    )
    after = manifest(
        "  <depend>z</depend>\n  <!-- why a -->\n  <exec_depend>a</exec_depend>\n"
        '  <exec_depend condition="$ROS_VERSION == 2">b</exec_depend> <!-- two -->\n'
    )
    assert format_text(before) == after
    assert format_text(after) == after


def test_it_writes_and_twice_is_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = package(tmp_path / "my_pkg", UNSORTED)
    other = package(tmp_path / "other", SORTED.replace("my_pkg", "other"))
    assert format_manifests([tmp_path]) == 0
    assert path.read_text() == SORTED
    said = capsys.readouterr()
    assert said.out.startswith("formatted: ")
    assert "1 formatted, 1 already in order" in said.err
    before = other.stat().st_mtime_ns
    assert format_manifests([tmp_path]) == 0
    assert capsys.readouterr().out == ""
    assert other.stat().st_mtime_ns == before


def test_encoding_mark_and_line_ends_are_kept(tmp_path: Path) -> None:
    path = package(tmp_path, "")
    head = '<?xml version="1.0" encoding="ISO-8859-1"?>'

    def latin(text: str) -> bytes:
        return text.replace('<?xml version="1.0"?>', head).replace("Ada", "Zoë").replace("\n", "\r\n").encode("latin-1")

    path.write_bytes(latin(UNSORTED))
    path.chmod(0o640)
    assert format_manifests([tmp_path]) == 0
    assert path.read_bytes() == latin(SORTED)
    assert path.stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("how", [{"check": True}, {"diff": True}, {"check": True, "diff": True}])
def test_check_and_diff_write_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str], how: dict[str, bool]) -> None:
    (tmp_path / ".git").mkdir()  # else the packages of other tests are its neighbours
    path = package(tmp_path, UNSORTED)
    assert format_manifests([path], **how) == 1
    assert path.read_text() == UNSORTED
    said = capsys.readouterr()
    assert ("+++ b/package.xml" in said.out) is how.get("diff", False)
    path.write_text(SORTED)
    assert format_manifests([path], **how) == 0


def test_what_cannot_be_read_is_left_alone_and_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    broken = package(tmp_path / "a", "<package>\n  <name>a</package>\n")
    fine = package(tmp_path / "b", UNSORTED)
    assert format_manifests([tmp_path]) == 1
    assert broken.read_text() == "<package>\n  <name>a</package>\n"
    assert fine.read_text() == SORTED
    assert "`<name>` is closed by `</package>`; it is left alone" in capsys.readouterr().err


def test_no_package_is_wrong_use(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match=r"no package\.xml"):
        format_manifests([tmp_path])
