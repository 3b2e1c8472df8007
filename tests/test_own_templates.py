"""Templates of one's own: read from a folder or a git repository, held to the same checks, and never trusted."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from planned import ADA, texts

from rospkg_cli.scaffold import ScaffoldError, bounds
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.custom_template import ADDRESS
from rospkg_cli.scaffold.plan import Plan, make_plan

HEAD = """\
title = "Ours"
build-type = "ament_cmake"
description = "{{ name }} of ours"
kinds = []
commands = ["colcon build --packages-select {{ name }}"]
"""
FILES = """
[[files]]
source = "package.xml"

[[files]]
source = "CMakeLists.txt"
about = "ours"

[[files]]
source = "_shared/LICENSE"
path = "LICENSE"
"""
MANIFEST = """\
{% from '_shared/manifest.j2' import keys %}
{% include '_shared/manifest_head.j2' %}

{{ keys('buildtool_depend', ['ament_cmake']) }}
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
"""
LISTS = """\
cmake_minimum_required(VERSION 3.20)
project({{ name }} NONE)
find_package(ament_cmake REQUIRED)
ament_package()
"""
WHO = ("-c", "user.name=Ada", "-c", "user.email=ada@example.org")


@pytest.fixture
def template(tmp_path: Path) -> Path:
    folder = tmp_path / "ours"
    write(folder, {"template.toml": HEAD + FILES, "package.xml": MANIFEST, "CMakeLists.txt": LISTS})
    return folder


def write(folder: Path, files: dict[str, str]) -> None:
    for path, text in files.items():
        file = folder / (path if path == "template.toml" else f"files/{path}.j2")
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def git(folder: Path, *command: str) -> None:
    subprocess.run(["git", *WHO, *command], cwd=folder, check=True, capture_output=True)


def plan(template: Path | str, **asked: object) -> Plan:
    return make_plan(Request("my_pkg", own_template=str(template), **{**ADA, **asked}), Path(), {})


def test_a_folder_is_a_template(template: Path) -> None:
    planned = plan(template, extras=("docs",))
    assert [(finding.code, finding.message) for finding in planned.findings] == []
    files = texts(planned)
    assert set(files) == {"package.xml", "CMakeLists.txt", "LICENSE", "doc/index.md"}
    assert "<description>my_pkg of ours</description>" in files["package.xml"]
    assert planned.commands == ("colcon build --packages-select my_pkg",)


def test_a_git_repository_is_one_too_and_a_branch_of_it(template: Path) -> None:
    git(template, "init", "--initial-branch", "first")
    git(template, "add", ".")
    git(template, "commit", "-m", "ours")
    git(template, "checkout", "-b", "second")
    write(template, {"CMakeLists.txt": LISTS + "# second\n"})
    git(template, "commit", "-am", "second")
    git(template, "checkout", "first")
    address = template.as_uri()
    assert "second" not in texts(plan(address))["CMakeLists.txt"]
    assert "# second\n" in texts(plan(f"{address}#second"))["CMakeLists.txt"]
    with pytest.raises(ScaffoldError, match="git can't clone"):
        plan(f"{address}#third")


def test_links_of_a_repository_lead_nowhere(template: Path, tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("cmake_minimum_required(VERSION 3.20)\n# mine alone\n")
    (template / "files/CMakeLists.txt.j2").unlink()
    (template / "files/CMakeLists.txt.j2").symlink_to(tmp_path / "secret")
    git(template, "init")
    git(template, "add", ".")
    git(template, "commit", "-m", "ours")
    try:
        written = texts(plan(template.as_uri()))["CMakeLists.txt"]
    except ScaffoldError as refused:
        written = str(refused)
    assert "mine alone" not in written


@pytest.mark.parametrize(
    "address, is_one",
    [
        ("https://example.org/a/b.git", True),
        ("git@example.org:a/b.git#main", True),
        ("ssh://git@example.org/a", True),
        ("ext::sh -c id", False),
        ("--upload-pack=id", False),
        ("http://example.org/a", False),
        ("nowhere", False),
    ],
)
def test_git_is_asked_for_addresses_alone(address: str, is_one: bool) -> None:
    assert bool(ADDRESS.fullmatch(address)) == is_one
    if not is_one:
        with pytest.raises(ScaffoldError, match="neither a folder nor the address"):
            plan(address)


def files_with(path: str) -> dict[str, str]:
    return {"template.toml": HEAD + FILES.replace('path = "LICENSE"', f'path = "{path}"')}


WRONG = {
    "no toml": ({"template.toml": "title ="}, "template.toml of .* is wrong: Invalid value"),
    "no title": ({"template.toml": "build-type = 'ament_cmake'"}, "lacks the key 'title'"),
    "unknown key": ({"template.toml": HEAD + FILES + "colour = 'red'"}, "is wrong: .*colour"),
    "kind": ({"template.toml": HEAD.replace("[]", "['flying']") + FILES}, "no kind of nodes `flying`"),
    "build type": ({"template.toml": HEAD.replace("ament_cmake", "catkin") + FILES}, "not `catkin`"),
    "no source": ({"template.toml": HEAD + FILES + "[[files]]\nsource = 'gone'"}, "gone.j2"),
    "unknown": ({"CMakeLists.txt": "{{ robot_colour }}"}, "'robot_colour' is undefined"),
    "syntax": ({"CMakeLists.txt": "ok\n{% if %}"}, r"CMakeLists.txt.j2 line 2: "),
    "raw text": ({"CMakeLists.txt": "# {{ description }}"}, "description|my_pkg of ours"),
    "arithmetic": ({"CMakeLists.txt": "{{ 1 / 0 }}"}, "fails: ZeroDivisionError"),
    "types": ({"CMakeLists.txt": "{{ 'a' + 1 }}"}, "fails: TypeError"),
    "escape": ({"CMakeLists.txt": "{{ ''.__class__.__mro__[1].__subclasses__() }}"}, "unsafe|undefined"),
    "endless": ({"CMakeLists.txt": "{% for i in range(10**9) %}{% endfor %}"}, "fails: OverflowError"),
    "up": (files_with("../LICENSE"), "no path inside of the package"),
    "absolute": (files_with("/etc/rospkg"), "no path inside of the package"),
    "hook": (files_with(".git/hooks/pre-commit"), "no path inside of the package"),
    "hook in capitals": (files_with(".GIT/hooks/pre-commit"), "no path inside of the package"),
    "hook on Windows": (files_with("a/.git. /config"), "no path inside of the package"),
    "short name": (files_with("GIT~1/config"), "no path inside of the package"),
    "stream": (files_with("a:b"), "no path inside of the package"),
    "long name": (files_with("a" * 201), "too long for a path"),
    "deep": (files_with("/".join("a" * 30)), "too long for a path"),
    "newline in a path": (files_with("{{ '\\n' }}x"), "where a line of text is wanted"),
    "escape in a command": (
        {"template.toml": HEAD.replace("colcon", "{{ '\\u001b[2J' }}") + FILES},
        "where a line of text is wanted",
    ),
    "twice": ({"template.toml": HEAD + FILES + "[[files]]\nsource = 'package.xml'"}, "two files"),
    "no package": ({"package.xml": "<package>"}, "our own linter refuses: .*package.xml"),
}


@pytest.mark.parametrize("wrong", WRONG)
def test_what_a_template_gets_wrong_is_said_in_one_sentence(template: Path, wrong: str) -> None:
    files, said = WRONG[wrong]
    write(template, files)
    with pytest.raises(ScaffoldError, match=said) as refused:
        plan(template)
    assert "\n" not in str(refused.value)


def test_a_folder_without_a_template_says_so(tmp_path: Path) -> None:
    with pytest.raises(ScaffoldError, match=r"has no template\.toml: No such file"):
        plan(tmp_path)


@pytest.fixture
def secret(tmp_path: Path) -> Path:
    (tmp_path / "secret").write_text("mine alone\n")
    return tmp_path / "secret"


@pytest.mark.parametrize("linked", ["files/CMakeLists.txt.j2", "files", "template.toml"])
def test_links_out_of_a_folder_are_not_read(template: Path, secret: Path, linked: str) -> None:
    moved = secret.parent / "moved"
    (template / linked).rename(moved)
    (template / linked).symlink_to(moved)
    with pytest.raises(ScaffoldError, match=rf"ours`.* `{linked}.*` is a link that leads out of the template"):
        plan(template)


def test_links_within_a_template_are_read(template: Path) -> None:
    (template / "files/CMakeLists.txt.j2").rename(template / "lists")
    (template / "files/CMakeLists.txt.j2").symlink_to("../lists")
    assert "CMakeLists.txt" in texts(plan(template))


def test_what_is_no_file_is_not_waited_for(template: Path) -> None:
    (template / "files/CMakeLists.txt.j2").unlink()
    os.mkfifo(template / "files/CMakeLists.txt.j2")
    with pytest.raises(ScaffoldError, match="is not a file"):
        plan(template)


DOUBLING = (
    "{{% set n = namespace(x={first}) %}}{{% for i in range(60) %}}{{% set n.x = n.x {operator} n.x %}}{{% endfor %}}"
)
ENDLESS = {
    "power": ("{{ 10**(10**10) }}", "OverflowError: a number would have more than 4096 bits"),
    "text": ("{{ 'a' * 10**11 }}", "OverflowError: a text or a list would be longer than 1,000,000"),
    "list": ("{% set x = [1] * 10**9 %}", "OverflowError: a text or a list would be longer"),
    "product": (
        "{% set n = namespace(x=2) %}{% for i in range(99) %}{% set n.x = n.x * n.x %}{% endfor %}",
        "4096 bits",
    ),
    "format": ("{{ '%0999999999d' % 1 }}{{ '{:>999999999}'.format(1) }}", "needs more than 512 MB of memory"),
    "method": ("{{ 'a'.ljust(10**10) }}", "needs more than 512 MB of memory"),
    "filter": ("{{ 'a' | center(10**10) }}", "needs more than 512 MB of memory"),
    "batch": ("{{ [1] | batch(10**9, 1) | list }}", "needs more than 512 MB of memory"),
    "doubling": (
        "{% set n = namespace(x='a') %}{% for i in range(60) %}{% set n.x = n.x ~ n.x %}{% endfor %}",
        "512 MB",
    ),
    "rounding": ("{{ 1.5 | round(10**9, 'ceil') }}", "round takes at most 20 digits"),
    "output": ("{% for i in range(10**5) %}{{ 'a' * 99 }}{% endfor %}", "writes more than 1,000,000 characters"),
    "macro": ("{% macro f() %}{{ f() }}{% endmacro %}{{ f() }}", "fails: RecursionError"),
    "include": ("{% include 'CMakeLists.txt.j2' %}", "fails: RecursionError"),
    "brackets": ("{{ " + "(" * 20_000 + " }}", "CMakeLists.txt.j2 is nested too deeply"),
    "blocks": (
        "{% for a in [1] %}" * 30 + "{% endfor %}" * 30,
        "fails: SyntaxError: too many statically",
    ),
    "size": ("#" * 1_000_001, r"`files/CMakeLists.txt.j2` has 1,000,001 bytes; at most 1,000,000 are read"),
}


@pytest.mark.parametrize("how", ENDLESS)
def test_a_template_has_bounds(template: Path, how: str) -> None:
    source, said = ENDLESS[how]
    write(template, {"CMakeLists.txt": source})
    with pytest.raises(ScaffoldError) as refused:
        plan(template)
    assert said in str(refused.value)
    assert "CMakeLists.txt" in str(refused.value) or "MB" in said
    assert str(refused.value).isprintable()


def test_loops_within_loops_end(template: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bounds, "CPU_SECONDS", 0.5)
    loops = "".join(f"{{% for {name} in range(10**5) %}}" for name in "abcd")
    write(template, {"CMakeLists.txt": loops + "{% endfor %}" * 4})
    with pytest.raises(ScaffoldError, match=r"ours`: it takes more than 0\.5 seconds; is there a loop"):
        plan(template)
    write(template, {"CMakeLists.txt": LISTS})
    monkeypatch.undo()
    assert plan(template).findings == ()


def test_a_template_lists_so_many_files_alone(template: Path) -> None:
    write(template, {"template.toml": HEAD + FILES + "[[files]]\nsource = 'x'\n" * 1_000})
    with pytest.raises(ScaffoldError, match="it lists 1003 files; at most 1000 are written"):
        plan(template)


PLACES = {
    "file": (
        {"package.xml": MANIFEST.replace("<export>", "{{ vers }}")},
        "files/package.xml.j2 line 5: 'vers' is",
    ),
    "toml": ({"template.toml": HEAD.replace("of ours", "{{ vers }}") + FILES}, "template.toml line 3: 'vers' is undef"),
    "command": ({"template.toml": HEAD.replace("colcon", "{{ vers }}") + FILES}, "template.toml line 5: 'vers' is"),
    "toml's syntax": ({"template.toml": HEAD.replace("of ours", "{% if %}") + FILES}, "template.toml line 3: "),
    "condition": ({"template.toml": HEAD + FILES + "when = 'vers'\n"}, "template.toml line 17: 'vers' is undefined"),
    "syntax": ({"CMakeLists.txt": "ok\n{% if %}"}, "files/CMakeLists.txt.j2 line 2: Expected"),
    "raw text": ({"CMakeLists.txt": "\n# {{ copyright }}"}, "files/CMakeLists.txt.j2 line 2: a template prints"),
    "included": ({"CMakeLists.txt": "{% include 'a' %}"}, "files/CMakeLists.txt.j2 line 1: there is no `a`"),
    "arithmetic": ({"CMakeLists.txt": "\n\n{{ 1 / 0 }}"}, "files/CMakeLists.txt.j2 line 3 fails: ZeroDivisionError"),
    "macro of ours": (
        {"package.xml": MANIFEST.replace("['ament_cmake']", "5")},
        "files/package.xml.j2 line 4 fails: TypeError",
    ),
}


@pytest.mark.parametrize("wrong", PLACES)
def test_a_fault_is_told_with_its_file_and_line(template: Path, wrong: str) -> None:
    files, said = PLACES[wrong]
    write(template, files)
    with pytest.raises(ScaffoldError) as refused:
        plan(template)
    assert f"the template `{template}`, {said}" in str(refused.value)


TOML = {
    "depth": "x = " + "[" * 100_000,
    "number": f"x = {'1' * 10_000}",
    "title": HEAD.replace('"Ours"', "5") + FILES,
    "kinds": HEAD.replace("kinds = []", "kinds = 5") + FILES,
    "kind": HEAD.replace("kinds = []", "kinds = [[1]]") + FILES,
    "files": HEAD + "files = 5",
    "file": HEAD + "files = [5]",
    "source": HEAD + "[[files]]\nsource = 5",
    "path": HEAD + "[[files]]\nsource = 'package.xml'\npath = [1]",
    "when": HEAD + "[[files]]\nsource = 'package.xml'\nwhen = 5",
    "each": HEAD + "[[files]]\nsource = 'package.xml'\neach = 'year'",
    "commands": HEAD.replace("commands = [", "commands = [5, ") + FILES,
    "description": HEAD.replace('description = "{{ name }} of ours"', "description = 2020-01-01") + FILES,
}


@pytest.mark.parametrize("wrong", TOML)
def test_values_of_other_types_are_one_sentence(template: Path, wrong: str) -> None:
    write(template, {"template.toml": TOML[wrong]})
    with pytest.raises(ScaffoldError) as refused:
        plan(template)
    assert str(template) in str(refused.value)
    assert str(refused.value).isprintable()
