"""Levels of what is in a Python module that nothing starts, imports or names, and in one that only launch files do."""

from __future__ import annotations

from rospkg_cli.example import INTERFACES_CMAKE, SETUP_PY, Example, manifest, scripts, setup_py

from .setups import python

OTHER = {"CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "other_ifs"), "msg/Status.msg": "float32 battery\n"}
SHARE = "from ament_index_python.packages import get_package_share_directory\n"
DEEP = "from .inner.deep import A\n"
MAIN = "def main():\n    print(A)\n"
TRIED = f"try:\n    {DEEP}except ImportError:\n    A = None\n\n\n{MAIN}"
NAMED = setup_py(scripts("talker = my_pkg.talker:main", "deep = my_pkg.inner.deep:A"))
OPTIONAL: tuple[tuple[str, dict[str, str | None]], ...] = (
    (TRIED, {}),
    (TRIED, {"my_pkg/other.py": DEEP + MAIN}),
    (TRIED, {"setup.py": NAMED}),
    (TRIED, {"my_pkg/plugins.xml": "<class type='my_pkg.inner.deep'/>\n"}),
    (TRIED.replace(DEEP, "from inner.deep import A\n"), {}),
    (MAIN, {"my_pkg/inner/top.py": TRIED.replace(".inner", ""), "setup.py": SETUP_PY}),
    (MAIN, {"my_pkg/inner/top.py": TRIED.replace(".inner.", ""), "setup.py": SETUP_PY}),
)
"""A third module is imported where that may fail; by another for certain, too; started; named; from beside it."""
RUN = "\n\nif __name__ == '__main__':\n    cv2.waitKey()\n"
BY_PATH: tuple[tuple[str, dict[str, str | None]], ...] = (
    (RUN, {}),
    ("", {"my_pkg/inner/top.py": f"import deep\n{RUN}"}),
    (RUN, {"my_pkg/other.py": DEEP}),
    (RUN, {"README.md": "Run `python3 my_pkg/inner/deep.py`.\n"}),
    (RUN, {"run.sh": "python3 -m my_pkg.inner.deep\n"}),
    (RUN, {"run.sh": "python3 -m my_pkg.inner.top\n"}),
)
"""A module of a package without programs is started by its path; serves such a one; is imported; a page names it."""
LAUNCH = {"launch/a.launch.py": "from my_pkg.inner.deep import A\n"}
STARTED = {
    "package.xml": manifest("  <exec_depend>std_msgs</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "b = my_pkg.other:main")),
    "my_pkg/talker.py": MAIN,
    "my_pkg/other.py": MAIN,
    "my_pkg/inner/__init__.py": "",
}


def deep(text: str, files: dict[str, str | None] | None = None) -> Example:
    """A package that starts two modules, with what stands in a third."""
    return python({**STARTED, "my_pkg/inner/deep.py": text, **(files or {})})


def each(text: str) -> tuple[Example, ...]:
    """Return the packages that reach the module: by nothing; another module; a page; a launch file; none starts."""
    return (
        deep(text),
        deep(text, {"my_pkg/talker.py": DEEP + MAIN}),
        deep(text, {"README.md": "Run `python3 my_pkg/inner/deep.py`.\n"}),
        deep(text, LAUNCH),
        deep(text, {"setup.py": SETUP_PY}),
        deep(text, {"setup.py": setup_py("entry_points=entries(),")}),
    )


def in_workspace(files: dict[str, str | None]) -> Example:
    """A package that uses another one of its workspace."""
    mine = {f"a/{path}": each for path, each in python(files).bad_files().items()}
    others = {"b/package.xml": manifest("", "cmake", "other_ifs"), **{f"b/{p}": t for p, t in OTHER.items()}}
    return Example(on="", bad={**mine, **others}, good={})


PATH = "from ament_index_python.packages import get_package_share_path\n\n"
READ = f"{PATH}print(open(get_package_share_path('my_pkg') / 'names' / 'people.txt').read())\n"

CASES = {
    "DEP112": (deep(f"{PATH}get_package_share_path('my_pgk')\n"),),
    "DEP113": (
        deep(READ, {"names/people.txt": "Ada\n"}),
        deep(READ, {"names/people.txt": "Ada\n", "my_pkg/talker.py": DEEP + MAIN}),
    ),
    "IDL010": each("from std_msgs.msg import String\n\nmsg = String()\nmsg.datta = ''\n"),
    "IDL011": (deep("from std_msgs.msg import Strin\n"), deep("from std_msgs.msg import Strin\n", LAUNCH)),
    "DEP101": (
        *each("import cv2\n"),
        deep("import cv2\n", {"my_pkg/talker.py": f"import cv2\n{MAIN}"}),
        deep("import rospy\n"),
        deep("import rospy\n", {"my_pkg/talker.py": DEEP + MAIN}),
        deep("import cv2\nimport launch\nimport launch_ros\n", LAUNCH),
        deep("import launch\n", {**LAUNCH, "test/test_a.py": "import my_pkg.inner.deep\n"}),
        deep("import launch\n", {**LAUNCH, "my_pkg/talker.py": f"import launch\n{MAIN}"}),
        *(deep("import cv2\n", {"my_pkg/talker.py": text, **more}) for text, more in OPTIONAL),
        deep("import rospy\n", {"my_pkg/talker.py": TRIED}),
        *(deep(f"import cv2\n{text}", {"setup.py": SETUP_PY, **more}) for text, more in BY_PATH),
        in_workspace({"my_pkg/talker.py": "from other_ifs.msg import Status\n"}),
    ),
    "DEP102": (in_workspace({"test/test_a.py": "from other_ifs.msg import Status\n"}),),
    "DEP103": (in_workspace({"launch/a.launch.xml": '<launch><node pkg="other_ifs" exec="a"/></launch>\n'}),),
    "DEP116": (
        in_workspace({"my_pkg/talker.py": SHARE + "get_package_share_directory('other_ifs')\n", "setup.py": NAMED}),
    ),
}
