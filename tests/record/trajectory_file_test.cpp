#include "console/record/trajectory_file.h"

#include "console/record/record_error.h"
#include "tests/record/full_disk.h"
#include "tests/record/scratch.h"

namespace tacit {
namespace {

using TrajectoryFileTest = ScratchTest;

WorldView a_view() {
  WorldView view;
  view.tick = 20;
  view.robots.push_back({RobotId{3}, {{1.5, 0.1}, Heading{}}, {}, true});
  view.enemies.push_back({EnemyId{8}, EnemyKind::Normal, {2.0, 3.0}});
  view.enemies.push_back({EnemyId{9}, EnemyKind::Decoy, {4.0, 5.0}});
  return view;
}

constexpr const char* kHeader = "tick,id,kind,x_m,y_m,heading_rad\n";
constexpr const char* kBodies = "20,3,robot,1.5,0.1,0\n20,8,normal,2,3,\n20,9,decoy,4,5,\n";

TEST_F(TrajectoryFileTest, HoldsALinePerBody) {
  TrajectoryFile(folder / "t.csv").append(a_view());

  EXPECT_EQ(text_of(folder / "t.csv"), std::string(kHeader) + kBodies);
}

TEST_F(TrajectoryFileTest, HasOneHeaderHoweverOftenItIsOpened) {
  TrajectoryFile(folder / "t.csv").append(a_view());
  TrajectoryFile(folder / "t.csv").append(a_view());

  EXPECT_EQ(text_of(folder / "t.csv"), std::string(kHeader) + kBodies + kBodies);
}

TEST_F(TrajectoryFileTest, HoldsWholeViewsWhenTheDiskIsFull) {
  TrajectoryFile file(folder / "t.csv");
  {
    const FullDisk full(50);
    EXPECT_THROW(file.append(a_view()), RecordError);
  }
  EXPECT_EQ(text_of(folder / "t.csv"), kHeader);
}

}  // namespace
}  // namespace tacit
