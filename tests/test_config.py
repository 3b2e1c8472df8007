"""The config file: where it is found, what it does, and what is said of a wrong one."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_process import run_here as rospkg

from rospkg_cli.config.file import find_config
from rospkg_cli.config.schema import ConfigError


@pytest.fixture
def package(tmp_path, write, clean) -> Path:
    text = clean["package.xml"].replace("Apache-2.0", "TODO")
    return write(tmp_path / "ws" / "my_pkg", {**clean, "package.xml": text})


def test_the_nearest_wins_and_rospkg_toml_before_pyproject(tmp_path: Path) -> None:
    inner = tmp_path / "a" / "b"
    inner.mkdir(parents=True)
    (tmp_path / "rospkg.toml").write_text('select = ["XML"]')
    (tmp_path / "a" / "pyproject.toml").write_text("[tool.black]\nline-length = 99\n")
    assert find_config(inner).select == ("XML",)
    (tmp_path / "a" / "pyproject.toml").write_text('[tool.rospkg]\nselect = ["SET"]\n')
    assert find_config(inner).select == ("SET",)
    (tmp_path / "a" / "rospkg.toml").write_text('select = ["DEP"]\n')
    assert find_config(inner).select == ("DEP",)


def test_ignore_with_a_reason(package: Path) -> None:
    (package.parent / "rospkg.toml").write_text('[ignore]\nXML104 = "the text will come"\n')
    done = rospkg("lint", cwd=package.parent)
    assert done.returncode == 0
    assert "1 ignored" in done.stdout


@pytest.mark.parametrize(
    "section, status",
    [
        ('[per-package."my_*".ignore]\nXML104 = "x"', 0),
        ('[per-package."other".ignore]\nXML104 = "x"', 1),
        ('[per-path."my_pkg/*.xml".ignore]\nXML104 = "x"', 0),
        ('[per-path."src".ignore]\nXML104 = "x"', 1),
        ('[severity]\nXML104 = "info"', 0),
        ('[severity]\nXML = "off"', 0),
        ('fail-on = "error"', 0),
        ('exclude = ["my_pkg"]', 2),
        ('select = ["RPK"]', 0),
    ],
)
def test_what_the_keys_do(package: Path, section: str, status: int) -> None:
    (package.parent / "rospkg.toml").write_text(section + "\n")
    assert rospkg("lint", cwd=package.parent).returncode == status


@pytest.mark.parametrize(
    "text, place, says",
    [
        ('\nselct = ["XML"]', "2:1", "there is no key `selct` (did you mean `select`?)"),
        ("select = 'XML'", "1:1", "`select` must be a list of strings"),
        ('ignore = ["XML104"]', "1:1", "must give a reason"),
        ('[ignore]\nXML104 = ""', "1:1", "must give a reason"),
        ('target = ["jazy"]', "1:1", "did you mean `jazzy`?"),
        ('[per-path.x]\nignores = { XML104 = "x" }', "2:1", "there is no key `ignores`"),
        ('fail-on = "errors"', "1:1", "must be one of error, warning, info"),
        ("pedantic = 1", "1:1", "must be true or false"),
        ("select = [", "", "not valid TOML"),
    ],
)
def test_a_wrong_one_is_one_sentence_with_its_place(tmp_path: Path, text: str, place: str, says: str) -> None:
    (tmp_path / "rospkg.toml").write_text(text)
    with pytest.raises(ConfigError) as caught:
        find_config(tmp_path)
    assert says in str(caught.value)
    assert f"rospkg.toml:{place}" in str(caught.value)


def test_misspelt_and_needless_names_are_findings(package: Path) -> None:
    (package.parent / "rospkg.toml").write_text('[ignore]\nXML1O4 = "typing error"\nRPK001 = "nothing is broken"\n')
    done = rospkg("lint", "--format", "concise", cwd=package.parent)
    found = [line.split(": ", 1) for line in done.stdout.splitlines()]
    assert [place for place, _ in found if "rospkg.toml" in place] == ["rospkg.toml:2:1", "rospkg.toml:3:1"]
    assert "RPK003" in done.stdout
    assert "RPK002" in done.stdout


def test_a_needless_name_is_shown_where_it_stands_among_others(package: Path) -> None:
    (package.parent / "rospkg.toml").write_text('ignore = { XML104 = "soon", RPK001 = "never" }\n')
    done = rospkg("lint", "--format", "concise", cwd=package.parent)
    assert [line.split(": ")[0] for line in done.stdout.splitlines() if "RPK002" in line] == ["rospkg.toml:1:29"]


@pytest.mark.parametrize(
    "before, after",
    [
        ('[ignore]\nRPK001 = "never"  # so\nXML104 = "soon"\n', '[ignore]\nXML104 = "soon"\n'),
        ('ignore = { RPK001 = "never", XML104 = "soon" }\n', 'ignore = { XML104 = "soon" }\n'),
        ('ignore = { XML104 = "soon", RPK001 = "ne, ver" }\n', 'ignore = { XML104 = "soon" }\n'),
        ('ignore.XML104 = "soon"\nignore.RPK001 = "never"\n', 'ignore.XML104 = "soon"\n'),
        (
            'ignore.XML104 = "soon"\n[per-path."my_pkg/*".ignore]\n"RPK001" = "never"\n[new]\nemail = "a@b.c"\n',
            'ignore.XML104 = "soon"\n[per-path."my_pkg/*".ignore]\n[new]\nemail = "a@b.c"\n',
        ),
    ],
)
def test_fix_takes_out_an_ignore_that_nothing_needs(package: Path, before: str, after: str) -> None:
    config = package.parent / "rospkg.toml"
    config.write_text(before)
    assert "RPK002" in rospkg("lint", cwd=package.parent).stdout
    done = rospkg("lint", "--fix", cwd=package.parent)
    assert (done.returncode, config.read_text()) == (0, after)


def test_what_one_section_needs_is_needless_in_another(package: Path) -> None:
    text = '[per-package."my_*".ignore]\nXML104 = "soon"\n[per-path."src".ignore]\nXML104 = "soon"\n'
    (package.parent / "rospkg.toml").write_text(text)
    done = rospkg("lint", "--format", "concise", cwd=package.parent)
    assert [line.split(" ")[0] for line in done.stdout.splitlines()] == ["rospkg.toml:4:1:"]


def test_in_pyproject_too(package: Path) -> None:
    config = package.parent / "pyproject.toml"
    config.write_text('[tool.black]\n[tool.rospkg.ignore]\nRPK001 = "never"\nXML104 = "soon"\n')
    assert rospkg("lint", "--fix", cwd=package.parent).returncode == 0
    assert config.read_text() == '[tool.black]\n[tool.rospkg.ignore]\nXML104 = "soon"\n'
