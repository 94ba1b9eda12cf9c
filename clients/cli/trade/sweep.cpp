#include "clients/cli/trade/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "clients/cli/trade/page/page.h"
#include "clients/cli/trade/shoot.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "renderer/compare/compare.h"

namespace pelage::trade {

namespace {

constexpr double frames_of_shell = 0.08;  // of R1, in usual frames
constexpr double work_of_strands = 40;

/// A scene on the server for as long as it is measured.
class Stage {
 public:
  static Result<Stage> of(Session& session, const Case& scene) {
    Stage stage(session, scene.id);
    if (scene.id.empty()) {
      const auto answer = session.make_scene("/v1/scenes", scene.request);
      if (!answer) return answer.status();
      const auto summary = decode_answer<SceneSummary>(answer->body);
      if (!summary) return summary.status();
      stage.id_ = summary->id, stage.made_ = true;
    }
    for (const std::string& command : scene.commands) {
      const auto answer = Session::accepted(session.connection().post_json(stage.path() + "/commands", command));
      if (!answer) return answer.status();
    }
    return stage;
  }

  Stage(Stage&& other) noexcept
      : session_(other.session_), id_(std::move(other.id_)), made_(std::exchange(other.made_, false)) {}
  Stage& operator=(Stage&&) = delete;
  ~Stage() {
    if (made_) (void)session_.connection().remove(path());
  }

  std::string path() const { return "/v1/scenes/" + id_; }

 private:
  Stage(Session& session, std::string id) : session_(session), id_(std::move(id)) {}

  Session& session_;
  std::string id_;
  bool made_ = false;
};

Result<Place> place_of(Session& session, const std::string& path, const Case& scene, int size) {
  const auto answer = Session::accepted(session.connection().get(path));
  if (!answer) return answer.status();
  const auto summary = decode_answer<SceneSummary>(answer->body);
  if (!summary) return summary.status();
  const ModelReport& model = summary->report;
  Place place{path, {}};
  place.request.width = place.request.height = size;
  Camera& camera = place.request.camera;
  camera.automatic = AutoView::none;
  camera.target = (model.bounds.min + model.bounds.max) / 2.0;
  camera.position = camera.target + scene.towards * model.size;
  place.request.background = Background::transparent;
  return place;
}

/// Measures settings on one scene; each different picture is drawn and timed once.
class Sweeper {
 public:
  Sweeper(Session& session, const Case& scene, const SweepOptions& options, const Place& place)
      : session_(session),
        scene_(scene),
        options_(options),
        place_(place),
        truths_(session, place, options.truth, options.passes) {}

  References& truths() { return truths_; }

  /// A row against R1, and with `strands` one against R2; the picture too where the report shows it.
  Status measure(const Setting& setting, bool strands, Report& report) {
    auto shot = shoot(session_, place_, setting.knobs);
    if (!shot) return shot.status();
    const auto cost = cost_of_frame(session_, place_, setting.knobs, options_.repeats);
    if (!cost) return cost.status();
    const auto shells = truths_.shells(setting.knobs);
    if (!shells) return shells.status();
    if (Status status = add_row(setting, **shells, *shot, *cost, strands, report); !status.ok() || !strands)
      return status;
    const auto traced = truths_.strands();
    if (!traced) return traced.status();
    return add_row(setting, **traced, *shot, *cost, false, report);
  }

 private:
  Row row_of(const Setting& setting, const Truth& truth, const Shot& shot, const FrameCost& cost) const {
    const Shot& true_shot = truth.shot;
    return {.scene = scene_.name,
            .size = options_.size,
            .series = setting.series,
            .base = setting.base,
            .value = setting.value,
            .reference = truth.name,
            .truth = truth.detail,
            .shells = setting.knobs.shells,
            .steps = setting.knobs.steps,
            .scale = shot.scale,
            .luminance = true_shot.luminance > 0 ? shot.luminance / true_shot.luminance : 1,
            .coverage = true_shot.coverage > 0 ? shot.coverage / true_shot.coverage : 1,
            .floor = truth.floor,
            .non_finite = shot.non_finite,
            .draw_ms = cost.draw,
            .cpu_ms = cost.cpu,
            .knobs = encode(setting.knobs)};
  }

  Status add_row(const Setting& setting, const Truth& truth, const Shot& shot, const FrameCost& cost, bool picture,
                 Report& report) {
    Row row = row_of(setting, truth, shot, cost);
    const auto error = error_of(truth.shot.picture, shot.picture);
    if (!error) return error.status();
    if (error->figures) {
      const FlipFigures silhouette = error->figures->silhouette.value_or(FlipFigures{});
      row.flip = error->figures->flip.mean, row.flip_95 = error->figures->flip.percentile_95;
      row.silhouette = silhouette.mean, row.silhouette_95 = silhouette.percentile_95;
    } else {
      row.flip = row.flip_95 = row.silhouette = row.silhouette_95 = 1;  // a broken picture is as wrong as can be
    }
    report.rows.push_back(row);
    if (picture && error->figures) add_picture(row, shot, *error, report);
    return {};
  }

  static void add_picture(const Row& row, const Shot& shot, const PictureError& error, Report& report) {
    const Image map = error_picture(error.flip, shot.picture.width, shot.picture.height);
    const std::string caption =
        fmt::format("error {:.4f}, silhouette {:.4f}, {} ms", row.flip, row.silhouette, milliseconds(cost_of(row)));
    report.pictures.push_back({row.scene, row.value, caption, jpeg_of(shot.picture), encode_jpeg(map, 84)});
  }

  Session& session_;
  const Case& scene_;
  const SweepOptions& options_;
  Place place_;
  References truths_;
};

/// A row for this setting that need not be drawn: kept from before, or the same knobs in another series.
const Row* known(const Report& report, const Case& scene, const Setting& setting) {
  const std::string knobs = encode(setting.knobs);
  const auto found = std::find_if(report.rows.begin(), report.rows.end(), [&](const Row& row) {
    return row.scene == scene.name && row.knobs == knobs && row.reference != "R2";
  });
  return found == report.rows.end() ? nullptr : &*found;
}

/// Takes out rows from before that would lie beside others on one plot: of another size or truth, of knobs that are not
/// tried any more, and tiers that are shown, for their pictures are in no table.
void forget_stale(const Case& scene, const std::vector<Setting>& settings, const SweepOptions& options,
                  Report& report) {
  const auto is_tried = [&](const Row& row) {
    return std::any_of(settings.begin(), settings.end(), [&](const Setting& setting) {
      return row.series == setting.series && row.base == setting.base && row.value == setting.value &&
             row.knobs == encode(setting.knobs);
    });
  };
  std::erase_if(report.rows, [&](const Row& row) {
    if (row.size != options.size) return true;
    if (row.scene != scene.name) return false;
    return row.truth != options.truth || (scene.swept && row.series == "tier") || !is_tried(row);
  });
}

Status show_truths(References& truths, const Case& scene, Report& report) {
  const auto shells = truths.shells({});
  if (!shells) return shells.status();
  const auto strands = truths.strands();
  if (!strands) return strands.status();
  const auto error = error_of((*shells)->shot.picture, (*strands)->shot.picture);
  if (!error) return error.status();
  const std::string far = error->figures ? fmt::format(", {:.3f} from R1", error->figures->flip.mean) : "";
  report.pictures.push_back({scene.name, "R1", "the truth of shells", jpeg_of((*shells)->shot.picture), ""});
  report.pictures.push_back({scene.name, "R2", "every strand traced" + far, jpeg_of((*strands)->shot.picture), ""});
  return {};
}

}  // namespace

double work_of(const Case& scene, const SweepOptions& options) {
  const double settings = static_cast<double>(settings_for(scene.swept, options.quick).size());
  return settings + 2.5 * frames_of_shell * options.truth + (scene.swept ? work_of_strands : 0);
}

namespace {

/// Draws a setting, or copies what is known of its knobs.
Status add(Sweeper& sweeper, const Case& scene, const Setting& setting, Report& report) {
  const bool shown = scene.swept && setting.series == "tier";
  const Row* row = shown ? nullptr : known(report, scene, setting);
  if (!row) return sweeper.measure(setting, shown, report);
  Row copy = *row;
  copy.series = setting.series, copy.base = setting.base, copy.value = setting.value;
  if (std::find(report.rows.begin(), report.rows.end(), copy) == report.rows.end()) report.rows.push_back(copy);
  return {};
}

}  // namespace

Status sweep(Session& session, const Case& scene, const SweepOptions& options, Report& report,
             const std::function<Status(double)>& done) {
  const auto stage = Stage::of(session, scene);
  if (!stage) return stage.status();
  const auto place = place_of(session, stage->path(), scene, options.size);
  if (!place) return place.status();
  Sweeper sweeper(session, scene, options, *place);
  const std::vector<Setting> settings = settings_for(scene.swept, options.quick);
  forget_stale(scene, settings, options, report);
  if (scene.swept) {
    if (Status status = show_truths(sweeper.truths(), scene, report); !status.ok()) return status;
  }
  if (Status status = done(work_of(scene, options) - static_cast<double>(settings.size())); !status.ok()) return status;
  for (const Setting& setting : settings) {
    if (Status status = add(sweeper, scene, setting, report); !status.ok()) return status;
    if (Status status = done(1); !status.ok()) return status;
  }
  return {};
}

}  // namespace pelage::trade
