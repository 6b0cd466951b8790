#pragma once

#include <cstdint>
#include <cstring>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <functional>
#include <vector>

#include "idl/bus/entities.h"
#include "idl/bus/qos.h"

namespace tacit::test {

namespace dds = eprosima::fastdds::dds;

using Bytes = std::vector<std::uint8_t>;

/// Sends any bytes under the name of a wire type.
class RawType final : public dds::TopicDataType {
 public:
  explicit RawType(const char* name) {
    setName(name);
    m_typeSize = 4096;
    m_isGetKeyDefined = false;
  }
  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override {
    const Bytes& bytes = *static_cast<Bytes*>(data);
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    return true;
  }
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t*, void*) override { return false; }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    const auto size = static_cast<std::uint32_t>(static_cast<Bytes*>(data)->size());
    return [size] { return size; };
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

template <class Topic, class Support>
class Forger {
 public:
  Forger(Participant& participant, RobotId robot) {
    dds::TypeSupport type(new RawType(Support().getName()));
    dds::DataWriterQos qos = dds::DATAWRITER_QOS_DEFAULT;
    qos::set_writer(qos, Topic::kPromise);
    qos.data_sharing().off();
    Participant::Entities& entities = participant.entities();
    writer_ =
        entities.publisher->create_datawriter(entities.topic(topic_name<Topic>(robot), type), qos);
  }
  void send(Bytes bytes) { writer_->write(&bytes); }

 private:
  dds::DataWriter* writer_ = nullptr;
};

}  // namespace tacit::test
