"""Templates of one's own: read from a folder or a git repository, held to the same checks, and never trusted."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from planned import ADA, texts

from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.own import ADDRESS
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
