#include "wizard_service/cbr/case_index.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <tuple>

namespace tacit::cbr {
namespace {

/// A case in its leaf: all that tells it from the others there.
struct Entry {
  int standing = 0;
  std::uint64_t mark = 0;
  CaseId id = 0;
};

Entry entry_of(const CaseHead& head) { return {head.standing, head.mark, head.id}; }

/// As `better` has it.
struct BetterEntry {
  bool operator()(const Entry& a, const Entry& b) const {
    return std::tuple(b.standing, a.mark, a.id) < std::tuple(a.standing, b.mark, b.id);
  }
};

using Leaf = std::set<Entry, BetterEntry>;

struct Node {
  std::optional<Entry> best;                    ///< Of all cases below; none in an empty node.
  std::vector<std::unique_ptr<Node>> children;  ///< By code; those without cases are null.
  Leaf cases;                                   ///< In a leaf alone.
};

void take_best(Node& node) {
  node.best = node.cases.empty() ? std::nullopt : std::optional(*node.cases.begin());
  for (const std::unique_ptr<Node>& child : node.children) {
    if (child && (!node.best || BetterEntry()(*child->best, *node.best))) node.best = child->best;
  }
}

/// A node, or a case at its place in a leaf, that may hold the next best case.
struct Candidate {
  std::int64_t bound = 0;  ///< No case there has a higher rank; that of a case itself.
  std::uint64_t mark = 0;  ///< No case there of that rank has a smaller one,
  CaseId id = 0;           ///< or the same and a smaller id.
  const Node* node = nullptr;
  std::size_t level = 0;
  std::optional<Leaf::const_iterator> at;  ///< Of a case.
  Share share;                             ///< What the way to here got; its most is the query's.
  CaseFeatures features;
};

struct LessPromising {
  bool operator()(const Candidate& a, const Candidate& b) const {
    return std::tuple(a.bound, b.mark, b.id) < std::tuple(b.bound, a.mark, a.id);
  }
};

/// The best-first search of one query. Candidates leave the queue by falling bound, and a bound is
/// never below the ranks of the cases that it stands for, so that a case that leaves the queue is
/// the next best of all.
class Search {
 public:
  Search(const Query& query, const Node& root) : query_(query) {
    for (std::size_t i = kFeatures; i-- > 0;) {
      const Share open = share_of(query, feature_table()[i].feature,
                                  code(query, feature_table()[i].feature).value_or(0));
      still_[i] = still_[i + 1] + open.most;
    }
    if (!root.best) return;
    Candidate start;
    start.node = &root;
    start.share.most = still_[0];
    push(start, *root.best);
  }

  /// None when all have been told.
  std::optional<Ranked> next() {
    while (!queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      if (best.at) {
        push_case(best, std::next(*best.at));
        return Ranked{best.id, best.features, best.bound, best.mark};
      }
      open(best);
    }
    return std::nullopt;
  }

 private:
  void push(Candidate candidate, const Entry& best) {
    const std::int64_t most = candidate.share.got + still_[candidate.level];
    candidate.bound = rank_of({most, candidate.share.most}, best.standing);
    candidate.mark = best.mark;
    candidate.id = best.id;
    queue_.push(candidate);
  }

  void push_case(Candidate candidate, Leaf::const_iterator at) {
    if (at == candidate.node->cases.end()) return;
    candidate.at = at;
    push(candidate, *at);
  }

  void open(const Candidate& parent) {
    if (parent.level == kFeatures) return push_case(parent, parent.node->cases.begin());
    const Feature feature = feature_table()[parent.level].feature;
    for (std::size_t found = 0; found < parent.node->children.size(); ++found) {
      const Node* node = parent.node->children[found].get();
      if (node == nullptr) continue;
      Candidate child = parent;
      child.node = node;
      ++child.level;
      child.share.got += share_of(query_, feature, found).got;
      set_code(child.features, feature, found);
      push(child, *node->best);
    }
  }

  const Query& query_;
  std::array<std::int64_t, kFeatures + 1> still_{};  ///< The most that the levels from here give.
  std::priority_queue<Candidate, std::vector<Candidate>, LessPromising> queue_;
};

}  // namespace

/// The nodes, and where each case is.
class CaseIndex::Tree {
 public:
  Tree() = default;
  explicit Tree(std::vector<CaseHead> heads) {
    std::sort(heads.begin(), heads.end(), [](const CaseHead& a, const CaseHead& b) {
      return std::tuple(a.features, -a.standing, a.mark, a.id) <
             std::tuple(b.features, -b.standing, b.mark, b.id);
    });
    for (const CaseHead& head : heads) {
      Leaf& cases = grow(head).cases;
      cases.insert(cases.end(), entry_of(head));
    }
    std::sort(heads.begin(), heads.end(),
              [](const CaseHead& a, const CaseHead& b) { return a.id < b.id; });
    for (const CaseHead& head : heads) heads_.emplace_hint(heads_.end(), head.id, head);
    assert(heads_.size() == heads.size());
  }

  void insert(const CaseHead& head) {
    const bool is_new = heads_.emplace(head.id, head).second;
    assert(is_new);
    if (is_new) grow(head).cases.insert(entry_of(head));
  }

  bool erase(CaseId id) {
    const auto found = heads_.find(id);
    if (found == heads_.end()) return false;
    prune(root_, found->second, 0);
    heads_.erase(found);
    return true;
  }

  [[nodiscard]] std::size_t size() const { return heads_.size(); }
  [[nodiscard]] const Node& root() const { return root_; }

 private:
  /// The leaf for the case; every node on the way learns of it.
  Node& grow(const CaseHead& head) {
    const Entry entry = entry_of(head);
    Node* node = &root_;
    for (const FeatureRow& row : feature_table()) {
      if (!node->best || BetterEntry()(entry, *node->best)) node->best = entry;
      const std::size_t found = code(head.features, row.feature);
      assert(found < row.values.size());
      node->children.resize(row.values.size());
      std::unique_ptr<Node>& child = node->children[found];
      if (!child) child = std::make_unique<Node>();
      node = child.get();
    }
    if (!node->best || BetterEntry()(entry, *node->best)) node->best = entry;
    return *node;
  }

  /// Takes the case out, and the nodes that it leaves empty.
  void prune(Node& node, const CaseHead& head, std::size_t level) {
    if (level == kFeatures) {
      node.cases.erase(entry_of(head));
    } else {
      std::unique_ptr<Node>& child =
          node.children[code(head.features, feature_table()[level].feature)];
      prune(*child, head, level + 1);
      if (!child->best) child.reset();
    }
    take_best(node);
  }

  Node root_;
  std::map<CaseId, CaseHead> heads_;
};

CaseIndex::CaseIndex() : tree_(std::make_unique<Tree>()) {}
CaseIndex::CaseIndex(std::span<const CaseHead> cases)
    : tree_(std::make_unique<Tree>(std::vector<CaseHead>(cases.begin(), cases.end()))) {}
CaseIndex::~CaseIndex() = default;
CaseIndex::CaseIndex(CaseIndex&&) noexcept = default;
CaseIndex& CaseIndex::operator=(CaseIndex&&) noexcept = default;

void CaseIndex::insert(const CaseHead& head) { tree_->insert(head); }
bool CaseIndex::erase(CaseId id) { return tree_->erase(id); }
void CaseIndex::update(const CaseHead& head) {
  tree_->erase(head.id);
  tree_->insert(head);
}
std::size_t CaseIndex::size() const { return tree_->size(); }

std::vector<Ranked> CaseIndex::retrieve(const Query& query, std::size_t most) const {
  std::vector<Ranked> found;
  Search search(query, tree_->root());
  while (found.size() < most) {
    const std::optional<Ranked> next = search.next();
    if (!next) break;
    found.push_back(*next);
  }
  return found;
}

std::vector<Ranked> retrieve_by_scan(std::span<const CaseHead> cases, const Query& query,
                                     std::size_t most) {
  std::vector<Ranked> kept;  // A heap with the worst in front.
  for (const CaseHead& head : cases) {
    const Ranked one{head.id, head.features, rank(query, head.features, head.standing), head.mark};
    if (kept.size() >= most && (most == 0 || !better(one, kept.front()))) continue;
    if (kept.size() == most) {
      std::pop_heap(kept.begin(), kept.end(), better);
      kept.pop_back();
    }
    kept.push_back(one);
    std::push_heap(kept.begin(), kept.end(), better);
  }
  std::sort_heap(kept.begin(), kept.end(), better);
  return kept;
}

}  // namespace tacit::cbr
