#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rclcpp/duration.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace hardware_interface
{
#ifdef HUMBLE
class LoanedStateInterface
{
public:
  double get_value() const {return 0.0;}
};

class LoanedCommandInterface
{
public:
  void set_value(double) {}
};
#else
class LoanedStateInterface
{
public:
  template<typename T = double>
  [[nodiscard]] std::optional<T> get_optional(unsigned int = 10) const {return T();}
};

class LoanedCommandInterface
{
public:
  template<typename T>
  [[nodiscard]] bool set_value(const T &, unsigned int = 10) {return true;}
};
#endif
}  // namespace hardware_interface

namespace controller_interface
{
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
enum class return_type {OK, ERROR};
enum class interface_configuration_type {ALL = 0, INDIVIDUAL = 1, NONE = 2};

struct InterfaceConfiguration
{
  interface_configuration_type type;
  std::vector<std::string> names = {};
};

class ControllerInterface : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface
{
public:
  virtual InterfaceConfiguration command_interface_configuration() const = 0;
  virtual InterfaceConfiguration state_interface_configuration() const = 0;
  virtual CallbackReturn on_init() = 0;
  virtual return_type update(const rclcpp::Time &, const rclcpp::Duration &) = 0;
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node() {return nullptr;}
  template<typename T>
  T auto_declare(const std::string &, const T & value) {return value;}

protected:
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;
};
}  // namespace controller_interface
