"""Lines and files that nobody misses: a leftover of rqt, the name of a license, interfaces that no code takes."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
TAKES = "from my_pkg.msg import Status\n\n\ndef main():\n    print(Status)\n"
NODE = "def main():\n    print('hello')\n"
GUI = "from rqt_gui_py.plugin import Plugin\n\n\nclass Panel(Plugin):\n    pass\n"


def found(code: str, **files: str) -> Finding:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    (finding,) = lint_files({**PYTHON, "my_pkg/__init__.py": "", **named}, [code]).findings
    return finding


@pytest.mark.parametrize(
    "path, starts, level",
    [
        ("my_pkg/talker.py", "talker", "error"),
        ("my_pkg/other.py", "talker", "info"),
        ("test/test_talker.py", "talker", "info"),
        ("old/talker.py", "talker", "info"),
    ],
)
def test_interfaces_that_code_takes_which_is_run(path: str, starts: str, level: str) -> None:
    files = {"my_pkg/talker.py": NODE, "msg/Status.msg": "int32 a\n", path: TAKES}
    setup = setup_py(scripts(f"{starts} = my_pkg.{starts}:main"))
    assert found("IDL008", **files, **{"setup.py": setup}).severity.value == level


@pytest.mark.parametrize("text", ["MIT, BSD", "See the LICENSE file"])
def test_a_license_is_read_by_who_releases(text: str) -> None:
    lost = {"package.xml": manifest().replace("<license>Apache-2.0", f"<license>{text}")}
    assert found("XML106", **lost).severity.value == "info"
    assert found("XML106", **lost, **{"tracks.yaml": "tracks: {}\n"}).severity.value == "warning"


def test_a_description_of_rqt_that_no_code_needs() -> None:
    lost = {"package.xml": manifest().replace("  </export>", '    <rqt_gui plugin="${prefix}/gone.xml"/>\n  </export>')}
    assert found("XML306", **lost).message.endswith("; no code here is a plugin of rqt")
    assert found("XML306", **lost).severity.value == "info"
    assert found("XML306", **lost, **{"my_pkg/panel.py": GUI}).severity.value == "error"
    assert found("XML306", **lost, **{"gone1.xml": "<library path='x'/>\n"}).severity.value == "error"
