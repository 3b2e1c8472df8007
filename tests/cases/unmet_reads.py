"""Parameters that code gets and nothing declares, by what leads to the code."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, scripts, setup_py

CPP = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker") {
    declare_parameter("rate", 10.0);
    declare_parameter("verbose", false);
    rate_ = get_parameter("rate").as_double();
    {BODY}
  }
  {MORE}
private:
  double rate_;
};
"""
MAIN = '#include "talker.hpp"\nint main() {Talker talker; return 0;}\n'
READS = 'get_parameter("verbos").as_bool();'
METHOD = f"void load() {{{READS}}}"
BUILD = CMAKE.replace("ament_package", "add_executable(talker src/main.cpp)\nament_package")


def in_cpp(body: str, more: str = "", build: str = BUILD, main: str = MAIN, path: str = "src/talker.hpp") -> Example:
    code = CPP.replace("{BODY}", body).replace("{MORE}", more)
    files = {"CMakeLists.txt": build, path: code, "src/main.cpp": main}
    return Example(bad={"package.xml": manifest("", "ament_cmake"), **files}, good={}, on="ament_cmake")


PYTHON = """\
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 10.0)
        self.declare_parameter('verbose', False)
        self.rate = self.get_parameter('rate').value
        {BODY}

    def load(self):
        {MORE}


def main():
    Talker()
"""
GETS = "self.get_parameter('verbos').value"


def in_python(body: str, more: str = "pass", *, is_used: bool = True) -> Example:
    code = PYTHON.replace("{BODY}", body).replace("{MORE}", more)
    other = PYTHON.replace("{BODY}", "self.get_parameter('verbose')").replace("{MORE}", "pass")
    files = {"my_pkg/talker.py": code if is_used else other, **({} if is_used else {"my_pkg/old_talker.py": code})}
    setup = {"package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n")}
    return Example(bad={**setup, "setup.py": setup_py(scripts("talker = my_pkg.talker:main")), **files}, good={})


CASES = {
    "PRM007": (
        in_cpp(READS),
        in_cpp(f"if (rate_ > 1.0) {{{READS}}}"),
        in_cpp("", METHOD),
        in_cpp("load();", METHOD),
        in_cpp("", METHOD.replace("()", "() override", 1)),
        in_cpp("", METHOD + "\n  // calls load()"),
        in_cpp("call(&Talker::load);", METHOD),
        in_cpp("return load();", METHOD),
        in_cpp("", f"void load();\n}};\nvoid Talker::load() {{{READS}", main=MAIN.replace("int main", "int  main")),
        in_cpp("if (rate_) {load();}", f"void load();\n}};\nvoid Talker::load() {{{READS}"),
        in_cpp(READS, build=CMAKE),
        in_cpp(READS, main="int main() {return 0;}\n"),
        in_cpp(READS, main="int main() {return 0;}\n", path="include/my_pkg/talker.hpp"),
        in_python(GETS),
        in_python(f"if self.rate > 1.0:\n            {GETS}"),
        in_python("pass", GETS),
        in_python("self.load()", GETS),
        in_python(GETS, is_used=False),
        in_python(f"if False:\n            {GETS}"),
    )
}
