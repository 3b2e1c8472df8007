"""Several configs in one workspace, and the options that choose among them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from in_process import run_here as rospkg

IGNORE = '[ignore]\nXML104 = "the text will come"\n'


@pytest.fixture
def workspace(tmp_path, write, clean) -> Path:
    """A workspace with packages `here` and, in a repository of its own, `there`: each with one warning."""
    for folder in ("src/here", "src/repo/there"):
        name = folder.rpartition("/")[2]
        text = clean["package.xml"].replace("my_pkg", name).replace("Apache-2.0", "TODO")
        text = text.replace("  <export>", "  <buildtool_depend>ament_cmake</buildtool_depend>\n  <export>")
        text = text.replace("ament_python", "ament_cmake")
        write(tmp_path / "ws" / folder, {"package.xml": text, "CMakeLists.txt": cmake(name)})
    return tmp_path / "ws"


def cmake(name: str) -> str:
    head = f"cmake_minimum_required(VERSION 3.20)\nproject({name})\n"
    return f"{head}find_package(ament_cmake REQUIRED)\nament_package()\n"


def found(cwd: Path, *arguments: str) -> set[tuple[str, str, str]]:
    """Return the code, level and place of each finding, the place from the root of the workspace."""
    done = rospkg("lint", "--format", "json", *arguments, cwd=cwd)
    assert done.returncode in (0, 1), done.stderr
    base = cwd.resolve()
    root = next(folder for folder in (base, *base.parents) if folder.name == "ws")
    return {
        (f["code"], f["severity"], (base / f["path"]).resolve().relative_to(root).as_posix())
        for f in json.loads(done.stdout)["findings"]
    }


def below(workspace: Path, *arguments: str) -> set[tuple[str, str, str]]:
    """Return what is found where each repository is linted by itself."""
    return found(workspace / "src/here", *arguments) | found(workspace / "src/repo", *arguments)


HERE = ("XML104", "warning", "src/here/package.xml")
THERE = ("XML104", "warning", "src/repo/there/package.xml")


@pytest.mark.parametrize(
    "root, nested, expected",
    [
        ("", "", {HERE, THERE}),
        (IGNORE, "", set()),
        ("", IGNORE, {HERE}),
        (IGNORE, "pedantic = false\n", {THERE}),
        ("", '[severity]\nXML104 = "error"\n', {HERE, ("XML104", "error", THERE[2])}),
        ("", 'select = ["SET"]\n', {HERE}),
        ('select = ["SET"]\n', 'select = ["XML104"]\n', {THERE}),
        ('select = ["SET"]\n', "pedantic = false\n", {THERE}),
        ("", 'exclude = ["there"]\n', {HERE}),
        ('exclude = ["repo"]\n', "pedantic = false\n", {HERE}),
        ("", '[per-path."there".ignore]\nXML104 = "soon"\n', {HERE}),
    ],
)
def test_the_nearest_config_counts_from_the_root_and_from_below(workspace: Path, root, nested, expected) -> None:
    (workspace / "rospkg.toml").write_text(root or "release = false\n")
    if nested:
        (workspace / "src/repo/rospkg.toml").write_text(nested)
    chosen = ("--select", "XML104") if "select" not in root + nested else ()
    assert found(workspace, *chosen) == expected
    if "exclude" not in root + nested:  # a folder of nothing but excluded packages is no run
        assert below(workspace, *chosen) == expected


def test_unused_ignores_are_judged_by_what_ran_on_the_package(workspace: Path) -> None:
    """In the repository SET rules alone run, so that its comment on XML104 is not judged."""
    (workspace / "rospkg.toml").write_text("release = false\n")
    (workspace / "src/repo/rospkg.toml").write_text('select = ["SET", "RPK"]\n')
    for path in ("src/here", "src/repo/there"):
        manifest = workspace / path / "package.xml"
        manifest.write_text(
            manifest.read_text()
            .replace("TODO", "Drives")
            .replace("  <name>", "  <!-- rospkg: ignore[XML104] x -->\n  <name>")
        )
    assert found(workspace) == {("RPK002", "warning", "src/here/package.xml")} == below(workspace)


def test_an_ignore_of_a_rule_that_did_not_run_on_its_packages_is_not_judged(workspace: Path) -> None:
    (workspace / "src/repo/rospkg.toml").write_text('select = ["SET", "RPK"]\n[ignore]\nXML101 = "x"\nSET101 = "x"\n')
    told = rospkg("lint", "--format", "concise", cwd=workspace).stdout
    assert [line.split(": ")[0] for line in told.splitlines() if "RPK002" in line] == ["src/repo/rospkg.toml:4:1"]


def test_an_unused_ignore_is_told_in_the_config_that_has_it(workspace: Path) -> None:
    (workspace / "rospkg.toml").write_text('[ignore]\nXML101 = "x"\n')
    (workspace / "src/repo/rospkg.toml").write_text('[ignore]\nXML101 = "x"\nXML104 = "x"\n')
    only = ("--select", "XML,RPK002")
    assert {place for code, _, place in found(workspace, *only) if code == "RPK002"} == {
        "rospkg.toml",
        "src/repo/rospkg.toml",
    }
    assert {place for code, _, place in found(workspace / "src/repo", *only) if code == "RPK002"} == {
        "src/repo/rospkg.toml"
    }


@pytest.mark.parametrize("key", ['target = ["humble"]', 'required-version = ">=99"', 'plugins = ["nowhere"]'])
def test_some_keys_count_in_the_config_of_the_root_alone(workspace: Path, key: str) -> None:
    (workspace / "src/repo/rospkg.toml").write_text(f"{key}\n")
    (workspace / "rospkg.toml").write_text("release = false\n")
    nested = rospkg("lint", cwd=workspace)
    assert (nested.returncode, nested.stderr) == (1, "")
    assert "  # does not count: only the root's does" in rospkg("lint", "--show-settings", cwd=workspace).stdout
    (workspace / "rospkg.toml").write_text(f"{key}\n")
    if "target" in key:
        assert "targets: humble" in rospkg("lint", "--show-settings", cwd=workspace / "src/repo").stdout
    else:
        assert rospkg("lint", cwd=workspace / "src/repo").returncode == 2


def test_what_is_set_is_shown(workspace: Path) -> None:
    (workspace / "rospkg.toml").write_text(f'select = ["XML"]\n{IGNORE}[per-path."a/*".severity]\nXML101 = "info"\n')
    (workspace / "src/repo/rospkg.toml").write_text('select = ["SET101"]\n')
    shown = rospkg("lint", "--show-settings", cwd=workspace).stdout
    assert shown.startswith(
        f"packages: 2 of 2 packages, below {workspace}\ntargets: all that are supported\nindex: none"
    )
    assert f"\n\n{workspace}/rospkg.toml: the root's, 1 package, " in shown
    assert '\n  select = ["XML"]\n  ignore = {"XML104": "the text will come"}\n' in shown
    assert '\n  per-path."a/*" = {"ignore": {}, "severity": {"XML101": "info"}}\n' in shown
    assert f'\n\n{workspace}/src/repo/rospkg.toml: 1 package, 1 rule\n  select = ["SET101"]\n' in shown


def test_isolated_and_one_config_for_all(workspace: Path) -> None:
    (workspace / "src/repo/rospkg.toml").write_text(IGNORE)
    (workspace / "src/here/rospkg.toml").write_text(IGNORE)
    only = ("--select", "XML104")
    assert found(workspace, *only) == set()
    assert found(workspace, *only, "--isolated") == {HERE, THERE}
    (workspace.parent / "ours.toml").write_text('[per-package."there".ignore]\nXML104 = "soon"\n')
    assert found(workspace, *only, "--config", "../ours.toml") == {HERE}
    (workspace / "pyproject.toml").write_text('[tool.rospkg.per-package."here".ignore]\nXML104 = "soon"\n')
    assert found(workspace, *only, "--config", "pyproject.toml") == {THERE}
    for arguments, says in (
        (("--config", "none.toml"), "--config: there is no file `none.toml`"),
        (("--config", "../ours.toml", "--isolated"), "contradict each other"),
    ):
        done = rospkg("lint", *arguments, cwd=workspace)
        assert (done.returncode, says in done.stderr) == (2, True)


def test_what_a_nested_config_ignores_is_listed_with_its_reason(workspace: Path) -> None:
    (workspace / "src/repo/rospkg.toml").write_text(IGNORE)
    done = rospkg("lint", "--select", "XML104", "--format", "json", cwd=workspace)
    suppressed = json.loads(done.stdout)["suppressed"]
    assert [(f["path"], f["reason"]) for f in suppressed] == [(THERE[2], "the text will come")]


def test_a_wrong_nested_config_is_one_sentence(workspace: Path) -> None:
    (workspace / "src/repo/rospkg.toml").write_text("selct = []\n")
    done = rospkg("lint", cwd=workspace)
    assert (done.returncode, "src/repo/rospkg.toml:1:1: there is no key `selct`" in done.stderr) == (2, True)


@pytest.mark.parametrize(
    "pattern, left",
    [
        ("repo", {HERE}),
        ("there", {HERE}),
        ("there/", {HERE}),
        ("th*", {HERE}),
        ("src/repo", {HERE}),
        ("src/*", set()),
        ("/src/here", {THERE}),
        ("src/repo/**", {HERE}),
        ("/repo", {HERE, THERE}),
        ("her", {HERE, THERE}),
    ],
)
def test_exclude_fits_as_gitignore_does(workspace: Path, pattern: str, left) -> None:
    (workspace / "rospkg.toml").write_text(f'exclude = ["{pattern}"]\n')
    done = rospkg("lint", "--select", "XML104", "--format", "json", "--allow-empty", cwd=workspace)
    assert {f["path"] for f in json.loads(done.stdout)["findings"]} == {place for _, _, place in left}


@pytest.mark.parametrize("pattern, is_told", [("repos", True), ("/repo", True), ("repo", False), ("include", False)])
def test_an_exclude_that_fits_nothing_is_told(workspace: Path, pattern: str, is_told: bool) -> None:
    (workspace / "src/here/include").mkdir()  # it leaves no package out, but there is something of that name
    (workspace / "rospkg.toml").write_text(f'target = ["jazzy"]\nexclude = ["{pattern}"]\n')
    done = rospkg("lint", "--format", "concise", "--select", "RPK002", cwd=workspace)
    says = f"rospkg.toml:2:13: warning RPK002 unused-suppression: `{pattern}` fits no folder and no file: it excludes"
    assert (says in done.stdout) == is_told
    part = rospkg("lint", "src/here", "--format", "concise", "--select", "RPK002", cwd=workspace)
    assert part.stdout == ""


def test_all_means_every_rule(workspace: Path) -> None:
    manifest = workspace / "src/here/package.xml"
    usual = found(workspace / "src/here")
    every = found(workspace / "src/here", "--select", "ALL")
    assert usual < every
    assert found(workspace / "src/here", "--select", "all", "--ignore", "XML104") == every - {HERE}
    assert found(workspace / "src/here", "--extend-select", "ALL") == every
    assert found(workspace / "src/here", "--ignore", "ALL") == set()
    (workspace / "rospkg.toml").write_text('[ignore]\nALL = "vendored"\n')
    assert found(workspace) == set()
    (workspace / "rospkg.toml").unlink()
    text = manifest.read_text()
    manifest.write_text(text.replace("  <license>", "  <!-- rospkg: ignore[ALL] soon -->\n  <license>"))
    assert HERE not in found(workspace / "src/here")
