#include "server/export/coat_alone.h"

#include "server/fields/coats.h"

namespace pelage {

CoatAlone::CoatAlone(const SceneView& scene, CoatId coat)
    : scene_(scene), settings_(scene.settings), fields_(scene.fields.of_coat(coat)) {
  for (NamedCoat& other : settings_.coats) other.muted = other.id != coat;
}

const Coat& CoatAlone::coat() const { return first_unmuted(settings_.coats).coat; }

SceneView CoatAlone::view() const {
  return {scene_.model,        fields_,        settings_,    scene_.revision,
          scene_.skin_texture, scene_.copy_id, scene_.swing, scene_.masked};
}

}  // namespace pelage
