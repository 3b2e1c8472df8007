"""What people type: help of a verb, rules by name, explanations of all, paths for names, names of other tools."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from in_process import run_here

from rospkg_cli.cli import complete

WHO = ("--maintainer", "Ada", "--email", "ada@example.org")


def test_help_of_a_verb_is_what_the_verb_says_of_itself(tmp_path: Path) -> None:
    shown = run_here("help", "lint", cwd=tmp_path)
    assert (shown.returncode, shown.stdout) == (0, run_here("lint", "--help", cwd=tmp_path).stdout)
    assert run_here("help", "index", "update", cwd=tmp_path).stdout.split()[:4] == [
        "Usage:",
        "rospkg",
        "index",
        "update",
    ]
    assert "Usage: rospkg [OPTIONS]" in run_here("help", cwd=tmp_path).stdout


def test_help_of_nothing_names_what_was_meant(tmp_path: Path) -> None:
    done = run_here("help", "lnt", cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "rospkg: there is no command `lnt` (did you mean `rospkg lint`?); `rospkg --help` shows how\n"


@pytest.mark.parametrize(
    "names, codes",
    [
        (["PLG00", "IDL001"], {"IDL001", "PLG002", "PLG003", "PLG004", "PLG005", "PLG006", "PLG007"}),
        (["set101,dep001"], {"SET101", "DEP001"}),
        (["empty-glob"], {"SET204"}),
        (["Empty-Glob"], {"SET204"}),
    ],
)
def test_rules_of_some_names(tmp_path: Path, names: list[str], codes: set[str]) -> None:
    lines = run_here("rules", *names, cwd=tmp_path).stdout.splitlines()
    assert {line[:6] for line in lines} == codes
    found = json.loads(run_here("rules", *names, "--format", "json", cwd=tmp_path).stdout)
    assert {each["code"] for each in found} == codes


def test_rules_without_a_name_are_all(tmp_path: Path) -> None:
    everything = json.loads(run_here("rules", "--format", "json", cwd=tmp_path).stdout)
    assert len(everything) == len(run_here("rules", cwd=tmp_path).stdout.splitlines()) > 150


def test_rules_of_an_unknown_name(tmp_path: Path) -> None:
    done = run_here("rules", "empty-glb", cwd=tmp_path)
    assert done.stderr == (
        "rospkg: there is no rule `empty-glb` (did you mean `empty-glob`?); `rospkg rules` lists them\n"
    )


def test_an_explanation_as_json(tmp_path: Path) -> None:
    found = json.loads(run_here("explain", "set204", "--format", "json", cwd=tmp_path).stdout)
    assert (found["code"], found["name"]) == ("SET204", "empty-glob")
    assert found["explanation"] == run_here("explain", "SET204", cwd=tmp_path).stdout


def test_all_explanations(tmp_path: Path) -> None:
    text = run_here("explain", "--all", cwd=tmp_path).stdout
    found = json.loads(run_here("explain", "--all", "--format", "json", cwd=tmp_path).stdout)
    assert "\n".join(each["explanation"] for each in found) == text
    assert len(found) == len(run_here("rules", cwd=tmp_path).stdout.splitlines())


@pytest.mark.parametrize(
    "typed, says",
    [
        ((), "name a rule: `rospkg explain SET101`; --all shows every rule, and `rospkg rules` lists them"),
        (("SET101", "--all"), "--all shows every rule, `SET101` among them; leave one of the two out"),
        (
            ("SET4",),
            "`SET4` matches several rules: SET401, SET402, SET403; name one, or list them: rospkg rules SET4",
        ),
        (("SET101", "--format", "txt"), "--format must be one of text, json; not `txt` (did you mean `text`?)"),
    ],
)
def test_what_to_explain_must_be_clear(tmp_path: Path, typed: tuple[str, ...], says: str) -> None:
    done = run_here("explain", *typed, cwd=tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"rospkg: {says}\n")


@pytest.mark.parametrize("typed", ["my_pkg/", "./my_pkg", "deep/er/my_pkg"])
def test_a_path_ends_in_the_name_of_the_package(tmp_path: Path, typed: str) -> None:
    done = run_here("new", typed, *WHO, "--launch", "none", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "<name>my_pkg</name>" in (tmp_path / typed / "package.xml").read_text()


def test_the_current_folder_where_it_holds_nothing_but_gits_own(tmp_path: Path) -> None:
    folder = tmp_path / "my_pkg"
    (folder / ".git").mkdir(parents=True)
    done = run_here("new", ".", *WHO, cwd=folder)
    assert (done.returncode, done.stderr) == (0, "")
    assert (folder / "my_pkg/__init__.py").is_file()
    assert sorted(each.name for each in tmp_path.iterdir()) == ["my_pkg"]


def test_an_empty_folder_of_that_name_is_filled(tmp_path: Path) -> None:
    (tmp_path / "my_pkg").mkdir()
    assert run_here("new", "my_pkg", *WHO, cwd=tmp_path).returncode == 0
    assert (tmp_path / "my_pkg/package.xml").is_file()


def test_a_folder_that_holds_something_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "my_pkg").mkdir()
    (tmp_path / "my_pkg/notes.txt").touch()
    done = run_here("new", ".", *WHO, cwd=tmp_path / "my_pkg")
    assert done.returncode == 2
    assert "exists already and was left alone" in done.stderr
    assert [each.name for each in (tmp_path / "my_pkg").iterdir()] == ["notes.txt"]


def test_a_family_is_not_written_into_one_folder(tmp_path: Path) -> None:
    done = run_here("new", ".", "--family", *WHO, cwd=tmp_path)
    says = "--family writes four packages; name the robot, and their folder with --into"
    assert (done.returncode, done.stderr) == (2, f"rospkg: {says}\n")


def test_the_options_of_ros2_pkg_create_are_known(tmp_path: Path) -> None:
    done = run_here(
        "new", "my_pkg", "--build-type", "ament_cmake", "--node-name", "driver", "--dependencies", "nav_msgs",
        "--maintainer-name", "Ada", "--maintainer-email", "ada@example.org", "--destination-directory", "src",
        cwd=tmp_path,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    manifest = (tmp_path / "src/my_pkg/package.xml").read_text()
    assert '<maintainer email="ada@example.org">Ada</maintainer>' in manifest
    assert "<depend>nav_msgs</depend>" in manifest
    assert (tmp_path / "src/my_pkg/src/driver.cpp").is_file()


def test_dependencies_with_blanks_between_them(tmp_path: Path) -> None:
    done = run_here("new", "my_pkg", "--dependencies", "rclpy", "nav_msgs", cwd=tmp_path)
    says = "names of dependencies are joined by commas: --depends rclpy,std_msgs; `rospkg new --help` shows how"
    assert (done.returncode, done.stderr) == (2, f"rospkg: {says}\n")


@pytest.mark.parametrize(
    "completed, typed, words",
    [
        (complete.rule_words, "SET40", ["SET401", "SET402", "SET403"]),
        (complete.rule_words, "set40", ["set401", "set402", "set403"]),
        (complete.rule_words, "empty-g", ["empty-glob"]),
        (complete.listed(complete.rule_codes), "URD002,UR", ["URD002,URD", "URD002,URD001"]),
        (complete.listed(complete.distro_names), "jazzy,k", ["jazzy,kilted"]),
        (complete.listed(complete.license_names), "Apache", ["Apache-2.0"]),
        (complete.listed(complete.format_names), "g", ["github", "gitlab"]),
        (complete.listed(complete.dependency_names), "rclpy,std_m", ["rclpy,std_msgs"]),
        (complete.choices("auto", "always", "never"), "a", ["auto", "always"]),
        (complete.node_kinds, "a:li", ["a:lifecycle"]),
        (complete.node_kinds, "a", []),
        (complete.node_kinds, "a:timer:p", []),
    ],
)
def test_values_that_a_shell_completes(completed: Callable[[str], Iterator[str]], typed: str, words: list[str]) -> None:
    assert list(completed(typed)) == words
