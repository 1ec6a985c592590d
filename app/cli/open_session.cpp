#include "cli/open_session.h"

#include "acquisition/stand_composites.h"
#include "base/errors.h"
#include "report/loss_wording.h"

namespace vantage {
namespace {

// What was found to be lost after the first `known` losses.
void tellLosses(const Session& session, std::size_t known, CommandContext& context) {
  const std::vector<Loss> losses = session.losses();
  for (std::size_t i = known; i < losses.size(); ++i)
    context.note("warning: " + english(phraseOf(losses[i], session.path())));
}

}  // namespace

Session openSession(const std::string& path, SessionAccess access, CommandContext& context) {
  Session session = Session::open(path, access, context.progress());
  tellLosses(session, 0, context);
  return session;
}

void checkSession(const Session& session, CommandContext& context) {
  const std::size_t known = session.losses().size();
  session.check(context.progress());
  tellLosses(session, known, context);
}

std::shared_ptr<const AcquisitionState> readSession(const std::string& path, CommandContext& context) {
  const Session session = openSession(path, SessionAccess::Read, context);
  const std::size_t known = session.losses().size();
  auto state = session.state();
  tellLosses(session, known, context);
  return state;
}

std::shared_ptr<const AcquisitionState> readObject(const std::string& path, CommandContext& context) {
  return std::make_shared<const AcquisitionState>(withObject(*readSession(path, context)));
}

SessionModel readSessionModel(const std::string& path, CommandContext& context) {
  const auto state = readObject(path, context);
  if (!state->model) throw InvalidInput(path + ": has no model yet, expected at least one view");
  return {state->model, worldOffset(outlineOf(*state)), state};
}

}  // namespace vantage
