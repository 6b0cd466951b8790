#pragma once

#include <cstddef>

#include "idl/topics/topics.h"

namespace tacit {

namespace wire {
class Percept;
class PerceptPubSubType;
class Command;
class CommandPubSubType;
class Order;
class OrderPubSubType;
class Telemetry;
class TelemetryPubSubType;
class Hello;
class HelloPubSubType;
class EventBatch;
class EventBatchPubSubType;
class WorldView;
class WorldViewPubSubType;
class Control;
class ControlPubSubType;
class RunStatus;
class RunStatusPubSubType;
class WizardRequest;
class WizardRequestPubSubType;
class WizardReply;
class WizardReplyPubSubType;
}  // namespace wire

/// Up to this many bytes a sample is copied; above, it is handed over where it lies.
inline constexpr std::size_t kSmallSample = 256;

/// The wire type of a word, and what Fast DDS needs to handle it.
template <class WireType, class SupportType>
struct WirePair {
  using Wire = WireType;
  using Support = SupportType;
};

template <class Word>
struct WireOf;
template <>
struct WireOf<Percept> : WirePair<wire::Percept, wire::PerceptPubSubType> {};
template <>
struct WireOf<Command> : WirePair<wire::Command, wire::CommandPubSubType> {};
template <>
struct WireOf<Order> : WirePair<wire::Order, wire::OrderPubSubType> {};
template <>
struct WireOf<Telemetry> : WirePair<wire::Telemetry, wire::TelemetryPubSubType> {};
template <>
struct WireOf<Hello> : WirePair<wire::Hello, wire::HelloPubSubType> {};
template <>
struct WireOf<EventBatch> : WirePair<wire::EventBatch, wire::EventBatchPubSubType> {};
template <>
struct WireOf<WorldView> : WirePair<wire::WorldView, wire::WorldViewPubSubType> {};
template <>
struct WireOf<Control> : WirePair<wire::Control, wire::ControlPubSubType> {};
template <>
struct WireOf<RunStatus> : WirePair<wire::RunStatus, wire::RunStatusPubSubType> {};
template <>
struct WireOf<WizardRequest> : WirePair<wire::WizardRequest, wire::WizardRequestPubSubType> {};
template <>
struct WireOf<WizardReply> : WirePair<wire::WizardReply, wire::WizardReplyPubSubType> {};

}  // namespace tacit
