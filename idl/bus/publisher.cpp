#include "idl/bus/publisher.h"

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include <atomic>
#include <exception>

#include "idl/bus/convert_events.h"
#include "idl/bus/convert_lockstep.h"
#include "idl/bus/convert_team.h"
#include "idl/bus/convert_views.h"
#include "idl/bus/convert_wizard.h"
#include "idl/bus/entities.h"
#include "idl/bus/qos.h"
#include "idl/bus/wire_of.h"
#include "idl/wire/lockstepPubSubTypes.h"
#include "idl/wire/teamPubSubTypes.h"
#include "idl/wire/wizardPubSubTypes.h"

namespace tacit {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

template <class Topic>
class Publisher<Topic>::Impl final : public dds::DataWriterListener {
  using Wire = typename WireOf<Word>::Wire;
  using Support = typename WireOf<Word>::Support;

 public:
  Impl(Participant::Entities& entities, RobotId robot, Promise promise)
      : publisher_(*entities.publisher), shares_memory_(promise == Promise::EveryTick) {
    const std::string name = topic_name<Topic>(robot);
    dds::TypeSupport type(new Support());
    dds::DataWriterQos qos = dds::DATAWRITER_QOS_DEFAULT;
    qos::set_writer(qos, promise);
    writer_ = publisher_.create_datawriter(entities.topic(name, type), qos, this,
                                           dds::StatusMask::publication_matched());
    if (writer_ == nullptr) {
      throw BusError("no writer could be made for " + name + " on " + entities.where);
    }
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() override {
    writer_->set_listener(nullptr);
    publisher_.delete_datawriter(writer_);
  }

  /// A reader in shared memory that was killed while it held its lock makes Fast DDS throw. To the
  /// others the sample may be lost, as it may anyway. Whatever is thrown elsewhere is a fault.
  bool publish(const Word& word) {
    if (!shares_memory_) return write(word);
    try {
      return write(word);
    } catch (const std::exception&) {
      return false;
    }
  }

  bool wait_received(std::chrono::milliseconds patience) {
    const auto s = std::chrono::duration_cast<std::chrono::seconds>(patience);
    const auto ns = std::chrono::nanoseconds(patience - s);
    return writer_->wait_for_acknowledgments(
               {static_cast<std::int32_t>(s.count()), static_cast<std::uint32_t>(ns.count())}) ==
           ReturnCode_t::RETCODE_OK;
  }

  int readers() const { return readers_.load(std::memory_order_relaxed); }

 private:
  /// Lending memory costs more than copying a small sample.
  static constexpr bool kInPlace =
      Topic::kPromise == Promise::EveryTick && sizeof(Wire) > kSmallSample;

  bool write(const Word& word) {
    if constexpr (kInPlace) {
      if (publish_in_place(word)) return true;
    }
    to_wire(word, scratch_);
    return writer_->write(&scratch_);
  }

  /// Writes straight into memory that the readers share; false when none is free.
  bool publish_in_place(const Word& word) {
    void* sample = nullptr;
    if (writer_->loan_sample(sample) != ReturnCode_t::RETCODE_OK) return false;
    to_wire(word, *static_cast<Wire*>(sample));
    return writer_->write(sample);
  }

  void on_publication_matched(dds::DataWriter*, const dds::PublicationMatchedStatus& s) override {
    readers_.store(s.current_count, std::memory_order_relaxed);
  }

  dds::Publisher& publisher_;
  dds::DataWriter* writer_ = nullptr;
  bool shares_memory_;
  std::atomic<int> readers_{0};
  Wire scratch_;
};

template <class Topic>
Publisher<Topic>::Publisher(Participant& participant, RobotId robot, Promise promise)
    : impl_(std::make_unique<Impl>(participant.entities(), robot, promise)) {}
template <class Topic>
Publisher<Topic>::~Publisher() = default;
template <class Topic>
Publisher<Topic>::Publisher(Publisher&&) noexcept = default;
template <class Topic>
Publisher<Topic>& Publisher<Topic>::operator=(Publisher&&) noexcept = default;

template <class Topic>
bool Publisher<Topic>::publish(const Word& word) {
  return impl_->publish(word);
}
template <class Topic>
int Publisher<Topic>::readers() const {
  return impl_->readers();
}
template <class Topic>
bool Publisher<Topic>::wait_received(std::chrono::milliseconds patience) {
  return impl_->wait_received(patience);
}

template class Publisher<topics::Percept>;
template class Publisher<topics::Command>;
template class Publisher<topics::Order>;
template class Publisher<topics::Telemetry>;
template class Publisher<topics::Hello>;
template class Publisher<topics::Events>;
template class Publisher<topics::WorldView>;
template class Publisher<topics::Trajectory>;
template class Publisher<topics::Control>;
template class Publisher<topics::Status>;
template class Publisher<topics::WizardRequest>;
template class Publisher<topics::WizardReply>;

}  // namespace tacit
