// The side of a session's state that its clients see.

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "console/gateway/session_state.h"

namespace tacit::gateway {
namespace {

/// Names that a client may follow; whoever needs more follows all.
constexpr std::size_t kMostFollowed = 1000;

}  // namespace

ClientPtr SessionState::join(std::function<void()> wake) {
  const std::scoped_lock lock(mutex_);
  if (closed_) {
    return nullptr;
  }
  auto client = std::make_shared<SessionClient>(limits_);
  client->wake = std::move(wake);
  clients_.insert(client);
  greet(*client);
  return client;
}

void SessionState::greet(SessionClient& client) {
  push(client, messages::server_info(name_, id_));
  messages::Json channels = messages::Json::array();
  for (const auto& [id, open] : channels_) {
    channels.push_back(messages::channel(id, open.channel));
  }
  if (!channels.empty()) {
    push(client, messages::advertise(std::move(channels)));
  }
  messages::Json services = messages::Json::array();
  for (const auto& [id, open] : services_) {
    services.push_back(messages::service(id, open.service));
  }
  if (!services.empty()) {
    push(client, messages::advertise_services(std::move(services)));
  }
  for (const auto& [id, status] : statuses_) {
    push(client, messages::status(status.level, status.message, id));
  }
  if (time_ns_) {
    client.outbox.set_time(messages::time(*time_ns_));
  }
}

void SessionState::leave(const ClientPtr& client) {
  const std::scoped_lock lock(mutex_);
  for (const auto& [subscription, channel] : client->subscriptions) {
    drop_subscriber(channel, client);
  }
  client->subscriptions.clear();
  client->closing = true;
  client->wake = nullptr;
  clients_.erase(client);
}

SessionState::Fate SessionState::fate(const ClientPtr& client) const {
  const std::scoped_lock lock(mutex_);
  if (client->stalled) {
    return Fate::Stalled;
  }
  return client->closing ? Fate::Go : Fate::Stay;
}

std::optional<Frame> SessionState::next(const ClientPtr& client) {
  const std::scoped_lock lock(mutex_);
  auto frame = client->outbox.pop();
  client->awake = frame.has_value();
  return frame;
}

SessionState::Reason SessionState::subscribe(const ClientPtr& client, std::uint32_t subscription,
                                             ChannelId channel) {
  const std::scoped_lock lock(mutex_);
  const auto found = channels_.find(channel);
  if (found == channels_.end()) {
    return "there is no channel " + std::to_string(channel);
  }
  OpenChannel& open = found->second;
  const bool twice = std::any_of(open.subscribers.begin(), open.subscribers.end(),
                                 [&](const auto& other) { return other.first == client; });
  if (twice) {
    return "channel " + std::to_string(channel) + " has a subscription already";
  }
  if (!client->subscriptions.emplace(subscription, channel).second) {
    return "subscription " + std::to_string(subscription) + " is in use";
  }
  open.subscribers.emplace_back(client, subscription);
  if (open.latest) {
    send_message(open, channel, open.subscribers.size() - 1, open.latest, open.latest_ns);
  }
  return {};
}

SessionState::Reason SessionState::unsubscribe(const ClientPtr& client,
                                               std::uint32_t subscription) {
  const std::scoped_lock lock(mutex_);
  const auto found = client->subscriptions.find(subscription);
  if (found == client->subscriptions.end()) {
    return "there is no subscription " + std::to_string(subscription);
  }
  client->outbox.forget(found->second);
  drop_subscriber(found->second, client);
  client->subscriptions.erase(found);
  return {};
}

void SessionState::drop_subscriber(ChannelId channel, const ClientPtr& client) {
  const auto open = channels_.find(channel);
  if (open != channels_.end()) {
    std::erase_if(open->second.subscribers,
                  [&](const auto& subscriber) { return subscriber.first == client; });
  }
}

void SessionState::call(const ClientPtr& client, ServiceId service, std::uint32_t call,
                        std::string_view request) {
  const auto handler = begin_call(*client, service, call);
  if (!handler) {
    return;
  }
  const ServiceReply reply([state = weak_from_this(), to = std::weak_ptr(client), service, call](
                               bool ok, std::string_view text) {
    const auto self = state.lock();
    const auto asker = to.lock();
    if (self && asker) {
      self->end_call(*asker, ok ? messages::service_response(service, call, text)
                                : messages::service_failure(service, call, text));
    }
  });
  try {
    (*handler)(request, reply);
  } catch (const std::exception& failure) {
    reply.fail(failure.what());
  }
}

std::shared_ptr<const ServiceHandler> SessionState::begin_call(SessionClient& client,
                                                               ServiceId service,
                                                               std::uint32_t call) {
  const std::scoped_lock lock(mutex_);
  const auto open = services_.find(service);
  if (open == services_.end()) {
    push(client, messages::service_failure(service, call, "there is no such service"));
    return nullptr;
  }
  if (client.calls >= limits_.calls) {
    push(client, messages::service_failure(service, call, "too many calls are under way"));
    return nullptr;
  }
  ++client.calls;
  return open->second.handler;
}

void SessionState::end_call(SessionClient& client, Frame answer) {
  const std::scoped_lock lock(mutex_);
  --client.calls;
  push(client, std::move(answer));
}

void SessionState::set_parameters(const std::vector<Parameter>& parameters) {
  Values set;
  for (const Parameter& parameter : parameters) {
    auto value = messages::Json::parse(parameter.value, nullptr, false);
    if (value.is_discarded()) {
      throw std::invalid_argument("no JSON: the value of " + parameter.name);
    }
    set[parameter.name] = {std::move(value), parameter.type};
  }
  const std::scoped_lock lock(mutex_);
  for (const auto& [name, value] : set) {
    parameters_[name] = value;
  }
  for (const ClientPtr& client : clients_) {
    Values news;
    for (const auto& [name, value] : set) {
      if (client->followed.contains(name)) {
        news[name] = value;
      }
    }
    if (!news.empty()) {
      push(*client, messages::parameter_values(news, nullptr));
    }
  }
}

void SessionState::on_parameters(ParameterHandler handler) {
  auto next = handler ? std::make_shared<const ParameterHandler>(std::move(handler)) : nullptr;
  const std::scoped_lock lock(mutex_);
  parameter_handler_.swap(next);
}

SessionState::Values SessionState::values_of(const std::set<std::string>& names) const {
  if (names.empty()) {
    return parameters_;
  }
  Values values;
  for (const std::string& name : names) {
    if (const auto found = parameters_.find(name); found != parameters_.end()) {
      values.insert(*found);
    }
  }
  return values;
}

void SessionState::give_parameters(const ClientPtr& client, const std::set<std::string>& names,
                                   const messages::Json& question) {
  const std::scoped_lock lock(mutex_);
  push(*client, messages::parameter_values(values_of(names), question));
}

void SessionState::follow_parameters(const ClientPtr& client, const std::set<std::string>& names) {
  const std::scoped_lock lock(mutex_);
  if (names.empty()) {
    for (const auto& [name, value] : parameters_) {
      client->followed.insert(name);
    }
  }
  for (const std::string& name : names) {
    if (client->followed.size() < kMostFollowed) {
      client->followed.insert(name);
    }
  }
}

void SessionState::unfollow_parameters(const ClientPtr& client,
                                       const std::set<std::string>& names) {
  const std::scoped_lock lock(mutex_);
  if (names.empty()) {
    client->followed.clear();
  }
  for (const std::string& name : names) {
    client->followed.erase(name);
  }
}

SessionState::Reason SessionState::wish_parameters(const std::vector<Parameter>& wanted) {
  std::shared_ptr<const ParameterHandler> handler;
  {
    const std::scoped_lock lock(mutex_);
    handler = parameter_handler_;
  }
  if (!handler) {
    return "parameters cannot be set here";
  }
  try {
    (*handler)(wanted);
  } catch (const std::exception& failure) {
    return failure.what();
  }
  return {};
}

void SessionState::follow_graph(const ClientPtr& client, bool follow) {
  const std::scoped_lock lock(mutex_);
  if (follow && !client->follows_graph) {
    push(*client, messages::graph_update({}, graph_));
  }
  client->follows_graph = follow;
}

void SessionState::tell(const ClientPtr& client, Frame frame) {
  const std::scoped_lock lock(mutex_);
  push(*client, std::move(frame));
}

}  // namespace tacit::gateway
