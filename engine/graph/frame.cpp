#include "graph/frame.h"

#include <algorithm>

#include "core/check.h"

namespace lampyris::graph {
namespace {

ResourceInfo imageInfo(std::string name, const ImageDesc& desc, Origin origin) {
    ResourceInfo info;
    info.name = std::move(name);
    info.isImage = true;
    info.origin = origin;
    info.image = desc;
    return info;
}

ResourceInfo bufferInfo(std::string name, const BufferDesc& desc, Origin origin) {
    ResourceInfo info;
    info.name = std::move(name);
    info.origin = origin;
    info.buffer = desc;
    return info;
}

}  // namespace

uint32_t Frame::add(ResourceInfo info) {
    resources_.push_back(std::move(info));
    return static_cast<uint32_t>(resources_.size() - 1);
}

uint32_t Frame::add(Node node) {
    nodes_.push_back(std::move(node));
    return static_cast<uint32_t>(nodes_.size() - 1);
}

Image Frame::image(std::string name, const ImageDesc& desc) {
    return {add(imageInfo(std::move(name), desc, Origin::Transient)), 0};
}

Buffer Frame::buffer(std::string name, const BufferDesc& desc) {
    return {add(bufferInfo(std::move(name), desc, Origin::Transient)), 0};
}

Image Frame::importImage(std::string name, const ImageDesc& desc, External external,
                         Access importedAs) {
    ResourceInfo info = imageInfo(std::move(name), desc, Origin::Imported);
    info.external = external;
    info.importedAs = importedAs;
    return {add(std::move(info)), 0};
}

Buffer Frame::importBuffer(std::string name, const BufferDesc& desc, External external,
                           Access importedAs) {
    ResourceInfo info = bufferInfo(std::move(name), desc, Origin::Imported);
    info.external = external;
    info.importedAs = importedAs;
    return {add(std::move(info)), 0};
}

HistoryImage Frame::history(std::string name, const ImageDesc& desc, bool known) {
    ResourceInfo previous = imageInfo(name, desc, Origin::History);
    ResourceInfo current = imageInfo(std::move(name), desc, Origin::History);
    const auto first = static_cast<uint32_t>(resources_.size());
    previous.historyPrevious = true;
    previous.historyPartner = first + 1;
    current.historyPartner = first;
    const Image previousImage{add(std::move(previous)), 0};
    const Image currentImage{add(std::move(current)), 0};
    return {previousImage, currentImage, !known};
}

ComputeNode Frame::compute(std::string name, const Shader& shader) {
    Node node;
    node.name = std::move(name);
    node.kind = NodeKind::Compute;
    node.shader = &shader;
    return {*this, add(std::move(node))};
}

RasterNode Frame::raster(std::string name, Extent extent) {
    Node node;
    node.name = std::move(name);
    node.kind = NodeKind::Raster;
    node.renderExtent = extent;
    return {*this, add(std::move(node))};
}

TransferNode Frame::transfer(std::string name) {
    Node node;
    node.name = std::move(name);
    node.kind = NodeKind::Transfer;
    return {*this, add(std::move(node))};
}

void Frame::output(Image image) {
    outputs_.push_back({image.resource, image.version});
}

void Frame::output(Buffer buffer) {
    outputs_.push_back({buffer.resource, buffer.version});
}

void Frame::publish(std::string name, Image image) {
    std::erase_if(published_, [&](const Published& other) { return other.name == name; });
    published_.push_back({std::move(name), image});
}

const ImageDesc& Frame::desc(Image image) const {
    CHECK(image.resource < resources_.size());
    CHECK(resources_[image.resource].isImage == true);
    return resources_[image.resource].image;
}

const BufferDesc& Frame::desc(Buffer buffer) const {
    CHECK(buffer.resource < resources_.size());
    CHECK(resources_[buffer.resource].isImage == false);
    return resources_[buffer.resource].buffer;
}

Image Frame::published(std::string_view name) const {
    const auto found = std::find_if(published_.begin(), published_.end(),
                                    [&](const Published& entry) { return entry.name == name; });
    return found == published_.end() ? Image{} : found->image;
}

std::vector<std::string> Frame::publishedNames() const {
    std::vector<std::string> names;
    names.reserve(published_.size());
    for (const Published& entry : published_) names.push_back(entry.name);
    return names;
}

}  // namespace lampyris::graph
