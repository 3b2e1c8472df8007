// A stand-in for the message that rosidl makes.

#ifndef GEOMETRY_MSGS__MSG__TRANSFORM_STAMPED_HPP_
#define GEOMETRY_MSGS__MSG__TRANSFORM_STAMPED_HPP_

#include <string>

#include "std_msgs/msg/header.hpp"

namespace geometry_msgs::msg
{
struct Vector3
{
  double x = 0.0, y = 0.0, z = 0.0;
};

struct Quaternion
{
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

struct Transform
{
  Vector3 translation;
  Quaternion rotation;
};

struct TransformStamped
{
  std_msgs::msg::Header header;
  std::string child_frame_id;
  Transform transform;
};
}  // namespace geometry_msgs::msg

#endif  // GEOMETRY_MSGS__MSG__TRANSFORM_STAMPED_HPP_
