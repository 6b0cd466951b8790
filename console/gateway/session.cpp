#include "console/gateway/session.h"

#include <atomic>
#include <utility>

#include "console/gateway/session_state.h"

namespace tacit::gateway {

class ServiceReply::Once {
 public:
  explicit Once(Send send) : send_(std::move(send)) {}
  Once(const Once&) = delete;
  Once& operator=(const Once&) = delete;
  ~Once() { answer(false, "the call was dropped without an answer"); }
  void answer(bool ok, std::string_view text) {
    if (!done_.exchange(true)) {
      send_(ok, text);
    }
  }

 private:
  std::atomic<bool> done_ = false;
  Send send_;
};

ServiceReply::ServiceReply(Send send) : once_(std::make_shared<Once>(std::move(send))) {}
void ServiceReply::ok(std::string_view json) const { once_->answer(true, json); }
void ServiceReply::fail(std::string_view message) const { once_->answer(false, message); }

Session::Session(std::shared_ptr<SessionState> state) : state_(std::move(state)) {}
Session::~Session() = default;

const std::string& Session::id() const { return state_->id(); }

ChannelId Session::advertise(const Channel& channel) { return state_->advertise(channel); }

void Session::unadvertise(ChannelId channel) { state_->unadvertise(channel); }

void Session::publish(ChannelId channel, std::uint64_t log_time_ns, Payload bytes) {
  state_->publish(channel, log_time_ns, bytes);
}

void Session::publish(ChannelId channel, std::uint64_t log_time_ns,
                      std::span<const std::uint8_t> bytes) {
  if (state_->wants(channel)) {
    state_->publish(channel, log_time_ns,
                    std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end()));
  }
}

std::size_t Session::subscribers(ChannelId channel) const { return state_->subscribers(channel); }

std::size_t Session::clients() const { return state_->clients(); }

void Session::set_time(std::uint64_t time_ns) { state_->set_time(time_ns); }

ServiceId Session::add_service(const Service& service, ServiceHandler handler) {
  return state_->add_service(service, std::move(handler));
}

void Session::remove_service(ServiceId service) { state_->remove_service(service); }

void Session::set_parameters(const std::vector<Parameter>& parameters) {
  state_->set_parameters(parameters);
}

void Session::on_parameters(ParameterHandler handler) { state_->on_parameters(std::move(handler)); }

void Session::set_connection_graph(const ConnectionGraph& graph) {
  state_->set_connection_graph(graph);
}

void Session::status(StatusLevel level, std::string_view message, std::string_view id) {
  state_->status(level, message, id);
}

void Session::remove_status(std::string_view id) { state_->remove_status(id); }

}  // namespace tacit::gateway
