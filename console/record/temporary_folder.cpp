#include "console/record/temporary_folder.h"

#include <stdlib.h>

#include <stdexcept>
#include <system_error>

namespace tacit {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder(const std::string& name) {
  std::string made = (fs::temp_directory_path() / (name + "-XXXXXX")).string();
  if (::mkdtemp(made.data()) == nullptr) throw std::runtime_error(made + ": cannot be made");
  path_ = made;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

}  // namespace tacit
