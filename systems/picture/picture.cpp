#include <hachure/components/picture.h>
#include <hachure/components/picture_coat.h>
#include <hachure/runtime/app/app.h>
#include <hachure/runtime/ecs/time.h>
#include <hachure/runtime/scene/draw_list.h>
#include <hachure/runtime/scene/frame_requests.h>
#include <hachure/runtime/scene/picture_list.h>
#include <hachure/runtime/scene/view.h>
#include <hachure/systems/picture/picture.h>
#include <hachure/systems/picture/picture_file.h>
#include <hachure/systems/picture/picture_passes.h>
#include <hachure/systems/picture/picture_place.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace hachure {
namespace {

PictureItem picture_item(const DrawPicture& drawn, const Picture& picture, const PictureFile& file, const View& view,
                         double seconds) {
    PictureItem item{.entity = drawn.entity, .object_id = drawn.object_id};
    item.place = picture_place(picture.fit, file.width(), file.height(), view.width, view.height);
    item.rect = cut_to_view(item.place, view.width, view.height);
    item.frame = file.frame_at(picture, seconds);
    item.has_normal = file.has_normal();
    item.has_depth = file.has_depth();
    item.key = gpu::key_of(item.object_id, item.place.x, item.place.y, item.place.width, item.place.height, view.width,
                           view.height, item.frame, item.has_normal, item.has_depth, std::string_view(picture.file));
    return item;
}

void collect_pictures(Query<const Picture> pictures, const DrawList& drawn, const View& view, const Time& time,
                      PictureFiles& files, PictureList& list) {
    std::erase_if(files.files, [&](const auto& entry) {
        return std::ranges::find(drawn.pictures, entry.first, &DrawPicture::entity) == drawn.pictures.end();
    });
    list.items.clear();
    gpu::KeyHash key;
    for (const DrawPicture& entry : drawn.pictures) {
        const auto found = pictures.find(entry.entity);
        const Picture& picture = std::get<const Picture&>(*found);
        if (picture.file.empty()) continue;
        const PictureFile& file = files.open(entry.entity, picture.file);
        const PictureItem item = picture_item(entry, picture, file, view, time.elapsed);
        if (item.rect.width == 0) continue;
        list.items.push_back(item);
        key.add(item.key);
    }
    list.key = key.value();
}

std::vector<AovInfo> picture_aovs() {
    return {{"picture_tone",
             "tone of pictures, from 0 black to 1 white, also behind surfaces; 1 where there is none",
             {"tone"}},
            {"picture_normal",
             "unit normal that pictures say of what they show, also behind surfaces; 0 where there is none",
             {"normal.X", "normal.Y", "normal.Z"}},
            {"picture_depth",
             "depth that pictures say of what they show, metres, also behind surfaces; 1e10 where there is none",
             {"Z"}}};
}

} // namespace

void register_picture(App& app) {
    app.add_component<Picture>();
    app.add_component<PictureCoat>();
    app.world().set_resource(PictureFiles{});
    if (!app.world().find_resource<PictureList>()) app.world().set_resource(PictureList{});
    if (!app.world().find_resource<DrawList>()) app.world().set_resource(DrawList{});
    for (AovInfo& aov : picture_aovs()) frame_requests(app.world()).known.push_back(std::move(aov));
    app.add_system(Stage::material, "picture.collect", collect_pictures).after("surface.collect");
    app.add_system(Stage::render, "picture.pass",
                   [passes = std::make_shared<PicturePasses>()](World& world) { passes->declare(world); })
        .after("deform.pass")
        .after("surface.passes")
        .before("gooch.pass")
        .before("metal.pass")
        .before("toon.pass")
        .before("edge_lines.pass")
        .before("abstracted_lines.pass")
        .before("velocity.pass")
        .before("compose.passes");
}

} // namespace hachure
