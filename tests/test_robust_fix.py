"""--fix when things go wrong: killed, no space left, a rule whose fix would break a file."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import pytest
from in_process import run_here as rospkg

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.run import worker
from rospkg_cli.engine.run.results import Results
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.example import scripts
from rospkg_cli.finding import Edit, Fix, Hit, Safety
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.rule_table import rule_by_code
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
        worker,
        "rule_by_code",
        lambda code: replace(real(code), over=Manifest, check=bad) if code == "XML104" else real(code),
    )
    comment = clean["package.xml"].replace("  <export>", NEEDLESS)
    tree = MemoryTree.of({**clean, "package.xml": comment})
    session = Session(tree, Scope(("",), frozenset({""}), "my_pkg"), frozenset({"RPK001", "RPK002", "XML104"}))
    outcome = fix_all(session, (Safety.SAFE,))
    assert [(f.code, "would break `package.xml`" in why) for f, why in outcome.refused] == [("XML104", True)]
    assert [f.code for f in outcome.applied] == ["RPK002"]
    entry = outcome.changes["package.xml"]
    assert entry is not None
    assert entry.text.text == clean["package.xml"]


def test_what_the_fixed_tree_says_is_reported(packages: Path) -> None:
    done = rospkg(*FIX, cwd=packages)
    assert done.returncode == 0
    assert "3 fixed" in done.stdout
    assert rospkg(*FIX, "--exit-non-zero-on-fix", cwd=packages).returncode == 0


def test_diff_shows_and_writes_nothing(packages: Path) -> None:
    before = manifests(packages)
    done = rospkg("lint", "--select", "RPK", "--diff", cwd=packages)
    assert done.returncode == 1
    assert done.stdout.count("\n-  <!-- rospkg: ignore[RPK001] never needed -->") == 3
    assert "+++ b/b/package.xml" in done.stdout
    assert manifests(packages) == before


def test_a_fix_that_shows_a_broken_file_for_the_first_time(clean) -> None:
    """The new `__init__.py` makes a module readable that was broken all along: nobody's fix broke it."""
    files = {
        **clean,
        "setup.py": clean["setup.py"].replace("packages=find_packages(exclude=['test'])", "packages=find_packages()"),
        "my_pkg/sub/y.py": "def main():\n    pass\n",
        "my_pkg/sub/x.py": "def main(:\n",
    }
    setup = files["setup.py"].replace("    zip_safe", f"    {scripts('y = my_pkg.sub.y:main')}\n    zip_safe")
    tree = MemoryTree.of({**files, "setup.py": setup})
    session = Session(tree, Scope(("",), frozenset({""}), "my_pkg"), EVERYTHING.codes())
    outcome = fix_all(session, (Safety.SAFE, Safety.UNSAFE))
    assert "my_pkg/sub/__init__.py" in outcome.changes
    assert [f.location.path for f in outcome.results.findings if f.code == "RPK001"] == ["my_pkg/sub/x.py"]


def test_a_fix_that_never_comes_to_rest_is_left_out_and_the_others_are_made(clean, monkeypatch) -> None:
    def grows(manifest: Manifest) -> Iterator[Hit]:
        end = manifest.root.open.end
        fix = Fix("Grow", (Edit(manifest.path, Span(end, end), "\n"),))
        yield Hit(manifest.path, manifest.root.open, f"bad at {len(manifest.source.text)}", fix=fix)

    real = rule_by_code
    monkeypatch.setattr(
        worker,
        "rule_by_code",
        lambda code: replace(real(code), over=Manifest, check=grows) if code == "XML104" else real(code),
    )
    tree = MemoryTree.of({**clean, "package.xml": clean["package.xml"].replace("  <export>", NEEDLESS)})
    session = Session(tree, Scope(("",), frozenset({""}), "my_pkg"), frozenset({"RPK001", "RPK002", "XML104"}))
    outcome = fix_all(session, (Safety.SAFE,))
    assert [(f.code, why) for f, why in outcome.refused] == [
        ("XML104", "it is found again after each fix; please report this")
    ]
    entry = outcome.changes["package.xml"]
    assert entry is not None
    assert entry.text.text == clean["package.xml"]


def test_what_a_killed_run_left_is_taken_away_by_the_next(packages: Path) -> None:
    over = subprocess.Popen([sys.executable, "-c", ""])
    over.wait()
    (packages / f"a/.package.xml.{over.pid}-x7.rospkg-tmp").write_text("half")
    (packages / f"a/.package.xml.{os.getpid()}-x8.rospkg-tmp").write_text("of a process that lives")
    assert rospkg("lint", "--select", "RPK", cwd=packages).returncode == 1
    assert len(list(packages.rglob("*.rospkg-tmp"))) == 2
    assert rospkg(*FIX, cwd=packages).returncode == 0
    assert [path.name for path in packages.rglob("*.rospkg-tmp")] == [f".package.xml.{os.getpid()}-x8.rospkg-tmp"]


def test_eight_at_once_do_what_one_does(packages: Path) -> None:
    before = manifests(packages)
    command = [sys.executable, "-m", "rospkg_cli", *FIX]
    running = [
        subprocess.Popen(command, cwd=packages, stdout=subprocess.PIPE, stderr=subprocess.PIPE) for _ in range(8)
    ]
    statuses = {process.wait() for process in running if process.communicate() or True}
    assert statuses <= {0, 1, 2}, "1 where another was faster, and a fix was left out"
    assert manifests(packages) == {n: t.replace(NEEDLESS.encode(), b"  <export>") for n, t in before.items()}


@pytest.mark.parametrize("moment", ["fsync", "chmod", "replace", "unlink", "mkstemp"])
def test_killed_at_any_moment_old_or_new(packages: Path, moment: str) -> None:
    before = manifests(packages)
    code = (
        "import os, pathlib, signal, sys, tempfile; done = []\n"
        f"owner = {{'fsync': os, 'mkstemp': tempfile}}.get({moment!r}, pathlib.Path)\n"
        f"real = getattr(owner, {moment!r})\n"
        "def dies(*given, **named):\n"
        "    done.append(given)\n"
        "    if len(done) == 2: os.kill(os.getpid(), signal.SIGKILL)\n"
        "    return real(*given, **named)\n"
        f"setattr(owner, {moment!r}, dies)\n"
        f"sys.argv = ['rospkg', *{FIX!r}]\n"
        "from rospkg_cli.__main__ import main; sys.exit(main())"
    )
    subprocess.run([sys.executable, "-c", code], cwd=packages, capture_output=True)
    fixed = {name: text.replace(NEEDLESS.encode(), b"  <export>") for name, text in before.items()}
    after = {name: text for name, text in manifests(packages).items() if not name.endswith(".rospkg-tmp")}
    assert after.keys() == before.keys()
    assert all(text in (before[name], fixed[name]) for name, text in after.items())
    assert rospkg(*FIX, cwd=packages).returncode == 0
    assert manifests(packages) == fixed


def test_a_file_that_can_t_be_written_does_not_stop_the_others(packages: Path) -> None:
    before = manifests(packages)
    (packages / "a/package.xml").chmod(0o444)
    done = rospkg(*FIX, cwd=packages)
    assert done.returncode == 1
    assert "in a/package.xml was not made: `a/package.xml` is read-only" in done.stderr
    assert "2 fixed" in done.stdout
    after = manifests(packages)
    assert [name for name in before if after[name] == before[name]] == ["a/package.xml"]


def test_a_file_saved_after_the_rules_read_it_is_left_alone(tmp_path: Path, write, clean, monkeypatch) -> None:
    """Offsets into the text that the rules saw are applied to no other, even where all else reads the new one."""
    old = clean["package.xml"].replace("  <export>", NEEDLESS)
    package = write(tmp_path / "my_pkg", {**clean, "package.xml": old})
    session = Session(DiskTree(tmp_path), Scope(("my_pkg",), frozenset({"my_pkg"})), frozenset({"RPK001", "RPK002"}))
    real, new = Session.run, old.replace("Drives my robot", "Drives")

    def then_saved(self: Session) -> Results:
        results = real(self)
        (package / "package.xml").write_text(new)
        vars(session.tree)["_entries"].clear()
        return results

    monkeypatch.setattr(Session, "run", then_saved)
    outcome = fix_all(session, (Safety.SAFE,))
    assert outcome.changes == {}
    assert [why for _, why in outcome.refused] == [
        "`my_pkg/package.xml` was changed by someone else meanwhile; run again"
    ]
