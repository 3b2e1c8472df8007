"""Programs whose `main()` comes with a test framework, an included file of any ending, or is not wanted (CMK125)."""

from __future__ import annotations

from .idioms_of_cmake import package

PROGRAM = "add_executable(talker src/talker.cpp)\n"
BARE = "target_link_options(talker PRIVATE -nostartfiles)\n"
CODE = "int answer() {return 42;}\n"
BOOST = "#include <boost/test/unit_test.hpp>\nnamespace a\n{\n  BOOST_AUTO_TEST_CASE(b) {}\n}\n"

CASES = {
    "CMK125": (
        package(PROGRAM, {"src/talker.cpp": CODE}),
        package(PROGRAM, {"src/talker.cpp": "#define BOOST_TEST_MODULE talker\n" + BOOST}),
        package(PROGRAM, {"src/talker.cpp": BOOST}),
        package(PROGRAM, {"src/talker.cpp": "#include <acme/test_main.hpp>\n" + CODE}),
        package(PROGRAM, {"src/talker.cpp": '#include "app.inc"\n', "src/app.inc": "int main() {return 0;}\n"}),
        package(PROGRAM, {"src/talker.cpp": '#include "app.inc"\n', "src/app.inc": CODE}),
        package(PROGRAM + BARE, {"src/talker.cpp": CODE}),
    ),
}
