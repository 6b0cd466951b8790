#pragma once

#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <functional>
#include <vector>

namespace tacit {

/// Stands for a wire type, which it resembles in all that Fast DDS compares: name, size and that it
/// has a key or has none. Its samples are `std::vector<std::uint8_t>`.
class OpaqueType final : public eprosima::fastdds::dds::TopicDataType {
 public:
  explicit OpaqueType(const eprosima::fastdds::dds::TopicDataType& like) {
    setName(like.getName());
    m_typeSize = like.m_typeSize;
    m_isGetKeyDefined = like.m_isGetKeyDefined;
  }
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    static_cast<Bytes*>(data)->assign(payload->data, payload->data + payload->length);
    return payload->length >= kEncapsulation;
  }
  void* createData() override { return new Bytes; }
  void deleteData(void* data) override { delete static_cast<Bytes*>(data); }

  // Nobody writes bytes, and nobody asks for their key.
  bool serialize(void*, eprosima::fastrtps::rtps::SerializedPayload_t*) override { return false; }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [] { return 0U; };
  }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }

 private:
  using Bytes = std::vector<std::uint8_t>;
  static constexpr std::uint32_t kEncapsulation = 4;
};

}  // namespace tacit
