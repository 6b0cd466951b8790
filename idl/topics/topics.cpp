#include "idl/topics/topics.h"

#include <algorithm>

namespace tacit {
namespace {

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size() + 1, width), ' ');
  return text;
}

std::string line(const char* verb, const std::string& topic, Promise promise) {
  return padded(verb, 8) + padded(topic, 28) + name(promise) + "\n";
}

std::string shown_name(Scope scope, std::string_view name) {
  switch (scope) {
    case Scope::Robot:
      return "tacit/robot_<id>/" + std::string(name);
    case Scope::Client:
      return "tacit/client_<box>/" + std::string(name);
    case Scope::Team:
      break;
  }
  return "tacit/" + std::string(name);
}

}  // namespace

std::string topic_name(Scope scope, std::string_view name, RobotId robot) {
  const std::string number = std::to_string(robot.value);
  switch (scope) {
    case Scope::Robot:
      return "tacit/robot_" + number + "/" + std::string(name);
    case Scope::Client:
      return "tacit/client_" + number + "/" + std::string(name);
    case Scope::Team:
      break;
  }
  return "tacit/" + std::string(name);
}

const char* name(Promise promise) {
  switch (promise) {
    case Promise::EveryTick:
      return "every tick";
    case Promise::Answer:
      return "answer";
    case Promise::Glimpse:
      return "glimpse";
    case Promise::LatestState:
      return "latest state";
    case Promise::MustArrive:
      return "must arrive";
    case Promise::NoGaps:
      return "no gaps";
    case Promise::Question:
      return "question";
  }
  return "";
}

std::string interface_text(Party party) {
  std::string reads;
  std::string writes;
  for_each_topic([&](auto topic) {
    using Topic = decltype(topic);
    const std::string shown = shown_name(Topic::kScope, Topic::kName);
    if (Topic::kReaders.contains(party)) reads += line("reads", shown, Topic::kPromise);
    if (Topic::kWriters.contains(party)) writes += line("writes", shown, Topic::kPromise);
  });
  return reads + writes;
}

}  // namespace tacit
