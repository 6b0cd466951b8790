#include "idl/bus/raw_subscriber.h"

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "idl/bus/listening_reader.h"
#include "idl/bus/opaque_type.h"
#include "idl/bus/wire_of.h"
#include "idl/wire/teamPubSubTypes.h"

namespace tacit {
namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

}  // namespace

template <class Topic>
class RawSubscriber<Topic>::Impl final : public ListeningReader {
  using Support = typename WireOf<typename Topic::Word>::Support;

 public:
  Impl(Participant& participant, RobotId robot, Take take) : robot_(robot), take_(std::move(take)) {
    dds::TypeSupport type(new OpaqueType(Support()));
    open(participant.entities(), topic_name<Topic>(robot), type, Topic::kPromise);
  }
  ~Impl() override { close(); }

 private:
  void on_data_available(dds::DataReader* reader) override {
    dds::SampleInfo info;
    while (reader->take_next_sample(&sample_.bytes, &info) == ReturnCode_t::RETCODE_OK) {
      sample_.robot = robot_;
      if (info.valid_data) take_(sample_);
    }
  }

  RobotId robot_;
  Take take_;
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
