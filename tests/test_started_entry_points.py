"""How grave an entry point is that can't start: by who starts it, and a file that is missing: by who brings it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

ON = existing_files(BACKDROPS["ament_python"])
NODE = "def main():\n    print('hello')\n"
STARTS = '<launch>\n  <node pkg="my_pkg" exec="{}"/>\n</launch>\n'
FAULTS = [
    ("SET101", "tuner = my_pkg.gone:main"),
    ("SET102", "tuner = my_pkg.tuner:mian"),
    ("SET103", "tuner = my_pkg.tuner.main"),
]


def found(code: str, files: dict[str, str]) -> Finding:
    (finding,) = lint_files({**ON, "package.xml": manifest(), "my_pkg/__init__.py": "", **files}, [code]).findings
    return finding


@pytest.mark.parametrize("code, entry", FAULTS)
def test_a_program_that_nothing_starts_beside_others(code: str, entry: str) -> None:
    setup = setup_py(scripts("talker = my_pkg.talker:main", entry))
    files = {"setup.py": setup, "my_pkg/talker.py": NODE, "my_pkg/tuner.py": NODE}
    assert found(code, files).severity.value == "error"
    for name, level in (("talker", "warning"), ("tuner", "error"), ("other", "error")):
        finding = found(code, {**files, "launch/a.launch.xml": STARTS.format(name)})
        assert finding.severity.value == level
        assert finding.message.endswith("; nothing here starts it, as others of the package are") is (
            level == "warning"
        )
    named = {"launch/a.launch.xml": STARTS.format("talker"), "README.md": "    ros2 run my_pkg tuner\n"}
    assert found(code, {**files, **named}).severity.value == "error"


LIVE = "Node(package='my_pkg', executable='talker')"
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    {}
    return LaunchDescription([{}])
"""
COMMENTED = "# tuner = Node(\n    #     package='my_pkg',\n    #     executable='tuner',\n    # )"


@pytest.mark.parametrize(
    ("comment", "live", "page", "level"),
    [
        (COMMENTED, LIVE, "- `tuner`: sets the gains.\n", "warning"),
        (COMMENTED.replace("'my_pkg'", "package_name"), LIVE, "- `tuner`: sets the gains.\n", "warning"),
        ("# left = Node(executable='tuner', package='my_pkg')", LIVE, "- `tuner`: sets the gains.\n", "warning"),
        ("", LIVE, "- `tuner`: sets the gains.\n", "error"),
        (COMMENTED, LIVE, "- `tuner`: `ros2 run my_pkg tuner`\n", "error"),
        (COMMENTED, f"{LIVE}, {LIVE.replace('talker', 'tuner')}", "", "error"),
        (COMMENTED, f"{LIVE}, {LIVE.replace(')', ', name=')}'tuner')", "", "error"),
        (COMMENTED.replace("my_pkg", "other_pkg"), LIVE, "- `tuner`: sets the gains.\n", "error"),
        (COMMENTED, "", "- `tuner`: sets the gains.\n", "error"),
    ],
)
def test_a_program_whose_start_is_commented_out(comment: str, live: str, page: str, level: str) -> None:
    setup = setup_py(scripts("talker = my_pkg.talker:main", "tuner = my_pkg.gone:main"))
    files = {"setup.py": setup, "my_pkg/talker.py": NODE, "README.md": page}
    files["launch/a.launch.py"] = LAUNCH.format(comment, live)
    assert found("SET101", files).severity.value == level


LISTED = "The other nodes\n\n- `tuner`\n- `logger`\n\n{}\n"


@pytest.mark.parametrize(
    ("page", "level"),
    [
        (LISTED.format("have not been fully ported yet."), "warning"),
        (LISTED.format("are not yet implemented, and come later."), "warning"),
        (LISTED.format("are started by hand."), "error"),
        (LISTED.format("The rest is not implemented."), "error"),
        (LISTED.format("are not yet implemented.") + "\nRun `tuner` at the start.\n", "error"),
        ("- `tuner`: sets the gains\n- `logger`\n\nare not yet implemented.\n", "error"),
    ],
)
def test_a_list_of_names_is_part_of_the_sentence_around_it(page: str, level: str) -> None:
    setup = setup_py(scripts("talker = my_pkg.talker:main", "tuner = my_pkg.gone:main"))
    files = {"setup.py": setup, "my_pkg/talker.py": NODE, "README.md": page}
    files["launch/a.launch.xml"] = STARTS.format("talker")
    assert found("SET101", files).severity.value == level


def test_an_entry_that_stops_the_build_is_an_error_whoever_starts_it() -> None:
    setup = setup_py(scripts("talker = my_pkg.talker:main", "tuner: my_pkg.tuner:main"))
    files = {"setup.py": setup, "my_pkg/talker.py": NODE, "my_pkg/tuner.py": NODE}
    assert found("SET103", {**files, "launch/a.launch.xml": STARTS.format("talker")}).severity.value == "error"


@pytest.mark.parametrize(
    "page, level",
    [
        ("Download the model:\n\n    wget https://example.org/a.pt -P models/\n", "info"),
        ("The model is models/a.pt.\n", "error"),
    ],
)
def test_a_file_that_a_page_tells_to_fetch(page: str, level: str) -> None:
    entry = "        ('share/' + package_name, ['package.xml']),\n"
    setup = setup_py().replace(entry, f"{entry}        ('share/' + package_name + '/models', ['models/a.pt']),\n")
    finding = found("SET205", {"setup.py": setup, "README.md": page})
    assert finding.severity.value == level
    assert finding.message.endswith("as a page or a script here says") is (level != "error")
