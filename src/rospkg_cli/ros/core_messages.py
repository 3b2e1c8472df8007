"""Messages of the packages that every ROS 2 distribution has: enough to see that a name was meant otherwise.

Source: ros2/common_interfaces, ros2/rcl_interfaces, ros2/geometry2 and ros2/unique_identifier_msgs, Rolling.  Later
distributions may add to a package; so nothing may be concluded from a name that is not here and like none.
"""

from __future__ import annotations

CORE_MESSAGES: dict[str, frozenset[str]] = {
    package: frozenset(names.split())
    for package, names in {
        "action_msgs": "GoalInfo GoalStatus GoalStatusArray",
        "actionlib_msgs": "GoalID GoalStatus GoalStatusArray",
        "builtin_interfaces": "Duration Time",
        "diagnostic_msgs": "DiagnosticArray DiagnosticStatus KeyValue",
        "geometry_msgs": """
            Accel AccelStamped AccelWithCovariance AccelWithCovarianceStamped Inertia InertiaStamped Point
            Point32 PointStamped Polygon PolygonInstance PolygonInstanceStamped PolygonStamped Pose Pose2D
            PoseArray PoseStamped PoseWithCovariance PoseWithCovarianceStamped Quaternion QuaternionStamped
            Transform TransformStamped Twist TwistStamped TwistWithCovariance TwistWithCovarianceStamped Vector3
            Vector3Stamped VelocityStamped Wrench WrenchStamped""",
        "lifecycle_msgs": "State Transition TransitionDescription TransitionEvent",
        "nav_msgs": "GridCells MapMetaData OccupancyGrid Odometry Path",
        "rcl_interfaces": """
            FloatingPointRange IntegerRange ListParametersResult Log LoggerLevel Parameter ParameterDescriptor
            ParameterEvent ParameterEventDescriptors ParameterType ParameterValue SetLoggerLevelsResult
            SetParametersResult""",
        "rosgraph_msgs": "Clock",
        "sensor_msgs": """
            BatteryState CameraInfo ChannelFloat32 CompressedImage FluidPressure Illuminance Image Imu
            JointState Joy JoyFeedback JoyFeedbackArray LaserEcho LaserScan MagneticField MultiDOFJointState
            MultiEchoLaserScan NavSatFix NavSatStatus PointCloud PointCloud2 PointField Range RegionOfInterest
            RelativeHumidity Temperature TimeReference""",
        "service_msgs": "ServiceEventInfo",
        "shape_msgs": "Mesh MeshTriangle Plane SolidPrimitive",
        "statistics_msgs": "MetricsMessage StatisticDataPoint StatisticDataType",
        "std_msgs": """
            Bool Byte ByteMultiArray Char ColorRGBA Empty Float32 Float32MultiArray Float64 Float64MultiArray
            Header Int16 Int16MultiArray Int32 Int32MultiArray Int64 Int64MultiArray Int8 Int8MultiArray
            MultiArrayDimension MultiArrayLayout String UInt16 UInt16MultiArray UInt32 UInt32MultiArray UInt64
            UInt64MultiArray UInt8 UInt8MultiArray""",
        "stereo_msgs": "DisparityImage",
        "tf2_msgs": "TF2Error TFMessage",
        "trajectory_msgs": "JointTrajectory JointTrajectoryPoint MultiDOFJointTrajectory MultiDOFJointTrajectoryPoint",
        "type_description_interfaces": "Field FieldType IndividualTypeDescription KeyValue TypeDescription TypeSource",
        "unique_identifier_msgs": "UUID",
        "visualization_msgs": """
            ImageMarker InteractiveMarker InteractiveMarkerControl InteractiveMarkerFeedback
            InteractiveMarkerInit InteractiveMarkerPose InteractiveMarkerUpdate Marker MarkerArray MenuEntry
            MeshFile UVCoordinate""",
    }.items()
}

CORE_NEEDS: dict[str, tuple[str, ...]] = {
    package: tuple(needs.split())
    for package, needs in {
        "action_msgs": "builtin_interfaces unique_identifier_msgs service_msgs",
        "actionlib_msgs": "builtin_interfaces std_msgs",
        "builtin_interfaces": "",
        "composition_interfaces": "rcl_interfaces",
        "diagnostic_msgs": "std_msgs",
        "geometry_msgs": "std_msgs",
        "lifecycle_msgs": "",
        "nav_msgs": "builtin_interfaces geometry_msgs std_msgs",
        "rcl_interfaces": "builtin_interfaces",
        "rosgraph_msgs": "builtin_interfaces",
        "sensor_msgs": "builtin_interfaces geometry_msgs std_msgs",
        "service_msgs": "builtin_interfaces",
        "shape_msgs": "geometry_msgs",
        "statistics_msgs": "builtin_interfaces",
        "std_msgs": "builtin_interfaces",
        "std_srvs": "",
        "stereo_msgs": "sensor_msgs std_msgs",
        "tf2_msgs": "builtin_interfaces geometry_msgs",
        "trajectory_msgs": "builtin_interfaces geometry_msgs std_msgs",
        "type_description_interfaces": "",
        "unique_identifier_msgs": "",
        "visualization_msgs": "builtin_interfaces geometry_msgs sensor_msgs std_msgs",
    }.items()
}
"""The packages whose interfaces each of them links, and so passes on."""
