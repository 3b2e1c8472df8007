// A stand-in for rclcpp: declarations as generated nodes use them, so that they compile and link.
// Signatures are those of rclcpp 16 to 28; nothing here runs a node.

#ifndef RCLCPP__RCLCPP_HPP_
#define RCLCPP__RCLCPP_HPP_

#include <cstdio>
#include <functional>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"

namespace rclcpp
{

inline void init(int, char const * const *) {}
inline bool shutdown() {return true;}
inline bool ok() {return true;}

namespace exceptions
{
class RCLError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}  // namespace exceptions

class Logger {};

__attribute__((format(printf, 2, 3))) inline void log(const Logger &, const char * format, ...)
{
  std::puts(format);
}

#define RCLCPP_INFO(logger, ...) rclcpp::log(logger, __VA_ARGS__)
#define RCLCPP_WARN(logger, ...) rclcpp::log(logger, __VA_ARGS__)
#define RCLCPP_INFO_ONCE(logger, ...) rclcpp::log(logger, __VA_ARGS__)

class Clock
{
public:
  using SharedPtr = std::shared_ptr<Clock>;
};

/// A point in time, that becomes a message where one is wanted.
class Time
{
public:
  template<typename MessageT>
  operator MessageT() const {return MessageT();}
};

class Duration
{
public:
  static Duration from_seconds(double) {return {};}
};

class QoS
{
public:
  QoS(std::size_t) {}  // NOLINT: rclcpp's is implicit too
  QoS & best_effort() {return *this;}
  QoS & transient_local() {return *this;}
};

class SensorDataQoS : public QoS
{
public:
  SensorDataQoS()
  : QoS(5) {}
};

class NodeOptions {};

class TimerBase
{
public:
  using SharedPtr = std::shared_ptr<TimerBase>;
  void cancel() {}
  std::function<void()> callback;
};

template<typename T>
class Publisher
{
public:
  using SharedPtr = std::shared_ptr<Publisher<T>>;
  virtual ~Publisher() = default;
  virtual void publish(const T &) {}
  virtual void publish(std::unique_ptr<T>) {}
};

template<typename T>
class Subscription
{
public:
  using SharedPtr = std::shared_ptr<Subscription<T>>;
};

template<typename T>
class Service
{
public:
  using SharedPtr = std::shared_ptr<Service<T>>;
};

template<typename T>
class Client
{
public:
  using SharedPtr = std::shared_ptr<Client<T>>;
  using SharedFuture = std::shared_future<std::shared_ptr<typename T::Response>>;
  bool service_is_ready() const {return false;}
  void async_send_request(std::shared_ptr<typename T::Request>, std::function<void(SharedFuture)>) {}
};

class Parameter
{
public:
  const std::string & get_name() const {return text_;}
  const std::string & as_string() const {return text_;}

private:
  std::string text_;
};

namespace node_interfaces
{
class OnSetParametersCallbackHandle
{
public:
  using SharedPtr = std::shared_ptr<OnSetParametersCallbackHandle>;
};

class NodeBaseInterface
{
public:
  using SharedPtr = std::shared_ptr<NodeBaseInterface>;
};
}  // namespace node_interfaces

class Node
{
public:
  using SharedPtr = std::shared_ptr<Node>;
  explicit Node(const std::string &, const NodeOptions & = NodeOptions()) {}
  virtual ~Node() = default;
  Logger get_logger() const {return {};}
  Clock::SharedPtr get_clock() {return {};}

  Time now() {return {};}
  node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return {};}

  template<typename T>
  auto declare_parameter(
    const std::string &, const T & value,
    const rcl_interfaces::msg::ParameterDescriptor & = rcl_interfaces::msg::ParameterDescriptor())
  {
    return T(value);
  }

  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
    std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<Parameter> &)>) {return {};}

  template<typename T>
  typename Publisher<T>::SharedPtr create_publisher(const std::string &, const QoS &) {return {};}

  template<typename T, typename CallbackT>
  typename Subscription<T>::SharedPtr create_subscription(
    const std::string &, const QoS &, CallbackT && callback)
  {
    const std::function<void(const T &)> typed = callback;
    return typed ? nullptr : nullptr;
  }

  template<typename T, typename CallbackT>
  typename Service<T>::SharedPtr create_service(const std::string &, CallbackT && callback)
  {
    const std::function<void(
        std::shared_ptr<typename T::Request>, std::shared_ptr<typename T::Response>)> typed = callback;
    return typed ? nullptr : nullptr;
  }

  template<typename T>
  typename Client<T>::SharedPtr create_client(const std::string &) {return {};}
};

template<typename NodeT, typename CallbackT>
TimerBase::SharedPtr create_timer(NodeT node, Clock::SharedPtr, Duration, CallbackT && callback)
{
  node->get_node_base_interface();
  auto timer = std::make_shared<TimerBase>();
  timer->callback = std::forward<CallbackT>(callback);
  return timer;
}

inline void spin(Node::SharedPtr) {}
inline void spin(node_interfaces::NodeBaseInterface::SharedPtr) {}

}  // namespace rclcpp

#endif  // RCLCPP__RCLCPP_HPP_
