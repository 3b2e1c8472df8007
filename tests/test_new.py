"""`rospkg new`: what it says, what it refuses and why, and that it writes all or nothing."""

from __future__ import annotations

import errno
import os
import re
import subprocess
from pathlib import Path

import pytest

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.new.run import new
from rospkg_cli.config.schema import ConfigError
from rospkg_cli.scaffold import write as writing
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.names import check_node_name, check_package_name, repaired
from rospkg_cli.scaffold.resolve_request import distro_of
from rospkg_cli.scaffold.target_folder import workspace_of

ADA = {"maintainer": "Ada Lovelace", "email": "ada@example.org", "year": 2026, "distro": "lyrical"}


@pytest.fixture(autouse=True)
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty home, in which git knows nobody; the working directory is beside it."""
    home = tmp_path / "home"
    home.mkdir()
    for name in [n for n in os.environ if n.startswith(("GIT_", "XDG_"))]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("HOME", str(home))
    monkeypatch.setenv("GIT_CONFIG_NOSYSTEM", "1")
    monkeypatch.setenv("LOGNAME", "ada")
    (tmp_path / "work").mkdir()
    monkeypatch.chdir(tmp_path / "work")
    return home


def everything(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*")}


def test_it_ends_with_the_tree_and_three_commands(capsys: pytest.CaptureFixture[str]) -> None:
    assert new(Request("my_robot_nav", **ADA)) == 0
    said = capsys.readouterr()
    assert said.err == ""
    tree, _, commands = said.out.partition("\n\n")
    assert tree.startswith("my_robot_nav/\n├── config/\n")
    assert {line.split()[-1] for line in commands.splitlines()} > {"my_robot_nav.launch.py", "install/setup.bash"}
    assert len(commands.splitlines()) == 4
    for path in everything(Path("my_robot_nav")):
        assert path.rpartition("/")[2] in tree


def test_modes_are_those_of_any_other_file() -> None:
    mask = os.umask(0o027)
    try:
        new(Request("my_robot_nav", **ADA))
    finally:
        os.umask(mask)
    assert Path("my_robot_nav").stat().st_mode & 0o777 == 0o750
    assert Path("my_robot_nav/setup.py").stat().st_mode & 0o777 == 0o640


def test_the_same_request_writes_the_same_bytes() -> None:
    for folder in ("one", "two"):
        new(Request("my_robot_nav", **ADA), Path(folder))
    compared = subprocess.run(["diff", "-r", "one", "two"], capture_output=True, check=False)
    assert compared.returncode == 0, compared.stdout


def test_a_dry_run_shows_every_file_and_writes_none(capsys: pytest.CaptureFixture[str]) -> None:
    assert new(Request("my_robot_nav", **ADA), Path("src"), dry_run=True) == 0
    said = capsys.readouterr().out
    assert everything(Path()) == set()
    new(Request("my_robot_nav", **ADA), Path("src"))
    for path in Path("src/my_robot_nav").rglob("*"):
        if path.is_file():
            assert f"── my_robot_nav/{path.relative_to('src/my_robot_nav').as_posix()}" in said
            assert path.read_text().removesuffix("\n") in said


REFUSED = {
    "My-Package": "try `my_package`", "2fast": "try `my_2fast`", "a": "try `my_a`", "trailing_": "try `trailing`",
    "a__b": "try `a_b`", "": "two or more", "naïve": "try `naive`", "class": "try `my_class`", "import": "Python",
    "template": "C\\+\\+", "test": "Python itself", "json": "Python itself", "distutils": "Python itself",
    "numpy": "taken", "std_msgs": "taken", "config": "taken", "x" * 61: "61 characters", "a b": "try `a_b`",
    "Straße": "try `strasse`", "RobótArm": "try `robot_arm`", "机器人": "two or more", "机器人2": "try `my_2`",
    "../up": "try `up`", "a/b": "try `a_b`", "name\n": "try `name`",
}  # fmt: skip


@pytest.mark.parametrize("name, reason", REFUSED.items())
def test_a_bad_name_is_refused_with_the_reason(name: str, reason: str) -> None:
    with pytest.raises(UsageError, match=reason) as raised:
        new(Request(name, **ADA))
    assert "\n" not in str(raised.value).replace(name, "")
    assert everything(Path()) == set()


def test_what_is_offered_instead_of_a_name_is_a_good_one() -> None:
    for name in REFUSED:
        better = repaired(name)
        if better not in ("", name):
            check_package_name(better)


@pytest.mark.parametrize("name", ["my_robot_nav", "Talker", "lambda", "-x", "talker:lifecicle", "greeting", "__init__"])
def test_a_bad_node_is_refused(name: str) -> None:
    with pytest.raises(UsageError, match=r"node|keyword"):
        new(Request("my_robot_nav", nodes=(name,), **ADA))
    assert everything(Path()) == set()


LANGUAGES = {
    ("ament_python", ("a_node:cpp",)): "no nodes in C\\+\\+; --type ament_cmake or mixed",
    ("ament_cmake", ("a_node:python",)): "no nodes in Python; --type ament_python or mixed",
    ("mixed", ("a_node:component:python",)): "component nodes are available in C\\+\\+ only",
    ("mixed", ("a_node",)): "--type ament_cmake is for; .*--node NAME:python",
    ("mixed", ("a_node:python",)): "--type ament_python is for; .*--node NAME:cpp",
    ("ament_python", ("demo_nodes_cpp/talker",)): "--type bringup starts such ones",
    ("mixed", ("a_node:timer:empty",)): "NAME:KIND:LANGUAGE",
    ("mixed", ("a_node:cpp:python",)): "NAME:KIND:LANGUAGE",
    ("ament_python", ("a_node:component",)): "component can be written only in C\\+\\+",
}


@pytest.mark.parametrize("template, nodes", LANGUAGES)
def test_a_language_that_does_not_fit_is_refused(template: str, nodes: tuple[str, ...]) -> None:
    with pytest.raises(UsageError, match=LANGUAGES[template, nodes]):
        new(Request("my_robot_nav", template=template, nodes=nodes, **ADA))


def test_nodes_may_have_names_that_packages_may_not() -> None:
    check_node_name("statistics", "my_robot_nav")


BAD = {
    "template": ("ament_pyton", "did you mean `ament_python`"),
    "license": ("Apache-3.0", "Apache-2.0"),
    "email": ("root@localhost", "e-mail"),
    "version": ("1.0", "0.1.0"),
    "distro": ("jazy", "did you mean `jazzy`"),
    "depends": (("a b",), "rosdep key"),
    "description": ("a\x00b", "U\\+0000"),
}


@pytest.mark.parametrize("option, value, reason", [(k, *v) for k, v in BAD.items()])
def test_a_bad_option_is_refused_with_the_reason(option: str, value: object, reason: str) -> None:
    with pytest.raises(UsageError, match=reason):
        new(Request("my_robot_nav", **{**ADA, option: value}))
    assert everything(Path()) == set()


@pytest.mark.parametrize("key, reason", [("my_robot_nav", "itself"), ("ament_python", "build type")])
def test_a_dependency_that_makes_no_sense_is_refused(key: str, reason: str) -> None:
    with pytest.raises(UsageError, match=reason):
        new(Request("my_robot_nav", depends=(key,), **ADA))


WRONG = {
    ("std_msgs", "opencv-python"): "is its name on PyPI.* write `--depends std_msgs,python3-opencv`",
    ("nav2_utill",): "no known ROS package .* write `--depends nav2_util`",
    ("json", "numpy"): "write `--depends python3-numpy`",
    ("json",): "comes with Python itself: .*; leave --depends out",
}


@pytest.mark.parametrize("depends", WRONG)
def test_a_key_that_is_certainly_wrong_is_refused_with_the_right_option(depends: tuple[str, ...]) -> None:
    with pytest.raises(UsageError, match=WRONG[depends]):
        new(Request("my_robot_nav", depends=depends, **ADA))
    assert everything(Path()) == set()


@pytest.mark.parametrize(
    "make", [Path.touch, lambda path: path.symlink_to("nowhere"), lambda path: path.symlink_to(".")]
)
def test_what_exists_is_left_alone(make) -> None:
    make(Path("my_robot_nav"))
    with pytest.raises(UsageError, match=r"exists already.*--diff"):
        new(Request("my_robot_nav", **ADA))
    assert everything(Path()) == {"my_robot_nav"}


def test_a_package_is_not_written_into_another() -> None:
    new(Request("outer_pkg", **ADA))
    before = everything(Path())
    with pytest.raises(UsageError, match=f"--into {Path.cwd()}"):
        new(Request("inner_pkg", **ADA), Path("outer_pkg/launch"))
    assert everything(Path()) == before


def test_a_file_is_no_folder_to_write_into() -> None:
    Path("file").touch()
    with pytest.raises(UsageError, match="is a file"):
        new(Request("my_robot_nav", **ADA), Path("file/below"))


def test_a_marker_that_hides_the_package_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    Path("COLCON_IGNORE").touch()
    assert new(Request("my_robot_nav", **ADA), Path("src")) == 0
    assert "COLCON_IGNORE` hides what lies below" in capsys.readouterr().err


@pytest.mark.parametrize("fault", [KeyboardInterrupt(), OSError(errno.ENOSPC, "No space left on device")])
def test_an_interrupted_write_leaves_nothing(fault: BaseException, monkeypatch: pytest.MonkeyPatch) -> None:
    real, count = writing.write, iter(range(100))

    def sometimes(path: Path, file) -> None:
        if next(count) == 7:
            raise fault
        real(path, file)

    monkeypatch.setattr(writing, "write", sometimes)
    with pytest.raises((KeyboardInterrupt, UsageError)) as raised:
        new(Request("my_robot_nav", **ADA), Path("ws/src"))
    assert everything(Path()) == set()
    if isinstance(fault, OSError):
        assert "No space left on device" in str(raised.value)


def test_a_folder_that_appears_meanwhile_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    real = writing.write

    def other(path: Path, file) -> None:
        Path("my_robot_nav").mkdir(exist_ok=True)
        real(path, file)

    monkeypatch.setattr(writing, "write", other)
    with pytest.raises(UsageError, match="exists already"):
        new(Request("my_robot_nav", **ADA))
    assert everything(Path()) == {"my_robot_nav"}


def test_without_git_and_home_the_login_maintains(capsys: pytest.CaptureFixture[str], monkeypatch) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    assert new(Request("my_robot_nav")) == 0
    said = capsys.readouterr().err
    assert len(said.splitlines()) == 1
    found = re.search(r"using (ada@[a-z0-9-]+\.local).*package.xml line (\d+) and setup.py line (\d+)", said)
    assert found
    address, line = found.group(1), int(found.group(2))
    manifest = Path("my_robot_nav/package.xml").read_text().splitlines()
    assert manifest[line - 1].strip() == f'<maintainer email="{address}">ada</maintainer>'


def test_git_says_who_maintains(home: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (home / ".gitconfig").write_text("[user]\n\tname = Grace Hopper\n\temail = grace@example.org\n")
    assert new(Request("my_robot_nav")) == 0
    assert capsys.readouterr().err == ""
    assert '<maintainer email="grace@example.org">Grace Hopper</maintainer>' in manifest_of("my_robot_nav")


def test_an_address_of_git_that_package_xml_cannot_hold_is_not_taken(home: Path, capsys) -> None:
    (home / ".gitconfig").write_text("[user]\n\tname = root\n\temail = root@localhost\n")
    assert new(Request("my_robot_nav")) == 0
    assert "ada@" in capsys.readouterr().err
    assert "root@localhost" not in manifest_of("my_robot_nav")


def test_the_config_says_what_nobody_typed(home: Path) -> None:
    own = home / ".config" / "rospkg" / "config.toml"
    own.parent.mkdir(parents=True)
    own.write_text('[new]\nmaintainer = "Ada"\nemail = "ada@example.org"\nlicense = "MIT"\n')
    Path("rospkg.toml").write_text('[new]\nlicense = "BSD-3-Clause"\n')
    new(Request("my_robot_nav", version="2.0.0"))
    written = manifest_of("my_robot_nav")
    assert '<maintainer email="ada@example.org">Ada</maintainer>' in written
    assert "<license>BSD-3-Clause</license>" in written
    assert "<version>2.0.0</version>" in written


def test_a_wrong_key_of_the_config_is_named() -> None:
    Path("rospkg.toml").write_text('[new]\nlicence = "MIT"\n')
    with pytest.raises(ConfigError, match=r"rospkg.toml:2:1: .*`licence` \(did you mean `license`\?\)"):
        new(Request("my_robot_nav", **ADA))


def manifest_of(name: str) -> str:
    return Path(name, "package.xml").read_text()


def test_the_distribution_comes_from_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    for sourced, chosen in (("humble", "humble"), ("jazzy", "jazzy"), ("iron", "lyrical"), ("", "lyrical")):
        monkeypatch.setenv("ROS_DISTRO", sourced)
        notes: list[str] = []
        assert distro_of("", notes).name == chosen
        assert bool(notes) == (sourced == "iron")
        assert distro_of("kilted", notes).name == "kilted"


def test_a_released_name_and_an_unknown_header_are_mentioned(capsys: pytest.CaptureFixture[str]) -> None:
    assert new(Request("turtlesim", license="GPL-3.0-only", **ADA)) == 0
    said = capsys.readouterr().err
    assert "ROS has a released package `turtlesim`" in said
    assert "ament_copyright knows no header for GPL-3.0-only" in said
    assert "test_copyright.py" not in everything(Path("turtlesim/test"))
    assert "ament_copyright" not in manifest_of("turtlesim")


def test_what_our_linter_says_of_the_request_is_passed_on(capsys: pytest.CaptureFixture[str]) -> None:
    assert new(Request("my_robot_nav", description="TODO", **ADA)) == 0
    assert re.search(
        r"^rospkg: my_robot_nav/package.xml:6: .*TODO.* \(XML104\)$", capsys.readouterr().err, re.MULTILINE
    )


@pytest.mark.parametrize(
    "into, workspace", [("ws/src", "ws"), ("ws/src/group", "ws"), ("ws", "ws"), ("src/ws/src", "src/ws"), (".", ".")]
)
def test_commands_start_where_colcon_does(into: str, workspace: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert workspace_of(Path(into)) == Path.cwd() / workspace
    new(Request("my_robot_nav", **ADA), Path(into))
    said = capsys.readouterr().out
    assert ("\nNext:\n" if workspace == "." else f"\nNext, in {Path.cwd() / workspace}:\n") in said
