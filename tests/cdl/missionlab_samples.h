#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace tacit::cdl {

struct SampleFile {
  std::string name;
  std::string text;
};

/// Where MissionLab's own missions are looked for; they are not part of the tree.
inline std::filesystem::path missionlab_folder() {
  const char* named = std::getenv("TACIT_MISSIONLAB_SAMPLES");
  return named != nullptr ? named : TACIT_SOURCE_DIR "/../shared/missionlab-samples";
}

/// MissionLab's own missions; none where there is no such folder.
inline std::vector<SampleFile> missionlab_samples() {
  std::vector<SampleFile> samples;
  const std::filesystem::path folder = missionlab_folder();
  if (!std::filesystem::is_directory(folder)) {
    return samples;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".cdl") {
      std::ifstream in(entry.path(), std::ios::binary);
      samples.push_back({entry.path().filename().string(),
                         {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}});
    }
  }
  return samples;
}

}  // namespace tacit::cdl
