// A stand-in for rclcpp_lifecycle: declarations as generated nodes use them.

#ifndef RCLCPP_LIFECYCLE__LIFECYCLE_NODE_HPP_
#define RCLCPP_LIFECYCLE__LIFECYCLE_NODE_HPP_

#include <memory>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"

namespace rclcpp_lifecycle
{

class State {};

namespace node_interfaces
{
class LifecycleNodeInterface
{
public:
  enum class CallbackReturn : uint8_t { SUCCESS = 97, FAILURE = 98, ERROR = 99 };
  virtual ~LifecycleNodeInterface() = default;
  virtual CallbackReturn on_configure(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_cleanup(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_shutdown(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_activate(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_deactivate(const State &) {return CallbackReturn::SUCCESS;}
  virtual CallbackReturn on_error(const State &) {return CallbackReturn::SUCCESS;}
};
}  // namespace node_interfaces

/// Not an rclcpp::Node: the real one is none either, so `spin(node)` does not compile.
class LifecycleNode : public node_interfaces::LifecycleNodeInterface
{
public:
  explicit LifecycleNode(
    const std::string &, const rclcpp::NodeOptions & = rclcpp::NodeOptions(), bool = true) {}
  rclcpp::Logger get_logger() const {return {};}
  rclcpp::Clock::SharedPtr get_clock() {return {};}
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return {};}

  template<typename T>
  auto declare_parameter(
    const std::string &, const T & value,
    const rcl_interfaces::msg::ParameterDescriptor & = rcl_interfaces::msg::ParameterDescriptor())
  {
    return T(value);
  }

  template<typename T>
  std::shared_ptr<LifecyclePublisher<T>> create_publisher(const std::string &, const rclcpp::QoS &)
  {
    return std::make_shared<LifecyclePublisher<T>>();
  }
};

}  // namespace rclcpp_lifecycle

#endif  // RCLCPP_LIFECYCLE__LIFECYCLE_NODE_HPP_
