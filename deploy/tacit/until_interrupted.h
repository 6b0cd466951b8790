#pragma once

#include <functional>
#include <stop_token>

namespace tacit {

/// Does `work` on a thread of its own and watches for signals meanwhile; one that asks for an early
/// end asks `work` to stop. Returns once `work` does: whether it was asked to stop. Throws what
/// `work` threw. Call it before there are other threads.
[[nodiscard]] bool until_interrupted(const std::function<void(const std::stop_token&)>& work);

}  // namespace tacit
