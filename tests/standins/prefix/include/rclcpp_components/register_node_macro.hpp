// A stand-in for rclcpp_components: checks that the class can be made from options, as a container makes it.

#ifndef RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_
#define RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_

#include <memory>

#include "rclcpp/rclcpp.hpp"

#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) \
  std::shared_ptr<NodeClass> make_component(const rclcpp::NodeOptions & options) \
  { \
    return std::make_shared<NodeClass>(options); \
  }

#endif  // RCLCPP_COMPONENTS__REGISTER_NODE_MACRO_HPP_
