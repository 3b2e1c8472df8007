"""`rospkg new --type workspace`, and what `--with` adds to the root of a family."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
import yaml
from in_process import Done, run_here

from rospkg_cli.scaffold import family_root
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.answers_record import RECORD

WHO = ("--maintainer", "Ada", "--email", "ada@example.org")
EVERYTHING = "ci,pre-commit,devcontainer"
PLAIN = {"src/.gitkeep", "my_ws.repos", "colcon_defaults.yaml", "rospkg.toml", "README.md", ".gitignore", RECORD}
EXTRAS = {".github/workflows/ci.yaml", ".pre-commit-config.yaml", ".devcontainer/devcontainer.json"}


def files(folder: Path) -> dict[str, str]:
    return {p.relative_to(folder).as_posix(): p.read_text() for p in folder.rglob("*") if p.is_file()}


def new(cwd: Path, *words: str) -> Done:
    return run_here("new", *words, cwd=cwd)


def test_it_has_what_packages_are_built_and_checked_with(tmp_path: Path) -> None:
    done = new(tmp_path, "my_ws", "--type", "workspace", "--distro", "jazzy")
    assert (done.returncode, done.stderr) == (0, "")
    found = files(tmp_path / "my_ws")
    assert set(found) == PLAIN
    assert yaml.safe_load(found["my_ws.repos"]) == {"repositories": {}}
    assert set(yaml.safe_load(found["colcon_defaults.yaml"])) == {"build", "test", "test-result"}
    assert 'target = ["jazzy"]\n' in found["rospkg.toml"]
    assert "/src/external/\n" in found[".gitignore"]
    assert found["README.md"].startswith("# my_ws\n\nA ROS 2 workspace for Jazzy Jalisco\n")
    assert f"Next, in {tmp_path / 'my_ws'}:\n  rospkg new src/my_robot\n" in done.stdout


def test_extras_stand_in_its_root_and_are_about_all_packages(tmp_path: Path) -> None:
    assert new(tmp_path, "my-ws.2", "--type", "workspace", "--with", EVERYTHING, "--distro", "jazzy").returncode == 0
    found = files(tmp_path / "my-ws.2")
    assert set(found) > EXTRAS
    workflow = yaml.safe_load(found[".github/workflows/ci.yaml"])
    steps = workflow["jobs"]["test"]["steps"]
    assert [step for step in steps if "path" in step.get("with", {})] == []
    assert "vcs import src/external < my-ws.2.repos" in steps[1]["run"]
    assert workflow["jobs"]["lint"]["steps"][-1] == {"run": "rospkg lint --target jazzy --format github src"}
    container = json.loads(found[".devcontainer/devcontainer.json"])
    assert container["workspaceMount"] == "source=${localWorkspaceFolder},target=/workspace,type=bind"


def test_packages_in_it_are_for_its_distribution_and_lint_is_silent(tmp_path: Path) -> None:
    assert new(tmp_path, "my_ws", "--type", "workspace", "--with", "ci", "--distro", "humble").returncode == 0
    root = tmp_path / "my_ws"
    done = new(root, "my_robot", "--family", "--into", "src", *WHO, "--with", "pre-commit,devcontainer")
    assert (done.returncode, done.stderr) == (0, "")
    assert "── .pre-commit-config.yaml" in done.stdout.replace("└", "├").replace("├── ", "── ")
    assert (root / ".pre-commit-config.yaml").is_file()
    assert "humble" in json.loads((root / ".devcontainer/devcontainer.json").read_text())["image"]
    assert not list((root / "src").rglob(".pre-commit-config.yaml"))
    lint = run_here("lint", "--pedantic", "--release", cwd=root)
    assert (lint.returncode, lint.stderr) == (0, "")


def test_what_is_there_already_is_left_alone_and_nothing_is_written(tmp_path: Path) -> None:
    (tmp_path / "ws/src").mkdir(parents=True)
    (tmp_path / "ws/.pre-commit-config.yaml").write_text("repos: []\n")
    done = new(tmp_path, "my_robot", "--family", "--into", "ws/src", *WHO, "--with", "ci,pre-commit")
    assert done.returncode == 2
    assert "ws/.pre-commit-config.yaml` exists already and was left alone; leave it out of --with" in done.stderr
    assert set(files(tmp_path)) == {"ws/.pre-commit-config.yaml"}
    assert list((tmp_path / "ws/src").iterdir()) == []


def test_the_workflow_fetches_repositories_only_where_there_is_one_list(tmp_path: Path) -> None:
    (tmp_path / "src").mkdir()

    def workflow() -> str:
        [file] = family_root.family_root(Request("arm", extras=("ci",)), tmp_path / "src", "jazzy").files
        return file.entry.text.text

    assert "vcs import" not in workflow()
    (tmp_path / "team.repos").touch()
    assert "vcs import src/external < team.repos\n" in workflow()
    (tmp_path / "a;b.repos").touch()
    assert "vcs import" not in workflow()
    (tmp_path / "team.repos").unlink()
    assert "vcs import" not in workflow()


def test_a_family_that_is_a_repository_is_checked_out_into_a_workspace(tmp_path: Path) -> None:
    done = new(tmp_path, "arm", "--family", "--into", "arms", *WHO, "--with", EVERYTHING)
    assert done.returncode == 0
    workflow = yaml.safe_load((tmp_path / "arms/.github/workflows/ci.yaml").read_text())
    assert [job["steps"][0]["with"]["path"] for job in workflow["jobs"].values()] == ["src/arm", "arm"]
    assert not list((tmp_path / "arms/arm").glob(".[gp]*/*"))


def test_where_the_root_fails_the_packages_are_taken_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: object, **__: object) -> None:
        raise family_root.ScaffoldError("the disk is full")

    monkeypatch.setattr(family_root, "write_into", full)
    done = new(tmp_path, "arm", "--family", "--into", "arms", *WHO, "--with", "ci")
    assert (done.returncode, done.stderr) == (2, "rospkg: the disk is full\n")
    assert list(tmp_path.iterdir()) == []


REFUSED = {
    ("my_ws", "--node", "a"): "a workspace has no nodes; packages have: rospkg new my_ws/src/my_robot",
    ("my_ws", "--msg", "A"): "a workspace has no messages",
    ("my_ws", "--no-params"): "a workspace has no params",
    ("my ws",): "can't be the name of a workspace: letters, digits, `_`, `-` and `.`; try `my_ws`",
    ("w" * 101,): "can't be the name of a workspace",
    ("my_ws", "--with", "docs"): "`docs` is for a package; leave it out of --with here: ci, pre-commit, devcontainer",
    ("my_ws", "--with", "cii"): "did you mean `ci`",
    ("my_ws", "-i"): "-i asks for packages",
    ("my_ws", "--family"): "`rospkg new ROBOT --family --into my_ws/src`",
    ("my_ws", "--description", "a\x00b"): "the description holds U+0000",
}


@pytest.mark.parametrize("words", REFUSED)
def test_what_it_can_not_have_is_refused(tmp_path: Path, words: tuple[str, ...]) -> None:
    done = new(tmp_path, *words, "--type", "workspace")
    assert done.returncode == 2
    assert REFUSED[words] in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_one_that_is_there_is_completed(tmp_path: Path) -> None:
    (tmp_path / "my_ws/src").mkdir(parents=True)
    (tmp_path / "my_ws/README.md").write_text("Mine.\n")
    assert new(tmp_path, "my_ws", "--type", "workspace").returncode == 2
    done = new(tmp_path, "my_ws", "--type", "workspace", "--skip")
    assert done.returncode == 0
    assert "skipped    README.md   differs, and lacks:\n" in done.stdout
    assert set(files(tmp_path / "my_ws")) == PLAIN
    assert (tmp_path / "my_ws/README.md").read_text() == "Mine.\n"


def test_its_description_is_yours(tmp_path: Path) -> None:
    words = ("my_ws", "--type", "workspace", "--description", "All *robots*", "--dry-run")
    assert "# my_ws\n\nAll \\*robots\\*\n" in new(tmp_path, *words).stdout
