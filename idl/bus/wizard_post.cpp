#include "idl/bus/wizard_post.h"

#include <unistd.h>

#include <string>

#include "idl/bus/participant.h"

namespace tacit {
namespace {

namespace fs = std::filesystem;

int lock(int domain, const fs::path& folder) {
  make_private(folder);
  return open_locked(folder / ("wizard-" + std::to_string(domain) + ".lock"));
}

}  // namespace

WizardPost::WizardPost(int domain, const fs::path& folder) : file_(lock(domain, folder)) {
  if (file_ < 0) {
    throw BusError("a wizard serves domain " + std::to_string(domain) + " already");
  }
}

WizardPost::~WizardPost() { close(file_); }

bool WizardPost::is_held(int domain, const fs::path& folder) {
  const int file = lock(domain, folder);
  if (file >= 0) close(file);
  return file < 0;
}

}  // namespace tacit
