// A stand-in for rclcpp_action: declarations as generated nodes use them.

#ifndef RCLCPP_ACTION__RCLCPP_ACTION_HPP_
#define RCLCPP_ACTION__RCLCPP_ACTION_HPP_

#include <array>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>

namespace rclcpp_action
{

using GoalUUID = std::array<uint8_t, 16>;
enum class GoalResponse : int8_t { REJECT = 1, ACCEPT_AND_EXECUTE = 2, ACCEPT_AND_DEFER = 3 };
enum class CancelResponse : int8_t { REJECT = 1, ACCEPT = 2 };
enum class ResultCode : int8_t { UNKNOWN = 0, SUCCEEDED = 4, CANCELED = 5, ABORTED = 6 };

template<typename T>
class ServerGoalHandle
{
public:
  bool is_canceling() const {return false;}
  std::shared_ptr<const typename T::Goal> get_goal() const {return {};}
  void publish_feedback(std::shared_ptr<typename T::Feedback>) {}
  void succeed(std::shared_ptr<typename T::Result>) {}
  void canceled(std::shared_ptr<typename T::Result>) {}
  void abort(std::shared_ptr<typename T::Result>) {}
};

template<typename T>
class Server
{
public:
  using SharedPtr = std::shared_ptr<Server<T>>;
  using GoalCallback = std::function<GoalResponse(
        const GoalUUID &, std::shared_ptr<const typename T::Goal>)>;
  using CancelCallback = std::function<CancelResponse(std::shared_ptr<ServerGoalHandle<T>>)>;
  using AcceptedCallback = std::function<void (std::shared_ptr<ServerGoalHandle<T>>)>;
};

template<typename T, typename NodeT>
typename Server<T>::SharedPtr create_server(
  NodeT, const std::string &, typename Server<T>::GoalCallback,
  typename Server<T>::CancelCallback, typename Server<T>::AcceptedCallback)
{
  return std::make_shared<Server<T>>();
}

template<typename T>
class ClientGoalHandle
{
public:
  using SharedPtr = std::shared_ptr<ClientGoalHandle<T>>;
  struct WrappedResult
  {
    GoalUUID goal_id;
    ResultCode code;
    std::shared_ptr<typename T::Result> result;
  };
  using FeedbackCallback = std::function<void (
        SharedPtr, const std::shared_ptr<const typename T::Feedback>)>;
  using ResultCallback = std::function<void (const WrappedResult &)>;
};

template<typename T>
class Client
{
public:
  using SharedPtr = std::shared_ptr<Client<T>>;
  using GoalHandle = ClientGoalHandle<T>;
  struct SendGoalOptions
  {
    std::function<void(typename GoalHandle::SharedPtr)> goal_response_callback;
    typename GoalHandle::FeedbackCallback feedback_callback;
    typename GoalHandle::ResultCallback result_callback;
  };
  bool action_server_is_ready() const {return false;}
  std::shared_future<typename GoalHandle::SharedPtr> async_send_goal(
    const typename T::Goal &, const SendGoalOptions & = SendGoalOptions())
  {
    return {};
  }
};

template<typename T, typename NodeT>
typename Client<T>::SharedPtr create_client(NodeT, const std::string &)
{
  return std::make_shared<Client<T>>();
}

}  // namespace rclcpp_action

#endif  // RCLCPP_ACTION__RCLCPP_ACTION_HPP_
