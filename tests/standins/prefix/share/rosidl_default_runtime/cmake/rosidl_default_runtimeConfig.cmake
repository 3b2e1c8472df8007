# A stand-in for what generated interfaces need at run time.
set(rosidl_default_runtime_FOUND TRUE)
