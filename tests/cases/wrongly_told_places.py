"""Variables that a search reads and the user gives (CMK115), and other faults of CMake and C++."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

SET = "set(SENSOR_SDK_LIB m)\n"
CORE = {"src/core.cpp": ""}


def package(lines: str) -> Example:
    text = CMAKE.replace("ament_package", f"{lines}\nament_package")
    return Example(bad={"CMakeLists.txt": text, **CORE}, good={}, on="ament_cmake")


CASES = {
    "CMK115": tuple(
        package(SET + lines)
        for lines in (
            "find_library(SDK sdk PATHS ${SENSOR_SDK_DIR}/lib /opt/sdk/lib)",
            "find_path(SDK sdk.h HINTS ${SENSOR_SDK_DIR} PATH_SUFFIXES include)",
            "find_library(SDK sdk ${SENSOR_SDK_DIR}/lib)",
            "find_package(sdk QUIET PATHS ${SENSOR_SDK_DIR})\ninclude_directories(${SENSOR_SDK_DIR})",
            "find_library(SDK NAMES ${SENSOR_SDK_DIR} PATHS /opt/sdk)",
            "include_directories(${SENSOR_SDK_DIR} $ENV{SENSOR_SDK_DIR})",
            "include_directories(${SENSOR_SDK_DIR})\nlink_directories($ENV{SENSOR_SDK_DIR})",
            "include_directories(${SENSOR_SDK_DIR})",
            "find_path(SDK sdk.h PATHS ${CMAKE_SOURCEDIR}/include)",
        )
    ),
}
