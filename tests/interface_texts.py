"""Interface texts with the verdict of rosidl; tests/real checks that it is theirs."""

from __future__ import annotations

TAKEN = [
    *(("msg", text) for text in (
        "", "# only a comment\n", "int32 a", "int32\ta  ", "  # an indented comment\nint32 a", "int32 a\r",
        "bool a True", "bool A=1", "byte b 255", "char c 65", "int8 a -128", "uint64 a 18446744073709551615",
        "int32 a 0x10", "int32 A=-5", "int32 a 1_000", "float32 x .5", "float64 x 1e-9", "float64 X=nan",
        "string s", "string s 'it\\'s'", "string S=", "string S=abc def", 'string s "a, b"', "wstring<=5 s",
        "string<=5[<=3] s", "int32[] a [1, 2]", "int32[2] a [1, 2]", "int32[<=2] a []", "string[] s ['x', \"y\"]",
        "string[] s [x, y]", "Point[3] a", "geometry_msgs/Point[<=3] a", "int32 A=1\nint32 a", "int32 class",
        "# a \\\\ b\nint32 a", "int32 a\n# at the end \\", "# 5 \u20ac\nint32 a", "int32 a # [m/s]", "int32[+3] a",
        "# [a\n# b]\nint32 a", 'string S=a"b', "string s '", "Foo_Request a", "int32 a\x0cint32 b",
    )),
    *(("srv", text) for text in ("---", "int32 a\n---\nint32 a\n", "---\n# nothing\n")),
    *(("action", text) for text in ("---\n---", "int32 a\n---\nint32 a\n---\nint32 a\n")),
]  # fmt: skip

REFUSED = [
    *(("msg", text) for text in (
        " int32 a", "\tint32 a", "int32", "int32 # a", "int32[<=3]a", "int a", "float a", "unsigned int a", "time t",
        "duration[] d", "time T=5", "std_msgs/msg/String s", "a/b/c/d e", "Std/Header h", "std__msgs/Header h",
        "std_msgs/header h", "/Header h", "int32[0] a", "int32[-1] a", "int32[x] a", "int32] a", "int32[][] a",
        "int32[3 ] a", "int32 [] a", "string<=0 s", "string<=x s", "string <= 5 s", "int32 a=5", "int32 aB",
        "int32 a__b", "int32 a_", "int32 _a", "int32 1a", "int32 A_=1", "int32 A__B=1", "int32 A B=1", "Foo A=1",
        "int32[] A=[1]", "string<=5 A=a", "int32 a\nint32 a", "int32 A=1\nint32 A=2", "int32 a;", "int32 a, b",
        "int32 a 5 6", "int32 a 1.0", "uint8 a 256", "uint8 a -1", "char A=-1", "bool a yes", "float32 x 1,5",
        "float32 x 1.0f", "Foo a 5", "int32[] a 1", "int32[2] a [1]", "int32[<=2] a [1, 2, 3]", "string[] s [ ]",
        "string[] s [,]", 'string[] s ["x]', 'string s "a=b"', 'string s "a"b"', "string<=3 s abcd", "string S=\\x",
        "string s \\", "string[] s ['\u00e9']", "int32 A=", "# C:\\Users\nint32 a", "int32 a # \\", "# \\n\nint32 a",
        "# \\u20ac\nint32 a", "# a \\\\\nint32 a", "int32 a # [m\n # s]", "---", "int32\u00a0a",
    )),
    *(("srv", text) for text in ("", "int32 a", "--- ", " ---", "----", "---\n---", "--- # here\n")),
    *(("action", text) for text in ("", "---", "---\n---\n---", "---\n--- \n")),
]  # fmt: skip
