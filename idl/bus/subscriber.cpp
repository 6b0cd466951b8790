#include "idl/bus/subscriber.h"

#include <fastdds/dds/core/LoanableSequence.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "idl/bus/convert_events.h"
#include "idl/bus/convert_lockstep.h"
#include "idl/bus/convert_team.h"
#include "idl/bus/convert_views.h"
#include "idl/bus/convert_wizard.h"
#include "idl/bus/listening_reader.h"
#include "idl/bus/wire_of.h"
#include "idl/wire/lockstepPubSubTypes.h"
#include "idl/wire/teamPubSubTypes.h"
#include "idl/wire/wizardPubSubTypes.h"

namespace tacit {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::types::ReturnCode_t;

constexpr Flaw kUndecodable{"it cannot be decoded"};

template <class Topic>
class Subscriber<Topic>::Impl final : public ListeningReader {
  using Wire = typename WireOf<Word>::Wire;
  using Support = typename WireOf<Word>::Support;

 public:
  Impl(Participant& participant, RobotId robot, Take take)
      : name_(topic_name<Topic>(robot)),
        rejections_(participant.rejections()),
        take_(std::move(take)) {
    dds::TypeSupport type(new Support());
    open(participant.entities(), name_, type, Topic::kPromise);
  }
  ~Impl() override { close(); }

 private:
  static constexpr bool kOncePerTick =
      Topic::kPromise == Promise::EveryTick || Topic::kPromise == Promise::Answer;
  /// Borrowing memory costs more than copying a small sample.
  static constexpr bool kBorrow = !kOncePerTick || sizeof(Wire) > kSmallSample;

  void on_data_available(dds::DataReader* reader) override {
    if constexpr (kBorrow) {
      while (read_in_place(*reader)) {
      }
    } else {
      read_copy(*reader);
    }
  }

  /// Every sample is announced by itself; one that was announced and is not there was dropped by
  /// Fast DDS, which could not decode it.
  void read_copy(dds::DataReader& reader) {
    dds::SampleInfo info;
    if (reader.take_next_sample(&sample_, &info) != ReturnCode_t::RETCODE_OK) {
      rejections_.add(name_, kUndecodable);
    } else if (info.valid_data) {
      accept(sample_, [] { return true; });
    }
  }

  /// True if there may be more to read.
  bool read_in_place(dds::DataReader& reader) {
    dds::LoanableSequence<Wire> samples;
    dds::SampleInfoSeq infos;
    const ReturnCode_t code = reader.take(samples, infos);
    if (code == ReturnCode_t::RETCODE_NO_DATA) return false;
    if (code != ReturnCode_t::RETCODE_OK) {
      rejections_.add(name_, kUndecodable);
      return false;
    }
    for (dds::LoanableCollection::size_type i = 0; i < samples.length(); ++i) {
      if (infos[i].valid_data)
        accept(samples[i], [&] { return is_whole(reader, samples[i], infos[i]); });
    }
    reader.return_loan(samples, infos);
    return Topic::kPromise != Promise::EveryTick;
  }

  /// A writer that shares its memory may have begun to write over what is being read.
  static bool is_whole(dds::DataReader& reader, const Wire& sample, const dds::SampleInfo& info) {
    return Topic::kPromise != Promise::EveryTick || reader.is_sample_valid(&sample, &info);
  }

  template <class IsWhole>
  void accept(const Wire& sample, IsWhole&& was_whole) {
    const Flaw flaw = from_wire(sample, word_);
    if (!was_whole()) return;
    if (flaw) {
      rejections_.add(name_, flaw);
    } else {
      take_(word_);
    }
  }

  std::string name_;
  Rejections& rejections_;
  Take take_;
  Wire sample_;
  Word word_;
};

template <class Topic>
Subscriber<Topic>::Subscriber(Participant& participant, RobotId robot, Take take)
    : impl_(std::make_unique<Impl>(participant, robot, std::move(take))) {}
template <class Topic>
Subscriber<Topic>::~Subscriber() = default;
template <class Topic>
Subscriber<Topic>::Subscriber(Subscriber&&) noexcept = default;
template <class Topic>
Subscriber<Topic>& Subscriber<Topic>::operator=(Subscriber&&) noexcept = default;

template <class Topic>
int Subscriber<Topic>::writers() const {
  return impl_->writers();
}

template class Subscriber<topics::Percept>;
template class Subscriber<topics::Command>;
template class Subscriber<topics::Order>;
template class Subscriber<topics::Telemetry>;
template class Subscriber<topics::Hello>;
template class Subscriber<topics::Events>;
template class Subscriber<topics::WorldView>;
template class Subscriber<topics::Trajectory>;
template class Subscriber<topics::Control>;
template class Subscriber<topics::Status>;
template class Subscriber<topics::WizardRequest>;
template class Subscriber<topics::WizardReply>;

}  // namespace tacit
