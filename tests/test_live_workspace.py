"""The packages of an editor's workspace between the first run and the one that has judged them all."""

from __future__ import annotations

from pathlib import Path

from rospkg_cli.cli.server.live_workspace import LiveWorkspace
from rospkg_cli.example import Example
from rospkg_cli.lookup.definition import definitions
from rospkg_cli.lookup.mention import mention_at

MANIFEST = Example(bad={}, good={}).bad_files()["package.xml"]


def test_a_neighbour_is_found_before_it_is_linted(tmp_path: Path) -> None:
    using = MANIFEST.replace("<export>", "<depend>my_other</depend><export>")
    for name, text in (("my_pkg", using), ("my_other", MANIFEST.replace("my_pkg", "my_other"))):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(text)
    live = LiveWorkspace(tmp_path, wanted={tmp_path / "my_pkg"})
    live.put(tmp_path / "my_pkg/package.xml", using.encode())
    live.lint()
    assert not live.is_finished
    world = live.world()
    assert world
    mention = mention_at(world.package("my_pkg"), "package.xml", using.index("my_other"))
    assert mention
    assert [each.path for each in definitions(world, "my_pkg", mention)] == ["my_other/package.xml"]
