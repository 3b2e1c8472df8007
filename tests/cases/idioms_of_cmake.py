"""What CMake files of well-kept packages say in other words: folders, switches, sources, exports."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

HEADERS = {
    "include/my_pkg/core.hpp": "int core();\n",
    "sdk/include/sdk/api.hpp": "int api();\n",
    "src/core.cpp": '#include "my_pkg/core.hpp"\nint core() {return 1;}\n',
    "src/talker.cpp": '#include "sdk/api.hpp"\nint main() {return api();}\n',
}
PROGRAM = "add_executable(talker src/talker.cpp src/core.cpp)\ninstall(TARGETS talker DESTINATION lib/my_pkg)\n"
TOLD = "target_include_directories(talker PRIVATE include)\n"
IMPORTED = (
    "add_library(sdk SHARED IMPORTED)\nset_target_properties(sdk PROPERTIES {} ${{PROJECT_SOURCE_DIR}}/sdk/include)\n"
)
LIST = 'target_include_directories(talker PRIVATE "$<BUILD_INTERFACE:{}>" "$<INSTALL_INTERFACE:include>")\n'
BOTH = "${PROJECT_BINARY_DIR};${PROJECT_SOURCE_DIR}/include;${PROJECT_SOURCE_DIR}/sdk/include"
SDK = {"sdk/lib/amd64/libapi.so": ""}
ON = 'if(CMAKE_SYSTEM_PROCESSOR MATCHES "{}")\n  install(DIRECTORY sdk/lib/arm64/ DESTINATION lib)\nendif()\n'
ASKED = "if($ENV{{{}}} STREQUAL a)\nendif()\n"


def package(lines: str, files: dict[str, str] = HEADERS, body: str = "") -> Example:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    return Example(bad={"CMakeLists.txt": text, "package.xml": manifest(body, "ament_cmake"), **files}, good={}, on="")


CASES = {
    "CMK102": tuple(package(ON.format(name), SDK) for name in ("aarch64", "arm64|armv7l", "x86_64")),
    "CMK123": (
        *(package(ASKED.format(name), {}) for name in ("HOME", "AMENT_PREFIX_PATH", "ROBOT_HOME")),
        package('if($ENV{ROBOT} MATCHES "a" OR $ENV{ARM} MATCHES "b")\nendif()\n', {}),
        package('if($ENV{ROBOT} MATCHES "a")\nendif()\n', {}),
    ),
    "CMK201": (
        package(PROGRAM + TOLD),
        package(IMPORTED.format("INTERFACE_INCLUDE_DIRECTORIES") + PROGRAM + TOLD),
        package(IMPORTED.format("INTERFACE_SYSTEM_INCLUDE_DIRECTORIES") + PROGRAM + TOLD),
        package(PROGRAM + LIST.format(BOTH)),
        package(PROGRAM + LIST.format("${PROJECT_BINARY_DIR};${PROJECT_SOURCE_DIR}/include")),
    ),
}
