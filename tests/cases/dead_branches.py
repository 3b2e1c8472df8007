"""Faults in branches for a package (`if(OpenMP_FOUND)`) that something looks for, and that nothing looks for."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

NODE = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
CORE = "add_library(robot_core_base src/core.cpp)\ninstall(TARGETS robot_core_base DESTINATION lib)\n"
LINKS = "target_link_libraries(talker m)\n"
MIXED = "target_link_libraries(talker PUBLIC OpenMP::OpenMP_CXX)\n"
FILES = {"src/talker.cpp": "int main() {return 0;}\n", "src/core.cpp": "int core() {return 0;}\n"}
SEARCHES = (
    "",
    "find_package(OpenMP)\n",
    "foreach(name Threads OpenMP)\n  find_package(${name})\nendforeach()\n",
    "set(OpenMP_CXX_FOUND TRUE CACHE BOOL x)\n",
    "pkg_check_modules(openmp omp)\n",
    "include(${SOMEWHERE}/more.cmake)\n",
    "find_package(cv_bridge REQUIRED)\n",
)


def package(lines: str) -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return Example(
        bad={"package.xml": manifest("  <depend>cv_bridge</depend>\n", "ament_cmake"), "CMakeLists.txt": text, **FILES},
        good={},
        on="",
    )


def where(condition: str, line: str) -> str:
    return f"if({condition})\n  {line}endif()\n"


SLIP = "target_include_directories(robot_core_bsae PUBLIC include)\n"
EMPTY = "target_include_directories(robot_core_base PUBLIC ${CMAKE_CURENT_SOURCE_DIR}/include)\n"
CASES = {
    "CMK110": tuple(package(f"{search}{CORE}{where('OpenMP_FOUND', SLIP)}") for search in SEARCHES[:2]),
    "CMK115": (
        *(package(f"{search}{CORE}{where('OpenMP_FOUND', EMPTY)}") for search in SEARCHES[:2]),
        *(
            package(f"find_package(octomap REQUIRED)\n{CORE}target_link_libraries(robot_core_base ${{{name}}})\n")
            for name in ("OCTOMAP_LIBRARIES", "OCTOMAP_LIBRARY", "octomap_LIBS")
        ),
    ),
    "CMK122": (
        *(package(f"{search}{NODE}{LINKS}{where('OpenMP_CXX_FOUND', MIXED)}") for search in SEARCHES),
        *(
            package(f"{NODE}{LINKS}{where(condition, MIXED)}")
            for condition in ("NOT OpenMP_FOUND", "WITH_MORE AND OpenMP_FOUND", "WITH_MORE OR OpenMP_FOUND")
        ),
        package(f"{NODE}{LINKS}{where('OpenCV_FOUND', MIXED)}"),
        package(f"find_package(cv_bridge REQUIRED)\n{NODE}{LINKS}{where('OpenCV_FOUND', MIXED)}"),
    ),
}
