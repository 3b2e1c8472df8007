"""What nobody is shown to start, to open or to release is an info, and a warning where somebody is."""

from __future__ import annotations

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.finding import Finding
from rospkg_cli.rules.manifest import xml107_missing_license_file as xml107
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
NATIVE = existing_files(BACKDROPS["ament_cmake"])
NAMED = "install(PROGRAMS scripts/talker.py scripts/tune.py DESTINATION lib/${PROJECT_NAME})\nament_package"
FOUND = "file(GLOB found scripts/*.py)\ninstall(PROGRAMS ${found} DESTINATION lib/${PROJECT_NAME})\nament_package"
SCRIPT = "#!/usr/bin/env python3\nimport {}\n"
STARTS = '<launch>\n  <node pkg="my_pkg" exec="{}"/>\n</launch>\n'
ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
GLOB = "        ('share/' + package_name + '/config', glob('config/*.yaml')),\n"
OPENS = "x = get_package_share_directory('my_pkg') + '/config/tree.xml'\n"


def found(code: str, on: dict[str, str], files: dict[str, str]) -> Finding:
    (finding,) = lint_files({**on, **files}, [code]).findings
    return finding


def test_a_script_that_nothing_starts_beside_others() -> None:
    scripts = {"scripts/talker.py": SCRIPT.format("sys"), "scripts/tune.py": SCRIPT.format("scipy")}
    files = {**scripts, "CMakeLists.txt": CMAKE.replace("ament_package", FOUND)}
    for starts, level in (("talker.py", "info"), ("tune.py", "warning"), ("other.py", "warning")):
        finding = found("DEP101", NATIVE, {**files, "launch/a.launch.xml": STARTS.format(starts)})
        assert finding.severity.value == level
        assert ("nothing here starts this script" in finding.message) == (level == "info")
    named = {**files, "CMakeLists.txt": CMAKE.replace("ament_package", NAMED)}
    starts = {"launch/a.launch.xml": STARTS.format("talker.py")}
    assert found("DEP101", NATIVE, {**named, **starts}).severity.value == "warning"


def test_a_script_for_ros_1_that_nothing_starts_beside_others() -> None:
    scripts = {"scripts/talker.py": SCRIPT.format("sys"), "scripts/tune.py": SCRIPT.format("rospy")}
    files = {**scripts, "CMakeLists.txt": CMAKE.replace("ament_package", FOUND)}
    for starts, level in (("talker.py", "info"), ("tune.py", "warning"), ("other.py", "warning")):
        assert found("DEP101", NATIVE, {**files, "launch/a.launch.xml": STARTS.format(starts)}).severity.value == level


def test_the_file_that_something_opens_is_the_one_that_is_told() -> None:
    setup = "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + GLOB)
    config = {"config/a.yaml": "a: 1\n", "config/b.json": "{}\n", "config/tree.xml": "<root/>\n"}
    finding = found("SET207", PYTHON, {"setup.py": setup, **config, "my_pkg/a.py": OPENS})
    assert finding.severity.value == "warning"
    assert finding.message.startswith("`config/tree.xml` and 1 more")
    assert found("SET207", PYTHON, {"setup.py": setup, **config}).severity.value == "info"


def test_a_copy_of_a_launch_file_is_set_aside() -> None:
    needs = {"package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n")}
    launch = '<launch>\n  <node pkg="rviz2" exec="rviz2"/>\n</launch>\n'
    for name, level in (("a.launch.xml", "warning"), ("a.launch copy.xml", "info"), ("a copy 2.launch.xml", "info")):
        setup = "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + GLOB.replace("config/*.yaml", "launch/*"))
        assert found("DEP103", PYTHON, {**needs, "setup.py": setup, f"launch/{name}": launch}).severity.value == level


def test_a_license_text_is_missed_by_who_releases() -> None:
    lost = {"package.xml": xml107.GOOD.replace('"LICENSE"', '"LICENCE"')}
    assert found("XML107", PYTHON, lost).severity.value == "info"
    assert found("XML107", PYTHON, {**lost, "tracks.yaml": "tracks: {}\n"}).severity.value == "error"


def test_a_package_that_is_left_out_and_nothing_started_imports() -> None:
    """A module in the way may be imported in a function; one that no entry point leads to shows no harm."""
    setup = setup_py(scripts("talker = my_pkg.talker:main")).replace(
        "find_packages(exclude=['test'])", "[package_name]"
    )
    uses, inner = (
        "from my_pkg.speech import words\n",
        {"my_pkg/speech/__init__.py": "", "my_pkg/speech/words.py": "A = 1\n"},
    )
    main = "def main():\n    {}\n"
    for talker, level in (
        (uses + main.format("words.A"), "error"),
        (main.format("from my_pkg import middle"), "warning"),
        (main.format("pass"), "info"),
    ):
        files = {"setup.py": setup, **inner, "my_pkg/talker.py": talker, "my_pkg/middle.py": uses}
        assert found("SET302", PYTHON, files).severity.value == level
        without = {path: text for path, text in files.items() if path != "my_pkg/speech/__init__.py"}
        assert (
            found(
                "SET301", PYTHON, {**without, "setup.py": setup.replace("[package_name]", "find_packages()")}
            ).severity.value
            == level
        )


def test_a_tool_beside_the_programs() -> None:
    setup, code = setup_py(scripts("talker = my_pkg.talker:main")), "import scipy\n\nprint(scipy)\n"
    page = {"README.md": "Run `python3 benchmarks/speed.py`.\n", "setup.py": setup}
    main = {"my_pkg/talker.py": "def main():\n    pass\n"}
    for folder, level in (("benchmarks", "info"), ("my_pkg/benchmarking", "info"), ("signals", "warning")):
        files = {**page, **main, f"{folder}/__init__.py": "", f"{folder}/speed.py": code}
        files["README.md"] = page["README.md"].replace("benchmarks", folder)
        assert found("DEP101", PYTHON, files).severity.value == level
    used = {"my_pkg/talker.py": "from my_pkg.tools import speed\n\n\ndef main():\n    print(speed)\n"}
    files = {**page, **used, "my_pkg/tools/__init__.py": "", "my_pkg/tools/speed.py": code}
    assert found("DEP101", PYTHON, files).severity.value == "warning"
