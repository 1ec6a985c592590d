#include "integration/colouring.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "base/errors.h"
#include "base/parallel.h"
#include "integration/view_witness.h"

namespace vantage {
namespace {

constexpr std::size_t kGrain = 1024;

bool hasColours(const View& view) {
  return view.image && !view.image->colours.empty();
}

// Red, green and blue of many samples, each as far as it counts.
class Mixture {
 public:
  void add(const Colour& colour, double weight) {
    sum_ += weight * Vec3(colour[0], colour[1], colour[2]);
    weight_ += weight;
  }

  [[nodiscard]] std::optional<Colour> colour() const {
    if (!(weight_ > 0.0)) return std::nullopt;
    Colour result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = static_cast<std::uint8_t>(std::min(sum_[static_cast<Eigen::Index>(k)] / weight_ + 0.5, 255.0));
    return result;
  }

 private:
  Vec3 sum_ = Vec3::Zero();
  double weight_ = 0.0;
};

// Adds what a view with colours says of a place of its mesh.
void add(Mixture& mixture, const View& view, const Opinion& opinion) {
  if (!(opinion.weight > 0.0)) return;
  const Triangle& t = view.mesh->mesh.triangles[opinion.contact.triangle];
  for (std::size_t k = 0; k < 3; ++k)
    mixture.add(view.image->colours[view.mesh->sample[t[k]]],
                opinion.weight * std::max(opinion.contact.weights[k], 0.0));
}

void checkProvenance(const Model& model, std::span<const View> views) {
  const std::size_t vertices = model.mesh.vertices.size();
  bool right = model.vertexView.size() == vertices && model.vertexSample.size() == vertices;
  for (std::size_t v = 0; v < vertices && right; ++v) {
    const std::uint32_t view = model.vertexView[v];
    right = view < views.size() && views[view].image && model.vertexSample[v] < views[view].image->range.size();
  }
  if (!right) throw InvalidInput("a model is to be coloured by views that it was not made of");
}

std::optional<Colour> ownColour(const Model& model, std::span<const View> views, std::size_t vertex) {
  const View& view = views[model.vertexView[vertex]];
  return hasColours(view) ? std::optional(view.image->colours[model.vertexSample[vertex]]) : std::nullopt;
}

}  // namespace

bool haveColours(std::span<const View> views) {
  return std::any_of(views.begin(), views.end(), hasColours);
}

VertexColours colourVertices(const Model& model, std::span<const View> views, const ConsensusOptions& options,
                             const Progress& progress) {
  if (!haveColours(views)) return {};
  checkProvenance(model, views);
  std::vector<View> coloured;
  std::copy_if(views.begin(), views.end(), std::back_inserter(coloured), hasColours);
  const std::vector<ViewWitness> witnesses = witnessesOf(coloured, options, progress.part(0.0, 0.0));
  const std::vector<Vec3> normals = computeVertexNormals(model.mesh);
  VertexColours colours(model.mesh.vertices.size());
  parallelChunks(colours.size(), kGrain, progress, [&](std::size_t begin, std::size_t end) {
    std::vector<std::optional<GridPosition>> hints(witnesses.size());
    for (std::size_t v = begin; v < end; ++v) {
      Mixture mixture;
      for (std::size_t k = 0; k < witnesses.size() && !normals[v].isZero(); ++k)
        add(mixture, coloured[k], witnesses[k].ask(model.mesh.vertices[v], normals[v], hints[k]));
      const std::optional<Colour> mixed = mixture.colour();
      colours[v] = mixed ? mixed : ownColour(model, views, v);
    }
  });
  return colours;
}

}  // namespace vantage
