#pragma once
namespace nav2_core {class GoalChecker {};}
