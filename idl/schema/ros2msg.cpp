#include "idl/schema/ros2msg.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tacit {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kNames{{
    {"boolean", "bool"},
    {"octet", "uint8"},
    {"char", "uint8"},
    {"short", "int16"},
    {"unsigned short", "uint16"},
    {"long", "int32"},
    {"unsigned long", "uint32"},
    {"long long", "int64"},
    {"unsigned long long", "uint64"},
    {"float", "float32"},
    {"double", "float64"},
    {"string", "string"},
}};

using Structs = std::span<const IdlStruct>;

/// The last one: a name counts from where it stands on, and the files are read one after another.
const IdlStruct& find(const std::string& name, Structs all) {
  return *std::find_if(all.rbegin(), all.rend(),
                       [&](const IdlStruct& each) { return each.name == name; });
}

std::string type_text(const IdlMember& member, Structs all) {
  const auto* const basic = std::find_if(
      kNames.begin(), kNames.end(), [&](const auto& each) { return each.first == member.type; });
  if (basic == kNames.end()) return ros2msg_name(find(member.type, all));
  const std::string bound = member.text_bound ? "<=" + std::to_string(*member.text_bound) : "";
  return std::string(basic->second) + bound;
}

std::string many_text(const IdlMember& member) {
  const std::string count = member.count ? std::to_string(*member.count) : "";
  switch (member.many) {
    case IdlMember::Many::One:
      return "";
    case IdlMember::Many::Array:
      return '[' + count + ']';
    case IdlMember::Many::Sequence:
      return count.empty() ? "[]" : "[<=" + count + ']';
  }
  return "";
}

std::string members_text(const IdlStruct& of, Structs all) {
  std::string text;
  for (const IdlMember& member : of.members) {
    text += type_text(member, all) + many_text(member) + ' ' + member.name + '\n';
  }
  return text;
}

/// Adds what `of` is made of to `parts`, each after what it stands in.
void collect_parts(const IdlStruct& of, Structs all, std::vector<const IdlStruct*>& parts) {
  for (const IdlMember& member : of.members) {
    if (is_basic(member.type)) continue;
    const IdlStruct& part = find(member.type, all);
    if (std::find(parts.begin(), parts.end(), &part) != parts.end()) continue;
    parts.push_back(&part);
    collect_parts(part, all, parts);
  }
}

}  // namespace

std::string ros2msg_name(const IdlStruct& of) {
  std::string package = of.scope;
  for (std::size_t at = package.find("::"); at != std::string::npos; at = package.find("::")) {
    package.replace(at, 2, "_");
  }
  return package + "/msg/" + of.name;
}

std::string ros2msg_text(const IdlStruct& of, Structs all) {
  std::vector<const IdlStruct*> parts;
  collect_parts(of, all, parts);
  std::string text = members_text(of, all);
  for (const IdlStruct* part : parts) {
    text +=
        std::string(80, '=') + "\nMSG: " + ros2msg_name(*part) + '\n' + members_text(*part, all);
  }
  return text;
}

}  // namespace tacit
