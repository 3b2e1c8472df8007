"""Look-ups of other packages in code that nothing leads to, beside code that something does."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, scripts, setup_py

START = "from ament_index_python.packages import get_package_share_directory\n\n\n"
LOOKS = "get_package_share_directory('nav2_bringup')"
IDLE = f"def unused():\n    return {LOOKS}\n\n\ndef main():\n    pass\n"
USED = IDLE.replace("pass", "unused()")
FILES = {
    "package.xml": manifest("  <exec_depend>ament_index_python</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
}
NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package"
SOURCE = 'auto share() {return ament_index_cpp::get_package_share_directory("nav2_bringup");}\n'


def python(**modules: str) -> Example:
    return Example(bad={**FILES, **{f"my_pkg/{name}.py": text for name, text in modules.items()}}, good={})


def cmake(path: str) -> Example:
    files = {"CMakeLists.txt": CMAKE.replace("ament_package", NODE), "src/node.cpp": "int main() {return 0;}\n"}
    return Example(bad={**files, path: SOURCE}, good={}, on="ament_cmake")


CASES = {
    "DEP116": (
        python(talker=START + IDLE),
        python(talker=START + USED),
        python(talker="def main():\n    pass\n", old=f"{START}SHARE = {LOOKS}\n"),
        python(talker=START + USED, old=f"{START}SHARE = {LOOKS}\n"),
        cmake("src/old.cpp"),
        cmake("src/node.cpp"),
    ),
}
