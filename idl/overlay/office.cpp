#include "idl/overlay/office.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "idl/types/config_error.h"
#include "idl/types/random.h"

namespace tacit {
namespace {

/// Decimetres, so that sums are exact and the file reads well.
using Dm = std::int64_t;

struct Place {
  Dm x = 0;
  Dm y = 0;
};

MapPoint metres(const Place& p) {
  return {static_cast<double>(p.x) / 10.0, static_cast<double>(p.y) / 10.0};
}

enum class Side : std::uint8_t { South, North };

struct Room {
  Side side = Side::South;
  Dm west = 0;
  Dm east = 0;
  bool open = true;
};

std::int64_t within(std::optional<std::int64_t> wish, const char* what, std::int64_t least,
                    std::int64_t most) {
  const std::int64_t value = wish.value_or(least);
  if (value < least || value > most) {
    throw ConfigError(std::string(what) + " = " + std::to_string(value) + ", wanted " +
                      std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

class Architect {
 public:
  Architect(std::uint64_t seed, const OfficeConfig& config)
      : seed_(seed),
        sentry_(config.sentry),
        approach_(config.approach),
        west_(config.approach ? kMargin + kLawn : kMargin),
        chance_(seed, "office") {
    decide_numbers(config);
    decide_sizes();
    lay_out(Side::South, rooms_wanted_ / 2);
    lay_out(Side::North, rooms_wanted_ - rooms_wanted_ / 2);
    stretch();
    close_some();
  }

  OverlayMap drawn() {
    draw_head();
    draw_hallway();
    draw_outer_walls();
    for (std::size_t i = 0; i < rooms_.size(); ++i) draw_room(i);
    draw_suspects();
    if (sentry_) draw_sentry();
    if (approach_) draw_approach();
    return std::move(map_);
  }

 private:
  static constexpr Dm kMargin = 20;
  static constexpr Dm kYard = 80;
  static constexpr Dm kLawn = 120;  ///< West of the building, for those who come from outside.
  static constexpr Dm kJamb = 6;    ///< Of wall, at least, between a door and the room's corner.
  static constexpr Dm kEntry = 16;
  static constexpr Dm kEnd = 8;  ///< From the hallway's end to the end of its centre line.

  Dm between(Dm least, Dm most) {
    return least + static_cast<Dm>(chance_.below(static_cast<std::uint64_t>(most - least + 1)));
  }

  void decide_numbers(const OfficeConfig& config) {
    rooms_wanted_ = config.rooms ? within(config.rooms, "rooms", 2, 8) : between(4, 8);
    const Dm most_closed = std::min<Dm>(2, rooms_wanted_ - 1);
    closed_ = config.closed_rooms
                  ? within(config.closed_rooms, "closed rooms", 0, rooms_wanted_ - 1)
                  : between(0, most_closed);
    const Dm open = rooms_wanted_ - closed_;
    suspects_ = config.suspects ? within(config.suspects, "suspect objects", 1, open)
                                : between(std::min<Dm>(2, open), std::min<Dm>(3, open));
  }

  void decide_sizes() {
    const Dm south_depth = between(45, 75);
    hall_south_ = kMargin + south_depth;
    hall_north_ = hall_south_ + 2 * between(9, 13);
    north_ = hall_north_ + between(45, 75);
  }

  void lay_out(Side side, Dm count) {
    Dm west = west_;
    for (Dm i = 0; i < count; ++i) {
      const Dm east = west + between(45, 85);
      rooms_.push_back({side, west, east, true});
      west = east;
    }
    east_ = std::max(east_, west);
  }

  /// The rooms of the shorter side grow alike until it is as long as the other.
  void stretch() {
    for (const Side side : {Side::South, Side::North}) {
      Dm reach = 0;
      for (const Room& room : rooms_) reach = room.side == side ? room.east : reach;
      const Dm from = reach - west_;
      const Dm to = east_ - west_;
      for (Room& room : rooms_) {
        if (room.side != side) continue;
        room.west = west_ + (room.west - west_) * to / from;
        room.east = west_ + (room.east - west_) * to / from;
      }
    }
  }

  void close_some() {
    for (Dm closed = 0; closed < closed_;) {
      Room& room = rooms_[chance_.below(rooms_.size())];
      closed += room.open ? 1 : 0;
      room.open = false;
    }
  }

  void add(MapContent content, const std::string& title = "") {
    const std::string before = title.empty() ? "" : "\n\n-- " + title + '\n';
    map_.statements.push_back({std::move(content), {}, before, {}});
  }

  void add_shape(ShapeKind kind, const std::string& name, const std::vector<Place>& places,
                 std::optional<double> size_m = {}) {
    MapShape shape{kind, name, {}, size_m};
    for (const Place& place : places) shape.points.push_back(metres(place));
    add(std::move(shape), std::exchange(title_, ""));
  }

  void add_wall(const Place& from, const Place& to) {
    add_shape(ShapeKind::Wall, "wall" + std::to_string(++walls_) + '*', {from, to});
  }

  void draw_head() {
    const Dm width = east_ + (sentry_ ? kYard : 0) + kMargin;
    const MapPoint size = metres({width, north_ + kMargin});
    map_.statements.push_back(
        {MapHeader{HeaderKind::MissionArea, {}, {size.x_m, size.y_m}},
         {},
         "-- An office building, made by chance from seed " + std::to_string(seed_) + '\n',
         {}});
    add(MapHeader{HeaderKind::Scenario, {"office"}, {}});
    add(MapMeasures{});
    const Place start{kMargin + 20, approach_ ? kMargin + 20 : middle()};
    add_shape(ShapeKind::PassagePoint, "StartPlace*", {start}, 0.2);
    add(MapObject{metres(start), 0.5, Mobility::Fixed, "white"});
  }

  void draw_hallway() {
    MapHallway hall{"hallway*", {}, metres({hall_north_ - hall_south_, 0}).x_m, {}};
    hall.centre_line = {metres({west_ + kEnd, middle()}), metres({east_ - kEnd, middle()})};
    hall.outline = {metres({west_, hall_south_}), metres({east_, hall_south_}),
                    metres({east_, hall_north_}), metres({west_, hall_north_})};
    add(std::move(hall), "The hallway");
  }

  void draw_outer_walls() {
    title_ = "Outer walls";
    add_wall({west_, kMargin}, {east_, kMargin});
    add_wall({west_, north_}, {east_, north_});
    draw_end(west_, approach_);
    draw_end(east_, sentry_);
  }

  /// The wall at an end of the building, with or without a way through it into the hallway.
  void draw_end(Dm x, bool open) {
    if (!open) {
      add_wall({x, kMargin}, {x, north_});
      return;
    }
    add_wall({x, kMargin}, {x, middle() - kEntry / 2});
    add_wall({x, middle() + kEntry / 2}, {x, north_});
    add_shape(ShapeKind::Gap, x == west_ ? "way in*" : "entry*",
              {{x - 1, middle()}, {x + 1, middle()}}, static_cast<double>(kEntry) / 10.0);
  }

  void draw_room(std::size_t index) {
    const Room& room = rooms_[index];
    const std::string number = std::to_string(index + 1);
    const Dm hall = room.side == Side::South ? hall_south_ : hall_north_;
    const Dm back = room.side == Side::South ? kMargin : north_;
    title_ = "Room " + number + (room.open ? "" : ", closed");
    add_shape(ShapeKind::Room, "Room " + number,
              {{room.west, hall}, {room.east, hall}, {room.east, back}, {room.west, back}});
    if (room.east != east_) add_wall({room.east, hall}, {room.east, back});
    if (!room.open) {
      add_wall({room.west, hall}, {room.east, hall});
      return;
    }
    const Dm width = between(10, 14);
    const Dm door = between(room.west + kJamb, room.east - kJamb - width);
    add_wall({room.west, hall}, {door, hall});
    add_wall({door + width, hall}, {room.east, hall});
    add_shape(ShapeKind::Door, "door " + number + '*', {{door, hall}, {door + width, hall}});
  }

  void draw_suspects() {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      if (rooms_[i].open) open.push_back(i);
    }
    const Dm real = between(0, suspects_ - 1);
    std::string title = "Suspect objects; the one that can be moved is the real one";
    for (Dm i = 0; i < suspects_; ++i) {
      const std::size_t chosen = chance_.below(open.size());
      const Place at = deep_inside(rooms_[open[chosen]]);
      open.erase(open.begin() + static_cast<std::ptrdiff_t>(chosen));
      add(MapObject{metres(at), 0.5, i == real ? Mobility::Movable : Mobility::Fixed, "brown"},
          std::exchange(title, ""));
    }
  }

  /// Away from all walls, in the half that lies farther from the hallway.
  Place deep_inside(const Room& room) {
    constexpr Dm kAway = 12;
    const Dm x = between(room.west + kAway, room.east - kAway);
    return room.side == Side::South
               ? Place{x, between(kMargin + kAway, (kMargin + hall_south_) / 2)}
               : Place{x, between((north_ + hall_north_) / 2, north_ - kAway)};
  }

  /// Once round the yard, then through the hallway and back.
  void draw_sentry() {
    const Dm near = east_ + 15;
    const Dm far = east_ + kYard - 15;
    const Dm low = middle() - 30;
    const std::vector<Place> way{
        {near, low},     {far, low}, {far, middle()}, {near, middle()}, {west_ + 35, middle()},
        {near, middle()}};
    title_ = "A sentry's way";
    for (std::size_t i = 0; i < way.size(); ++i) {
      add_shape(ShapeKind::PassagePoint, "Sentry" + std::to_string(i + 1), {way[i]}, 0.5);
    }
  }

  /// Points by which one comes over the lawn to the way in.
  void draw_approach() {
    const Dm near = west_ - 15;
    const std::vector<Place> way{
        {between(kMargin + 30, kMargin + 60), between(kMargin + 40, middle())},
        {between(kMargin + 70, near - 15), between(middle() - 20, north_ - 20)}};
    title_ = "The way from the start to the building";
    for (std::size_t i = 0; i < way.size(); ++i) {
      add_shape(ShapeKind::PassagePoint, "Way" + std::to_string(i + 1), {way[i]}, 0.5);
    }
    add_shape(ShapeKind::PassagePoint, "Entry", {{near, middle()}}, 0.5);
  }

  [[nodiscard]] Dm middle() const { return (hall_south_ + hall_north_) / 2; }

  std::uint64_t seed_;
  bool sentry_;
  bool approach_;
  Dm west_;
  Stream chance_;
  Dm rooms_wanted_ = 0;
  Dm closed_ = 0;
  Dm suspects_ = 0;
  Dm hall_south_ = 0;
  Dm hall_north_ = 0;
  Dm north_ = 0;
  Dm east_ = 0;
  std::vector<Room> rooms_;
  OverlayMap map_;
  std::string title_;
  int walls_ = 0;
};

}  // namespace

OverlayMap random_office(std::uint64_t seed, const OfficeConfig& config) {
  return Architect(seed, config).drawn();
}

}  // namespace tacit
