#include "overlay/panel_node.h"

#include <imgui.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "gpu/staging.h"
#include "overlay/shaders.h"
#include "shared/overlay.h"

namespace lampyris::overlay {
namespace {

static_assert(sizeof(ImDrawVert) == 4 * shared::PANEL_VERTEX_WORDS);

/// All lists one behind the other.
struct Joined {
    std::vector<ImDrawVert> vertices;
    std::vector<uint32_t> indices;
    std::vector<graph::Draw> draws;
};

/// The part of a clip rectangle that lies in the picture; nothing where it lies outside.
std::optional<graph::Rectangle> cut(const ImVec4& clip, const ImVec2& origin,
                                    graph::Extent extent) {
    const auto inside = [](float value, uint32_t most) {
        return static_cast<uint32_t>(std::clamp(value, 0.0f, static_cast<float>(most)));
    };
    const uint32_t left = inside(clip.x - origin.x, extent.width);
    const uint32_t top = inside(clip.y - origin.y, extent.height);
    const uint32_t right = inside(clip.z - origin.x, extent.width);
    const uint32_t bottom = inside(clip.w - origin.y, extent.height);
    if (right <= left || bottom <= top) return std::nullopt;
    return graph::Rectangle{left, top, right - left, bottom - top};
}

Joined join(const ImDrawData& lists, graph::Extent extent) {
    Joined joined;
    joined.vertices.reserve(static_cast<size_t>(lists.TotalVtxCount));
    joined.indices.reserve(static_cast<size_t>(lists.TotalIdxCount));
    shared::PanelDraw drawn{};
    drawn.scale = {2.0f / lists.DisplaySize.x, 2.0f / lists.DisplaySize.y};
    drawn.offset = {-1.0f - lists.DisplayPos.x * drawn.scale.x,
                    -1.0f - lists.DisplayPos.y * drawn.scale.y};
    for (int i = 0; i < lists.CmdListsCount; ++i) {
        const ImDrawList& list = *lists.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const auto area = cut(command.ClipRect, lists.DisplayPos, extent);
            if (!area || command.ElemCount == 0 || command.UserCallback != nullptr) continue;
            drawn.firstIndex = static_cast<uint32_t>(joined.indices.size()) + command.IdxOffset;
            drawn.firstVertex = static_cast<uint32_t>(joined.vertices.size()) + command.VtxOffset;
            drawn.samples = command.TextureId == pictureTexture() ? shared::PANEL_SAMPLES_PICTURE
                                                                  : shared::PANEL_SAMPLES_FONT;
            graph::Draw draw;
            draw.count = command.ElemCount;
            draw.scissor = area;
            draw.pushConstants(drawn);
            joined.draws.push_back(draw);
        }
        joined.vertices.insert(joined.vertices.end(), list.VtxBuffer.begin(), list.VtxBuffer.end());
        joined.indices.insert(joined.indices.end(), list.IdxBuffer.begin(), list.IdxBuffer.end());
    }
    return joined;
}

const graph::RasterPipeline& pipeline() {
    static const graph::RasterPipeline made{.vertex = &shaders::panelsVert,
                                            .fragment = &shaders::panelsFrag,
                                            .attributes = {},
                                            .depthTest = false,
                                            .depthWrite = false,
                                            .blend = true};
    return made;
}

}  // namespace

core::Result<gpu::Image> makeFont(gpu::Device& device) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    unsigned char* texels = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsRGBA32(&texels, &width, &height);
    TRY(gpu::Image image,
        gpu::Image::create(device,
                           {.format = VK_FORMAT_R8G8B8A8_UNORM,
                            .extent = {static_cast<uint32_t>(width), static_cast<uint32_t>(height)},
                            .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                            .name = "overlay font"}));
    TRY(gpu::Staging staging, gpu::Staging::create(device));
    const auto bytes = static_cast<size_t>(width) * static_cast<size_t>(height) * 4;
    TRY_VOID(staging.write(image, 0, std::as_bytes(std::span{texels, bytes})));
    TRY_VOID(staging.flush());
    return image;
}

void* pictureTexture() {
    static char here;  // its address is all that matters
    return &here;
}

graph::Image addPanels(graph::Frame& frame, const ImDrawData& lists, const gpu::Image& font,
                       graph::Image picture, graph::Image shown) {
    const graph::Extent extent = frame.desc(shown).extent;
    Joined joined = join(lists, extent);
    if (joined.draws.empty()) return shown;
    const VkExtent2D size = font.options().extent;
    const graph::Image letters =
        frame.importImage("overlay font", {graph::Format::RGBA8Unorm, {size.width, size.height}},
                          {&font}, graph::Access::Sampled);
    auto node = frame.raster("overlay", extent);
    const graph::Image drawn = node.colour(0, shown);
    node.sample(shared::SLOT_PANEL_FONT, letters, graph::Filtering::Linear)
        .sample(shared::SLOT_PANEL_PICTURE, picture.valid() ? picture : letters,
                graph::Filtering::Nearest)
        .storageData(shared::SLOT_PANEL_VERTICES, joined.vertices.data(),
                     joined.vertices.size() * sizeof(ImDrawVert))
        .storageData(shared::SLOT_PANEL_INDICES, joined.indices.data(),
                     joined.indices.size() * sizeof(uint32_t));
    node.record({&shaders::panelsVert, &shaders::panelsFrag},
                [draws = std::move(joined.draws)](graph::RasterCommands& commands) {
                    for (graph::Draw draw : draws) {
                        draw.pipeline = &pipeline();
                        commands.draw(draw);
                    }
                });
    return drawn;
}

}  // namespace lampyris::overlay
