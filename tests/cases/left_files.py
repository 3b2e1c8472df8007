"""Files that nothing installs, compiles, starts or names, beside those that something does."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, scripts, setup_py

HOME = "/home/ada/ws/src/my_pkg/photos"
FILES = {
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/talker.py": "def main():\n    pass\n",
    "photos/a.png": "",
}
OPENS = f"import glob\n\nIMAGES = glob.glob('{HOME}')\n"
NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"
BESIDE = "install(FILES launch/b.launch.xml DESTINATION share/my_pkg/launch)\n"
LAUNCH = '<launch>\n  <node pkg="joy" exec="joy_node"/>\n</launch>\n'


def python(**files: str) -> Example:
    return Example(bad={**FILES, **{name.replace("__", "/") + ".py": text for name, text in files.items()}}, good={})


def cmake(lines: str = "", **files: str) -> Example:
    named = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    built = {
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{NODE}{lines}ament_package"),
        "src/node.cpp": "int main() {return 0;}\n",
        "photos/a.png": "",
    }
    return Example(bad={**built, **named}, good={}, on="ament_cmake")


def source(text: str = HOME) -> str:
    return f'std::string where() {{return "{text}";}}\n'


WRONG = "import rclpy\n\n\ndef main():\n    rclpy.init()\n    time.sleep(1)\n"


def in_folder(entry: str, folder: str) -> Example:
    files = {"setup.py": setup_py(scripts(f"talker = my_pkg.{entry}:main")), f"my_pkg/{folder}talker.py": WRONG}
    return Example(bad={**files, "my_pkg/other.py": "def main():\n    pass\n"}, good={})


CASES = {
    "DEP117": (in_folder("talker", ""), in_folder("deep.talker", "deep/"), in_folder("other", "deep/")),
    "DEP118": (
        python(my_pkg__calibrate=OPENS),
        python(my_pkg__calibrate=OPENS, my_pkg__talker="from . import calibrate\n\ndef main():\n    pass\n"),
        cmake(src__old_DOT_cpp=source()),
        cmake("target_sources(node PRIVATE src/old.cpp)\n", src__old_DOT_cpp=source()),
        cmake(scripts__calibrate_DOT_py=OPENS),
        cmake(scripts__calibrate_DOT_py=OPENS, README_DOT_md="Run scripts/calibrate.py\n"),
        cmake("install(PROGRAMS scripts/calibrate.py DESTINATION lib/my_pkg)\n", scripts__calibrate_DOT_py=OPENS),
    ),
    "DEP103": (
        cmake(launch__a_DOT_launch_DOT_xml=LAUNCH),
        cmake("install(DIRECTORY launch DESTINATION share/my_pkg)\n", launch__a_DOT_launch_DOT_xml=LAUNCH),
        cmake(launch__a_DOT_launch_DOT_xml=LAUNCH, README_DOT_md="ros2 launch launch/a.launch.xml\n"),
        cmake(BESIDE, launch__a_DOT_launch_DOT_xml=LAUNCH, launch__b_DOT_launch_DOT_xml="<launch/>\n"),
        cmake(
            BESIDE,
            launch__a_DOT_launch_DOT_xml=LAUNCH,
            launch__b_DOT_launch_DOT_xml='<launch>\n  <include file="$(dirname)/a.launch.xml"/>\n</launch>\n',
        ),
    ),
}
