"""`rospkg new --minimal`: a package of every type without what nothing is built, run or tested with."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_process import run_here as rospkg
from planned import plan, texts
from test_templates import faultless

from rospkg_cli.cli.new.interactive import command_of
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.template import template_names


@pytest.mark.parametrize("distro", ["humble", "lyrical"])
@pytest.mark.parametrize("template", template_names())
def test_every_type_is_written_without_a_finding(template: str, distro: str) -> None:
    planned = plan(template=template, distro=distro, minimal=True)
    faultless(planned)
    assert {"README.md", "CONTRIBUTING.md", ".gitignore", "config/params.yaml"}.isdisjoint(texts(planned))


def test_a_first_package_has_what_it_needs() -> None:
    assert set(texts(plan("hello_pkg", nodes=("talker",), minimal=True))) == {
        "package.xml", "setup.py", "setup.cfg", "resource/hello_pkg", "hello_pkg/__init__.py", "hello_pkg/py.typed",
        "hello_pkg/talker.py", "hello_pkg/greeting.py", "launch/hello_pkg.launch.py", "test/test_greeting.py",
        "LICENSE",
    }  # fmt: skip


def test_tests_that_were_asked_for_stay() -> None:
    """With ament's linters comes what ament_copyright wants in the root of a repository."""
    assert {"test/test_flake8.py", "CONTRIBUTING.md"} <= set(texts(plan(minimal=True, tests="ament")))


def test_the_command_without_questions_says_so() -> None:
    assert command_of(Request("hello_pkg", minimal=True)) == "rospkg new hello_pkg --minimal"


def test_a_template_of_ones_own_is_as_it_is(tmp_path: Path) -> None:
    done = rospkg("new", "hello_pkg", "--minimal", "--template", "ours", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert "leave it or --template out" in done.stderr
