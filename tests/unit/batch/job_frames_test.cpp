// What a job plans for each of its frames.
#include "server/batch/job_frames.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "base/temporary_name.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "server/batch/input_file.h"
#include "server/batch/job_scene.h"
#include "server/batch/output_file.h"
#include "server/batch/turntable.h"
#include "server/export/temporary_folder.h"

namespace pelage::testing {
namespace {

RenderJob job_of(const std::string& more) {
  const auto job = decode_job(
      R"({"builtin": {"builtin": "sphere", "triangles": 500}, "output": "f.##.png", "frames": "1-5")" + more + "}");
  EXPECT_TRUE(job.ok()) << job.status().message << job.status().pointer;
  return job ? *job : RenderJob{};
}

class JobFrames : public ::testing::Test {
 protected:
  std::vector<JobFrame> plan(const RenderJob& job, const JobPart& part = {}) {
    if (!scene_) scene_.emplace(std::move(JobScene::open(job, ".")).value());
    auto frames = plan_job(job, part, "/job", *scene_->scene());
    EXPECT_TRUE(frames.ok()) << frames.status().message << frames.status().pointer;
    return frames ? *frames : std::vector<JobFrame>();
  }
  std::optional<JobScene> scene_;
};

TEST_F(JobFrames, AreTheSameInWhateverPartTheyAreDrawn) {
  const RenderJob job = job_of(R"(, "turntable": {}, "keyframes": [{"parameter": "/frame/exposure",
                                  "keys": [{"frame": 1, "value": 0}, {"frame": 5, "value": 1}]}])");
  const auto all = plan(job);
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[3].file, "/job/f.04.png");
  const auto part = plan(job, {.frames = "4", .output = "other.#.exr"});
  ASSERT_EQ(part.size(), 1u);
  EXPECT_EQ(part[0].file, "./other.4.exr");
  EXPECT_EQ(part[0].moment.request.exposure, all[3].moment.request.exposure);
  EXPECT_EQ(part[0].moment.request.camera.position, all[3].moment.request.camera.position);
  EXPECT_NE(part[0].fingerprint, all[3].fingerprint);  // has another format
  EXPECT_EQ(plan(job, {.frames = "2-4"})[2].fingerprint, all[3].fingerprint);
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_NE(all[k].fingerprint, all[0].fingerprint);
}

TEST_F(JobFrames, AreRefusedWhereTheJobHasNone) {
  const RenderJob job = job_of("");
  plan(job);
  const auto refused = plan_job(job, {.frames = "6", .output = {}}, ".", *scene_->scene());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.status().pointer, "/frames");
}

TEST_F(JobFrames, InTilesHoldEachPixelOnce) {
  const auto frames = plan(job_of(R"(, "frame": {"width": 101, "height": 37}, "tiles": {"columns": 7, "rows": 3})"));
  ASSERT_EQ(frames[1].tiles.size(), 21u);
  std::vector<int> hits(101 * 37);
  std::set<std::string> files, fingerprints;
  for (const JobTile& tile : frames[1].tiles) {
    for (int y = 0; y < tile.crop.height; ++y)
      for (int x = 0; x < tile.crop.width; ++x)
        ++hits.at(static_cast<std::size_t>((tile.crop.top + y) * 101 + tile.crop.left + x));
    files.insert(tile.file), fingerprints.insert(tile.fingerprint);
  }
  EXPECT_EQ(hits, std::vector<int>(hits.size(), 1));
  EXPECT_EQ(files.size(), 21u);
  EXPECT_EQ(fingerprints.size(), 21u);
  EXPECT_EQ(frames[1].tiles[8].number, 9);
  EXPECT_EQ(frames[1].tiles[8].file, "/job/f.02.tile9.png");
  const auto whole = plan(job_of(R"(, "frame": {"width": 101, "height": 37})"));
  EXPECT_EQ(frames[1].fingerprint, whole[1].fingerprint);  // the same picture
  EXPECT_TRUE(whole[1].tiles.empty());
}

TEST_F(JobFrames, ThatAreBlurredAreDrawnWhileTheShutterIsOpen) {
  const std::string moves =
      R"(, "fps": 10, "turntable": {"turns": "camera"}, "keyframes": [{"parameter": "/frame/exposure",
                                "keys": [{"frame": 1, "value": 0}, {"frame": 5, "value": 4}]}])";
  const auto sharp = plan(job_of(moves));
  const auto frames = plan(job_of(moves + R"(, "motion_blur": {"shutter": 0.5, "samples": 4})"));
  EXPECT_TRUE(sharp[2].shutter_moments.empty());
  ASSERT_EQ(frames[2].shutter_moments.size(), 4u);
  EXPECT_EQ(encode(frames[2].moment.request), encode(sharp[2].moment.request));
  EXPECT_NE(frames[2].fingerprint, sharp[2].fingerprint);
  for (std::size_t k = 0; k < 4; ++k) {
    const FrameRequest& request = frames[2].shutter_moments[k].request;
    const double later = 0.5 * ((static_cast<double>(k) + 0.5) / 4 - 0.5);
    EXPECT_DOUBLE_EQ(*request.time, (3 + later) / 10);
    EXPECT_NEAR(request.exposure, 2 + later, 1e-12);
    const auto turned =
        turned_camera(sharp[2].moment.request.camera, 1, scene_->scene()->model()->surface.mesh(), 72 * later);
    EXPECT_LT(glm::length(request.camera.position - turned.position), 1e-9) << k;
  }
}

TEST_F(JobFrames, ThatAreBlurredTurnAsFastAsTheirClip) {
  RenderJob job = job_of(R"(, "turntable": {"turns": "camera"}, "motion_blur": {"shutter": 1, "samples": 2})");
  job.frames = "1-9x2";  // five frames: one frame's time is half of the time between two of them
  const auto frames = plan(job);
  const Camera own = frames[1].moment.request.camera, opening = frames[1].shutter_moments[1].request.camera;
  const Camera turned = turned_camera(own, 1, scene_->scene()->model()->surface.mesh(), 72.0 / 2 / 4);
  EXPECT_LT(glm::length(opening.position - turned.position), 1e-9);
}

TEST_F(JobFrames, ThatAreBlurredShareTheirTracingOut) {
  const auto frames = plan(job_of(R"(, "motion_blur": {"samples": 4}, "frame": {"quality": {"method": "strands",
                                      "trace": {"passes": 10, "noise": 0.01, "seconds": 8, "seed": 7}}})"));
  for (std::uint32_t k = 0; k < 4; ++k) {
    const Tracing& trace = frames[0].shutter_moments[k].request.knobs.trace;
    EXPECT_EQ(trace.passes, 3);
    EXPECT_DOUBLE_EQ(trace.noise, 0.02);
    EXPECT_DOUBLE_EQ(trace.seconds, 2);
    EXPECT_EQ(trace.seed, 7 + k);
  }
}

TEST_F(JobFrames, ThatHaveNoMeanAreNotBlurred) {
  plan(job_of(""));
  const auto pointer = [&](const std::string& more) {
    return plan_job(job_of(R"(, "motion_blur": {})" + more), {}, ".", *scene_->scene()).status().pointer;
  };
  EXPECT_EQ(pointer(R"(, "time_lapse": true)"), "/motion_blur");
  EXPECT_EQ(pointer(R"(, "frame": {"budget_ms": 50})"), "/frame/budget_ms");
  EXPECT_EQ(pointer(R"(, "frame": {"overlay": "length"})"), "/frame/overlay");
  EXPECT_EQ(pointer(R"(, "frame": {"quality": {"method": "strands", "trace": {"shutter": 0.1}}})"),
            "/frame/quality/trace/shutter");
}

TEST_F(JobFrames, HaveTheJobsLimitAndNoOther) {
  EXPECT_EQ(plan(job_of("")).front().moment.max_seconds, std::nullopt);
  const RenderJob limited = job_of(R"(, "frame": {"max_seconds": 60})");
  EXPECT_EQ(plan(limited).front().moment.max_seconds, 60);
  EXPECT_EQ(plan(job_of("")).front().fingerprint, plan(limited).front().fingerprint);
}

TEST_F(JobFrames, OfOneTurnCloseTheCircle) {
  const auto frames = plan(job_of(R"(, "turntable": {"turns": "camera"})"));
  const glm::dvec3 first = frames[0].moment.request.camera.position, target = frames[0].moment.request.camera.target;
  for (std::size_t k = 0; k < 5; ++k) {
    const Camera& camera = frames[k].moment.request.camera;
    EXPECT_NEAR(glm::length(camera.position - target), glm::length(first - target), 1e-9);
    EXPECT_NEAR(camera.position.y, first.y, 1e-9);
    const glm::dvec2 a(first.z - target.z, first.x - target.x),
        b(camera.position.z - target.z, camera.position.x - target.x);
    const double turned = std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
    EXPECT_NEAR(std::remainder(glm::degrees(turned) - 72.0 * static_cast<double>(k), 360.0), 0, 1e-6) << k;
    EXPECT_TRUE(frames[k].moment.settings.empty());
  }
}

TEST_F(JobFrames, OfAModelThatTurnsKeepTheLightsOnThePicture) {
  const auto frames = plan(job_of(R"(, "turntable": {"degrees": 100})"));
  const Camera& begin = frames[0].moment.request.camera;
  const auto& lights = std::get<SetLights>(frames[0].moment.settings.at(0)).lights;
  const auto in_view = [](const Camera& camera, glm::dvec3 direction) {
    const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    return glm::dvec3(glm::dot(direction, right), glm::dot(direction, glm::cross(right, forward)),
                      glm::dot(direction, forward));
  };
  for (const JobFrame& frame : frames) {
    const auto& turned = std::get<SetLights>(frame.moment.settings.at(0)).lights;
    for (std::size_t k = 0; k < lights.size(); ++k) {
      const glm::dvec3 difference =
          in_view(frame.moment.request.camera, turned[k].direction) - in_view(begin, lights[k].direction);
      EXPECT_LT(glm::length(difference), 1e-9);
    }
  }
  EXPECT_GT(glm::length(frames[4].moment.request.camera.position - begin.position), 0.5);
}

TEST(Turntables, FinishWhereTheyBeganHoweverFarTheyTurn) {
  const Mesh mesh;
  const Camera camera{.automatic = AutoView::none, .position = {0, 1, 3}, .target = {0, 0.5, 0}};
  for (const double degrees : {360.0, -720.0, 3.6e5}) {
    const Camera turned = turned_camera(camera, 1, mesh, degrees);
    EXPECT_LT(glm::length(turned.position - camera.position), 1e-9) << degrees;
  }
}

TEST_F(JobFrames, OfATimeLapseGoFromTheFirstGroomToTheLast) {
  const RenderJob job = job_of(R"(, "time_lapse": true, "commands": [
      {"op": "length", "value": 0.1, "flood": true}, {"op": "length", "value": 0.2, "flood": true},
      {"op": "smooth", "passes": 2, "flood": true}, {"op": "length", "value": 0.3, "flood": true}])");
  std::vector<std::uint64_t> revisions;
  for (const JobFrame& frame : plan(job)) revisions.push_back(frame.moment.request.revision.value());
  EXPECT_EQ(revisions.front(), 0u);
  EXPECT_TRUE(std::ranges::is_sorted(revisions));
  EXPECT_EQ(revisions.back(), scene_->scene()->summary().revision);
  const auto turned = plan_job(job_of(R"(, "time_lapse": true, "turntable": {})"), {}, ".", *scene_->scene());
  ASSERT_FALSE(turned.ok());
  EXPECT_EQ(turned.status().pointer, "/turntable/turns");
}

TEST(OutputFiles, AreWholeOrNotThere) {
  const auto folder = TemporaryFolder::make();
  const std::string path = folder->file("deep/er/frame.png");
  ASSERT_TRUE(write_atomically(path, "some bytes").ok());
  EXPECT_EQ(*read_file(path), "some bytes");
  EXPECT_FALSE(is_drawn(path, "00"));
  std::filesystem::create_directory(folder->file("taken"));
  std::ofstream(folder->file("taken/file")) << "x";
  const Status refused = write_atomically(folder->file("taken"), "bytes");
  EXPECT_FALSE(refused.ok());
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder->file("."))) {
    ++files;
    EXPECT_EQ(entry.path().filename().string().front() == '.', false) << entry.path();
  }
  EXPECT_EQ(files, 2u);  // the folders `deep` and `taken`
}

TEST(OutputFiles, HaveNamesOfTheirOwnWhileTheyAreWritten) {
  std::set<std::string> names;
  for (int k = 0; k < 1000; ++k) names.insert(temporary_beside("out/fox.0001.png"));
  EXPECT_EQ(names.size(), 1000u);
  EXPECT_TRUE(names.begin()->starts_with("out/.fox.0001.png." + host_name().substr(0, 40) + "-")) << *names.begin();
  EXPECT_TRUE(names.begin()->ends_with(".tmp"));
}

TEST(OutputFiles, TryingAFolderLeavesNothing) {
  const auto folder = TemporaryFolder::make();
  EXPECT_TRUE(check_folder_writable(folder->file("deep/er/frame.png")).ok());
  EXPECT_TRUE(std::filesystem::is_empty(folder->file(".")));
  std::ofstream(folder->file("taken")) << "x";
  EXPECT_EQ(check_folder_writable(folder->file("taken/frame.png")).code, Code::internal);
  EXPECT_EQ(check_folder_writable(folder->file("taken/deeper/frame.png")).code, Code::internal);
}

TEST(InputFiles, RefusePipesAndFolders) {
  const auto folder = TemporaryFolder::make();
  const std::string pipe = folder->file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, folder->file("."), folder->file("none"), std::string("/dev/null")}) {
    const auto bytes = read_file(path);
    ASSERT_FALSE(bytes.ok()) << path;
    EXPECT_EQ(bytes.status().code, Code::not_found);
    EXPECT_NE(bytes.status().message.find(path), std::string::npos);
  }
}

TEST(OutputFiles, AreKnownByTheirFingerprint) {
  const auto folder = TemporaryFolder::make();
  const std::string path = folder->file("frame.png"), print(32, 'a');
  const Image image{2, 2, std::vector<std::uint8_t>(16, 200)};
  const std::vector<ImageText> texts{{"pelage/fingerprint", print}};
  const std::string bytes = encode_png(image, false, texts);
  ASSERT_TRUE(write_atomically(path, bytes).ok());
  EXPECT_TRUE(is_drawn(path, print));
  EXPECT_FALSE(is_drawn(path, std::string(32, 'b')));
  ASSERT_TRUE(write_atomically(path, bytes.substr(0, bytes.size() - 14)).ok());  // truncated
  EXPECT_FALSE(is_drawn(path, print));
  EXPECT_FALSE(is_drawn(folder->file("none.png"), print));
}

TEST(JobScenes, AreRefusedWithWhatIsWrong) {
  RenderJob job;
  job.output = "#.png", job.scene = "none.pelage";
  EXPECT_EQ(JobScene::open(job, "/tmp").status().code, Code::not_found);
  const auto folder = TemporaryFolder::make();
  std::ofstream(folder->file("a.pelage")) << "no scene";
  std::ofstream(folder->file("a.txt")) << "no scene";
  job.scene = folder->file("a.pelage");
  EXPECT_EQ(JobScene::open(job, "/tmp").status().code, Code::invalid);
  job.scene = folder->file("a.txt");
  EXPECT_EQ(JobScene::open(job, "/tmp").status().pointer, "/scene");
  job.scene.clear(), job.builtin = BuiltinModel{Builtin::sphere, 100};
  job.commands = *decode_commands(R"({"op": "comb", "stroke": {"samples": [
      {"triangle": 0, "barycentric": [1, 0, 0]}, {"triangle": 999999, "barycentric": [1, 0, 0]}]}})");
  EXPECT_EQ(JobScene::open(job, "/tmp").status().pointer, "/commands/0/stroke/samples/1/triangle");
}

}  // namespace
}  // namespace pelage::testing
