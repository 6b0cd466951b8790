#include "deploy/tacit/dds_run.h"

#include <random>

#include "deploy/tacit/cast.h"
#include "idl/bus/domain_lease.h"
#include "idl/bus/leftovers.h"
#include "idl/bus/venue_file.h"

namespace tacit {
namespace {

/// Removes what killed processes of a run left in shared memory, also when an error ends it.
class Broom {
 public:
  explicit Broom(std::uint32_t run_nonce) : run_nonce_(run_nonce) {}
  ~Broom() { remove_leftovers(run_nonce_); }
  Broom(const Broom&) = delete;
  Broom& operator=(const Broom&) = delete;

 private:
  std::uint32_t run_nonce_;
};

}  // namespace

Ending run_over_dds(const RunPlan& plan, const RunDirectory& directory, Signals& signals) {
  const std::uint32_t run_nonce = std::random_device{}();
  const DomainLease lease = DomainLease::take(run_nonce);
  const Broom broom(run_nonce);
  const Venue venue{lease.domain(), run_nonce};
  const VenueFile live(directory.path(), venue);
  const Cast cast = cast_for(plan, directory, venue);
  return Supervisor(cast, signals, std::chrono::duration<double>(plan.wish.timeout_s)).run();
}

}  // namespace tacit
