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
from rospkg_cli.package.manifest import Manifest
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


@pytest.fixture
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("elsewhere")


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
def test_they_run_where_the_config_names_them(package: Path, site: Path, write, clean, jobs: str) -> None:
    install(site, MODULE.format(code="OUR001"))
    write(package.parent / "other", {path: text.replace("my_pkg", "other") for path, text in clean.items()})
    done = rospkg(site, "lint", "--jobs", jobs, "--format", "json", cwd=package.parent)
    found = json.loads(done.stdout)["findings"]
    assert {(each["code"], each["package"]) for each in found if each["code"] == "OUR001"} >= {("OUR001", "my_pkg")}
    assert done.returncode == 1
    (package.parent / "rospkg.toml").unlink()
    assert "OUR001" not in rospkg(site, "lint", cwd=package.parent).stdout


def test_they_can_be_ignored_listed_and_explained(package: Path, site: Path) -> None:
    install(site, MODULE.format(code="OUR001"))
    assert rospkg(site, "lint", "--ignore", "our-name", cwd=package).returncode == 0
    assert "OUR001  our-name" in rospkg(site, "rules", cwd=package).stdout
    assert "Wants the names of our house" in rospkg(site, "explain", "OUR001", cwd=package).stdout
    sarif = rospkg(site, "lint", "--format", "sarif", cwd=package)
    assert json.loads(sarif.stdout)["runs"][0]["results"][0]["ruleId"] == "OUR001"


@pytest.mark.parametrize(
    "module, name, says",
    [
        (MODULE.format(code="OUR001"), "our-hose", "there is no plugin `our-house` (did you mean `our-hose`?)"),
        (
            MODULE.format(code="XML104"),
            "our-house",
            "has a rule `XML104`, and that code is that of the built-in rule `placeholder",
        ),
        (MODULE.format(code="our1"), "our-house", "is not three uppercase letters and three digits"),
        (EMPTY, "our-house", "offers no rules"),
        ("import nowhere_at_all\n", "our-house", "can't be loaded: ModuleNotFoundError"),
    ],
)
def test_what_cannot_be_used_is_one_sentence(package: Path, site: Path, module: str, name: str, says: str) -> None:
    install(site, module, name)
    done = rospkg(site, "lint", cwd=package)
    assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1)
    assert says in done.stderr


@pytest.mark.parametrize("of_root", [False, True])
def test_what_lies_in_a_linted_folder_is_not_run(package: Path, tmp_path: Path, site: Path, of_root: bool) -> None:
    place = package if of_root else tmp_path / "deep/down"
    install(place, f"open({str(site / 'ran')!r}, 'w')\n" + MODULE.format(code="OUR001"))
    done = rospkg(place, "lint", str(package), cwd=site if of_root else tmp_path)
    assert (done.returncode, done.stdout, len(done.stderr.splitlines())) == (2, "", 1)
    assert f"`our-house` lies in `{place}`, below `" in done.stderr
    assert (
        "and nothing of what is linted is run: install it where rospkg is installed, or take it out of PYTHONPATH"
        in done.stderr
    )
    assert not (site / "ran").exists()
