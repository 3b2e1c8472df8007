"""--fix when things go wrong: killed, no space left, a rule whose fix would break a file."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import pytest
from test_lint_command import rospkg

from rospkg_cli.engine import shard
from rospkg_cli.engine.fix import repair
from rospkg_cli.engine.session import Scope, Session
from rospkg_cli.engine.stamp import rule_by_code
from rospkg_cli.finding import Edit, Fix, Hit, Safety
from rospkg_cli.model.manifest import Manifest
from rospkg_cli.source import Span
from rospkg_cli.tree import MemoryTree

NEEDLESS = "  <!-- rospkg: ignore[RPK001] never needed -->\n  <export>"


@pytest.fixture
def packages(tmp_path, write, clean) -> Path:
    """Three packages, each with a needless ignore that --fix takes out."""
    for name in ("a", "b", "c"):
        text = clean["package.xml"].replace("my_pkg", name).replace("  <export>", NEEDLESS)
        write(tmp_path / "ws" / name, {"package.xml": text.replace("ament_python", "ament_cargo")})
    return tmp_path / "ws"


def manifests(packages: Path) -> dict[str, bytes]:
    return {str(p.relative_to(packages)): p.read_bytes() for p in sorted(packages.rglob("*")) if p.is_file()}


FIX = ["lint", "--select", "RPK", "--fix"]


def test_killed_in_the_middle_every_file_is_whole(packages: Path) -> None:
    before = manifests(packages)
    code = (
        "import os, pathlib, signal, sys; real, done = pathlib.Path.replace, []\n"
        "def replace(self, to):\n"
        "    done.append(to)\n"
        "    if len(done) == 2: os.kill(os.getpid(), signal.SIGKILL)\n"
        "    return real(self, to)\n"
        "pathlib.Path.replace = replace\n"
        f"sys.argv = ['rospkg', *{FIX!r}]\n"
        "from rospkg_cli.__main__ import main; sys.exit(main())"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=packages, capture_output=True)
    assert done.returncode == -9
    after = manifests(packages)
    fixed = {name: text.replace(NEEDLESS.encode(), b"  <export>") for name, text in before.items()}
    named = {name: text for name, text in after.items() if "/." not in name}
    assert all(text in (before[name], fixed[name]) for name, text in named.items())
    assert sum(named[name] == fixed[name] for name in named) == 1
    assert rospkg(*FIX, cwd=packages).returncode == 0
    assert {n: t for n, t in manifests(packages).items() if "/." not in n} == fixed


@pytest.fixture
def tiny_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 64 KiB; only root can make one."""
    folder = tmp_path / "disk"
    folder.mkdir()
    made = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", folder], capture_output=True, text=True)
    if made.returncode:
        pytest.skip(f"a small file system can't be mounted here: {made.stderr.strip()}")
    yield folder
    subprocess.run(["umount", folder], check=True)


def test_a_full_disk_is_said_and_nothing_is_half(tiny_disk: Path, write, clean) -> None:
    text = clean["package.xml"].replace("  <export>", NEEDLESS).replace("ament_python", "ament_cargo")
    write(tiny_disk, {"package.xml": text})
    with (tiny_disk / "ballast").open("wb", buffering=0) as ballast, suppress(OSError):
        while True:
            ballast.write(b"x" * 4096)
    done = rospkg(*FIX, cwd=tiny_disk)
    assert done.returncode == 2
    assert "No space left on device; nothing was written" in done.stderr
    assert (tiny_disk / "package.xml").read_text() == text
    assert sorted(path.name for path in tiny_disk.iterdir()) == ["ballast", "package.xml"]


def test_a_fix_that_would_break_a_file_is_taken_back_and_said(clean, monkeypatch: pytest.MonkeyPatch) -> None:
    def bad(manifest: Manifest) -> Iterator[Hit]:
        end = manifest.root.open.end
        fix = Fix("Break", (Edit(manifest.path, Span(end, end), "<broken"),))
        yield Hit(manifest.path, manifest.root.open, "bad", fix=fix)

    real = rule_by_code
    monkeypatch.setattr(
        shard, "rule_by_code", lambda code: replace(real(code), check=bad) if code == "XML104" else real(code)
    )
    comment = clean["package.xml"].replace("  <export>", NEEDLESS)
    tree = MemoryTree.of({**clean, "package.xml": comment})
    session = Session(tree, Scope(("",), frozenset({""}), "my_pkg"), frozenset({"RPK001", "RPK002", "XML104"}))
    outcome = repair(session, (Safety.SAFE,))
    assert [(f.code, "would break `package.xml`" in why) for f, why in outcome.refused] == [("XML104", True)]
    assert [f.code for f in outcome.applied] == ["RPK002"]
    entry = outcome.changes["package.xml"]
    assert entry is not None
    assert entry.text.text == clean["package.xml"]


def test_what_the_fixed_tree_says_is_reported(packages: Path) -> None:
    done = rospkg(*FIX, cwd=packages)
    assert done.returncode == 0
    assert "3 repaired" in done.stdout
    assert rospkg(*FIX, "--exit-non-zero-on-fix", cwd=packages).returncode == 0


def test_diff_shows_and_writes_nothing(packages: Path) -> None:
    before = manifests(packages)
    done = rospkg("lint", "--select", "RPK", "--diff", cwd=packages)
    assert done.returncode == 1
    assert done.stdout.count("\n-  <!-- rospkg: ignore[RPK001] never needed -->") == 3
    assert "+++ b/b/package.xml" in done.stdout
    assert manifests(packages) == before
