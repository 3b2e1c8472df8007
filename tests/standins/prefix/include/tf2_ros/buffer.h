// A stand-in for tf2_ros: signatures of geometry2 (humble d0dbd516, jazzy 646342c6, rolling 1b005c65).

#ifndef TF2_ROS__BUFFER_H_
#define TF2_ROS__BUFFER_H_

#include <stdexcept>
#include <string>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"

namespace tf2
{
class TransformException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct TimePoint {};
constexpr TimePoint TimePointZero;

class BufferCore {};
}  // namespace tf2

namespace tf2_ros
{
class Buffer : public tf2::BufferCore
{
public:
  explicit Buffer(rclcpp::Clock::SharedPtr) {}
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string &, const std::string &, const tf2::TimePoint &) const
  {
    return geometry_msgs::msg::TransformStamped();
  }
};
}  // namespace tf2_ros

#endif  // TF2_ROS__BUFFER_H_
