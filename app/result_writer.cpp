#include "result_writer.h"

#include <cstdint>
#include <utility>

#include "acquisition/model_colours.h"
#include "acquisition/stand_composites.h"
#include "base/atomic_file.h"
#include "io/mesh_writer.h"
#include "io/output_file.h"
#include "print_text.h"

namespace vantage {

ResultWriter::ResultWriter(Undertaking& work, QObject* parent) : QObject(parent), work_(work) {}

void ResultWriter::exportModel(const SharedState& state, const QString& path, std::vector<std::string> inUse) {
  work_.begin<bool>(
      Activity::Writing, tr("Writing %1").arg(path),
      [state, path = path.toStdString(), inUse = std::move(inUse)](const Progress& progress) {
        checkOutput(path, OutputKind::Mesh, inUse);
        const AcquisitionState object = withObject(*state);
        const VertexColours colours = holdsColours(path) ? coloursOf(object, progress.part(0.0, 0.5)) : VertexColours{};
        vantage::exportModel(*object.model, path, progress.part(0.5, 1.0), worldOffset(outlineOf(object)), colours);
        return true;
      },
      [this, path](bool) { emit written(path); });
}

void ResultWriter::exportFinished(const SharedState& state, const QString& path, const HandOver& how,
                                  std::vector<std::string> inUse) {
  struct Made {
    QString done;
    QString whyNot;
  };
  work_.begin<Made>(
      Activity::Writing, tr("Writing %1").arg(path),
      [state, path = path.toStdString(), how, inUse = std::move(inUse)](const Progress& progress) {
        checkOutput(path, OutputKind::Mesh, inUse);
        const AcquisitionState object = withObject(*state);
        const FinishedModel made = finish(*object.model, how.finishing, progress.part(0.0, 0.6));
        if (how.onlyPrintable && !made.check.printable()) return Made{{}, whyNotPrintable(made.check)};
        const VertexColours colours =
            made.coloursOf(holdsColours(path) ? coloursOf(object, progress.part(0.6, 0.8)) : VertexColours{});
        const std::vector<std::uint8_t> invented = made.invented();
        exportModelAs(made.model, path, {worldOffset(outlineOf(object)), colours, invented, how.unit},
                      progress.part(0.8, 1.0));
        return Made{finishingText(made), {}};
      },
      [this, path](const Made& made) {
        if (!made.whyNot.isEmpty()) {
          emit printRefused(made.whyNot);
          return;
        }
        emit written(path);
        emit madeReady(made.done);
      });
}

void ResultWriter::writeReport(const SharedState& state, const QString& path, ReportParts parts,
                               std::vector<std::string> inUse) {
  work_.begin<bool>(
      Activity::Writing, tr("Writing %1").arg(path),
      [state, path = path.toStdString(), parts = std::move(parts), inUse = std::move(inUse)](const Progress& progress) {
        progress.checkpoint(0.0);
        checkOutput(path, OutputKind::Report, inUse);
        AtomicFile file(path);
        const AcquisitionState object = withObject(*state);
        file.write(makeHtmlReport(object, parts(object)));
        file.commit();
        return true;
      },
      [this, path](bool) { emit written(path); });
}

}  // namespace vantage
