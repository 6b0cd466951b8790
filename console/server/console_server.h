#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tacit {

/// Where the console serves from, and what.
struct ConsoleServerConfig {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8080;         ///< 0: any that is free.
  std::string token;                 ///< See gateway::ServerConfig.
  std::vector<std::string> origins;  ///< Pages of other servers that may open sockets.
  std::filesystem::path pages;       ///< Of the page; a plain one when it is not there.
  std::filesystem::path runs;        ///< Folder of run directories.
  std::filesystem::path programs;    ///< Where `tacit` and `wizard_service` lie.
  std::string cases;                 ///< Case base; empty: the wizard's own.
  std::vector<std::filesystem::path> maps;
  std::vector<std::filesystem::path> missions;
  std::vector<std::filesystem::path> scenarios;
};

/// The page, the REST interface and the socket of all runs in a folder.
class ConsoleServer {
 public:
  /// Begins to serve. Throws gateway::ServerError when the address cannot be had, ConfigError when
  /// the folder of runs cannot be made.
  explicit ConsoleServer(const ConsoleServerConfig& config);
  ~ConsoleServer();
  ConsoleServer(const ConsoleServer&) = delete;
  ConsoleServer& operator=(const ConsoleServer&) = delete;

  /// Where a browser finds it.
  [[nodiscard]] std::string url() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tacit
