// A stand-in for rclcpp_lifecycle: declarations as generated nodes use them.

#ifndef RCLCPP_LIFECYCLE__LIFECYCLE_PUBLISHER_HPP_
#define RCLCPP_LIFECYCLE__LIFECYCLE_PUBLISHER_HPP_

#include "rclcpp/rclcpp.hpp"

namespace rclcpp_lifecycle
{

template<typename T>
class LifecyclePublisher : public rclcpp::Publisher<T> {};

}  // namespace rclcpp_lifecycle

#endif  // RCLCPP_LIFECYCLE__LIFECYCLE_PUBLISHER_HPP_
