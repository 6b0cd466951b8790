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

/// MissionLab's own missions in the folder that TACIT_MISSIONLAB_SAMPLES names; none without it.
inline std::vector<SampleFile> missionlab_samples() {
  std::vector<SampleFile> samples;
  const char* folder = std::getenv("TACIT_MISSIONLAB_SAMPLES");
  if (folder == nullptr) {
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
