"""Projects that name their languages: what is written in another one (CMK131), and silences."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest

FILES = {
    "src/talker.c": "int talk(void) {return 0;}\n",
    "src/main.cpp": "int main() {return 0;}\n",
    "src/fast.cu": "int fast() {return 0;}\n",
}
INSTALL = "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
PROJECT = "project(my_pkg)\n"


def program(project: str, sources: str, more: str = "", after: str = "") -> Example:
    lines = f"{more}add_executable(talker {sources})\n{after}{INSTALL}"
    text = CMAKE.replace(PROJECT, f"project(my_pkg {project})\n").replace("ament_package", lines + "ament_package")
    return Example(bad={"CMakeLists.txt": text, **FILES}, good={}, on="ament_cmake")


def interfaces(project: str, more: str = "") -> Example:
    text = INTERFACES_CMAKE.replace(PROJECT, f"project(my_pkg {project})\n{more}")
    files = {"msg/Status.msg": "bool ok\n", "srv/SetMode.srv": "string mode\n---\nbool ok\n"}
    body = {"package.xml": manifest(INTERFACES_BODY, "ament_cmake")}
    return Example(bad={"CMakeLists.txt": text, **body, **files}, good={}, on="ament_cmake")


CASES = {
    "CMK131": (
        interfaces("CXX"),
        interfaces("VERSION 1.0.0 LANGUAGES CXX"),
        interfaces("LANGUAGES C VERSION 1.0.0"),
        interfaces("NONE"),
        interfaces("LANGUAGES"),
        interfaces("VERSION 1.0.0"),
        interfaces("VERSION 1.0.0 DESCRIPTION C"),
        interfaces("CXX C"),
        interfaces("${LANGUAGES}"),
        interfaces("CXX", "enable_language(C)\n"),
        interfaces("CXX", "if(WITH_C)\n  enable_language(C)\nendif()\n"),
        interfaces("CXX", "option(WITH_C off OFF)\nif(WITH_C)\n  enable_language(C)\nendif()\n"),
        interfaces("CXX", "include(${WHERE}/languages.cmake)\n"),
        program("CXX", "src/main.cpp"),
        program("CXX", "src/talker.c"),
        program("CXX", "src/main.cpp src/talker.c"),
        program("C", "src/main.cpp"),
        program("C CXX", "src/main.cpp src/fast.cu"),
        program("C CXX CUDA", "src/main.cpp src/fast.cu"),
        program("C CXX", "src/main.cpp src/fast.cu", "include(CheckLanguage)\ncheck_language(CUDA)\n"),
        program("C CXX", "src/main.cpp src/fast.cu", "find_package(CUDA REQUIRED)\n"),
        program(
            "CXX",
            "src/main.cpp src/talker.c",
            "set_source_files_properties(src/talker.c PROPERTIES LANGUAGE CXX)\n",
        ),
        program("CXX", "src/talker.c", "", "target_sources(talker PRIVATE src/main.cpp)\n"),
        program("CXX", "src/talker.c", "", "set_target_properties(talker PROPERTIES LINKER_LANGUAGE CXX)\n"),
    ),
}
