// The import worker and its limits: whatever the worker does, the caller gets a Status and keeps running.
#include "server/import/import.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "base/random.h"
#include "server/import/map_picture.h"
#include "server/import_worker/parse.h"

namespace pelage::import_test {
namespace {

const std::string one_triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// Makes a folder for the files of each test.
class Import : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "/pelage_import_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Writes a shell script to use in place of the worker.
  std::string script(const std::string& text) const {
    const std::string path = folder_ + "/worker";
    std::ofstream(path) << "#!/bin/sh\n" << text << "\n";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

  Status run(const std::string& worker, const std::string& bytes, ImportLimits limits = {}) const {
    const Result<RawModel> model = import_model(worker, ModelFormat::obj, bytes_of(bytes), "", limits);
    return model.ok() ? Status() : model.status();
  }

  std::string folder_;
};

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(Import, ReadsOneTriangle) {
  const Result<RawModel> model = import_model(PELAGE_IMPORT, ModelFormat::obj, bytes_of(one_triangle));
  ASSERT_TRUE(model.ok()) << model.status().message;
  EXPECT_EQ(model->positions.size(), 3u);
  EXPECT_EQ(model->corners, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_FALSE(model->is_32_bit);
}

TEST_F(Import, DeadlineEndsTheWorker) {
  ImportLimits limits;
  limits.seconds = 0.2;
  const Status status = run(script("exec sleep 60"), one_triangle, limits);
  EXPECT_EQ(status.code, Code::invalid);
  EXPECT_TRUE(contains(status.message, "longer than 0.2 s")) << status.message;
}

TEST_F(Import, DeadlineEndsTheRealWorker) {
  std::string large;
  while (large.size() < 20'000'000) large += "v 0.123456 0.234567 0.345678\nf 1 2 3 4 5 6\n";
  ImportLimits limits;
  limits.seconds = 0.01;
  const Status status = run(PELAGE_IMPORT, large, limits);
  EXPECT_EQ(status.code, Code::invalid);
  EXPECT_TRUE(contains(status.message, "longer than")) << status.message;
}

TEST_F(Import, MemoryLimitIsARefusal) {
  if (is_sanitized) GTEST_SKIP() << "the address space is not limited under sanitizers";
  std::string large;
  while (large.size() < 60'000'000) large += "v 0.123456 0.234567 0.345678\nf 1 2 3 4 5 6\n";
  ImportLimits limits;
  limits.memory_bytes = std::size_t{200} << 20;  // three times the size of the file
  const Status status = run(PELAGE_IMPORT, large, limits);
  EXPECT_EQ(status.code, Code::invalid);
  EXPECT_TRUE(contains(status.message, "memory")) << status.message;
}

TEST_F(Import, CrashesAreRefusalsThatSaySo) {
  const Status crashed = run(script("kill -SEGV $$"), one_triangle);
  EXPECT_EQ(crashed.code, Code::invalid);
  EXPECT_TRUE(contains(crashed.message, "crashed")) << crashed.message;
  EXPECT_TRUE(contains(run(script("kill -XCPU $$"), one_triangle).message, "processor time"));
  EXPECT_TRUE(contains(run(script("kill -SYS $$"), one_triangle).message, "must not"));
}

TEST_F(Import, ReasonIsTheLastLineOfTheErrorOutput) {
  const Status status = run(script("echo noise >&2; echo face 7 is bad >&2; exit 3"), one_triangle);
  EXPECT_EQ(status.message, "The model cannot be read: face 7 is bad");
}

TEST_F(Import, NonsenseAndTooLongAnswersAreRefused) {
  EXPECT_EQ(run(script("echo hello"), one_triangle).code, Code::invalid);
  EXPECT_EQ(run(script("exit 0"), one_triangle).code, Code::invalid);
  ImportLimits limits;
  limits.answer_bytes = 1000;
  const Status status = run(script("exec yes"), one_triangle, limits);
  EXPECT_EQ(status.code, Code::invalid);
  EXPECT_TRUE(contains(status.message, "larger than 1000")) << status.message;
}

TEST_F(Import, WorkerThatDoesNotListenRaisesNoSignalHere) {
  const std::string large(5'000'000, 'v');
  EXPECT_EQ(run(script("echo no >&2; exit 3"), large).code, Code::invalid);
}

TEST_F(Import, MissingWorkerIsInternal) { EXPECT_EQ(run(folder_ + "/nothing", one_triangle).code, Code::internal); }

TEST_F(Import, WorkerInheritsNoDescriptorAndNoEnvironment) {
  const int leaked = fcntl(STDERR_FILENO, F_DUPFD, 77);  // without close-on-exec
  ASSERT_GE(leaked, 77);
  setenv("PELAGE_TEST_SECRET", "secret", 1);
  const Status status = run(script("echo [$(ls /proc/self/fd)] [$PELAGE_TEST_SECRET] >&2; exit 3"), one_triangle);
  close(leaked);
  EXPECT_TRUE(contains(status.message, "[0 1 2")) << status.message;
  EXPECT_FALSE(contains(status.message, std::to_string(leaked))) << status.message;
  EXPECT_FALSE(contains(status.message, "secret")) << status.message;
}

/// Opening a FIFO without a writer blocks for ever, so a reader that opens it misses the deadline.
TEST_F(Import, FilesNamedInsideAModelAreNotOpened) {
  const std::string fifo = folder_ + "/materials.mtl";
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  ImportLimits limits;
  limits.seconds = 20;
  EXPECT_TRUE(run(PELAGE_IMPORT, "mtllib " + fifo + "\nusemtl a\n" + one_triangle, limits).ok());
  const std::string gltf = R"({"asset": {"version": "2.0"}, "buffers": [{"uri": ")" + fifo + R"(", "byteLength": 4}]})";
  const Result<RawModel> model = import_model(PELAGE_IMPORT, ModelFormat::gltf, bytes_of(gltf), "", limits);
  ASSERT_FALSE(model.ok());
  EXPECT_TRUE(contains(model.status().message, fifo)) << model.status().message;
}

TEST_F(Import, OtherFormatsAreNotGuessed) {
  for (const ModelFormat format :
       {ModelFormat::ply, ModelFormat::stl, ModelFormat::off, ModelFormat::gltf, ModelFormat::glb, ModelFormat::tds}) {
    const Result<RawModel> model = import_model(PELAGE_IMPORT, format, bytes_of(one_triangle));
    EXPECT_FALSE(model.ok()) << static_cast<int>(format);
  }
}

TEST_F(Import, AnEnvironmentIsReadAsLight) {
  const std::string hdr =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n" + std::string("\x80\x40\x00\x81\x80\x40\x00\x81", 8);
  const Result<SphericalHarmonics> light = import_environment(PELAGE_IMPORT, bytes_of(hdr));
  ASSERT_TRUE(light.ok()) << light.status().message;
  EXPECT_NEAR((*light)[0].x, 3.5449, 0.02);
  EXPECT_NEAR((*light)[0].y, 3.5449 / 2, 0.02);
  EXPECT_NEAR(glm::length((*light)[3]), 0, 1e-6);
  const Status refused = import_environment(PELAGE_IMPORT, bytes_of("x")).status();
  EXPECT_EQ(refused.code, Code::invalid);
  EXPECT_EQ(refused.message, "The environment cannot be read: it is neither PNG, JPEG, EXR nor HDR.");
}

TEST_F(Import, APictureThatCannotBeReadIsSaidOnce) {
  EXPECT_EQ(import_picture(PELAGE_IMPORT, bytes_of("x")).status().message,
            "The picture cannot be read: it is neither PNG nor JPEG.");
  EXPECT_EQ(import_map(PELAGE_IMPORT, bytes_of("x")).status().message,
            "The picture cannot be read: it is neither PNG, JPEG, EXR nor HDR.");
}

TEST_F(Import, NonsenseInPlaceOfPicturesIsRefused) {
  const std::string worker = script("echo hello");
  EXPECT_EQ(import_environment(worker, bytes_of("x")).status().code, Code::invalid);
  EXPECT_EQ(import_picture(worker, bytes_of("x")).status().code, Code::invalid);
  EXPECT_EQ(import_picture(script("kill -SEGV $$"), bytes_of("x")).status().code, Code::invalid);
}

TEST(PictureCodec, PicturesComeBackAndDamageIsRefused) {
  SphericalHarmonics light{};
  for (std::size_t i = 0; i < 9; ++i) light[i] = {double(i), -1e6, 0.1};
  EXPECT_EQ(*decode_harmonics(bytes_of(encode_harmonics(light))), light);
  EXPECT_FALSE(decode_harmonics(bytes_of(encode_harmonics(light) + "x")).ok());
  light[4].z = 1.1e6;
  EXPECT_FALSE(decode_harmonics(bytes_of(encode_harmonics(light))).ok());
  light[4].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(decode_harmonics(bytes_of(encode_harmonics(light))).ok());

  const RawImage image{1, 2, {1, 2, 3, 4, 5, 6, 7, 8}};
  const std::string bytes = encode_raw_image(image);
  EXPECT_EQ(decode_raw_image(bytes_of(bytes))->rgba, image.rgba);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(decode_raw_image(bytes_of(bytes.substr(0, length))).ok()) << length;
  }
  EXPECT_FALSE(decode_raw_image(bytes_of(bytes + "x")).ok());
  EXPECT_FALSE(decode_raw_image(bytes_of(encode_raw_image({-1, 2, image.rgba}))).ok());
  EXPECT_FALSE(decode_raw_image(bytes_of(encode_raw_image({0, 0, {}}))).ok());
}

RawModel everything() {
  RawModel model;
  model.is_32_bit = true;
  model.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  model.face_sizes = {3, 4};
  model.corners = {0, 1, 2, 0, 2, 3, no_position};
  model.corner_uv.assign(7, {0.25, 0.5});
  model.corner_colour.assign(7, {1, 0.5f, 0.25f, 1});
  model.face_material = {0, 1};
  model.materials = {{{1, 1, 1}, 0, "Fur"}, {{0.5f, 0.5f, 0.5f}, -1}};
  model.images = {{2, 1, {1, 2, 3, 4, 5, 6, 7, 8}}};
  model.length_scale = {1, 0.5f, 2, 4};
  model.front = Axis::minus_x;
  model.pose = "Walk@0.5", model.animations = {"Walk", ""};
  model.add_loss("missing_pictures", "fur.png", 2);
  return model;
}

TEST(RawCodec, ModelsComeBack) {
  const std::string bytes = encode_raw_model(everything());
  const Result<RawModel> back = decode_raw_model(bytes_of(bytes));
  ASSERT_TRUE(back.ok()) << back.status().message;
  EXPECT_EQ(encode_raw_model(*back), bytes);
  EXPECT_EQ(back->corners, everything().corners);
  EXPECT_EQ(back->images[0].rgba, everything().images[0].rgba);
  EXPECT_TRUE(back->is_32_bit);
  EXPECT_EQ(back->front, Axis::minus_x);
  EXPECT_EQ(back->materials[0].name, "Fur");
  EXPECT_EQ(back->losses, everything().losses);
}

/// Expects that a model is read in an earlier format: with that version digit, and without its last `less` bytes.
void expect_read(const RawModel& model, char version, std::size_t less) {
  std::string bytes = encode_raw_model(model);
  bytes[6] = version;
  bytes.resize(bytes.size() - less);
  const Result<RawModel> back = decode_raw_model(bytes_of(bytes));
  ASSERT_TRUE(back.ok()) << back.status().message;
  EXPECT_EQ(encode_raw_model(*back), encode_raw_model(model));
}

TEST(RawCodec, ModelsOfEarlierJournalsAreRead) {
  RawModel model = everything();
  for (RawMaterial& material : model.materials) material.name.clear();
  constexpr std::size_t names = 8 + 2 * 8;  // the empty names of two materials
  expect_read(model, '2', names);
  model.front.reset(), model.pose.clear(), model.animations.clear(), model.losses.clear();
  expect_read(model, '1', names + 2 + 8 + 8 + 8 + 8);  // axes, one empty text, no animations, no losses
}

TEST(RawCodec, EveryTruncationAndAnyTrailingByteIsRefused) {
  const std::string bytes = encode_raw_model(everything());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(decode_raw_model(bytes_of(bytes.substr(0, length))).ok()) << length;
  }
  EXPECT_FALSE(decode_raw_model(bytes_of(bytes + "x")).ok());
}

TEST(RawCodec, BrokenContentIsRefused) {
  const auto refused = [](auto breaks) {
    RawModel model = everything();
    breaks(model);
    return !decode_raw_model(bytes_of(encode_raw_model(model))).ok();
  };
  EXPECT_FALSE(refused([](RawModel&) {}));
  EXPECT_TRUE(refused([](RawModel& m) { m.corners[1] = 4; }));
  EXPECT_TRUE(refused([](RawModel& m) { m.face_sizes = {3, 3}; }));
  EXPECT_TRUE(refused([](RawModel& m) { m.face_sizes = {7, 0}; }));
  EXPECT_TRUE(refused([](RawModel& m) { m.corner_uv.pop_back(); }));
  EXPECT_TRUE(refused([](RawModel& m) { m.face_material[0] = 2; }));
  EXPECT_TRUE(refused([](RawModel& m) { m.materials[0].image = 1; }));
  EXPECT_TRUE(refused([](RawModel& m) { m.images[0].width = 3; }));
  EXPECT_TRUE(refused([](RawModel& m) { m.images[0].width = m.images[0].height = 0; }));
  EXPECT_TRUE(refused([](RawModel& m) { m.length_scale[2] = 0; }));
}

/// Wrong counts are refused before memory is allocated for them; whatever is accepted is valid.
TEST(RawCodec, RandomDamageIsRefusedOrHarmless) {
  const std::string bytes = encode_raw_model(everything());
  Random random(7);
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = bytes;
    for (int k = 0; k < 3; ++k) {
      damaged[static_cast<std::size_t>(random.uniform() * static_cast<double>(damaged.size()))] =
          static_cast<char>(static_cast<int>(random.uniform() * 256) - 128);
    }
    const Result<RawModel> model = decode_raw_model(bytes_of(damaged));
    if (!model.ok()) continue;
    for (std::uint32_t corner : model->corners) ASSERT_TRUE(corner < model->positions.size() || corner == no_position);
  }
}

TEST(ProgramFolder, HoldsThisProgram) { EXPECT_TRUE(std::filesystem::exists(program_folder() + "/unit_surface")); }

}  // namespace
}  // namespace pelage::import_test
