#pragma once

#include <string>

namespace std_msgs::msg
{
struct Header
{
  int stamp;
  std::string frame_id;
};
}  // namespace std_msgs::msg

namespace geometry_msgs::msg
{
struct Vector3 {double x, y, z;};
struct Quaternion {double x, y, z, w;};
struct Pose
{
  Vector3 position;
  Quaternion orientation;
};
struct PoseStamped
{
  std_msgs::msg::Header header;
  Pose pose;
};
}  // namespace geometry_msgs::msg
