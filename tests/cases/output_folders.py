"""Programs and libraries that come to the install folder without a rule of their own (CMK103, CMK104)."""

from __future__ import annotations

from .idioms_of_cmake import package
from .swept_programs import NODE

FILES = {
    "src/talker.cpp": NODE.replace("#include", '#include "core.hpp"\n#include', 1).replace("init", "init(core());", 1),
    "src/core.cpp": '#include "core.hpp"\nint core() {return 1;}\n',
    "src/core.hpp": "int core();\n",
    "src/other.cpp": NODE,
}
TALKER = "add_executable(talker src/other.cpp)\n"
OTHER = TALKER + "set_target_properties({} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${{CMAKE_INSTALL_PREFIX}}/lib/my_pkg)\n"
COPIED = "install(DIRECTORY ${PROJECT_BINARY_DIR}/bin/ DESTINATION lib/my_pkg USE_SOURCE_PERMISSIONS)\n"
LIBRARY = (
    "add_library(core SHARED src/core.cpp)\nadd_executable(talker src/talker.cpp)\ntarget_link_libraries(talker core)\n"
    "install(TARGETS talker DESTINATION lib/my_pkg)\n"
)
BIN = TALKER + "install(TARGETS talker DESTINATION bin)\n"
LINK = 'install(CODE "execute_process(COMMAND ln -s ../../bin/talker ${CMAKE_INSTALL_PREFIX}/lib/my_pkg/talker)")\n'
ASIDE = LIBRARY + "install(TARGETS core DESTINATION lib/my_pkg)\n"

CASES = {
    "CMK103": (
        package(TALKER, FILES),
        package("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_INSTALL_PREFIX}/lib/my_pkg)\n" + TALKER, FILES),
        package("set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)\n" + TALKER, FILES),
        package("set(EXECUTABLE_OUTPUT_PATH ${PROJECT_BINARY_DIR}/bin)\n" + TALKER + COPIED, FILES),
        package(OTHER.format("talker"), FILES),
        package("add_executable(listener src/other.cpp)\n" + OTHER.format("listener"), FILES),
        package(LIBRARY, FILES),
        package(LIBRARY + "install(FILES $<TARGET_FILE:core> DESTINATION lib)\n", FILES),
        package(ASIDE, FILES),
        package(ASIDE, FILES | {"env.dsv.in": "prepend-non-duplicate;LD_LIBRARY_PATH;lib/my_pkg\n"}),
    ),
    "CMK104": (package(BIN, FILES), package(BIN + LINK, FILES)),
}
