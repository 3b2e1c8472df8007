"""`rospkg new --update`: what users did to a package, and what the templates did since, side by side."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest
from in_process import run_here
from planned import plan

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.fixing.write_all import write_all
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.answers_record import RECORD, read_record, record_text, request_of, tomllib, with_record
from rospkg_cli.scaffold.line_digests import digests
from rospkg_cli.scaffold.merge_dependencies import with_all_dependencies
from rospkg_cli.scaffold.merge_lines import merge_lines
from rospkg_cli.scaffold.plan import Plan, make_plan
from rospkg_cli.scaffold.render import RenderedFile
from rospkg_cli.scaffold.update import UpdatedFile, updates
from rospkg_cli.scaffold.workspace import WorkspacePackages
from rospkg_cli.scaffold.write import write_folder
from rospkg_cli.tree import TreeEntry

NAME = "my_robot_nav"
NODE, SETUP, README, LAUNCH = f"{NAME}/{NAME}_node.py", "setup.py", "README.md", f"launch/{NAME}.launch.py"
DRIVE = "my_robot_drive"
Edits = Mapping[str, Callable[[bytes], bytes | None] | bytes | None]
"""What becomes of a file's bytes: a new text, None where it goes."""


@pytest.fixture(scope="module")
def made() -> Plan:
    return plan()


def swap(old: bytes, new: bytes) -> Callable[[bytes], bytes]:
    def swapped(data: bytes) -> bytes:
        assert old in data
        return data.replace(old, new)

    return swapped


def added(text: bytes) -> Callable[[bytes], bytes]:
    return lambda data: data + text


def edited(content: Mapping[str, bytes], edits: Edits) -> dict[str, bytes]:
    found = dict(content)
    for path, edit in edits.items():
        data = edit(found[path]) if callable(edit) else edit
        if data is None:
            del found[path]
        else:
            found[path] = data
    return found


def planned(made: Plan, edits: Edits) -> Plan:
    """Return what templates write that were changed so, with their record."""
    content = edited({file.path: file.entry.data for file in made.files}, edits)
    modes = {file.path: file.entry.mode for file in made.files}
    files = [RenderedFile(path, TreeEntry("file", data, modes.get(path, 0o644)), "") for path, data in content.items()]
    return with_record(replace(made, files=tuple(files)))


def content(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def update(package: Path, new: Plan, name: str = NAME) -> dict[str, UpdatedFile]:
    """Update a package, and look that a second time changes nothing."""
    found = {each.path: each for each in updates(package, read_record(package), name, new.files)}
    tree = DiskTree(package)
    write_all(package, tree, {path: each.after for path, each in found.items() if each.changes}, tree.fence)
    again = updates(package, read_record(package), name, new.files)
    assert [each.path for each in again if each.changes] == []
    return found


IN_NODE = b"        # mine, with \xc3\xa4 and a blank at the end \n"
TOP, MIDDLE = b"import rclpy\n", b"    def __init__(self) -> None:\n"
TITLE, SECTION = b"# my_robot_nav\n", b"## Nodes\n"
BUILT = b"colcon build --packages-up-to my_robot_nav"

XML = "package.xml"


def depend(name: bytes) -> bytes:
    return b"  <exec_depend>%b</exec_depend>\n" % name


RCLPY = depend(b"rclpy")
HISTORIES: dict[str, tuple[Edits, Edits, dict[str, str]]] = {
    "nothing happened": ({}, {}, {}),
    "only the user edited": ({NODE: swap(MIDDLE, MIDDLE + IN_NODE), README: added(b"More.\n")}, {},
                             {NODE: "kept", README: "kept"}),
    "only the template changed": ({}, {SETUP: added(b"# new\n")}, {SETUP: "updated"}),
    "both, far from each other": ({NODE: added(b"# the end\n")}, {NODE: swap(TOP, TOP + b"import time\n")},
                                  {NODE: "merged"}),
    "both at the same place": ({README: swap(BUILT, BUILT + b" --symlink-install")},
                               {README: swap(BUILT, BUILT + b" --merge-install")}, {README: "conflict"}),
    "both in one way": ({README: swap(TITLE, b"# Navigation\n")}, {README: swap(TITLE, b"# Navigation\n")}, {}),
    "at two places, one of them the same": (
        {README: lambda data: data.replace(BUILT, BUILT + b" -a").replace(SECTION, SECTION + b"\nMine.\n")},
        {README: lambda data: data.replace(BUILT, BUILT + b" -b") + b"Theirs.\n"}, {README: "conflict"}),
    "a file that the user removed has changed": ({README: None}, {README: added(b"x\n")}, {README: "skipped"}),
    "a file that the user removed is as it was": ({LAUNCH: None}, {}, {LAUNCH: "skipped"}),
    "a file is new": ({}, {"doc/new.md": b"New.\n"}, {"doc/new.md": "created"}),
    "a file is new that the user has": ({"doc/new.md": b"New.\n"}, {"doc/new.md": b"New.\n"}, {}),
    "a file is new that the user has otherwise": ({"doc/new.md": b"New.\nMine.\n"}, {"doc/new.md": b"New.\nTheirs.\n"},
                                                  {"doc/new.md": "conflict"}),
    "a file is no longer written": ({}, {LAUNCH: None}, {LAUNCH: "removed"}),
    "a file is no longer written that the user edited": (
        {LAUNCH: added(b"# mine\n")}, {LAUNCH: None}, {LAUNCH: "kept"}),
    "a file is no longer written that the user removed": ({LAUNCH: None}, {LAUNCH: None}, {}),
    "line ends of Windows": ({NODE: lambda data: data.replace(b"\n", b"\r\n") + b"# mine\r\n"},
                             {NODE: swap(TOP, TOP + b"import time\n")}, {NODE: "merged"}),
    "line ends of Windows and nothing else": ({NODE: swap(b"\n", b"\r\n")}, {NODE: swap(TOP, TOP + b"import time\n")},
                                              {NODE: "updated"}),
    "no line feed at the end": ({README: lambda data: data.rstrip()}, {README: swap(TITLE, b"# Robot\n")},
                                {README: "merged"}),
    "a file that the user emptied": ({README: b""}, {README: swap(TITLE, b"# Robot\n")}, {README: "conflict"}),
    "bytes that are no text": ({README: b"\x00\x01\xff"}, {README: added(b"x\n")}, {README: "skipped"}),
    "all lines indented anew": ({NODE: swap(b"    ", b"  ")}, {NODE: swap(MIDDLE, MIDDLE + b"        # new\n")},
                                {NODE: "conflict"}),
    "lines moved": ({SETUP: lambda data: b"".join(sorted(data.splitlines(keepends=True)))}, {SETUP: added(b"# new\n")},
                    {SETUP: "conflict"}),
    "files of the user's own": ({"notes.txt": b"mine", f"{NAME}/more.py": b"x = 1\n"}, {SETUP: added(b"# new\n")},
                                {SETUP: "updated"}),
    "a node that the user renamed": (
        {NODE: None, f"{NAME}/nav.py": IN_NODE, SETUP: swap(b".my_robot_nav_node:main", b".nav:main")},
        {NODE: swap(TOP, TOP + b"import time\n"), SETUP: added(b"# new\n")}, {NODE: "skipped", SETUP: "merged"}),
    "a text that the user renamed": ({README: None, "README.rst": b"Mine.\n"}, {README: added(b"x\n")},
                                     {README: "skipped"}),
    "line ends of Windows in a conflict": (
        {README: lambda data: data.replace(BUILT, BUILT + b" -a").replace(b"\n", b"\r\n")},
        {README: swap(BUILT, BUILT + b" -b")}, {README: "conflict"}),
    "a conflict that the user resolved": (
        {README: swap(BUILT, BUILT + b" -a -b")}, {README: added(b"x\n")}, {README: "merged"}),
    "dependencies of both at one place": (
        {XML: swap(RCLPY, RCLPY + depend(b"sensor_msgs"))},
        {XML: swap(RCLPY, depend(b"nav_msgs") + RCLPY + depend(b"rclpz"))},
        {XML: "merged"}),
    "a dependency instead of another": (
        {XML: swap(RCLPY, depend(b"rclcpp"))}, {XML: swap(RCLPY, RCLPY + depend(b"rosbag2"))}, {XML: "merged"}),
    "a dependency and something else": (
        {XML: swap(RCLPY, RCLPY + b"  <!-- mine -->\n")}, {XML: swap(RCLPY, RCLPY + depend(b"rosbag2"))},
        {XML: "conflict"}),
    "a merge that was left as it was": (
        {README: b"<<<<<<< yours\na\n=======\nb\n>>>>>>> rospkg\n"}, {SETUP: added(b"# new\n")},
        {SETUP: "updated", README: "kept"}),
}  # fmt: skip


@pytest.mark.parametrize("history", HISTORIES)
def test_what_the_user_wrote_survives(made: Plan, tmp_path: Path, history: str) -> None:
    mine, theirs, expected = HISTORIES[history]
    package = tmp_path / NAME
    write_folder(package, with_record(made).files)
    written = content(package)
    yours = edited(written, mine)
    for path in {*written, *yours}:
        (package / path).parent.mkdir(parents=True, exist_ok=True)
        (package / path).write_bytes(yours[path]) if path in yours else (package / path).unlink()
    new = planned(made, theirs)
    found = update(package, new)
    told = {path: each.status for path, each in found.items() if each.status != "identical" and path != RECORD}
    assert told == expected
    after = content(package)
    for path, data in yours.items():
        own = set(data.split(b"\n")) - set(written.get(path, b"").split(b"\n"))
        assert own <= set(after.get(path, b"").split(b"\n"))
        assert after.get(path) == data or path == RECORD or told.get(path) not in (None, "kept", "skipped")
    assert {path for path in yours if b"\r" in yours[path]} == {path for path in after if b"\r" in after[path]}
    for file in new.files:
        if told.get(file.path) in ("updated", "created", None) and file.path in after:
            assert after[file.path].replace(b"\r\n", b"\n") == file.entry.data


@pytest.fixture
def package(made: Plan, tmp_path: Path) -> Path:
    write_folder(tmp_path / NAME, with_record(made).files)
    return tmp_path / NAME


def test_an_unmarked_place_is_in_conflict_as_git_shows_it(made: Plan, package: Path) -> None:
    (package / README).write_bytes(swap(BUILT, BUILT + b" -a")((package / README).read_bytes()))
    update(package, planned(made, {README: swap(BUILT, BUILT + b" -b")}))
    both = b"<<<<<<< yours\n%b -a\n=======\n%b -b\n>>>>>>> rospkg\n" % (BUILT, BUILT)
    assert both in (package / README).read_bytes()


def test_dependencies_of_both_are_in_their_order_and_what_one_side_removed_stays_away() -> None:
    lines = {name: depend(name.encode()) for name in "abcdefg"}
    base, yours, new = (b"".join(lines[name] for name in names) for names in ("bd", "acd", "bdeg"))
    merged = merge_lines(yours.replace(b"\n", b"\r\n"), digests(base), new)
    assert merged is not None
    assert (merged.conflicts, re.findall(rb">(\w)<", merged.data)) == (0, [b"a", b"c", b"d", b"e", b"g"])


def test_a_group_of_dependencies_that_one_side_has_stays_with_its_blank_line() -> None:
    side, other = depend(b"mine") + b"\n", b"  <x/>\n"
    text = b"<<<<<<< yours\n%b=======\n%b>>>>>>> rospkg\n"
    assert with_all_dependencies(text % (side, b""), b"") == (side, 1)
    assert with_all_dependencies(text % (b"", side), b"a\n") == (side, 1)
    assert with_all_dependencies(text % (side, b""), side) == (b"\n", 1)
    for unlike in ((side, depend(b"other")), (other, b""), (b"", other), (side + other, b"")):
        assert with_all_dependencies(text % unlike, b"") == (text % unlike, 0)


def test_modes_and_links_stay_the_users(made: Plan, package: Path) -> None:
    (package / SETUP).chmod(0o755)
    (package / README).rename(package.parent / README)
    (package / README).symlink_to(f"../{README}")
    found = update(package, planned(made, {SETUP: added(b"# new\n"), README: added(b"new\n")}))
    assert (found[SETUP].status, found[README].status, found[README].about) == ("updated", "skipped", "it is a link")
    assert (package / SETUP).stat().st_mode & 0o111 == 0o111
    assert b"new" not in (package.parent / README).read_bytes()


@pytest.fixture
def renamed(package: Path) -> Path:
    """The package after `rospkg rename`, which leaves the launch file its name."""
    node = package / NODE
    node.write_bytes(node.read_bytes() + IN_NODE)
    done = run_here("rename", NAME, "my_robot_drive", "--allow-dirty", cwd=package.parent)
    assert done.returncode == 0, done.stderr
    [manifest] = package.parent.glob("*/package.xml")
    return manifest.parent


def test_a_package_that_was_renamed_gets_what_is_new_and_keeps_what_it_has(renamed: Path) -> None:
    new = with_record(plan("my_robot_drive", nodes=(f"{NAME}_node", "extra:timer"), tests="ament", launch="py"))
    found = update(renamed, new, "my_robot_drive")
    assert [path for path, each in found.items() if each.status == "conflict"] == []
    node, launch = found[f"my_robot_drive/{NAME}_node.py"], found["launch/my_robot_drive.launch.py"]
    assert (node.status, found["setup.py"].status) == ("kept", "updated")
    assert (launch.status, launch.about) == ("created", f"it was `{LAUNCH}`")
    assert found[LAUNCH].status == "removed"
    assert (renamed / f"my_robot_drive/{NAME}_node.py").read_bytes().endswith(IN_NODE)
    assert {path for path in content(renamed) if path != RECORD} == {f.path for f in new.files} - {RECORD}
    left = {path for path, data in content(renamed).items() if re.search(rb"\bmy_robot_nav\b", data)}
    assert left == set()


def test_a_launch_file_that_moves_takes_what_the_user_wrote_with_it(renamed: Path) -> None:
    (renamed / LAUNCH).write_bytes((renamed / LAUNCH).read_bytes() + b"# mine\n")
    update(renamed, with_record(plan("my_robot_drive", nodes=(f"{NAME}_node",))), "my_robot_drive")
    assert (renamed / "launch/my_robot_drive.launch.py").read_bytes().endswith(b"# mine\n")
    assert not (renamed / LAUNCH).exists()


def test_a_launch_file_that_is_as_it_would_be_only_moves_and_a_link_stays(renamed: Path) -> None:
    new = with_record(plan("my_robot_drive", nodes=(f"{NAME}_node",)))
    [launch] = [file for file in new.files if file.path.startswith("launch/")]
    (renamed / LAUNCH).write_bytes(launch.entry.data)
    (renamed / LAUNCH).rename(renamed.parent / "shared.py")
    (renamed / LAUNCH).symlink_to(renamed.parent / "shared.py")
    found = {each.path: each for each in updates(renamed, read_record(renamed), DRIVE, new.files)}
    assert (found[launch.path].status, LAUNCH in found) == ("skipped", False)
    (renamed / LAUNCH).unlink()
    (renamed / LAUNCH).write_bytes(launch.entry.data)
    found = update(renamed, new, DRIVE)
    assert (found[launch.path].status, found[LAUNCH].status) == ("created", "removed")
    assert (renamed / launch.path).read_bytes() == launch.entry.data


def test_a_record_says_what_was_asked_for(package: Path) -> None:
    request = read_record(package).request
    assert (request.name, request.nodes, request.year, request.launch) == (NAME, (f"{NAME}_node",), 2026, "py")
    assert with_record(plan(minimal=True)) == plan(minimal=True)
    assert plan(template="interfaces").asked.msgs == ("Status",)
    assert plan(template="interfaces", srvs=("Go",)).asked.msgs == ()
    assert plan(template="interfaces").asked.launch == ""


def lines_of(made: Plan) -> dict[str, tuple[str, ...]]:
    return {file.path: digests(file.entry.data) for file in made.files}


@pytest.mark.parametrize("template", ["mixed", "interfaces", "plugin", "bringup"])
def test_what_is_recorded_asks_for_the_same_again(template: str) -> None:
    """Where defaults follow from the type of package; a plan that asks for all of it writes the same files."""
    made = plan("my_pkg", template=template, description='Says "ä"', depends=("sensor_msgs",))
    read = request_of(tomllib.loads(record_text(made.asked, lines_of(made)))["answers"])
    assert read == made.asked
    assert make_plan(read, Path(), {"license": "MIT", "launch": "xml"}, WorkspacePackages()).files == made.files


def test_digests_are_numbers_which_no_speller_reads(made: Plan) -> None:
    lines = record_text(made.asked, lines_of(made)).partition("[lines]\n")[2].splitlines()
    assert all(re.fullmatch(r'(\d{7}( |$))+|"[^"]+" = """|"""', line) for line in lines if line)
    assert max(map(len, lines)) < 100


ADA = ("--maintainer", "Ada", "--email", "ada@example.org", "--distro", "jazzy")


def test_more_answers_are_added_and_others_take_the_place(tmp_path: Path) -> None:
    asked = ("new", "my_pkg", "--node", "talker:publisher", *ADA, "--tests", "none")
    assert run_here(*asked, cwd=tmp_path).returncode == 0
    main = tmp_path / "my_pkg/my_pkg/talker.py"
    main.write_text(main.read_text() + "# mine\n")
    again = ("new", "--update", "my_pkg", "--node", "extra:timer", "--license", "MIT")
    before = content(tmp_path)
    shown = run_here(*again, "--dry-run", cwd=tmp_path)
    assert (shown.returncode, shown.stdout.endswith("\nNothing was written.\n")) == (0, True)
    diff = run_here(*again, "--diff", cwd=tmp_path)
    assert diff.returncode == 1
    assert "+            'extra = my_pkg.extra:main',\n" in diff.stdout
    assert content(tmp_path) == before
    done = run_here(*again, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert "created    my_pkg/extra.py\n" in done.stdout
    assert "merged     my_pkg/talker.py\n" in done.stdout
    assert main.read_text().endswith("# mine\n")
    assert "MIT" in (tmp_path / "my_pkg/package.xml").read_text()
    assert "'talker = my_pkg.talker:main'" in (tmp_path / "my_pkg/setup.py").read_text()
    assert run_here("lint", "my_pkg", "--pedantic", "--release", cwd=tmp_path).returncode == 0
    twice = run_here("new", "--update", "my_pkg", cwd=tmp_path)
    assert (twice.returncode, twice.stdout) == (0, "")
    assert twice.stderr == "rospkg: nothing is to be done: it is as it would be written today\n"


def test_a_conflict_is_marked_and_listed(package: Path) -> None:
    manifest = package / "package.xml"
    manifest.write_text(manifest.read_text().replace("Apache-2.0", "Zlib"))
    done = run_here("new", "--update", package, "--license", "MIT", "--dry-run", cwd=package)
    assert (done.returncode, done.stderr) == (1, "")
    done = run_here("new", "--update", ".", "--license", "MIT", cwd=package)
    assert done.returncode == 1
    assert "conflict   package.xml   1 place with `<<<<<<<`\n" in done.stdout
    assert "1 file has conflicts, marked as git does; edit `package.xml`" in done.stderr


def test_without_a_record_there_is_no_update(tmp_path: Path) -> None:
    assert run_here("new", "my_pkg", "--no-record", *ADA, cwd=tmp_path).returncode == 0
    assert not (tmp_path / "my_pkg" / RECORD).exists()
    done = run_here("new", "--update", "my_pkg", cwd=tmp_path)
    assert done.returncode == 2
    assert f"has no `{RECORD}`" in done.stderr
    assert "it has no package.xml" in run_here("new", "--update", ".", cwd=tmp_path).stderr


BROKEN = {
    '[answers]\nyear = "2026"\n[lines]\n': "`year` is not what it should be",
    "[answers]\nnodes = [1]\n[lines]\n": "`nodes` holds more than texts",
    "[answers]\ncolour = 'red'\n[lines]\n": "`colour` is no answer that this version knows",
    "[answers]\n": "lacks the key 'lines'",
    "[answers": "is not as it was written",
    "[answers]\n[lines]\na = 1\n": "is not as it was written",
    "answers = 1\nlines = 1\n": "is not as it was written",
    "[answers]\ntests = 'none'\n[lines]\n'../notes.txt' = ''\n": "no path inside of the package",
    "[answers]\n[lines]\n\"a\\u0000b\" = ''\n": "is no path; take it from git",
    '[answers]\nmaintainer = "a\\nb\\u0007"\n[lines]\n': "holds U+0007",
    "[answers]\nnodes = ['../x']\n[lines]\n": "is a node of another package",
    "[answers]\nown_template = 'https://example.org/x.git'\n[lines]\n": "name it, if you trust it: --template https",
    "[answers]\ntemplate = 'rocket'\n[lines]\n": "there is no type of package `rocket`",
}


@pytest.mark.parametrize("text", BROKEN)
def test_a_record_that_is_wrong_is_refused_in_a_sentence(package: Path, text: str) -> None:
    (package.parent / "notes.txt").write_text("mine")
    (package / RECORD).write_text(text)
    before = content(package.parent)
    done = run_here("new", "--update", package, cwd=package)
    assert (done.returncode, done.stdout) == (2, "")
    assert BROKEN[text] in done.stderr
    assert done.stderr.count("\n") == 1
    assert content(package.parent) == before


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (("other_name",), "leave `other_name` out"),
        (("--force",), "leave --force, --skip"),
        (("--minimal",), "leave --force, --skip"),
        (("--type", "mixed"), "can't make another type of a package; it is `ament_python`"),
    ],
)
def test_what_does_not_go_with_it_is_said(package: Path, words: tuple[str, ...], why: str) -> None:
    done = run_here("new", "--update", package, *words, cwd=package)
    assert done.returncode == 2
    assert why in done.stderr


def test_git_is_needed_only_where_both_sides_changed(
    made: Plan, package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    (package / LAUNCH).write_bytes((package / LAUNCH).read_bytes() + b"# mine\n")
    new = planned(made, {SETUP: added(b"# new\n"), README: added(b"new\n")})
    (package / SETUP).write_bytes(b"# mine\n" + (package / SETUP).read_bytes())
    with pytest.raises(ScaffoldError, match="git is not installed"):
        update(package, new)
    (package / SETUP).write_bytes((package / SETUP).read_bytes().removeprefix(b"# mine\n"))
    assert update(package, new)[README].status == "updated"


def test_what_was_left_out_comes_back_and_what_was_added_goes(tmp_path: Path) -> None:
    asked = ("my_pkg", "--params", "none", "--with", "ci,pre-commit", "--launch", "none", "--tests", "none")
    assert run_here("new", *asked, *ADA, cwd=tmp_path).returncode == 0
    package, values, hook = tmp_path / "my_pkg", "config/params.yaml", ".pre-commit-config.yaml"
    assert (package / hook).is_file()

    def updated(*words: str) -> tuple[bool, ...]:
        done = run_here("new", "--update", "my_pkg", *words, cwd=tmp_path)
        assert (done.returncode, done.stderr) == (0, "")
        return tuple((package / path).is_file() for path in (values, hook, "launch/my_pkg.launch.py"))

    assert updated("--params", "file", "--with", "none,pre-commit", "--launch", "py") == (True, True, True)
    assert not (package / ".github/workflows/ci.yaml").exists()
    assert updated("--params", "none", "--with", "none", "--launch", "none") == (False, False, False)
    assert updated("--params", "generate") == (True, False, False)
    assert (package / "my_pkg/my_pkg_node_parameters.yaml").is_file()
    assert run_here("lint", "my_pkg", "--pedantic", cwd=tmp_path).returncode == 0


def test_a_workspace_is_updated_too(tmp_path: Path) -> None:
    asked = ("my_ws", "--type", "workspace", "--distro", "jazzy", "--with", "none")
    assert run_here("new", *asked, cwd=tmp_path).returncode == 0
    root = tmp_path / "my_ws"
    assert read_record(root).request.distro == "jazzy"
    (root / "README.md").write_text((root / "README.md").read_text() + "Mine.\n")
    (root / "src/.gitkeep").unlink()
    assert run_here("new", "src/arm", *ADA, "--tests", "none", cwd=root).returncode == 0
    before = content(root / "src")
    done = run_here("new", "--update", ".", "--distro", "lyrical", "--with", "ci", cwd=root)
    assert (done.returncode, done.stderr) == (0, "")
    assert re.search(r"^created +\.github/workflows/ci\.yaml$", done.stdout, re.MULTILINE)
    assert re.search(r"^merged +README\.md$", done.stdout, re.MULTILINE)
    assert (root / "README.md").read_text().endswith("Mine.\n")
    assert 'target = ["lyrical"]' in (root / "rospkg.toml").read_text()
    assert content(root / "src") == before
    assert "nothing is to be done" in run_here("new", "--update", ".", cwd=root).stderr
    refused = run_here("new", "--update", "my_ws", "--node", "talker", cwd=tmp_path)
    assert (refused.returncode, "a workspace has no nodes" in refused.stderr) == (2, True)
    assert "nor the `.rospkg-answers.toml` of a workspace" in run_here("new", "--update", "src", cwd=root).stderr
