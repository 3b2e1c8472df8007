"""Rules of other installed packages."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

MODULE = '''
from rospkg_cli.example import Example, manifest
from rospkg_cli.finding import Hit, Severity
from rospkg_cli.model.manifest import Manifest
from rospkg_cli.rule import rule
from rospkg_cli.source import Span


@rule("{code}", "our-name", over=Manifest, severity=Severity.WARNING, examples=())
def our_name(manifest):
    """
    ## What it does
    Wants the names of our house.
    """
    yield Hit("package.xml", Span(0, 5), "not one of ours")
'''
EMPTY = "nothing = 1\n"


@pytest.fixture
def package(tmp_path, write, clean) -> Path:
    (tmp_path / "rospkg.toml").write_text('plugins = ["our-house"]\n')
    return write(tmp_path / "my_pkg", clean)


def install(folder: Path, module: str, name: str = "our-house") -> None:
    """Write what pip would: a module, and the metadata of its distribution."""
    info = folder / "our_house-1.0.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: our-house\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(f"[rospkg_cli.rules]\n{name} = our_house_rules\n")
    (folder / "our_house_rules.py").write_text(module)


def rospkg(site: Path, *arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    code = f"import sys; sys.path.append({str(site)!r}); from rospkg_cli.__main__ import main; sys.exit(main())"
    return subprocess.run([sys.executable, "-c", code, *arguments], cwd=cwd, capture_output=True, text=True)


@pytest.mark.parametrize("jobs", ["1", "2"])
def test_they_run_where_the_config_names_them(package: Path, tmp_path: Path, write, clean, jobs: str) -> None:
    install(tmp_path / "site", MODULE.format(code="OUR001"))
    write(package.parent / "other", {path: text.replace("my_pkg", "other") for path, text in clean.items()})
    done = rospkg(tmp_path / "site", "lint", "--jobs", jobs, "--format", "json", cwd=package.parent)
    found = json.loads(done.stdout)["findings"]
    assert {(each["code"], each["package"]) for each in found if each["code"] == "OUR001"} >= {("OUR001", "my_pkg")}
    assert done.returncode == 1
    (package.parent / "rospkg.toml").unlink()
    assert "OUR001" not in rospkg(tmp_path / "site", "lint", cwd=package.parent).stdout


def test_they_can_be_ignored_listed_and_explained(package: Path, tmp_path: Path) -> None:
    install(tmp_path / "site", MODULE.format(code="OUR001"))
    assert rospkg(tmp_path / "site", "lint", "--ignore", "our-name", cwd=package).returncode == 0
    assert "OUR001  our-name" in rospkg(tmp_path / "site", "rules", cwd=package).stdout
    assert "Wants the names of our house" in rospkg(tmp_path / "site", "explain", "OUR001", cwd=package).stdout
    sarif = rospkg(tmp_path / "site", "lint", "--format", "sarif", cwd=package)
    assert json.loads(sarif.stdout)["runs"][0]["results"][0]["ruleId"] == "OUR001"


@pytest.mark.parametrize(
    "module, name, says",
    [
        (MODULE.format(code="OUR001"), "our-hose", "there is no plug-in `our-house` (did you mean `our-hose`?)"),
        (MODULE.format(code="XML104"), "our-house", "has a rule `XML104`, and that code is that of our `placeholder"),
        (MODULE.format(code="our1"), "our-house", "is not three capitals and three digits"),
        (EMPTY, "our-house", "offers no rules"),
        ("import nowhere_at_all\n", "our-house", "can't be loaded: ModuleNotFoundError"),
    ],
)
def test_what_cannot_be_used_is_one_sentence(package: Path, tmp_path: Path, module: str, name: str, says: str) -> None:
    install(tmp_path / "site", module, name)
    done = rospkg(tmp_path / "site", "lint", cwd=package)
    assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1)
    assert says in done.stderr
