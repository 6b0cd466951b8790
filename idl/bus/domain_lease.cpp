#include "idl/bus/domain_lease.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <string>

#include "idl/bus/identity.h"
#include "idl/bus/leftovers.h"
#include "idl/bus/lock_file.h"
#include "idl/bus/participant.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

bool is_port_free(std::uint16_t port) {
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool free = bind(probe, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  close(probe);
  return free;
}

void clean_up_after_last_holder(int file) {
  char text[16] = {};
  std::uint32_t nonce = 0;
  const ssize_t size = pread(file, text, sizeof text, 0);
  if (size <= 0) return;
  if (std::from_chars(text, text + size, nonce, 16).ec == std::errc{}) remove_leftovers(nonce);
}

void write_nonce(int file, std::uint32_t nonce) {
  char text[16];
  const auto end = std::to_chars(text, text + sizeof text, nonce, 16).ptr;
  const auto size = static_cast<std::size_t>(end - text);
  if (ftruncate(file, 0) != 0 || pwrite(file, text, size, 0) != static_cast<ssize_t>(size)) {
    throw BusError(std::string("a domain lease cannot be written: ") + std::strerror(errno));
  }
}

}  // namespace

DomainLease DomainLease::take(std::uint32_t run_nonce, const fs::path& folder) {
  make_private(folder);
  for (int domain = kFirst; domain <= kLast; ++domain) {
    const int file = open_locked(folder / ("domain-" + std::to_string(domain) + ".lock"));
    if (file < 0) continue;
    if (!is_port_free(discovery_port(domain))) {
      close(file);
      continue;
    }
    DomainLease lease(domain, file);
    clean_up_after_last_holder(file);
    write_nonce(file, run_nonce);
    return lease;
  }
  throw BusError("none of the DDS domains " + std::to_string(kFirst) + " to " +
                 std::to_string(kLast) + " is free; " + folder.string() +
                 " holds a lease for each run that is going on");
}

DomainLease::~DomainLease() {
  if (file_ < 0) return;
  // The file stays: removing it would let two processes lock two files of one name.
  [[maybe_unused]] const int emptied = ftruncate(file_, 0);
  close(file_);
}

}  // namespace tacit
