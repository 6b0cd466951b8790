#include "idl/bus/raw_subscriber.h"

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <atomic>

#include "idl/bus/entities.h"
#include "idl/bus/opaque_type.h"
#include "idl/bus/qos.h"
#include "idl/bus/wire_of.h"
#include "idl/wire/teamPubSubTypes.h"

namespace tacit {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

}  // namespace

template <class Topic>
class RawSubscriber<Topic>::Impl final : public dds::DataReaderListener {
  using Support = typename WireOf<typename Topic::Word>::Support;

 public:
  Impl(Participant& participant, RobotId robot, Take take)
      : robot_(robot), take_(std::move(take)), subscriber_(*participant.entities().subscriber) {
    dds::TypeSupport type(new OpaqueType(Support()));
    dds::DataReaderQos qos = dds::DATAREADER_QOS_DEFAULT;
    qos::set_reader(qos, Topic::kPromise);
    const std::string name = topic_name<Topic>(robot);
    reader_ = subscriber_.create_datareader(participant.entities().topic(name, type), qos, this,
                                            dds::StatusMask::data_available()
                                                << dds::StatusMask::subscription_matched());
    if (reader_ == nullptr) {
      throw BusError("no reader could be made for " + name + " on " + participant.entities().where);
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() override {
    reader_->set_listener(nullptr);
    subscriber_.delete_datareader(reader_);
  }

  int writers() const { return writers_.load(std::memory_order_relaxed); }

 private:
  void on_data_available(dds::DataReader* reader) override {
    dds::SampleInfo info;
    while (reader->take_next_sample(&sample_.bytes, &info) == ReturnCode_t::RETCODE_OK) {
      sample_.robot = robot_;
      if (info.valid_data) take_(sample_);
    }
  }

  void on_subscription_matched(dds::DataReader*,
                               const dds::SubscriptionMatchedStatus& status) override {
    writers_.store(status.current_count, std::memory_order_relaxed);
  }

  RobotId robot_;
  Take take_;
  dds::Subscriber& subscriber_;
  dds::DataReader* reader_ = nullptr;
  std::atomic<int> writers_{0};
  RawSample sample_;
};

template <class Topic>
RawSubscriber<Topic>::RawSubscriber(Participant& participant, RobotId robot, Take take)
    : impl_(std::make_unique<Impl>(participant, robot, std::move(take))) {}
template <class Topic>
RawSubscriber<Topic>::~RawSubscriber() = default;
template <class Topic>
RawSubscriber<Topic>::RawSubscriber(RawSubscriber&&) noexcept = default;
template <class Topic>
RawSubscriber<Topic>& RawSubscriber<Topic>::operator=(RawSubscriber&&) noexcept = default;

template <class Topic>
int RawSubscriber<Topic>::writers() const {
  return impl_->writers();
}

template class RawSubscriber<topics::WorldView>;
template class RawSubscriber<topics::Trajectory>;
template class RawSubscriber<topics::Events>;
template class RawSubscriber<topics::Status>;
template class RawSubscriber<topics::Telemetry>;

}  // namespace tacit
