#include <cctype>
#include <map>

#include "idl/cdl/diagram.h"

namespace tacit::cdl {
namespace {

bool is_plain(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || std::isalnum(byte) != 0;
}

std::string indented(int depth) { return std::string(static_cast<std::size_t>(2 * depth), ' '); }

/// Mermaid's own entities: `#34;` is a quotation mark.
std::string mermaid_text(const std::string& label) {
  std::string text;
  for (const char letter : label) {
    const bool safe =
        is_plain(letter) || std::string_view(" ._(),*").find(letter) != std::string_view::npos;
    text += safe ? std::string(1, letter)
                 : '#' + std::to_string(static_cast<unsigned char>(letter)) + ';';
  }
  return text.empty() ? " " : text;
}

void mermaid(const Box& box, int depth, std::string& out) {
  const std::string line = indented(depth);
  out += line + "state \"" + mermaid_text(box.label) + "\" as " + box.id;
  out += box.inside.empty() ? "\n" : " {\n";
  if (!box.initial.empty()) {
    out += line + "  [*] --> " + box.initial + '\n';
  }
  for (const Box& inner : box.inside) {
    mermaid(inner, depth + 1, out);
  }
  for (const Arrow& arrow : box.arrows) {
    out += line + "  " + arrow.from + " --> " + arrow.to + " : " + mermaid_text(arrow.label) + '\n';
  }
  out += box.inside.empty() ? "" : line + "}\n";
}

std::string dot_text(const std::string& label) {
  std::string text;
  for (const char letter : label) {
    text += letter == '"' || letter == '\\' ? std::string{'\\', letter} : std::string(1, letter);
  }
  return '"' + text + '"';
}

void dot(const Box& box, int depth, std::string& out) {
  const std::string line = indented(depth);
  if (box.inside.empty()) {
    out += line + box.id + " [label=" + dot_text(box.label) + "];\n";
    return;
  }
  out += line + "subgraph cluster_" + box.id + " {\n";
  out += line + "  label=" + dot_text(box.label) + ";\n";
  // Arrows to a cluster end at this point inside it.
  out += line + "  " + box.id + " [shape=point];\n";
  for (const Box& inner : box.inside) {
    dot(inner, depth + 1, out);
  }
  if (!box.initial.empty()) {
    out += line + "  " + box.id + " -> " + box.initial + ";\n";
  }
  for (const Arrow& arrow : box.arrows) {
    out +=
        line + "  " + arrow.from + " -> " + arrow.to + " [label=" + dot_text(arrow.label) + "];\n";
  }
  out += line + "}\n";
}

std::string xml_text(const std::string& label) {
  std::string text;
  for (const char letter : label) {
    switch (letter) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += letter;
    }
  }
  return '"' + text + '"';
}

/// Events are names with dots between; `*` would stand for any event.
std::string event_name(const std::string& trigger) {
  std::string name;
  for (const char letter : trigger) {
    name += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  }
  return name.empty() ? "always" : name;
}

using Leaving = std::multimap<std::string_view, const Arrow*>;

void scxml(const Box& box, int depth, const Leaving& arrows, std::string& out) {
  const std::string line = indented(depth);
  const std::string tag = box.concurrent && !box.inside.empty() ? "parallel" : "state";
  out += line + '<' + tag + " id=\"" + box.id + '"';
  out += box.initial.empty() ? "" : " initial=\"" + box.initial + '"';
  out += " t:label=" + xml_text(box.label) + ">\n";
  const auto [first, last] = arrows.equal_range(box.id);
  for (auto arrow = first; arrow != last; ++arrow) {
    out += line + "  <transition event=\"" + event_name(arrow->second->event) + "\" target=\"" +
           arrow->second->to + "\" t:label=" + xml_text(arrow->second->label) + "/>\n";
  }
  Leaving inner_arrows;
  for (const Arrow& arrow : box.arrows) {
    inner_arrows.emplace(arrow.from, &arrow);
  }
  for (const Box& inner : box.inside) {
    scxml(inner, depth + 1, inner_arrows, out);
  }
  out += line + "</" + tag + ">\n";
}

}  // namespace

std::string to_mermaid(const Box& team) {
  std::string out = "stateDiagram-v2\n";
  for (const Box& robot : team.inside) {
    mermaid(robot, 1, out);
  }
  return out;
}

std::string to_dot(const Box& team) {
  std::string out = "digraph team {\n  compound=true;\n  node [shape=box, style=rounded];\n";
  for (const Box& robot : team.inside) {
    dot(robot, 1, out);
  }
  return out + "}\n";
}

std::string to_scxml(const Box& team) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" xmlns:t=\"urn:tacit:mission\" "
      "version=\"1.0\" datamodel=\"null\" initial=\"team\">\n";
  scxml(team, 1, {}, out);
  return out + "</scxml>\n";
}

}  // namespace tacit::cdl
