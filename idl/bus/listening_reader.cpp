#include "idl/bus/listening_reader.h"

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "idl/bus/qos.h"

namespace tacit {

namespace dds = eprosima::fastdds::dds;

void ListeningReader::open(Participant::Entities& entities, const std::string& name,
                           dds::TypeSupport& type, Promise promise) {
  dds::DataReaderQos qos = dds::DATAREADER_QOS_DEFAULT;
  qos::set_reader(qos, promise);
  subscriber_ = entities.subscriber;
  reader_ = subscriber_->create_datareader(entities.topic(name, type), qos, this,
                                           dds::StatusMask::data_available()
                                               << dds::StatusMask::subscription_matched());
  if (reader_ == nullptr) {
    throw BusError("no reader could be made for " + name + " on " + entities.where);
  }
}

void ListeningReader::close() {
  reader_->set_listener(nullptr);
  subscriber_->delete_datareader(reader_);
}

void ListeningReader::on_subscription_matched(dds::DataReader*,
                                              const dds::SubscriptionMatchedStatus& status) {
  writers_.store(status.current_count, std::memory_order_relaxed);
}

}  // namespace tacit
