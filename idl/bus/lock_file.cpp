#include "idl/bus/lock_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "idl/bus/participant.h"

namespace tacit {

namespace fs = std::filesystem;

fs::path lease_folder() {
  const char* runtime = std::getenv("XDG_RUNTIME_DIR");
  if (runtime != nullptr && *runtime != '\0') return fs::path(runtime) / "tacit";
  return "/tmp/tacit-" + std::to_string(geteuid());
}

void make_private(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  struct stat status {};
  const bool there =
      (mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST) && lstat(folder.c_str(), &status) == 0;
  if (!there || !S_ISDIR(status.st_mode) || status.st_uid != geteuid()) {
    throw BusError("the folder for domain leases, " + folder.string() +
                   ", is not a folder of this user that can be written to");
  }
}

int open_locked(const fs::path& path) {
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (file < 0) throw BusError(path.string() + ": " + std::strerror(errno));
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  close(file);
  return -1;
}

}  // namespace tacit
