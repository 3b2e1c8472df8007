"""What --fix, --fix-only, --show-fixes and --diff print, and how they exit."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from in_process import run_here as rospkg

from rospkg_cli.cli.lint.fix_list import MOST

UNUSED = "  <!-- rospkg: ignore[XML104] long gone -->\n"


@pytest.fixture
def package(tmp_path, write, clean) -> Path:
    """A package with one finding that has a fix (RPK002), and one that has none (XML104)."""
    manifest = clean["package.xml"].replace("  <name>", f"{UNUSED}  <name>").replace("Apache-2.0", "TODO")
    return write(tmp_path / "my_pkg", {**clean, "package.xml": manifest})


def test_fix_lists_what_it_fixed_and_reports_what_is_left(package: Path) -> None:
    done = rospkg("lint", "--fix", cwd=package)
    listed, left = done.stdout.split("\n\n", 1)
    assert listed == "Fixed 1 finding in 1 file:\n  package.xml: RPK002 remove the ignore of XML104"
    assert left.startswith("package.xml:8:12: warning XML104")
    assert "1 fixed; 1 warning left in 1 package" in left
    assert (done.returncode, UNUSED in (package / "package.xml").read_text()) == (1, False)


def test_fix_only_reports_nothing_that_is_left(package: Path) -> None:
    done = rospkg("lint", "--fix-only", cwd=package)
    assert done.stdout == "Fixed 1 finding in 1 file:\n  package.xml: RPK002 remove the ignore of XML104\n"
    assert (done.returncode, done.stderr) == (0, "")
    assert UNUSED not in (package / "package.xml").read_text()
    again = rospkg("lint", "--fix-only", "--exit-non-zero-on-fix", cwd=package)
    assert (again.returncode, again.stdout) == (0, "")


def test_fix_only_still_fails_where_files_changed_or_nothing_is_there(package: Path) -> None:
    assert rospkg("lint", "--fix-only", "--exit-non-zero-on-fix", cwd=package).returncode == 1
    (package / "package.xml").unlink()
    nothing = rospkg("lint", "--fix-only", cwd=package)
    assert (nothing.returncode, "RPK006" in nothing.stdout) == (2, True)


def test_of_many_fixes_the_first_are_listed_and_all_with_show_fixes(tmp_path: Path, write, clean) -> None:
    for number in range(MOST + 2):
        manifest = clean["package.xml"].replace("my_pkg", f"p{number:02}").replace("  <name>", f"{UNUSED}  <name>")
        write(tmp_path / f"p{number:02}", {"package.xml": manifest})
    select = ("--select", "RPK002,XML104")
    few = rospkg("lint", *select, "--fix", cwd=tmp_path).stdout.split("\n\n")[0].splitlines()
    assert few[0] == f"Fixed {MOST + 2} findings in {MOST + 2} files:"
    assert few[-1] == "  … and 2 others; --show-fixes lists all"
    assert few[1:-1] == [f"  p{n:02}/package.xml: RPK002 remove the ignore of XML104" for n in range(MOST)]
    for number in range(MOST + 2):
        manifest = tmp_path / f"p{number:02}" / "package.xml"
        manifest.write_text(manifest.read_text().replace("  <name>", f"{UNUSED}  <name>"))
    every = rospkg("lint", *select, "--fix", "--show-fixes", cwd=tmp_path).stdout.split("\n\n")[0].splitlines()
    assert len(every) == MOST + 3


def test_equal_fixes_of_a_file_are_one_line(package: Path) -> None:
    manifest = package / "package.xml"
    manifest.write_text(manifest.read_text().replace(UNUSED, f"{UNUSED}  <!-- x -->\n{UNUSED}"))
    shown = rospkg("lint", "--fix-only", cwd=package).stdout
    assert shown == "Fixed 2 findings in 1 file:\n  package.xml: RPK002 remove the ignore of XML104 (×2)\n"


def test_other_formats_list_fixes_on_stderr_and_only_where_asked(package: Path) -> None:
    done = rospkg("lint", "--fix", "--format", "concise", "--show-fixes", cwd=package)
    assert done.stdout.startswith("package.xml:8:12: warning XML104")
    assert done.stderr == "Fixed 1 finding in 1 file:\n  package.xml: RPK002 remove the ignore of XML104\n"
    (package / "package.xml").write_text((package / "package.xml").read_text().replace("  <name>", f"{UNUSED}  <name>"))
    silent = rospkg("lint", "--fix", "--format", "concise", cwd=package)
    assert (silent.stdout, silent.stderr) == (done.stdout, "")


def test_quiet_lists_nothing(package: Path) -> None:
    assert rospkg("lint", "--fix-only", "--quiet", cwd=package).stdout == ""


def test_diff_tells_how_many_and_nothing_else(package: Path) -> None:
    done = rospkg("lint", "--diff", cwd=package)
    assert done.stdout.startswith("--- a/package.xml\n+++ b/package.xml\n")
    assert (done.returncode, done.stderr) == (1, "rospkg: --fix would fix 1 finding in 1 file\n")
    unsafe = rospkg("lint", "--diff", "--unsafe-fixes", cwd=package)
    assert unsafe.stderr == "rospkg: --fix --unsafe-fixes would fix 1 finding in 1 file\n"
    assert rospkg("lint", "--diff", "--exit-zero", cwd=package).returncode == 0
    rospkg("lint", "--fix-only", cwd=package)
    nothing = rospkg("lint", "--diff", cwd=package)
    assert (nothing.returncode, nothing.stdout, nothing.stderr) == (0, "", "rospkg: --fix would change nothing\n")


def test_exit_zero(package: Path) -> None:
    assert rospkg("lint", cwd=package).returncode == 1
    assert rospkg("lint", "--exit-zero", cwd=package).returncode == 0
    assert rospkg("lint", "--exit-zero", "--fix", "--exit-non-zero-on-fix", cwd=package).returncode == 0
    (package / "package.xml").unlink()
    assert rospkg("lint", "--exit-zero", cwd=package).returncode == 2


def test_what_came_up_while_others_were_fixed_is_told(package: Path) -> None:
    """The comment ignores a finding on a line that is removed, and is then unused itself."""
    manifest = package / "package.xml"
    line, comment = "  <depend>std_msgs</depend>\n", "  <!-- rospkg: ignore[XML209] soon used -->\n"
    manifest.write_text(manifest.read_text().replace(UNUSED, f"{line}{comment}{line}{UNUSED}"))
    done = rospkg("lint", "--select", "XML201,XML209,RPK002,XML104", "--fix", cwd=package)
    assert "\n4 fixed (1 of them came up while others were fixed); 1 warning left in " in done.stdout
    assert "ignore" not in manifest.read_text()


def test_the_hooks_do_not_repeat_each_other() -> None:
    hooks = {
        each["id"]: each for each in yaml.safe_load((Path(__file__).parents[1] / ".pre-commit-hooks.yaml").read_text())
    }
    assert hooks["rospkg-fix"]["entry"] == "rospkg lint --fix-only --exit-non-zero-on-fix --allow-empty"
    assert hooks["rospkg-lint"]["entry"] == "rospkg lint --allow-empty"
