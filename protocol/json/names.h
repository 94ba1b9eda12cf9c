// The words of the contract for each enumerator; decoding and encoding share them.
#pragma once

#include <array>
#include <cassert>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/commands/answers.h"
#include "protocol/commands/command.h"
#include "protocol/commands/export.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/guides.h"
#include "protocol/commands/job.h"
#include "protocol/commands/quality.h"
#include "protocol/commands/scene.h"

namespace pelage::json_names {

template <class E>
struct Name {
  std::string_view text;
  E value;
};

inline constexpr std::array<Name<Units>, 2> units{{{"relative", Units::relative}, {"world", Units::world}}};
inline constexpr std::array<Name<RadiusUnits>, 3> radius_units{
    {{"relative", RadiusUnits::relative}, {"world", RadiusUnits::world}, {"pixels", RadiusUnits::pixels}}};
inline constexpr std::array<Name<FalloffShape>, 3> falloff_shapes{
    {{"volume", FalloffShape::volume}, {"surface", FalloffShape::surface}, {"screen", FalloffShape::screen}}};
inline constexpr std::array<Name<Reach>, 2> reaches{{{"skin", Reach::skin}, {"fur", Reach::fur}}};
inline constexpr std::array<Name<StrandKind>, 2> strand_kinds{
    {{"coat", StrandKind::coat}, {"curve", StrandKind::curve}}};
inline constexpr std::array<Name<DistanceKind>, 3> distance_kinds{
    {{"straight", DistanceKind::straight}, {"dijkstra", DistanceKind::dijkstra}, {"heat", DistanceKind::heat}}};
inline constexpr std::array<Name<Alignment>, 2> alignments{{{"box", Alignment::box}, {"none", Alignment::none}}};
inline constexpr std::array<Name<LengthMode>, 7> length_modes{{{"set", LengthMode::set},
                                                               {"add", LengthMode::add},
                                                               {"scale", LengthMode::scale},
                                                               {"average", LengthMode::average},
                                                               {"jitter", LengthMode::jitter},
                                                               {"min", LengthMode::min},
                                                               {"max", LengthMode::max}}};
inline constexpr std::array<Name<EditLayerAction>, 5> edit_layer_actions{{{"add", EditLayerAction::add},
                                                                          {"set", EditLayerAction::set},
                                                                          {"move", EditLayerAction::move},
                                                                          {"merge_down", EditLayerAction::merge_down},
                                                                          {"remove", EditLayerAction::remove}}};
inline constexpr std::array<Name<CoatRegion>, 3> coat_regions{
    {{"all", CoatRegion::all}, {"none", CoatRegion::none}, {"mask", CoatRegion::mask}}};
inline constexpr std::array<Name<MaskAction>, 5> mask_actions{{{"select", MaskAction::select},
                                                               {"grow", MaskAction::grow},
                                                               {"shrink", MaskAction::shrink},
                                                               {"smooth", MaskAction::smooth},
                                                               {"invert", MaskAction::invert}}};
inline constexpr std::array<Name<MaskCombine>, 4> mask_combines{{{"replace", MaskCombine::replace},
                                                                 {"add", MaskCombine::add},
                                                                 {"subtract", MaskCombine::subtract},
                                                                 {"intersect", MaskCombine::intersect}}};
inline constexpr std::array<Name<PictureChannel>, 5> picture_channels{{{"luminance", PictureChannel::luminance},
                                                                       {"red", PictureChannel::red},
                                                                       {"green", PictureChannel::green},
                                                                       {"blue", PictureChannel::blue},
                                                                       {"alpha", PictureChannel::alpha}}};
inline constexpr std::array<Name<MapEncoding>, 6> map_encodings{{{"automatic", MapEncoding::automatic},
                                                                 {"value", MapEncoding::value},
                                                                 {"uv_tangent", MapEncoding::uv_tangent},
                                                                 {"fast_fur", MapEncoding::fast_fur},
                                                                 {"vector", MapEncoding::vector},
                                                                 {"vertices", MapEncoding::vertices}}};
inline constexpr std::array<Name<MapFormat>, 5> map_formats{{{"png", MapFormat::png},
                                                             {"png16", MapFormat::png16},
                                                             {"exr", MapFormat::exr},
                                                             {"exr_half", MapFormat::exr_half},
                                                             {"npy", MapFormat::npy}}};
/// The names of the fields, from the table of their shapes.
constexpr std::array<Name<Field>, field_count> make_field_names() {
  std::array<Name<Field>, field_count> names{};
  for (std::size_t f = 0; f < field_count; ++f) names[f] = {shape_of(field_at(f)).name, field_at(f)};
  return names;
}
inline constexpr std::array<Name<Field>, field_count> fields = make_field_names();
inline constexpr std::array<Name<Falloff>, 5> falloffs{{{"constant", Falloff::constant},
                                                        {"linear", Falloff::linear},
                                                        {"smooth", Falloff::smooth},
                                                        {"sharp", Falloff::sharp},
                                                        {"sphere", Falloff::sphere}}};
inline constexpr std::array<Name<KeyInterpolation>, 3> key_interpolations{
    {{"step", KeyInterpolation::step}, {"linear", KeyInterpolation::linear}, {"spline", KeyInterpolation::spline}}};
inline constexpr std::array<Name<Turning>, 2> turnings{{{"model", Turning::model}, {"camera", Turning::camera}}};
inline constexpr std::array<Name<AutoView>, 6> auto_views{{{"front", AutoView::front},
                                                           {"back", AutoView::back},
                                                           {"left", AutoView::left},
                                                           {"right", AutoView::right},
                                                           {"top", AutoView::top},
                                                           {"three_quarter", AutoView::three_quarter}}};
inline constexpr std::array<Name<LeanCurve>, 2> lean_curves{{{"arc", LeanCurve::arc}, {"root", LeanCurve::root}}};
inline constexpr std::array<Name<PatternKind>, 7> pattern_kinds{{{"none", PatternKind::none},
                                                                 {"stripes", PatternKind::stripes},
                                                                 {"spots", PatternKind::spots},
                                                                 {"rosettes", PatternKind::rosettes},
                                                                 {"tabby", PatternKind::tabby},
                                                                 {"patches", PatternKind::patches},
                                                                 {"countershading", PatternKind::countershading}}};
inline constexpr std::array<Name<ColourSource>, 3> colour_sources{
    {{"automatic", ColourSource::automatic}, {"model", ColourSource::model}, {"coat", ColourSource::coat}}};
inline constexpr std::array<Name<ShadingModel>, 6> shading_models{
    {{"lengyel", ShadingModel::lengyel},
     {"kajiya", ShadingModel::kajiya},
     {"energy_conserving", ShadingModel::energy_conserving},
     {"scheuermann", ShadingModel::scheuermann},
     {"kajiya_kay", ShadingModel::kajiya_kay},
     {"marschner", ShadingModel::marschner}}};
inline constexpr std::array<Name<Absorption>, 2> absorptions{
    {{"colour", Absorption::colour}, {"melanin", Absorption::melanin}}};
inline constexpr std::array<Name<LightKind>, 4> light_kinds{{{"directional", LightKind::directional},
                                                             {"point", LightKind::point},
                                                             {"spot", LightKind::spot},
                                                             {"area", LightKind::area}}};
inline constexpr std::array<Name<CastShadow>, 4> cast_shadows{{{"none", CastShadow::none},
                                                               {"hard", CastShadow::hard},
                                                               {"soft", CastShadow::soft},
                                                               {"penumbra", CastShadow::penumbra}}};
inline constexpr std::array<Name<PupilShape>, 2> pupil_shapes{
    {{"round", PupilShape::round}, {"slit", PupilShape::slit}}};
inline constexpr std::array<Name<Tier>, 4> tiers{{{"draft", Tier::draft},
                                                  {"interactive", Tier::interactive},
                                                  {"detailed", Tier::detailed},
                                                  {"reference", Tier::reference}}};
inline constexpr std::array<Name<Method>, 3> methods{
    {{"raster", Method::raster}, {"strands", Method::strands}, {"shells", Method::shells}}};
inline constexpr std::array<Name<Transport>, 2> transports{
    {{"transmittance", Transport::transmittance}, {"paths", Transport::paths}}};
inline constexpr std::array<Name<StrandScattering>, 2> strand_scatterings{
    {{"look", StrandScattering::look}, {"energy_conserving", StrandScattering::energy_conserving}}};
inline constexpr std::array<Name<TraceEnd>, 4> trace_ends{{{"none", TraceEnd::none},
                                                           {"passes", TraceEnd::passes},
                                                           {"noise", TraceEnd::noise},
                                                           {"seconds", TraceEnd::seconds}}};
inline constexpr std::array<Name<EntryKind>, 6> entry_kinds{{{"do", EntryKind::command},
                                                             {"join", EntryKind::join},
                                                             {"undo", EntryKind::undo},
                                                             {"redo", EntryKind::redo},
                                                             {"revert", EntryKind::revert},
                                                             {"replay", EntryKind::replay}}};
inline constexpr std::array<Name<PlanEnd>, 5> plan_ends{{{"asked", PlanEnd::asked},
                                                         {"budget", PlanEnd::budget},
                                                         {"error", PlanEnd::error},
                                                         {"best", PlanEnd::best},
                                                         {"cheapest", PlanEnd::cheapest}}};
/// What the error of a FrameEstimate is measured against. There is only one choice, so the struct has no member for it.
inline constexpr std::array<Name<std::size_t>, 1> error_references{{{"traced_strands", 0}}};
inline constexpr std::array<Name<ShellPolicy>, 2> shell_policies{
    {{"uniform", ShellPolicy::uniform}, {"adaptive", ShellPolicy::adaptive}}};
inline constexpr std::array<Name<FragmentOrder>, 2> fragment_orders{
    {{"four_pass", FragmentOrder::four_pass}, {"sorted", FragmentOrder::sorted}}};
inline constexpr std::array<Name<ToneMap>, 2> tone_maps{{{"none", ToneMap::none}, {"filmic", ToneMap::filmic}}};
inline constexpr std::array<Name<ExportFormat>, 6> export_formats{{{"usda", ExportFormat::usda},
                                                                   {"hair", ExportFormat::hair},
                                                                   {"shells", ExportFormat::shells},
                                                                   {"cards", ExportFormat::cards},
                                                                   {"fields", ExportFormat::fields},
                                                                   {"pelage", ExportFormat::pelage}}};
inline constexpr std::array<Name<CurveBasis>, 2> curve_bases{
    {{"linear", CurveBasis::linear}, {"cubic", CurveBasis::cubic}}};
inline constexpr std::array<Name<AssetFrame>, 2> asset_frames{
    {{"source", AssetFrame::source}, {"pelage", AssetFrame::pelage}}};
inline constexpr std::array<Name<GuideFormat>, 3> guide_formats{
    {{"usda", GuideFormat::usda}, {"hair", GuideFormat::hair}, {"json", GuideFormat::json}}};
inline constexpr std::array<Name<FrameFormat>, 7> frame_formats{{{"png", FrameFormat::png},
                                                                 {"png16", FrameFormat::png16},
                                                                 {"jpeg", FrameFormat::jpeg},
                                                                 {"webp", FrameFormat::webp},
                                                                 {"exr", FrameFormat::exr},
                                                                 {"npy", FrameFormat::npy},
                                                                 {"npy_linear", FrameFormat::npy_linear}}};
inline constexpr std::array<Name<ExrType>, 2> exr_types{{{"half", ExrType::half}, {"float", ExrType::single}}};
inline constexpr std::array<Name<Aov>, 13> aovs{{{"beauty", Aov::beauty},
                                                 {"alpha", Aov::alpha},
                                                 {"depth", Aov::depth},
                                                 {"position", Aov::position},
                                                 {"normal", Aov::normal},
                                                 {"tangent", Aov::tangent},
                                                 {"albedo", Aov::albedo},
                                                 {"direct", Aov::direct},
                                                 {"shadow", Aov::shadow},
                                                 {"sample_count", Aov::sample_count},
                                                 {"strand", Aov::strand},
                                                 {"root", Aov::root},
                                                 {"cryptomatte", Aov::cryptomatte}}};
inline constexpr std::array<Name<Overlay>, 10> overlays{{{"none", Overlay::none},
                                                         {"direction", Overlay::direction},
                                                         {"strokes", Overlay::strokes},
                                                         {"length", Overlay::length},
                                                         {"density", Overlay::density},
                                                         {"wetness", Overlay::wetness},
                                                         {"mask", Overlay::mask},
                                                         {"difference", Overlay::difference},
                                                         {"bald", Overlay::bald},
                                                         {"wire", Overlay::wire}}};
inline constexpr std::array<Name<Builtin>, 6> builtins{{{"torus", Builtin::torus},
                                                        {"knot", Builtin::knot},
                                                        {"sphere", Builtin::sphere},
                                                        {"plane", Builtin::plane},
                                                        {"cloth", Builtin::cloth},
                                                        {"creature", Builtin::creature}}};
inline constexpr std::array<Name<ModelFormat>, 8> model_formats{{{"obj", ModelFormat::obj},
                                                                 {"ply", ModelFormat::ply},
                                                                 {"stl", ModelFormat::stl},
                                                                 {"off", ModelFormat::off},
                                                                 {"gltf", ModelFormat::gltf},
                                                                 {"glb", ModelFormat::glb},
                                                                 {"3ds", ModelFormat::tds},
                                                                 {"zip", ModelFormat::zip}}};
inline constexpr std::array<Name<FurPatches>, 3> fur_patches{
    {{"overlapping", FurPatches::overlapping}, {"hard", FurPatches::hard}, {"own_uvs", FurPatches::own_uvs}}};
inline constexpr std::array<Name<GroomForm>, 2> groom_forms{{{"even", GroomForm::even}, {"animal", GroomForm::animal}}};
inline constexpr std::array<Name<Axis>, 6> axes{{{"x", Axis::plus_x},
                                                 {"-x", Axis::minus_x},
                                                 {"y", Axis::plus_y},
                                                 {"-y", Axis::minus_y},
                                                 {"z", Axis::plus_z},
                                                 {"-z", Axis::minus_z}}};

/// Returns all words of an enumeration.
template <class E, std::size_t N>
std::vector<std::string_view> texts_of(const std::array<Name<E>, N>& names) {
  std::vector<std::string_view> texts;
  for (const auto& name : names) texts.push_back(name.text);
  return texts;
}

/// Returns the word of a value; every value that goes on the wire has one.
template <class Names, class E>
constexpr std::string_view text_of(const Names& names, E value) {
  for (const auto& name : names) {
    if (name.value == value) return name.text;
  }
  assert(false);
  return {};
}

/// The same as std::string.
template <class Names, class E>
std::string word_of(const Names& names, E value) {
  return std::string(text_of(names, value));
}

}  // namespace pelage::json_names
