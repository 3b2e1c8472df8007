"""Packages that are called like the folder of a well-known library, whose headers are not only theirs."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

PROGRAM = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
FOUND = "find_package(PCL REQUIRED)\ninclude_directories(include ${PCL_INCLUDE_DIRS})\n"
INSTALLED = "include_directories(include)\ninstall(DIRECTORY include/ DESTINATION include)\n"


def named(name: str, lines: str = "", body: str = "") -> dict[str, str]:
    """Return the files of a package that has a name."""
    text = CMAKE.replace("my_pkg", name).replace("ament_package", f"{lines}ament_package")
    own = manifest(body, "ament_cmake").replace("<name>my_pkg", f"<name>{name}")
    return {"package.xml": own, "CMakeLists.txt": text}


def includes(name: str, header: str) -> Example:
    source = {"src/talker.cpp": f"#include <{name}/{header}>\nint main() {{return 0;}}\n"}
    own = {f"include/{name}/words.h": "int words();\n"}
    return Example(bad={**named(name, FOUND + PROGRAM), **source, **own}, good={}, on="ament_cmake")


def beside(name: str, header: str) -> Example:
    """Return a package that includes a header of another one, which has one in a folder of its name."""
    user = named("user", f"find_package({name} REQUIRED)\n{PROGRAM}", f"  <depend>{name}</depend>\n")
    source = {"user/src/talker.cpp": f"#include <{name}/{header}>\nint main() {{return 0;}}\n"}
    own = {f"{name}/include/{name}/words.h": "int words();\n"}
    files = {f"{name}/{path}": text for path, text in named(name, INSTALLED).items()}
    return Example(
        bad={**files, **{f"user/{path}": text for path, text in user.items()}, **source, **own}, good={}, on=""
    )


CASES = {
    "CMK201": tuple(
        make(name, header)
        for make in (includes, beside)
        for name in ("pcl", "moveit", "my_pkg")
        for header in ("point_types.h", "wrds.h")
    ),
}
