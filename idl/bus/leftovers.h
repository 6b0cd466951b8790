#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace tacit {

/// The files in shared memory that belong to participants of the run: what its living processes
/// use, and what its killed ones could not take away. Only files of this user.
[[nodiscard]] std::vector<std::filesystem::path> leftovers(std::uint32_t run_nonce);

/// Removes them; for when the run's processes are gone. Returns how many went.
std::size_t remove_leftovers(std::uint32_t run_nonce);

}  // namespace tacit
