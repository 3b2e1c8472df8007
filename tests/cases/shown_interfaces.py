"""Sentences and silences of the rules for interfaces: lines, names, types, lists in CMake."""

from __future__ import annotations

from rospkg_cli.example import INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest


def message(*lines: str, cmake: str = INTERFACES_CMAKE, **files: str) -> Example:
    """A package of interfaces whose message has some lines; more files by their paths."""
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    text = "".join(f"{line}\n" for line in lines) or "float32 a\n"
    return Example(bad={"msg/Status.msg": text, "CMakeLists.txt": cmake, **named}, good={}, on="interfaces")


def typed(*types: str, cmake: str = INTERFACES_CMAKE, depends: tuple[str, ...] = (), **files: str) -> Example:
    found = message(*(f"{each} f{number}" for number, each in enumerate(types)), cmake=cmake, **files)
    body = "".join(f"  <depend>{name}</depend>\n" for name in depends) + INTERFACES_BODY
    return Example(bad={**found.bad, "package.xml": manifest(body, "ament_cmake")}, good={}, on="interfaces")


def listed(*names: str, before: str = "", more: str = "") -> str:
    """CMake that generates some files."""
    head, _, _ = INTERFACES_CMAKE.partition("rosidl_generate_interfaces(")
    lines = "".join(f'  "{name}"\n' for name in names)
    call = f"rosidl_generate_interfaces(${{PROJECT_NAME}}\n{lines}{more})\n"
    return f"{head}{before}{call}ament_export_dependencies(rosidl_default_runtime)\nament_package()\n"


BOTH = ("msg/Status.msg", "srv/SetMode.srv")
MAYBE = "if(UNKNOWN)\n  list(APPEND files msg/Status.msg)\nendif()\n"
FROM_LIST = listed("srv/SetMode.srv", before=MAYBE).replace('"srv/', '${files} "srv/')
UNKNOWN = listed("${FILES}", *BOTH)
ASIDE = listed("srv/SetMode.srv", before="# msg/Status.msg is not ready\n")
FIELDS = (
    "Count",
    "count_",
    "_count",
    "a__b",
    "camelCase",
    "HTTPServer",
    "9lives",
    "a-b",
    "from",
    "class",
    "int",
    "sequence",
    "label",
    "label",
    "x",
    "print",
    "None",
    "default",
    "long",
    "in",
    "count2",
    "a.b",
    "self",
)
CONSTANTS = ("idle", "Idle", "IDLE_", "_IDLE", "A__B", "IDLE", "IDLE", "CLASS", "from", "A9", "camelCase")
LINES = (
    " int32 a",
    "int32",
    "int32 a b",
    "int32 a = 5",
    "int32 A = 5.5",
    "string[] A=x",
    "int32 [] a",
    "int32[3 ] a",
    "int32[] a 5",
    "int32[2] a [1]",
    "int32[<=2] a [1, 2, 3]",
    "string<=3 a 'long one'",
    "string<=0 a",
    "string<= a",
    "int32[x] a",
    "int32] a",
    "int32[][] a",
    "bool a yes",
    "bool a True",
    "int8 a 200",
    "uint8 a -1",
    "float32 a x",
    "float64 a 1e5",
    "string a 'it's'",
    'string a "b # c"',
    "string[] a ['é']",
    "string a '\\x'",
    "int32 a;",
    "int32 a,",
    "double a",
    "unsigned a",
    "time a",
    "duration a",
    "char a 'x'",
    "byte a 300",
    "my_pkg/msg/Status a",
    "a/b/c/D a",
    "My_Pkg/A a",
    "status a",
    "Status a 5",
    "int32 a[3]",
    "wstring a 'x'",
    "int32 a # [unit",
    "# C:\\Users",
    "int64 A=99999999999999999999",
    "---",
    "uint64 a 0x1F",
    "float32 A=nan",
    "bool A=1",
    'string A="x"',
    "int32[] a [1, 2]",
    "string[] a [x, 'y']",
    "int32 a [1]",
    "fixed a",
)

CASES = {
    "IDL001": (
        *(message(*LINES[number : number + 6]) for number in range(0, len(LINES), 6)),
        message("Header h", "std_msgs/Header h2"),
        message("Header h", msg__Header_DOT_msg="int32 a\n"),
        message("int a", cmake=ASIDE),
        message("int a", "Header h", cmake=FROM_LIST),
        message("int a", cmake=UNKNOWN),
        message(srv__SetMode_DOT_srv="int32 a\n"),
        message(srv__SetMode_DOT_srv="int32 a\n---\nint32 b\n---\nint32 c\n"),
        message(srv__SetMode_DOT_srv="int32 a\n --- \nint32 b\n"),
        message(cmake=listed(*BOTH, "action/Go.action"), action__Go_DOT_action="int32 a\n---\nint32 b\n"),
        message("\ufeffint32 a"),
    ),
    "IDL003": (
        message(*(f"int32 {name}" for name in FIELDS)),
        message(*(f"int32 {name}={number}" for number, name in enumerate(CONSTANTS))),
        message("int32 Count", "int32 from", "int32 a", "int32 a", "int32 sequence", cmake=FROM_LIST),
        message("int32 Count", cmake=ASIDE),
        message(srv__SetMode_DOT_srv="int32 a\nint32 A=1\n---\nint32 a\nint32 a\nint32 A=2\n"),
    ),
    "IDL004": (
        typed("SetMode", "Statsu", "Nothing", "my_pkg/Nothing", "std_msgs/Strin", "std_msgs/Nothing",
              "who_knows/Nothing",
              "geometry_msgs/Pose2D", "rclcpp/Node", depends=("std_msgs", "geometry_msgs", "who_knows", "rclcpp")),
        typed("Nothing", cmake=FROM_LIST),
        typed("Nothing", cmake=ASIDE),
        typed("Other", msg__Other_DOT_msg="int32 a\n"),
        typed("Other", cmake=listed(*BOTH, "msg/Other.msg"), msg__Other_DOT_msg="int32 a\n"),
    ),
    "IDL005": (
        message(msg__Other_DOT_msg="int32 a\n", interfaces__More_DOT_msg="int32 a\n",
                action__Go_DOT_action="---\n---\n"),
        *(message(msg__Other_DOT_msg=text)
          for text in ("int a\n", "Else other\n", "my_pkg/Else other\n", "my_pkg/Status one\nother/Else two\n")),
        message(msg__other_DOT_msg="int32 a\n"),
        message(cmake=ASIDE),
        message(cmake=FROM_LIST),
        message(cmake=UNKNOWN, msg__Other_DOT_msg="int32 a\n"),
        message(msg__Other_DOT_msg="int32 a\n", _DOT_gitignore="msg/Other.msg\n"),
        message(cmake=listed(*BOTH, before="# and msg/Other.msg\n"), msg__Other_DOT_msg="int32 a\n"),
        message(cmake=listed(), msg__Other_DOT_msg="int32 a\n"),
    ),
    "IDL006": (
        message(cmake=listed(*BOTH, "msg/Statsu.msg", "msg/Nothing.msg", "${NAME}.msg")),
        message(cmake=listed(*BOTH, "${CMAKE_CURRENT_BINARY_DIR}/msg/Made.msg")),
        message(cmake=listed(*BOTH, "msg/Ignored.msg"), _DOT_gitignore="msg/Ignored.msg\n"),
        message(cmake=f"if(UNKNOWN)\n{listed('msg/Nothing.msg')}endif()\n"),
    ),
    "IDL007": (
        typed("std_msgs/Header", "geometry_msgs/Pose", cmake=listed(*BOTH, before="find_package(std_msgs REQUIRED)\n"),
              depends=("std_msgs", "geometry_msgs")),
        typed("std_msgs/Header", cmake=listed(*BOTH, more="  DEPENDENCIES sensor_msgs\n"), depends=("sensor_msgs",
              "std_msgs")),
        typed("std_msgs/Header", cmake=listed(*BOTH, more="  DEPENDENCIES who_knows\n"), depends=("who_knows",
              "std_msgs")),
        typed("std_msgs/Header", cmake=listed(*BOTH, more="  DEPENDENCIES ${PACKAGES}\n"), depends=("std_msgs",)),
        typed("std_msgs/Header", cmake=FROM_LIST, depends=("std_msgs",)),
        typed("builtin_interfaces/Time", "action_msgs/GoalInfo", "service_msgs/ServiceEventInfo", "my_pkg/Status",
              "Status"),
        Example(bad=typed("service_msgs/ServiceEventInfo").bad, good={}, on="interfaces", targets=("humble",)),
    ),
    "IDL009": (
        message(cmake=listed(*BOTH, "msg/Status.msg", "./msg/Status.msg")),
        message(cmake=listed(*BOTH) + listed(*BOTH).replace("(${PROJECT_NAME}", "(again")),
    ),
}  # fmt: skip
