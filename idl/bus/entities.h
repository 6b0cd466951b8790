#pragma once

#include <string>

#include "idl/bus/participant.h"

namespace eprosima::fastdds::dds {
class DomainParticipant;
class Publisher;
class Subscriber;
class Topic;
class TypeSupport;
}  // namespace eprosima::fastdds::dds

namespace tacit {

/// The Fast DDS side of a participant.
struct Participant::Entities {
  eprosima::fastdds::dds::DomainParticipant* participant = nullptr;
  eprosima::fastdds::dds::Publisher* publisher = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber = nullptr;
  std::string where;  ///< "domain 3", for messages.

  /// The topic of that name, made at first use. Throws BusError, also when
  /// one of `type` and what its name stands for already is opaque, the other not.
  eprosima::fastdds::dds::Topic* topic(const std::string& name,
                                       eprosima::fastdds::dds::TypeSupport& type);
};

}  // namespace tacit
