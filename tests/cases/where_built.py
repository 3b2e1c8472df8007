"""Python packages that are not installed: what a build with links reaches, what entry points import as they start."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, SETUP_CFG, Example, manifest, scripts, setup_py
from rospkg_cli.rules.setup import set002_wrong_script_dir as set002
from rospkg_cli.rules.setup import set105_entry_point_not_installed as set105
from rospkg_cli.rules.setup import set302_package_not_installed as set302

from .little_harm import MAIN, SHARED, below
from .setups import CONFIG, OTHER_NAME, python

LINKS = "colcon build --symlink-install\n"
NODES = {"setup.py": set105.LISTED.replace("«", "").replace("»", ""), **set105.FILES}
BESIDE = {
    **NODES,
    "setup.py": NODES["setup.py"].replace("my_pkg.nodes.talker:", "nodes.talker:"),
    "nodes/__init__.py": "",
    "nodes/talker.py": MAIN,
    "my_pkg/nodes/talker.py": None,
}
SETUP = setup_py(scripts("talker = my_pkg.talker:main"))
START = "def main():\n    print('hello')\n"
WORDS = {"setup.py": SETUP, "my_pkg/speech/words.py": "A = 1\n"}
IMPORT = "from my_pkg.speech.words import A\n"
IMPORTING = (
    {"my_pkg/talker.py": IMPORT + START},
    {"my_pkg/talker.py": START, "my_pkg/other.py": IMPORT},
    {"my_pkg/talker.py": f"from . import other\n{START}", "my_pkg/other.py": IMPORT},
    {"my_pkg/talker.py": f"from my_pkg.other import A\n{START}", "my_pkg/other.py": IMPORT},
    {"my_pkg/talker.py": START, "my_pkg/__init__.py": IMPORT},
    {"my_pkg/talker.py": START.replace("print('hello')", IMPORT.rstrip())},
    {"my_pkg/talker.py": f"try:\n    {IMPORT}except ImportError:\n    A = 2\n{START}"},
    {"my_pkg/talker.py": f"from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    {IMPORT}{START}"},
    {"my_pkg/talker.py": START, "test/test_a.py": IMPORT},
    {"my_pkg/talker.py": START},
)
NEEDS = "  <depend>my_pkg</depend>\n  <export>"
USER = {"src/b/package.xml": manifest("", "ament_cmake", "bringup").replace("  <export>", NEEDS)}
LISTED = SETUP.replace(set302.FOUND, "[package_name, 'my_pkg.speech']")


NAMED = OTHER_NAME.replace(SHARED, f"{SHARED}{SHARED.replace('package.xml', 'launch/a.launch.xml')}")
OWN_MARKER = NAMED.replace("'resource/' + package_name", "'resource/my_pkg'")
IGNORING = CMAKE.replace("ament_package", "install(PROGRAMS my_pkg/talker.py DESTINATION lib/my_pkg)\nament_package")
GENERATED = "from catkin_pkg.python_setup import generate_distutils_setup\n\n" + setup_py()
CATKIN = manifest("  <buildtool_depend>catkin</buildtool_depend>\n", "catkin")
LAUNCHED = {"launch/a.launch.xml": "<launch/>\n"}
RENAMED = {"setup.py": NAMED, **LAUNCHED, "resource/your_pkg": "", "resource/my_pkg": None}
CFG = SETUP_CFG.replace("my_pkg", "your_pkg")


def importing(files: dict[str, str], setup: str) -> Example:
    return python({**WORDS, "setup.py": setup, **files})


TALKER_CFG = SETUP_CFG.replace("install_scripts=$base/lib/my_pkg", "install_scripts=$base/lib/your_pkg")
CASES = {
    "SET002": (
        *(
            below({**set002.PACKAGE, "setup.cfg": TALKER_CFG}, {"README.md": text})
            for text in (LINKS, "colcon build\n")
        ),
        below({**set002.PACKAGE, "setup.cfg": TALKER_CFG.partition("[install]")[0]}, {"README.md": LINKS}),
        below({**set002.PACKAGE, "setup.cfg": TALKER_CFG.replace("my_pkg", "your_pkg")}, {"README.md": LINKS}),
    ),
    "SET105": (
        *(
            below(NODES, {path: LINKS})
            for path in (
                ".github/workflows/ci.yml",
                ".vscode/tasks.json",
                "src/docker/Dockerfile",
                "src/Readme.md",
                "src/a/README.md",
                "scripts/build_all.bash",
                "scripts/build_all.py",
                "docs/a.md",
            )
        ),
        below(BESIDE, {"README.md": LINKS}),
        below(NODES, {"README.md": LINKS, "src/a/Dockerfile": "RUN colcon build\n"}),
    ),
    "SET301": (
        *(importing(files, SETUP) for files in IMPORTING),
        below(WORDS | IMPORTING[0], {"Dockerfile": LINKS}),
        below({**WORDS, **IMPORTING[0], "my_pkg/__init__.py": None}, {"Dockerfile": LINKS}),
        *(
            below({"setup.py": SETUP, "my_pkg/talker.py": START, f"my_pkg/{name}/words.py": "A = 1\n"}, USER)
            for name in ("speech", "old")
        ),
        below({**WORDS, **IMPORTING[-1], "setup.py": LISTED}, USER),
    ),
    "SET401": (
        python({"setup.py": OWN_MARKER, **LAUNCHED}),
        python({"setup.py": OWN_MARKER.replace("a.launch.xml'", "a.txt'"), "launch/a.txt": ""}),
        python({"setup.py": OWN_MARKER.replace("'share/' + package_name", "'share/my_pkg'"), **LAUNCHED}),
        python({**RENAMED, "resource/my_pkg": ""}),
        python({**RENAMED, "setup.cfg": CFG}),
        python({**RENAMED, "setup.cfg": CFG, "resource/my_pkg": ""}),
        python(RENAMED),
        below({**RENAMED, "setup.cfg": CFG}, {"src/b/package.xml": manifest("", "ament_cmake", "your_pkg")}),
    ),
    "WSP001": (
        *(
            Example(bad={f"{each}/package.xml": manifest("", "cmake", "arm") for each in folders}, good={}, on="")
            for folders in (
                ("src/arm", "src/arms"),
                ("src/arm", "src/a/arm"),
                ("src/arm", "src/old/arm"),
                ("src/arm", "src/b_ws/arm"),
                ("src/arm", "src/b/src/arm"),
                ("src/b/src/arm", "src/b/src/a/arm"),
                ("a/arm", "a/arms"),
                ("arm", "src"),
                ("arm", "b_ws/src/arm"),
                ("a/arm", "b_ws/arm"),
                ("src/arm", "src/arms", "src/old/arm"),
            )
        ),
        Example(bad={"src/a/package.xml": CATKIN, "src/b/package.xml": manifest("", "cmake")}, good={}, on=""),
    ),
    "WSP005": tuple(
        Example(bad={"package.xml": manifest("", "cmake"), **files}, good={}, on="")
        for files in (
            {"a/package.xml": CATKIN.replace("my_pkg", "arm")},
            {"a/package.xml": CATKIN, "b/package.xml": manifest("", "cmake", "arm")},
            {".a/package.xml": manifest("", "cmake", "arm")},
            {"a/package.xml": manifest("", "cmake")},
            {"Thirdparty/a/package.xml": manifest("", "cmake", "arm")},
            {"a/package.xml": CATKIN.replace("my_pkg", "ament_arm")},
            *(
                {
                    "CMakeLists.txt": CMAKE.replace("ament_package", f"{added}\nament_package"),
                    **{f"lib/{each}/package.xml": manifest("", "ament_cmake", each) for each in ("arm", "leg")},
                    **{f"lib/{each}/CMakeLists.txt": CMAKE.replace("my_pkg", each) for each in ("arm", "leg")},
                    "lib/leg/src/CMakeLists.txt": "add_library(leg leg.cpp)\n",
                }
                for added in (
                    "add_subdirectory(lib/arm)",
                    "add_subdirectory(lib/arm)\nadd_subdirectory(lib/leg/src)",
                    "include(ExternalProject)\nExternalProject_Add(arm SOURCE_DIR ${PROJECT_SOURCE_DIR}/lib/arm)",
                    "if(FALSE)\n  add_subdirectory(lib/arm)\nendif()\nadd_subdirectory(lib/legs)",
                )
            ),
        )
    ),
    "XML307": (
        *(
            python(
                {
                    "CMakeLists.txt": CMAKE.replace("ament_package", f"{rule}\nament_package"),
                    "config/a.yaml": "",
                    "setup.py": setup_py().replace("'resource/' + package_name", f"'resource/my_pkg', '{named}'"),
                }
            )
            for rule, named in (
                ("install(DIRECTORY config DESTINATION share/my_pkg)", "config/a.yaml"),
                ("install(DIRECTORY config/ DESTINATION share/my_pkg)", "resource/a.yaml"),
                ("install(FILES config/a.yaml DESTINATION share/my_pkg)", "a.yaml"),
                ("# install(DIRECTORY config DESTINATION share/my_pkg)", "a.yaml"),
                ("install(DIRECTORY maps DESTINATION share/my_pkg)", "a.yaml"),
                ("add_executable(a a.cpp)\ninstall(TARGETS a DESTINATION lib/my_pkg)", "a.yaml"),
            )
        ),
        *(
            Example(on="ament_cmake", good={}, bad={"setup.py": setup, "my_pkg/talker.py": MAIN, **files})
            for setup, files in (
                (SETUP, {}),
                (SETUP, {"CMakeLists.txt": IGNORING}),
                (SETUP, {"my_pkg/talker.py": None, "my_pkg/other.py": MAIN}),
                (setup_py(), {}),
                (setup_py(), {"my_pkg/__init__.py": ""}),
                (setup_py(), {"my_pkg/__init__.py": "", "my_pkg/talker.py": None}),
                (GENERATED, {"my_pkg/__init__.py": ""}),
                (NAMED, {"my_pkg/talker.py": None, **LAUNCHED}),
                (NAMED, {"my_pkg/talker.py": None, "config/a.yaml": ""}),
            )
        ),
    ),
    "SET206": (
        python({**CONFIG, "my_pkg/a.py": "A = 'src/all/my_pkg/config/nav.yaml'\n"}),
        *(
            below({"setup.py": setup_py(), **files}, {**USER, "src/b/launch/a.launch.py": f"A = {text}\n"})
            for text, files in (
                ("'nav.yaml'", CONFIG),
                ("'nov.yaml'", CONFIG),
                ("f'{A}.yaml'", CONFIG),
                ("1", {"maps/a.pgm": ""}),
                ("'nav.yaml'", {"config/nav.yml": ""}),
            )
        ),
        below(CONFIG, {"src/b/package.xml": USER["src/b/package.xml"].replace("ament_cmake", "metapackage")}),
    ),
    "SET302": (
        *(
            importing({"my_pkg/speech/__init__.py": "", **files}, SETUP.replace(set302.FOUND, "[package_name]"))
            for files in IMPORTING
        ),
        below(
            {**set302.FILES, "setup.py": SETUP.replace(set302.FOUND, "[package_name]"), "my_pkg/talker.py": START}, USER
        ),
    ),
}
