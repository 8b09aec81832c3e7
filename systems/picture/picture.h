#pragma once

namespace hachure {

class App;

/// Images and videos behind the surfaces of the view (components/picture.h), in the look of their PictureCoat; what
/// other capabilities read of them: runtime/scene/picture_list.h.
void register_picture(App& app);

} // namespace hachure
