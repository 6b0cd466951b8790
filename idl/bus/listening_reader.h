#pragma once

#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include <atomic>
#include <string>

#include "idl/bus/entities.h"
#include "idl/topics/topics.h"

namespace tacit {

/// A reader of Fast DDS that tells itself of what comes, and counts its writers.
class ListeningReader : public eprosima::fastdds::dds::DataReaderListener {
 public:
  ListeningReader() = default;
  ListeningReader(const ListeningReader&) = delete;
  ListeningReader& operator=(const ListeningReader&) = delete;

  /// Writers that are there now. From any thread.
  [[nodiscard]] int writers() const { return writers_.load(std::memory_order_relaxed); }

 protected:
  /// Begins; what `on_data_available` uses is there. Throws BusError.
  void open(Participant::Entities& entities, const std::string& name,
            eprosima::fastdds::dds::TypeSupport& type, Promise promise);
  /// Ends, once, before what `on_data_available` uses goes.
  void close();

 private:
  void on_subscription_matched(
      eprosima::fastdds::dds::DataReader*,
      const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) final;

  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
  eprosima::fastdds::dds::DataReader* reader_ = nullptr;
  std::atomic<int> writers_{0};
};

}  // namespace tacit
