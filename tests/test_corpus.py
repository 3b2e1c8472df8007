"""Whole packages and what is said of them: `tests/corpus/<package>` beside `<package>.out`.

`pytest tests/test_corpus.py --update-golden` writes the outputs anew; read the diff before it is committed.
"""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.report import Report, render

CORPUS = Path(__file__).parent / "corpus"
PACKAGES = sorted(p.name for p in CORPUS.iterdir() if p.is_dir())


@pytest.mark.parametrize("name", PACKAGES)
def test_what_is_said(name: str, pytestconfig: pytest.Config) -> None:
    session = Session(DiskTree(CORPUS), Scope((name,), frozenset({name})), EVERYTHING.codes())
    stream = io.StringIO()
    render("text", Report(session.run(), CORPUS, CORPUS, width=80, shows_info=True, shows_all=True), stream)
    golden = CORPUS / f"{name}.out"
    if pytestconfig.getoption("--update-golden"):
        golden.write_text(stream.getvalue())
    assert stream.getvalue() == golden.read_text()


def test_chapter_nine_is_seen_through() -> None:
    """What the book gets wrong, by code and by the name that the finding must give."""
    seen = {(name, f.code): f.message for name in PACKAGES for f in findings(name)}
    for package, code, names in CHAPTER_NINE:
        assert any(k == (package, code) for k in seen), (package, code)
        assert any(names in f.message for f in findings(package) if f.code == code), (package, code, names)


def findings(name: str):
    scope = Scope((name,), frozenset({name}))
    return Session(DiskTree(CORPUS), scope, EVERYTHING.codes()).run().findings


CHAPTER_NINE = [
    ("my_robot_examples", "SET101", "robot_controller"),
    ("my_robot_examples", "SET202", "resource/my_robot_examples"),
    ("my_robot_examples", "SET001", "setup.cfg"),
    ("my_robot_examples", "SET304", "tests_require"),
    ("my_robot_examples", "DEP202", "geometry_msgs"),
    ("my_robot_examples", "DEP202", "message_filters"),
    ("my_robot_nav", "SET101", "nav_cli"),
    ("my_robot_nav", "IDL008", "RobotPath.msg"),
    ("my_robot_nav", "DEP101", "numpy"),
]
