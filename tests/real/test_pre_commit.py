"""The hooks under the real pre-commit, in a real git repository with two packages."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from absent import absent
from checkout import copy_checkout
from shell import Shell
from venvs import NoIndexError, cache_folder, venv

from rospkg_cli.example import Example

CONFIG = """\
repos:
- repo: {checkout}
  rev: v0.1.0
  hooks:
  - id: {hook}
"""


def git(shell: Shell, folder: Path, *arguments: str) -> str:
    done = shell.run("git", *arguments, cwd=folder)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture
def repository(tmp_path: Path, shell: Shell) -> Path:
    """A git repository with the packages one and two, both faultless, and this checkout's hooks at its side."""
    hooks = copy_checkout(tmp_path / "hooks")
    for folder in (hooks, tmp_path / "repository"):
        folder.mkdir(exist_ok=True)
        git(shell, folder, "init", "--quiet", "--initial-branch", "main")
    for name in ("one", "two"):
        for path, text in Example(bad={}, good={}).bad_files().items():
            target = tmp_path / "repository" / name / path.replace("my_pkg", name)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text.replace("my_pkg", name))
    for folder in (hooks, tmp_path / "repository"):
        git(shell, folder, "add", "--all")
        git(shell, folder, "commit", "--quiet", "--message", "first")
    git(shell, hooks, "tag", "v0.1.0")
    return tmp_path / "repository"


def pre_commit(shell: Shell, repository: Path, hook: str, *arguments: str, **variables: str):
    text = CONFIG.format(checkout=repository.parent / "hooks", hook=hook)
    (repository / ".pre-commit-config.yaml").write_text(text)
    git(shell, repository, "add", ".pre-commit-config.yaml")
    extra = {"PIP_CACHE_DIR": str(cache_folder() / "pip"), "PRE_COMMIT_HOME": str(repository.parent / "pre-commit")}
    program = Path(sys.executable).with_name("pre-commit")
    return shell.run(program, "run", *arguments, cwd=repository, **extra, **variables)


def break_license(package: Path) -> None:
    manifest = package / "package.xml"
    manifest.write_text(manifest.read_text().replace("Apache-2.0", "TODO"))


def test_lint_looks_at_the_packages_of_the_staged_files(repository: Path, shell: Shell, index: None) -> None:
    break_license(repository / "one")
    break_license(repository / "two")
    (repository / "README.md").write_text("no package's file\n")
    git(shell, repository, "add", "one", "README.md")
    done = pre_commit(shell, repository, "rospkg-lint")
    assert done.returncode == 1, done.stdout + done.stderr
    assert "one/package.xml:8:12: warning XML104" in done.stdout
    assert "two/package.xml" not in done.stdout
    skipped = pre_commit(shell, repository, "rospkg-lint", SKIP="rospkg-lint")
    assert skipped.returncode == 0, skipped.stdout
    git(shell, repository, "checkout", "--quiet", "HEAD", "--", "one")
    assert pre_commit(shell, repository, "rospkg-lint", "--all-files").returncode == 1
    git(shell, repository, "checkout", "--quiet", "HEAD", "--", "two")
    silent = pre_commit(shell, repository, "rospkg-lint", "--all-files")
    assert silent.returncode == 0, silent.stdout


@pytest.fixture
def index() -> None:
    """pre-commit installs the hook through pip: without an index there is nothing to try."""
    try:
        venv(sys.executable, ("hatchling",))
    except NoIndexError as error:
        absent(str(error))


def test_fix_repairs_and_the_next_commit_goes_through(repository: Path, shell: Shell, index: None) -> None:
    manifest = repository / "one" / "package.xml"
    ignore = "  <!-- rospkg: ignore[RPK001] never needed -->\n  <export>"
    manifest.write_text(manifest.read_text().replace("  <export>", ignore))
    git(shell, repository, "add", "one")
    stopped = pre_commit(shell, repository, "rospkg-fix")
    assert stopped.returncode == 1, stopped.stdout + stopped.stderr
    assert "files were modified by this hook" in stopped.stdout
    assert "never needed" not in manifest.read_text()
    git(shell, repository, "add", "one")
    assert pre_commit(shell, repository, "rospkg-fix").returncode == 0


def test_format_orders_the_manifest(repository: Path, shell: Shell, index: None) -> None:
    manifest = repository / "one" / "package.xml"
    text = manifest.read_text()
    moved = "  <exec_depend>std_msgs</exec_depend>\n  <exec_depend>rclpy</exec_depend>\n  <export>"
    manifest.write_text(text.replace("  <export>", moved))
    git(shell, repository, "add", "one")
    assert pre_commit(shell, repository, "rospkg-format").returncode == 1
    names = [line.strip() for line in manifest.read_text().splitlines() if "exec_depend" in line]
    assert names == ["<exec_depend>rclpy</exec_depend>", "<exec_depend>std_msgs</exec_depend>"]
    git(shell, repository, "add", "one")
    assert pre_commit(shell, repository, "rospkg-format").returncode == 0
