#include "idl/bus/qos.h"

#include <fastdds/rtps/attributes/ServerAttributes.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include <algorithm>

namespace tacit::qos {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;

constexpr const char* kLoopback = "127.0.0.1";
/// A sample that was not taken yet is superseded; the second slot lets a writer go on while a
/// reader still holds the first.
constexpr int kEveryTickDepth = 2;
/// How far the reader of a topic without gaps may fall behind before its writer waits.
constexpr int kNoGapsDepth = 512;
/// Questions that a reader may be behind.
constexpr int kQuestionDepth = 64;
const Duration_t kNoGapsPatience{5, 0};
/// The time after which a lost sample of a reliable topic is noticed.
const Duration_t kHeartbeat{0, 50'000'000};
/// The same where somebody waits for a word that may take many datagrams.
const Duration_t kShortHeartbeat{0, 5'000'000};

rtps::GuidPrefix_t to_rtps(const GuidPrefix& prefix) {
  rtps::GuidPrefix_t out;
  std::copy(prefix.begin(), prefix.end(), out.value);
  return out;
}

rtps::Locator_t server_locator(int domain) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  rtps::IPLocator::setIPv4(locator, kLoopback);
  locator.port = discovery_port(domain);
  return locator;
}

rtps::GuidPrefix_t server_prefix(const Identity& identity) {
  const bool of_wizard = identity.party == Party::Wizard || identity.party == Party::Client;
  const Party server = of_wizard ? Party::Wizard : Party::World;
  return to_rtps(guid_prefix({server, {}, identity.domain, identity.run_nonce, 0}));
}

void set_discovery(rtps::BuiltinAttributes& builtin, const Identity& identity) {
  rtps::DiscoverySettings& discovery = builtin.discovery_config;
  discovery.leaseDuration = Duration_t(10, 0);
  discovery.leaseDuration_announcementperiod = Duration_t(2, 0);
  discovery.discoveryServer_client_syncperiod = Duration_t(0, 100'000'000);
  builtin.use_WriterLivelinessProtocol = false;
  builtin.mutation_tries = 2000;
  if (identity.party == Party::World || identity.party == Party::Wizard) {
    discovery.discoveryProtocol = rtps::DiscoveryProtocol::SERVER;
    builtin.metatrafficUnicastLocatorList.push_back(server_locator(identity.domain));
  } else {
    discovery.discoveryProtocol = rtps::DiscoveryProtocol::CLIENT;
    rtps::RemoteServerAttributes server;
    server.guidPrefix = server_prefix(identity);
    server.metatrafficUnicastLocatorList.push_back(server_locator(identity.domain));
    discovery.m_DiscoveryServers.push_back(server);
  }
}

template <class Qos>
void unlimited(Qos& qos) {
  qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;
  qos.resource_limits().max_samples = dds::LENGTH_UNLIMITED;
  qos.resource_limits().max_samples_per_instance = dds::LENGTH_UNLIMITED;
  qos.resource_limits().allocated_samples = 0;
}

template <class Qos>
void bounded(Qos& qos, dds::HistoryQosPolicyKind kind, int depth) {
  qos.history().kind = kind;
  qos.history().depth = depth;
  qos.resource_limits().max_samples = depth;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = depth;
  qos.resource_limits().allocated_samples = kind == dds::KEEP_LAST_HISTORY_QOS ? depth : 0;
}

/// What reader and writer have in common.
template <class Qos>
void set_endpoint(Qos& qos, Promise promise) {
  const bool reliable =
      promise != Promise::EveryTick && promise != Promise::Answer && promise != Promise::Glimpse;
  const bool kept = promise == Promise::MustArrive || promise == Promise::LatestState;
  qos.reliability().kind =
      reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind = kept ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_RESERVE_MEMORY_MODE;
  switch (promise) {
    case Promise::EveryTick:
      qos.data_sharing().automatic();
      [[fallthrough]];
    // Whoever shares memory locks what its reader waits on. One that is killed while it holds the
    // lock takes the reader's process with it.
    case Promise::Answer:
      bounded(qos, dds::KEEP_LAST_HISTORY_QOS, kEveryTickDepth);
      qos.endpoint().history_memory_policy = rtps::PREALLOCATED_MEMORY_MODE;
      break;
    case Promise::Glimpse:
    case Promise::LatestState:
      bounded(qos, dds::KEEP_LAST_HISTORY_QOS, 1);
      break;
    case Promise::MustArrive:
      unlimited(qos);
      break;
    case Promise::NoGaps:
      bounded(qos, dds::KEEP_ALL_HISTORY_QOS, kNoGapsDepth);
      break;
    case Promise::Question:
      bounded(qos, dds::KEEP_LAST_HISTORY_QOS, kQuestionDepth);
      break;
  }
}

}  // namespace

void set_participant(dds::DomainParticipantQos& qos, const Identity& identity) {
  auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {kLoopback};
  qos.transport().use_builtin_transports = false;
  qos.transport().user_transports = {udp};
  qos.wire_protocol().prefix = to_rtps(guid_prefix(identity));
  set_discovery(qos.wire_protocol().builtin, identity);
}

void set_writer(dds::DataWriterQos& qos, Promise promise) {
  set_endpoint(qos, promise);
  const bool awaited = promise == Promise::Question || promise == Promise::LatestState;
  qos.publish_mode().kind = dds::SYNCHRONOUS_PUBLISH_MODE;
  qos.reliable_writer_qos().times.heartbeatPeriod = awaited ? kShortHeartbeat : kHeartbeat;
  qos.reliability().max_blocking_time =
      promise == Promise::NoGaps ? kNoGapsPatience : Duration_t(0, 100'000'000);
}

void set_reader(dds::DataReaderQos& qos, Promise promise) {
  set_endpoint(qos, promise);
  qos.reliable_reader_qos().times.heartbeatResponseDelay = Duration_t(0, 1'000'000);
}

}  // namespace tacit::qos
