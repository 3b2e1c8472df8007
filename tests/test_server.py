"""`rospkg server`: an editor opens packages, types, and sees findings come and go."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from editor import Editor, applied
from in_process import run_here
from lsprotocol import types
from writing import Write

DEPENDENCY = "  <exec_depend>rclpy</exec_depend>\n"

MESSAGES = {
    "package.xml": """\
<?xml version="1.0"?>
<package format="3">
  <name>my_msgs</name>
  <version>1.0.0</version>
  <description>The messages of my robot</description>
  <maintainer email="ada@example.org">Ada Lovelace</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
""",
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.10)
project(my_msgs)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Status.msg" "msg/Robot.msg")
ament_export_dependencies(rosidl_default_runtime)
ament_package()
""",
    "msg/Status.msg": "float32 battery\n",
    "msg/Robot.msg": "Status status\n",
}

CMAKE = """\
cmake_minimum_required(VERSION 3.10)
project({})
find_package(ament_cmake REQUIRED)
if(BUILD_TESTING)
  ament_add_gtest(test_it test/test_it.cpp)
endif()
ament_package()
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("editor")


@pytest.fixture(scope="module")
def editor(folder: Path) -> Iterator[Editor]:
    """One server for all tests of this module; each has packages of its own."""
    (folder / "src").mkdir()
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "LANG") if name in os.environ}
    found = Editor(folder, **kept, XDG_CACHE_HOME=os.devnull, XDG_CONFIG_HOME=os.devnull)
    yield found
    found.quit()


@pytest.fixture
def package(folder: Path, write: Write, clean: dict[str, str], request: pytest.FixtureRequest) -> Path:
    """A faultless package with the name of the test."""
    name = request.node.name.removeprefix("test_")[:40].rstrip("_")
    files = {path.replace("my_pkg", name): text.replace("my_pkg", name) for path, text in clean.items()}
    return write(folder / "src" / name, files)


def edits_of(action: types.CodeAction) -> Any:
    """Return the edits of an action that changes one file."""
    assert action.edit is not None
    [change] = action.edit.document_changes or ()
    return getattr(change, "edits", ())


def test_findings_come_and_go_with_what_is_typed(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    text = path.read_text()
    editor.open(path)
    editor.type(path, text.replace("Apache-2.0", "TODO"))
    editor.until(lambda: editor.codes(path) == ["XML104"])
    [found] = editor.diagnostics[path]
    assert (found.source, found.severity) == ("rospkg", 2)
    assert found.message.startswith("the license is `TODO`")
    editor.type(path, text)
    editor.until(lambda: editor.codes(path) == [])


def test_closing_without_saving_gives_the_file_back(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    editor.open(path)
    editor.type(path, path.read_text().replace("Apache-2.0", "TODO"))
    editor.until(lambda: editor.codes(path) == ["XML104"])
    editor.close(path)
    editor.until(lambda: editor.codes(path) == [])


def test_what_changes_on_disk_counts(editor: Editor, package: Path) -> None:
    assert [each.method for each in editor.watched] == ["workspace/didChangeWatchedFiles"]
    path = package / "package.xml"
    text = path.read_text()
    path.write_text(text.replace("Apache-2.0", "TODO"))
    editor.wrote(path)
    editor.until(lambda: editor.codes(path) == ["XML104"])
    path.write_text(text)
    editor.wrote(path)
    editor.until(lambda: editor.codes(path) == [])


def test_a_package_outside_of_the_folders_is_linted_too(editor: Editor, tmp_path: Path, write: Write) -> None:
    write(tmp_path / "other/my_pkg", {"package.xml": "<package/>"})
    editor.open(tmp_path / "other/my_pkg/package.xml")
    editor.until(lambda: "XML001" in editor.codes(tmp_path / "other/my_pkg/package.xml"))


def test_the_same_as_lint_of_the_saved_text(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    text = path.read_text().replace("Apache-2.0", "TODO").replace("ada@example.org", "ada")
    editor.open(path)
    editor.type(path, text)
    editor.until(lambda: len(editor.codes(path)) > 1)
    path.write_text(text)
    lines = run_here("lint", package, "--format", "concise", cwd=package).stdout.splitlines()
    shown = [f"{d.range.start.line + 1}:{d.range.start.character + 1}" for d in editor.diagnostics[path]]
    assert shown == [":".join(line.split(":")[1:3]) for line in lines if line.startswith("package.xml")]
    assert all(any(d.message in line for line in lines) for d in editor.diagnostics[path])


def test_a_neighbour_goes_red(editor: Editor, folder: Path, write: Write) -> None:
    """Not the package that is edited, but the one that uses its message, has the finding."""
    messages = write(folder / "src/my_msgs", MESSAGES)
    user = {name: text.replace("my_msgs", "my_more_msgs") for name, text in MESSAGES.items()}
    user["msg/Robot.msg"] = "my_msgs/Status status\n"
    user["package.xml"] = user["package.xml"].replace("  <exec", "  <depend>my_msgs</depend>\n  <exec", 1)
    user["CMakeLists.txt"] = user["CMakeLists.txt"].replace('msg/Robot.msg")', 'msg/Robot.msg" DEPENDENCIES my_msgs)')
    user["CMakeLists.txt"] = user["CMakeLists.txt"].replace(
        "rosidl_gen", "find_package(my_msgs REQUIRED)\nrosidl_gen", 1
    )
    write(folder / "src/my_more_msgs", user)
    cmake, uses = messages / "CMakeLists.txt", folder / "src/my_more_msgs/msg/Robot.msg"
    editor.open(cmake)
    editor.type(cmake, MESSAGES["CMakeLists.txt"].replace('"msg/Status.msg" ', ""))
    editor.until(lambda: editor.codes(messages / "msg/Status.msg") == ["IDL005"])
    (messages / "msg/Status.msg").rename(messages / "msg/State.msg")
    editor.type(cmake, MESSAGES["CMakeLists.txt"].replace("Status", "State"))
    editor.until(lambda: editor.codes(uses) == ["IDL004"])


def test_a_fix_is_one_action(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    text = path.read_text().replace("  <export>", f"{DEPENDENCY}{DEPENDENCY}  <export>", 1)
    editor.open(path)
    editor.type(path, text)
    editor.until(lambda: bool(editor.codes(path)))
    fix = next(each for each in editor.actions(path) if each.edit and each.is_preferred)
    after = applied(text, edits_of(fix))
    assert after == text.replace(DEPENDENCY, "", 1)
    editor.type(path, after)
    editor.until(lambda: "XML201" not in editor.codes(path))


def test_actions_are_those_of_the_line(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    text = path.read_text().replace("Apache-2.0", "TODO")
    editor.open(path)
    editor.type(path, text)
    editor.until(lambda: editor.codes(path) == ["XML104"])
    line = text.split("\n").index("  <license>TODO</license>")
    titles = [each.title for each in editor.actions(path, line, line)]
    assert titles == ["Ignore XML104 with a reason"]
    assert editor.actions(path, line + 1, line + 1) == []


def test_all_fixes_are_offered_where_one_is_made(editor: Editor, package: Path) -> None:
    """What is declared twice is an error for the one tag, and an info, which is left alone, for the other."""
    path = package / "package.xml"
    text = path.read_text()
    editor.open(path)
    for tag, are_fixed in (("depend", True), ("exec_depend", False)):
        editor.type(path, text.replace("  <export>", f"  <{tag}>rclpy</{tag}>\n" * 2 + "  <export>"))
        editor.settle()
        assert "XML201" in editor.codes(path)
        assert ("source.fixAll.rospkg" in [each.kind for each in editor.actions(path)]) is are_fixed


def test_what_no_fix_declares_is_declared_by_an_action(editor: Editor, package: Path, write: Write) -> None:
    """A command for tests whose package is neither found nor declared: where it is to be found, no fix can know."""
    write(package, {"CMakeLists.txt": CMAKE.format(package.name), "test/test_it.cpp": ""})
    (package / "setup.py").unlink()
    path = package / "package.xml"
    text = path.read_text().replace(">ament_python<", ">ament_cmake<")
    text = text.replace("  <export>", "  <buildtool_depend>ament_cmake</buildtool_depend>\n  <export>")
    path.write_text(text)
    editor.wrote(path, package / "CMakeLists.txt", package / "setup.py")
    editor.open(package / "CMakeLists.txt")
    declare = next(each for each in editor.actions(package / "CMakeLists.txt") if each.title.startswith("declare"))
    assert declare.title == "declare `ament_cmake_gtest` as <test_depend> (DEP104)"
    assert applied(text, edits_of(declare)) == text.replace(
        "  <export>", "  <test_depend>ament_cmake_gtest</test_depend>\n  <export>"
    )


def test_folders_come_and_go(editor: Editor, folder: Path, package: Path, tmp_path: Path, write: Write) -> None:
    """One elsewhere, and one inside of another, which takes over the files in it."""
    write(tmp_path / "elsewhere/my_pkg", {"package.xml": "<package/>"})
    path, other = package / "package.xml", tmp_path / "elsewhere/my_pkg/package.xml"
    editor.open(path)
    editor.type(path, path.read_text().replace("Apache-2.0", "TODO"))
    editor.change_folders(added=[tmp_path / "elsewhere", package])
    editor.until(lambda: "XML001" in editor.codes(other))
    editor.settle()
    assert editor.codes(path) == ["XML104"]
    editor.change_folders(removed=[tmp_path / "elsewhere", package])
    editor.until(lambda: editor.codes(other) == [])
    editor.settle()
    assert editor.codes(path) == ["XML104"]


def test_an_ignore_comment_is_written_above_the_line(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    text = path.read_text().replace("Apache-2.0", "TODO")
    editor.open(path)
    editor.type(path, text)
    editor.until(lambda: editor.codes(path) == ["XML104"])
    ignore = next(each for each in editor.actions(path) if each.title.startswith("Ignore"))
    after = applied(text, edits_of(ignore))
    assert "  <!-- rospkg: ignore[XML104] say here why -->\n  <license>TODO" in after
    editor.type(path, after)
    editor.until(lambda: editor.codes(path) == [])


def test_all_fixes_of_a_package(editor: Editor, package: Path) -> None:
    """Those that change other files too; the module is nowhere but in the editor."""
    (package / ".git").mkdir()  # a repository of its own: what another package of it declares is an info
    module = package / package.name / "talker.py"
    module.touch()
    editor.open(module)
    editor.type(module, "import rclpy\n\nrclpy.init()\n")
    editor.until(lambda: editor.codes(module) == ["DEP101"])
    every = next(each for each in editor.actions(module) if str(each.kind).startswith("source.fixAll"))
    assert every.edit is None
    resolved = editor.run(editor.client.code_action_resolve_async(every))
    manifest = (package / "package.xml").read_text()
    assert applied(manifest, edits_of(resolved)) == manifest.replace("  <export>", f"{DEPENDENCY}  <export>")


def test_columns_count_utf_16_units(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    text = path.read_text().replace("<description>Drives my robot", "<!-- 🤖🤖 --><description>TODO", 1)
    editor.open(path)
    editor.type(path, text)
    editor.until(lambda: bool(editor.codes(path)))
    at = editor.diagnostics[path][0].range
    line = text.split("\n")[at.start.line].encode("utf-16-le")
    assert line[2 * at.start.character : 2 * at.end.character].decode("utf-16-le") == "TODO"


def test_definition_hover_completion_and_format(editor: Editor, package: Path) -> None:
    path = package / "package.xml"
    other = f"  <depend>{package.name}</depend>\n  <buildtool_depend>ament_lint</buildtool_depend>\n"
    text = path.read_text().replace("  <export>", f"{other}  <export>")
    editor.open(path)
    editor.type(path, text)
    line = text.split("\n").index(f"  <depend>{package.name}</depend>")
    at = {"text_document": types.TextDocumentIdentifier(path.as_uri()), "position": types.Position(line, 12)}
    client = editor.client
    editor.until(lambda: bool(editor.codes(path)))
    [place] = editor.run(client.text_document_definition_async(types.DefinitionParams(**at))) or ()
    assert (place.uri, place.range.start.line) == (path.as_uri(), 3)
    told = editor.run(client.text_document_hover_async(types.HoverParams(**at)))
    assert told
    assert told.contents.value.startswith(f"**{package.name}** 1.0.0, in this workspace")
    offered = editor.run(client.text_document_completion_async(types.CompletionParams(**at)))
    assert offered
    assert package.name in [each.label for each in offered.items]
    options = types.FormattingOptions(tab_size=2, insert_spaces=True)
    asked = types.DocumentFormattingParams(at["text_document"], options)
    edits = editor.run(client.text_document_formatting_async(asked))
    assert applied(text, edits).index("ament_lint") < applied(text, edits).index(f"<depend>{package.name}")


def test_a_wrong_config_is_a_message_and_nothing_ends(editor: Editor, folder: Path, package: Path) -> None:
    config, path = folder / "rospkg.toml", package / "package.xml"
    config.write_text("selct = []\n")
    editor.open(path)
    editor.until(lambda: told(editor, "there is no key `selct`") == 1)
    config.unlink()
    editor.type(path, path.read_text().replace("Apache-2.0", "TODO"))
    editor.until(lambda: editor.codes(path) == ["XML104"])
    config.write_text("selct = []\n")
    editor.wrote(config)
    editor.until(lambda: told(editor, "there is no key `selct`") == 2)
    config.unlink()
    editor.wrote(config)
    editor.settle()


def told(editor: Editor, part: str) -> int:
    return sum(part in each for each in editor.messages)


def test_without_pygls_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("rospkg_cli.cli.server.run.find_spec", lambda _: None)
    done = run_here("server", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (
        2,
        "rospkg: rospkg server needs pygls: pip install 'rospkg-cli[server]'\n",
    )
