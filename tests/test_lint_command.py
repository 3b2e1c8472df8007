"""`rospkg lint` as it is typed: exit status, selection, targets, formats, fixing."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import run_here

from rospkg_cli.cli.app import app

TODO = "TODO: License declaration"


def rospkg(*arguments: object, cwd: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run the command as a process of its own, as a user does; `run_here` shows the same at a tenth of the cost."""
    command = [sys.executable, "-m", "rospkg_cli", *map(str, arguments)]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, env={**os.environ, **environment})


@pytest.fixture
def package(tmp_path, write, clean) -> Path:
    """A package whose license is a placeholder: one warning."""
    return write(tmp_path / "ws" / "my_pkg", {**clean, "package.xml": clean["package.xml"].replace("Apache-2.0", TODO)})


def test_clean_is_0(tmp_path, write, clean) -> None:
    done = rospkg("lint", write(tmp_path / "my_pkg", clean), cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("No problems found (1 package")


def test_a_warning_is_1_unless_only_errors_count(package: Path) -> None:
    assert run_here("lint", cwd=package).returncode == 1
    assert run_here("lint", "--fail-on", "error", cwd=package).returncode == 0


@pytest.mark.parametrize(
    "arguments, says",
    [
        (["nowhere"], "`nowhere` does not exist"),
        (["--select", "SET999"], "there is no rule `SET999`"),
        (["--select", "placeholder-metdata"], "did you mean `placeholder-metadata`?"),
        (["--target", "jazy"], "did you mean `jazzy`?"),
        (["--format", "jsn"], "did you mean `json`?"),
        (["--output", "json"], "FORMAT:FILE"),
        (["--jobs", "0"], "(1 or more)"),
        (["--workspace", "nowhere"], "not a folder"),
        (["--fail-on", "errors"], "did you mean `error`?"),
        (["--frmat"], "there is no option `--frmat`"),
    ],
)
def test_wrong_use_is_2_and_one_sentence(package: Path, arguments: list[str], says: str) -> None:
    done = run_here("lint", *arguments, cwd=package)
    assert done.returncode == 2
    assert says in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert done.stdout == ""


def test_nothing_checked_is_2_with_a_finding(tmp_path: Path) -> None:
    done = rospkg("lint", "--format", "json", cwd=tmp_path)
    assert done.returncode == 2
    assert [f["code"] for f in json.loads(done.stdout)["findings"]] == ["RPK006"]
    assert run_here("lint", "--allow-empty", cwd=tmp_path).returncode == 0


def test_a_rule_that_raises_is_3_and_the_others_go_on(package: Path) -> None:
    code = (
        "import sys, dataclasses, types; from rospkg_cli.__main__ import main\n"
        "from rospkg_cli.engine.run import worker\n"
        "real = worker.rule_by_code\n"
        "def broken(slice): raise RuntimeError('no'); yield\n"
        "def patched(code):\n"
        "    return dataclasses.replace(real(code), check=broken) if code == 'RPK001' else real(code)\n"
        "worker.rule_by_code = patched\n"
        "from rospkg_cli.engine.run.rule_inputs import InputBuilder as B; B.of = lambda self, kind, of=B.of: "
        "[types.SimpleNamespace(skipped=False, path='')] if kind.__name__ == 'Unreadable' else of(self, kind)\n"
        "sys.argv = ['rospkg', 'lint', '--format', 'json', *sys.argv[1:]]; sys.exit(main())"
    )
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, cwd=package, capture_output=True, text=True)
    assert done.returncode == 3
    findings = json.loads(done.stdout)["findings"]
    assert [f["code"] for f in findings] == ["RPK005", "XML104"]
    assert "Traceback" not in done.stderr
    again = subprocess.run([*command, "--traceback"], cwd=package, capture_output=True, text=True)
    assert "RuntimeError: no" in again.stderr


def test_select_and_ignore(package: Path) -> None:
    assert run_here("lint", "--select", "RPK", cwd=package).returncode == 0
    assert run_here("lint", "--ignore", "XML1", cwd=package).returncode == 0
    assert run_here("lint", "--select", "placeholder-metadata", "--ignore", "XML", cwd=package).returncode == 1


def test_json_follows_its_schema_and_counts_from_1(package: Path) -> None:
    done = run_here("lint", "--format", "json", cwd=package.parent)
    data = json.loads(done.stdout)
    (finding,) = data["findings"]
    line = (package / "package.xml").read_text().splitlines()[finding["line"] - 1]
    assert line[finding["column"] - 1 : finding["end_column"] - 1] == TODO
    assert finding["path"] == "my_pkg/package.xml"
    assert finding["package"] == "my_pkg"
    assert data["summary"]["warnings"] == 1


def test_concise_and_github(package: Path) -> None:
    line = run_here("lint", "--format", "concise", cwd=package).stdout
    assert line.startswith("package.xml:8:12: warning XML104 placeholder-metadata: ")
    annotation = run_here("lint", "--format", "github", cwd=package).stdout
    assert annotation.startswith("::warning file=package.xml,line=8,endLine=8,col=12,endColumn=37,title=XML104 ")


def test_output_writes_a_file_beside(package: Path) -> None:
    done = rospkg("lint", "--output", "json:out/report.json", "--format", "concise", cwd=package)
    assert "XML104" in done.stdout
    assert json.loads((package / "out" / "report.json").read_text())["findings"]


def test_jobs_do_not_change_a_byte(tmp_path, write, clean) -> None:
    for number in range(5):
        manifest = clean["package.xml"].replace("my_pkg", f"pkg_{number}").replace("Apache-2.0", TODO)
        write(tmp_path / f"pkg_{number}", {"package.xml": manifest})
    one, two = (rospkg("lint", "--format", "json", "--jobs", n, cwd=tmp_path) for n in (1, 2))
    assert one.stdout == two.stdout
    assert len(json.loads(one.stdout)["findings"]) >= 5


def test_color_only_where_it_is_wanted(package: Path) -> None:
    assert "\x1b[" not in rospkg("lint", cwd=package).stdout
    assert "\x1b[" in run_here("lint", "--color", "always", cwd=package).stdout
    assert "\x1b[" in run_here("lint", cwd=package, FORCE_COLOR="1").stdout
    assert "\x1b[" not in run_here("lint", cwd=package, NO_COLOR="1", FORCE_COLOR="1").stdout


def test_version_help_and_completion(tmp_path: Path) -> None:
    assert rospkg("--version", cwd=tmp_path).stdout.startswith("rospkg ")
    assert run_here("lint", "--version", cwd=tmp_path).returncode == 2
    for verb in [command.name or command.callback.__name__ for command in app.registered_commands]:
        done = run_here(verb, "-h", cwd=tmp_path)
        assert (done.returncode, "Example" in done.stdout) == (0, True), verb
    shown = rospkg("--show-completion", "bash", cwd=tmp_path, _TYPER_COMPLETE_TEST_DISABLE_SHELL_DETECTION="1")
    assert "_ROSPKG_COMPLETE" in shown.stdout


def test_explain_and_rules(tmp_path: Path) -> None:
    done = rospkg("explain", "placeholder-metadata", cwd=tmp_path)
    assert done.stdout.startswith("# XML104 placeholder-metadata")
    assert TODO in done.stdout
    assert "did you mean `XML104`" not in run_here("explain", "XML10", cwd=tmp_path).stderr
    assert run_here("explain", "XML1O4", cwd=tmp_path).returncode == 2
    listed = json.loads(rospkg("rules", "--format", "json", cwd=tmp_path).stdout)
    assert {"code", "name", "severity", "fix", "summary"} <= set(listed[0])
