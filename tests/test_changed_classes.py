"""Fields that a class of messages gets in Python, and errors that `suppress` takes (IDL010)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.rules.interfaces import idl010_unknown_field as idl010
from rospkg_cli.testing import lint_files

NODE = idl010.NODE.format("dat")


@pytest.mark.parametrize(
    "old, new, count",
    [
        ("", "", 1),
        ("\n\ndef main", "\n\nString.dat = property(str)\n\n\ndef main", 0),
        ("\n\ndef main", "\n\nsetattr(String, 'dat', 1)\n\n\ndef main", 0),
        ("\n\ndef main", "\n\nString.__slots__.append('dat')\n\n\ndef main", 0),
        ("\n\ndef main", "\n\nsetattr(Node, 'dat', 1)\n\n\ndef main", 1),
        ("\n\ndef main", "\n\nprint(String.data)\n\n\ndef main", 1),
    ],
)
def test_a_class_that_is_changed_has_other_fields(old: str, new: str, count: int) -> None:
    files = {"setup.py": idl010.LISTENS, "package.xml": manifest(idl010.DEPENDS)}
    text = NODE.replace(old, new, 1) if old else NODE
    assert len(lint_files({**files, "my_pkg/listener.py": text}, ["IDL010"]).findings) == count


@pytest.mark.parametrize(
    "around, count",
    [
        ("with suppress(AttributeError):", 0),
        ("with contextlib.suppress(KeyError, AttributeError):", 0),
        ("with suppress(KeyError):", 1),
        ("with other(AttributeError):", 1),
        ("with lock:", 1),
    ],
)
def test_an_error_that_is_suppressed(around: str, count: int) -> None:
    (line,) = (each for each in NODE.splitlines() if "msg.dat" in each)
    indent = line[: len(line) - len(line.lstrip())]
    text = NODE.replace(line, f"{indent}{around}\n{indent}    {line.strip()}")
    files = {"setup.py": idl010.LISTENS, "package.xml": manifest(idl010.DEPENDS), "my_pkg/listener.py": text}
    assert len(lint_files(files, ["IDL010"]).findings) == count
