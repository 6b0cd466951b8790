#pragma once

#include "idl/bus/identity.h"
#include "idl/topics/topics.h"

namespace eprosima::fastdds::dds {
class DataReaderQos;
class DataWriterQos;
class DomainParticipantQos;
}  // namespace eprosima::fastdds::dds

namespace tacit::qos {

/// How promises and transports become Fast DDS settings: the one place.

/// Discovery and small traffic over UDP on 127.0.0.1, with the world's participant as the server,
/// the wizard's among its clients.
void set_participant(eprosima::fastdds::dds::DomainParticipantQos& qos, const Identity& identity);
void set_writer(eprosima::fastdds::dds::DataWriterQos& qos, Promise promise);
void set_reader(eprosima::fastdds::dds::DataReaderQos& qos, Promise promise);

}  // namespace tacit::qos
