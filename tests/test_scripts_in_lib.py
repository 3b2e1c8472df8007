"""Executables of which `data_files` installs a script of the same name into lib/<package> (SET001, SET002)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_CFG, SETUP_PY, manifest
from rospkg_cli.testing import lint_files

NODE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n"
SCRIPT = "#!/usr/bin/env python3\nfrom my_pkg.talker import main\n\nmain()\n"
ENTRIES = "    entry_points={'console_scripts': ['talker = my_pkg.talker:main', 'other = my_pkg.other:main']},\n"
ONE = ENTRIES.replace(", 'other = my_pkg.other:main'", "")
INSTALLED = "('lib/' + package_name, ['scripts/talker']),"


def told(entries: str, installed: str, cfg: str | None, script: str = SCRIPT) -> list[tuple[str, str]]:
    setup = SETUP_PY.replace("    license=", f"{entries}    license=").replace(
        "data_files=[", f"data_files=[\n        {installed}"
    )
    files = {
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "setup.py": setup,
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": NODE,
        "my_pkg/other.py": NODE,
        "scripts/talker": script,
    }
    if cfg is not None:
        files["setup.cfg"] = cfg
    found = lint_files(files, ["SET001", "SET002"]).findings
    return [(each.code, each.message.partition(":")[2].partition(" goes")[0].strip(" `")) for each in found]


@pytest.mark.parametrize(
    ("entries", "installed", "named"),
    [
        (ONE, INSTALLED, []),
        (ENTRIES, INSTALLED, ["other"]),
        (ONE, "", ["talker"]),
        (ONE, "('lib/another', ['scripts/talker']),", ["talker"]),
        (ONE, "('bin', ['scripts/talker']),", ["talker"]),
        (ONE, "('share/' + package_name, ['scripts/talker']),", ["talker"]),
    ],
)
def test_a_script_in_lib_is_found_without_setup_cfg(entries: str, installed: str, named: list[str]) -> None:
    assert told(entries, installed, None) == [("SET001", each) for each in named]


def test_a_script_that_may_not_be_executed_is_not_found() -> None:
    assert told(ONE, INSTALLED, None, SCRIPT.partition("\n")[2]) == [("SET001", "talker")]


@pytest.mark.parametrize(
    "cfg", [SETUP_CFG.replace("lib/my_pkg", "lib/old_pkg"), "[develop]\nscript_dir=$base/lib/my_pkg\n"]
)
def test_a_script_in_lib_is_found_beside_a_wrong_setup_cfg(cfg: str) -> None:
    assert told(ONE, INSTALLED, cfg) == []
    assert {code for code, _ in told(ENTRIES, INSTALLED, cfg)} == {"SET002"}
    assert {code for code, _ in told(ONE, "", cfg)} == {"SET002"}
