"""CMake: its grammar, and an interpreter that builds nothing."""
