#include "idl/bus/participant.h"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/log/StdoutErrConsumer.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/PublisherQos.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/SubscriberQos.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "idl/bus/entities.h"
#include "idl/bus/opaque_type.h"
#include "idl/bus/qos.h"

namespace tacit {
namespace {

namespace dds = eprosima::fastdds::dds;

dds::DomainParticipantFactory& factory() { return *dds::DomainParticipantFactory::get_instance(); }

/// Standard output belongs to the program's results.
void send_log_to_standard_error() {
  auto consumer = std::make_unique<dds::StdoutErrConsumer>();
  consumer->stderr_threshold(dds::Log::Kind::Info);
  dds::Log::ClearConsumers();
  dds::Log::RegisterConsumer(std::move(consumer));
}

bool is_opaque(const dds::TypeSupport& type) {
  return dynamic_cast<const OpaqueType*>(type.get()) != nullptr;
}

/// Fast DDS keeps the first of several supports of one name, and hands its samples to all.
void require_same_kind(const dds::DomainParticipant& participant, const dds::TypeSupport& type) {
  if (is_opaque(participant.find_type(type.get_type_name())) != is_opaque(type)) {
    throw BusError(type.get_type_name() + " is read as bytes and as words by one participant");
  }
}

}  // namespace

Participant::Participant(const Identity& identity) : entities_(std::make_unique<Entities>()) {
  send_log_to_standard_error();
  dds::DomainParticipantQos qos;
  qos::set_participant(qos, identity);
  Entities& made = *entities_;
  made.where = "domain " + std::to_string(identity.domain);
  made.participant =
      factory().create_participant(static_cast<dds::DomainId_t>(identity.domain), qos);
  if (made.participant == nullptr) {
    throw BusError("no Fast DDS participant could be made on " + made.where + ": is UDP port " +
                   std::to_string(discovery_port(identity.domain)) +
                   " on 127.0.0.1 taken, or this identity in use?");
  }
  made.publisher = made.participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  made.subscriber = made.participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  if (made.publisher == nullptr || made.subscriber == nullptr) {
    throw BusError("no publisher or subscriber could be made on " + made.where);
  }
}

Participant::~Participant() {
  if (entities_->participant == nullptr) return;
  entities_->participant->delete_contained_entities();
  factory().delete_participant(entities_->participant);
}

dds::Topic* Participant::Entities::topic(const std::string& name, dds::TypeSupport& type) {
  if (auto* known = dynamic_cast<dds::Topic*>(participant->lookup_topicdescription(name))) {
    require_same_kind(*participant, type);
    return known;
  }
  type->auto_fill_type_object(false);
  type->auto_fill_type_information(false);
  type.register_type(participant);
  require_same_kind(*participant, type);
  dds::Topic* made = participant->create_topic(name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  if (made == nullptr) throw BusError("topic " + name + " could not be made on " + where);
  return made;
}

}  // namespace tacit
