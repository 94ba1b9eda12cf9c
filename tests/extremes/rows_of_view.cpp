// Rows of light, camera and eye.
#include "tests/extremes/row.h"

namespace pelage::testing {

namespace {

const std::string small = R"("width": 16, "height": 12)";

Row of_light(std::string value, const std::string& light, const std::string& quality = {}, std::string refused = {}) {
  return {
      .area = "light",
      .value = std::move(value),
      .commands = {R"({"op": "set_lights", "lights": [{)" + light + "}]}"},
      .frame = "{" + small + R"(, "quality": {"method": "shells", "shells": {"shadow_maps": true)" + quality + "}}}",
      .refused = std::move(refused)};
}

Row of_camera(std::string value, const std::string& camera, std::string refused = {}) {
  return {.area = "camera",
          .value = std::move(value),
          .frame = "{" + small + R"(, "camera": {)" + camera + "}}",
          .refused = std::move(refused)};
}

Row of_frame(std::string value, const std::string& frame, std::string refused = {}) {
  return {.area = "camera", .value = std::move(value), .frame = "{" + frame + "}", .refused = std::move(refused)};
}

/// An eye in front of the ball. The ball's radius is 1, its size 3.46.
Row of_eye(std::string value, const std::string& eye, std::string refused = {}, const std::string& steps = "8",
           const std::string& camera = R"("position": [0, 0, 2], "target": [0, 0, 1])") {
  return {.area = "eye",
          .value = std::move(value),
          .commands = {R"({"op": "set_eyes", "eyes": [{"position": [0, 0, 1], )" + eye + "}]}"},
          .frame = "{" + small + R"(, "camera": {)" + camera + R"(}, "quality": {"eye_steps": )" + steps + "}}",
          .refused = std::move(refused)};
}

const std::string all_shadows = R"(, "self_shadow_maps": true, "cast_shadow": "soft")";

void add_lights_at_positions(Rows& rows, const std::string& kind, const std::string& more) {
  struct LightPosition {
    const char *name, *position;
  };
  for (const LightPosition& position :
       {LightPosition{"on the surface", "[0, 0, 1]"}, LightPosition{"inside the fur", "[0, 0, 1.08]"},
        LightPosition{"at the tips", "[0, 0, 1.1732]"}, LightPosition{"in the middle of the model", "[0, 0, 0]"},
        LightPosition{"1e6 away", "[0, 1e6, 0]"}, LightPosition{"1e27 away", "[0, 1e27, 0]"}}) {
    for (const char* intensity : {"0", "1", "1e8"}) {
      rows.push_back(of_light(kind + " " + position.name + ", intensity " + intensity,
                              R"("kind": ")" + kind + R"(", "position": )" + position.position + R"(, "intensity": )" +
                                  intensity + more + all_shadows,
                              R"(, "shadow_resolution": 32)"));
    }
  }
}

const std::string spot_above = R"("kind": "spot", "direction": [0, -1, 0], "intensity": 10, "position": )";
const std::string sun = R"("direction": [0, -1, 0])";

void add_shadow_maps(Rows& rows) {
  rows.push_back(
      of_light("shadow map of 1 x 1, a spot", spot_above + "[0, 3, 0]" + all_shadows, R"(, "shadow_resolution": 1)"));
  rows.push_back(of_light("shadow map of 1 x 1, a sun", sun + all_shadows, R"(, "shadow_resolution": 1)"));
  rows.push_back(
      of_light("shadow map of 1 x 1, hard", sun + R"(, "cast_shadow": "hard")", R"(, "shadow_resolution": 1)"));
  for (const char* position : {"[0, 1.0000001, 0]", "[0, 1.05, 0]", "[0, 1.1733, 0]"}) {
    rows.push_back(of_light(std::string("a caster on the near plane: spot at ") + position,
                            spot_above + position + all_shadows, R"(, "shadow_resolution": 64)"));
    for (const std::string edge : {"hard", "penumbra"}) {
      rows.push_back(of_light("the same, " + edge + ": spot at " + position,
                              spot_above + position + R"(, "cast_shadow": ")" + edge + '"',
                              R"(, "shadow_resolution": 64)"));
    }
  }
  rows.push_back(of_light("a spot of 0.1 degrees", spot_above + R"([0, 3, 0], "cone_degrees": 0.1)" + all_shadows));
  rows.push_back(of_light("shadow scale 0", sun + all_shadows + R"(, "shadow_scale": 0)"));
  rows.push_back(of_light("shadow scale 1000", sun + all_shadows + R"(, "shadow_scale": 1000)"));
}

void add_penumbras(Rows& rows) {
  const std::string penumbra = R"(, "cast_shadow": "penumbra")";
  rows.push_back(of_light("shadow map of 1 x 1, penumbra", sun + penumbra, R"(, "shadow_resolution": 1)"));
  for (const char* angle : {"0", "90"})
    rows.push_back(of_light(std::string("penumbra of a sun that spans ") + angle + " degrees",
                            sun + penumbra + R"(, "angle_degrees": )" + angle));
  for (const char* radius : {"0", "10"})
    rows.push_back(of_light(std::string("penumbra of a spot of radius ") + radius,
                            spot_above + R"([0, 3, 0], "radius": )" + radius + penumbra));
  rows.push_back(
      of_light("a sun that spans 90 degrees, intensity 1e8", sun + R"(, "angle_degrees": 90, "intensity": 1e8)"));
}

void add_refused_lights(Rows& rows) {
  rows.push_back(of_light("intensity over 1e8", R"("intensity": 1.1e8)", "", "/lights/0/intensity"));
  rows.push_back(of_light("intensity below 0", R"("intensity": -1)", "", "/lights/0/intensity"));
  rows.push_back(of_light("a direction of no length", R"("direction": [0, 0, 0])", "", "/lights/0/direction"));
  rows.push_back(
      of_light("a position beyond 1e27", R"("kind": "point", "position": [1e28, 0, 0])", "", "/lights/0/position/0"));
  rows.push_back(
      of_light("shadow map of 0 x 0", sun, R"(, "shadow_resolution": 0)", "/quality/shells/shadow_resolution"));
}

void add_many_lights(Rows& rows) {
  Row eight = of_light("eight lights of 1e8 at one position", "");
  std::string lights;
  for (int i = 0; i < 8; ++i)
    lights += std::string(i ? ", " : "") +
              R"({"kind": "point", "position": [0, 0, 1.02], "intensity": 1e8, "self_shadow_maps": true})";
  eight.commands = {R"({"op": "set_lights", "lights": [)" + lights + "]}"};
  rows.push_back(eight);
  Row nine = eight;
  nine.value = "nine lights", nine.refused = "/lights";
  nine.commands = {R"({"op": "set_lights", "lights": [{}, )" + lights + "]}"};
  rows.push_back(nine);
}

void add_harmonics(Rows& rows) {
  for (const char* harmonic : {"-1e6", "1e6"}) {
    const std::string one = std::string("[") + harmonic + ", " + harmonic + ", 1]";
    std::string nine_of_them = one;
    for (int i = 1; i < 9; ++i) nine_of_them += ", " + one;
    Row row = of_light(std::string("surroundings of harmonics ") + harmonic + ", intensity 100", "");
    row.commands = {R"({"op": "set_environment", "environment": {"intensity": 100, "harmonics": [)" + nine_of_them +
                    "]}}"};
    rows.push_back(row);
  }
}

}  // namespace

Rows light_rows() {
  Rows rows;
  add_lights_at_positions(rows, "point", "");
  add_lights_at_positions(rows, "spot", R"(, "direction": [0, 0, -1], "cone_degrees": 90)");
  add_lights_at_positions(rows, "area", R"(, "direction": [0, 0, -1])");
  add_shadow_maps(rows);
  add_penumbras(rows);
  add_refused_lights(rows);
  add_many_lights(rows);
  add_harmonics(rows);
  return rows;
}

Rows camera_rows() {
  Rows rows{
      of_camera("inside the fur", R"("position": [0, 0, 1.08], "target": [0, 0, 0])"),
      of_camera("inside the fur, outwards", R"("position": [0, 0, 1.08], "target": [0, 0, 2])"),
      of_camera("on the skin", R"("position": [0, 0, 1], "target": [0, 0, 0])"),
      of_camera("on the skin, along it", R"("position": [0, 0, 1], "target": [1, 0, 1])"),
      of_camera("in the middle of the model", R"("position": [0, 0, 0], "target": [0, 0, 1])"),
      of_camera("grazing the tips", R"("position": [0, 1.1, 4], "target": [0, 1.1, 0])"),
      of_camera("grazing the skin, 1 degree wide", R"("position": [0, 1, 4], "target": [0, 1, 0], "fov_degrees": 1)"),
      of_camera("far over near 1e7: 1e-7 above the tips",
                R"("position": [0, 0, 1.1732052], "target": [0, 0, 0], "fov_degrees": 150)"),
      of_camera("far over near 1e7: 3.5e7 away", R"("position": [0, 0, 3.5e7], "target": [0, 0, 0], "fov_degrees": 1)"),
      of_camera("1e27 away", R"("position": [1e27, 1e27, 0], "target": [0, 0, 0])"),
      of_camera("150 degrees wide", R"("position": [0, 0, 1.3], "target": [0, 0, 0], "fov_degrees": 150)"),
      of_camera("0.9 degrees wide", R"("position": [0, 0, 3], "target": [0, 0, 0], "fov_degrees": 0.9)",
                "/camera/fov_degrees"),
      of_camera("at its target", R"("position": [0, 0, 3], "target": [0, 0, 3])", "/camera"),
      of_camera("up along the view", R"("position": [0, 3, 0], "target": [0, 0, 0])", "/camera/up"),
      of_camera("beyond 1e27", R"("position": [0, 1e28, 0], "target": [0, 0, 0])", "/camera/position/1")};
  for (const char* size : {R"("width": 1, "height": 1)", R"("width": 1, "height": 300)", R"("width": 300, "height": 1)",
                           R"("width": 2048, "height": 1)"})
    rows.push_back(of_frame(std::string("picture: ") + size, size));
  rows.push_back(of_frame("1 x 1 at a quarter of the size", R"("width": 1, "height": 1, "quality": {"scale": 0.25})"));
  rows.push_back(of_frame("1 x 1 at twice the size", R"("width": 1, "height": 1, "quality": {"scale": 2})"));
  rows.push_back(of_frame("exposure 20", small + R"(, "exposure": 20)"));
  rows.push_back(of_frame("exposure -20", small + R"(, "exposure": -20)"));
  rows.push_back(of_frame("exposure 21", small + R"(, "exposure": 21)", "/exposure"));
  rows.push_back(of_frame("0 x 0", R"("width": 0, "height": 0)", "/width"));
  rows.push_back(of_frame("8193 wide", R"("width": 8193, "height": 8)", "/width"));
  rows.push_back(of_frame("8192 x 8192 at twice the size", R"("width": 8192, "height": 8192, "quality": {"scale": 2})",
                          "/quality"));
  rows.push_back(of_frame(
      "8192 x 8192, sorted, 64 shells",
      R"("width": 8192, "height": 8192, "quality": {"method": "shells", "shells": {"order": "sorted", "count": 64}})",
      "/quality"));
  rows.push_back(of_frame("8192 x 8192, two AOVs of an EXR",
                          R"("width": 8192, "height": 8192, "format": "exr", "aovs": ["beauty", "depth"])", "/aovs"));
  return rows;
}

Rows eye_rows() {
  Rows rows;
  const std::string ball = R"("radius": 0.1)";
  for (const char* index : {"1", "3"}) {
    const std::string eye = ball + R"(, "refraction": )" + index;
    rows.push_back(of_eye(std::string("n = ") + index, eye));
    rows.push_back(of_eye(std::string("n = ") + index + ", seen at 89.9 degrees", eye, "", "8",
                          R"("position": [2, 0, 1.0034907], "target": [0, 0, 1])"));
    rows.push_back(of_eye(std::string("n = ") + index + ", iris depth 0, relief 0.2",
                          eye + R"(, "iris": {"depth": 0, "relief": 0.2})"));
    for (const char* pupil : {"0", "1"})
      rows.push_back(of_eye(std::string("n = ") + index + ", pupil " + pupil + ", a slit",
                            eye + R"(, "pupil": {"shape": "slit", "size": )" + pupil + "}"));
    for (const char* steps : {"0", "1", "64"})
      rows.push_back(of_eye(std::string("n = ") + index + ", " + steps + " steps", eye, "", steps));
  }
  rows.push_back(of_eye("no bulge, iris depth 0.5", ball + R"(, "bulge": 0, "iris": {"depth": 0.5})"));
  rows.push_back(of_eye("radius 1e-6 sizes", R"("radius": 1e-6)"));
  rows.push_back(of_eye("radius 1e6 sizes, around everything", R"("radius": 1e6)"));
  rows.push_back(of_eye("seen from inside", ball, "", "8", R"("position": [0, 0, 1.1], "target": [0, 0, 0])"));
  rows.push_back(of_eye("lids that are shut", ball + R"(, "lids": {"upper_degrees": -90, "lower_degrees": -90})"));
  rows.push_back(of_eye("radius 0", R"("radius": 0)", "/eyes/0/radius"));
  rows.push_back(of_eye("n = 0.9", ball + R"(, "refraction": 0.9)", "/eyes/0/refraction"));
  rows.push_back(of_eye("n = 3.1", ball + R"(, "refraction": 3.1)", "/eyes/0/refraction"));
  rows.push_back(of_eye("a pupil of 1.1", ball + R"(, "pupil": {"size": 1.1})", "/eyes/0/pupil/size"));
  rows.push_back(of_eye("looking at its own centre", ball + R"(, "look_at": [0, 0, 1])", "/eyes/0/look_at"));
  rows.push_back(of_eye("65 steps", ball, "/quality/eye_steps", "65"));
  return rows;
}

}  // namespace pelage::testing
