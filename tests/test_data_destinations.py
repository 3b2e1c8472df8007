"""SET208: files in a place where nothing is searched are loud where something looks for them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, setup_py
from rospkg_cli.testing import lint_files

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
PACKAGE = existing_files(BACKDROPS["ament_python"])
OPENS = "path = os.path.join(get_package_share_directory('my_pkg'), {})\n"
PLUGIN = manifest().replace("  <export>", '  <export>\n    <rqt_gui plugin="${prefix}/a.xml"/>')


def told(entries: str, files: dict[str, str]) -> list[str]:
    lines = "".join(f"        {each},\n" for each in entries.split(";"))
    found = lint_files({**PACKAGE, "setup.py": setup_py().replace(ENTRY, ENTRY + lines), **files}, ["SET208"]).findings
    return [f"{each.severity.value}: {each.message.rpartition('; ')[2]}" for each in found]


@pytest.mark.parametrize(
    ("path", "code", "level"),
    [
        ("config/a.yaml", "", "info"),
        ("config/a.yaml", OPENS.format("'config', 'a.yaml'"), "warning"),
        ("config/a.yaml", OPENS.format("'config', name"), "warning"),
        ("config/a.yaml", OPENS.format("'config', 'b.yaml'"), "info"),
        ("config/a.yaml", "# " + OPENS.format("'config', 'a.yaml'"), "info"),
        ("config/a.yaml", OPENS.replace("my_pkg", "your_pkg").format("'config', 'a.yaml'"), "info"),
        ("launch/a.launch.py", "", "warning"),
        ("launch/start.py", "", "warning"),
    ],
)
def test_who_looks_for_the_files(path: str, code: str, level: str) -> None:
    files = {path: PACKAGE.get(path, "a: 1\n"), "my_pkg/talker.py": code}
    (found,) = told(f"('share/your_pkg/x', ['{path}'])", files)
    assert found.startswith(level)


def test_the_manifest_is_looked_for() -> None:
    text = setup_py().replace(ENTRY, ENTRY.replace("share", "shared"))
    (found,) = lint_files({**PACKAGE, "setup.py": text}, ["SET208"]).findings
    assert found.severity.value == "warning"


def test_why_it_is_an_info() -> None:
    files = {"launch/a.launch.py": "A = 1\n", "config/a.yaml": "a: 1\n"}
    twice = "('launch', ['launch/a.launch.py']);('share/my_pkg/launch', ['launch/a.launch.py'])"
    assert told(twice, files) == ["info: another entry installs its files where they are looked for"]
    assert told("('config', ['config/a.yaml'])", files) == ["info: nothing here opens its files there"]


def test_a_description_of_plugins_that_package_xml_names() -> None:
    (found,) = told("('share/your_pkg', ['a.xml'])", {"a.xml": "<library/>\n", "package.xml": PLUGIN})
    assert found.startswith("warning")
