"""setup.cfg: the values of configparser, with the place of each."""

from __future__ import annotations

import configparser

import pytest
from hypothesis import given
from hypothesis import strategies as st
from reading import one, package

from rospkg_cli.checks.read_sentences import what_is_wrong
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.package.setup.parse_setup_cfg import OPTION, parse_setup_cfg
from rospkg_cli.package.setup.setup_cfg import SetupCfg
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files
from rospkg_cli.unreadable import UnreadableError

TEXT = """\
# a comment
[develop]
script_dir=$base/lib/my_pkg
[install]
install-scripts : $base/lib/my_pkg   
[options]
packages =
    my_pkg
    # not this
    my_pkg.sub

    other
empty =
"""  # noqa: W291 - blanks at the end are part of the case


def read(text: str) -> SetupCfg:
    return one({"setup.cfg": text}, SetupCfg)


def test_every_part_has_its_place() -> None:
    cfg = read(TEXT)
    shown = [
        (section.name, cfg.source.slice(section.span), option.key, cfg.source.slice(option.key_span), option.value.text)
        for section in cfg.sections.values()
        for option in section.options.values()
    ]
    assert shown == [
        ("develop", "[develop]", "script_dir", "script_dir", "$base/lib/my_pkg"),
        ("install", "[install]", "install-scripts", "install-scripts", "$base/lib/my_pkg"),
        ("options", "[options]", "packages", "packages", "my_pkg\n    # not this\n    my_pkg.sub\n\n    other"),
        ("options", "[options]", "empty", "empty", ""),
    ]
    packages = cfg.get("options", "packages")
    assert packages is not None
    assert [line.text for line in packages.value.lines()] == ["my_pkg", "my_pkg.sub", "other"]
    assert [cfg.source.slice(line.shown) for line in packages.value.lines()] == ["my_pkg", "my_pkg.sub", "other"]
    assert cfg.get("install", "install_scripts") is cfg.sections["install"].options["install-scripts"]


CASES = ["[a]", "[b]", "x = 1", "y: 2", "  more", "\tmore", "z=", "", "# c", "  ; c", "w", "q = a = b", "X=3"]
LINES = st.lists(
    st.sampled_from(
        ["[a]", "[b]", "x = 1", "y: 2", "  more", "\tmore", "z=", "", "# c", "  ; c", "w", "q = a = b", "X=3"]
    ),
    max_size=9,
)


@given(LINES)
def test_it_reads_what_configparser_reads(lines: list[str]) -> None:
    text = "\n".join(lines)
    parser = configparser.RawConfigParser()
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    try:
        parser.read_string(text)
    except configparser.Error:
        assert package({"setup.cfg": text}).parts(SetupCfg).broken
        return
    theirs = {s: {k: squeezed(v or "") for k, v in parser.items(s)} for s in parser.sections()}
    sections = read(text).sections.values()
    ours = {s.name: {o.key: squeezed(o.value.text) for o in s.options.values()} for s in sections}
    assert ours == theirs


def squeezed(value: str) -> str:
    lines = [line.strip() for line in value.splitlines()]
    return "\n".join(line for line in lines if line and not line.startswith(("#", ";")))


@pytest.mark.parametrize(
    "text, at, why",
    [
        ("x = 1\n", "x = 1", "before the first"),
        ("[a]\nx = 1\nx = 2\n", "x = 2", "twice"),
        ("[a]\n[b]\n[a]\n", "[a]", "twice"),
        ("[a]\nnothing here\n", "nothing here", "neither"),
    ],
)
def test_what_configparser_refuses(text: str, at: str, why: str) -> None:
    (broken,) = package({"setup.cfg": text}).parts(SetupCfg).broken
    assert text[broken.span.start : broken.span.end] == at
    assert why in what_is_wrong(broken)


def test_an_option_is_found_in_one_pass() -> None:
    found = OPTION.match(f"a{' ' * 100_000}b")
    assert found is not None
    assert len(found["key"]) == 100_002


@pytest.mark.parametrize(
    ("text", "key", "value"),
    [("a b = c: d", "a b", "c: d"), ("a", "a", None), ("a  :", "a", ""), ("= b", "", "b"), ("a=b", "a", "b")],
)
def test_an_option_ends_at_its_first_sign(text: str, key: str, value: str | None) -> None:
    found = OPTION.match(text)
    assert found is not None
    assert (found["key"], found["value"]) == (key, value)


def test_a_file_that_is_too_long_is_skipped_and_that_is_said() -> None:
    with pytest.raises(UnreadableError) as caught:
        parse_setup_cfg(Source("setup.cfg", "[a]\n" + "b\n" * 100_000))
    assert caught.value.unreadable.skipped
    assert "200,000 characters" in what_is_wrong(caught.value.unreadable)


INSTALLS = "find_package(ament_cmake_python REQUIRED)\nament_python_install_package(my_pkg)\n"


@pytest.mark.parametrize(("lines", "count"), [("", 0), (INSTALLS, 1)])
def test_cmake_runs_setuptools_for_its_python_packages_alone(lines: str, count: int) -> None:
    cmake = CMAKE.replace("ament_package", f"{lines}ament_package")
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": cmake,
        "setup.cfg": "[develop]\nscript-dir=a\n",
    }
    assert len(lint_files({**files, "my_pkg/__init__.py": ""}, ["SET003"]).findings) == count
