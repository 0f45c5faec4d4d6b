/// \file Declaring one frame: resources in, nodes in any number, and what must come out.
///
/// Handles are values. A node that writes a resource takes the handle and returns its successor;
/// using the old one afterwards is an error that compile() names ("stale handle").
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "graph/builders.h"
#include "graph/node.h"
#include "graph/resource.h"

namespace lampyris::graph {

/// Where a resource comes from.
enum class Origin : uint8_t { Transient, Imported, History };

struct ResourceInfo {
    std::string name;
    bool isImage = false;
    Origin origin = Origin::Transient;
    ImageDesc image;
    BufferDesc buffer;
    External external;                      ///< imported
    Access importedAs = Access::None;       ///< how it was last touched outside
    uint32_t historyPartner = 0xffffffffu;  ///< history: the other of the pair (previous ↔ current)
    bool historyPrevious = false;
    uint32_t versions = 1;
};

/// An image carried from frame to frame. `previous` holds what `current` held in the last frame
/// that had it.
struct HistoryImage {
    Image previous;
    Image current;           ///< contents undefined until written
    bool firstFrame = true;  ///< previous holds zeros
};

/// The declaration of one frame. Built anew every frame; cheap.
class Frame {
 public:
    [[nodiscard]] Image image(std::string name, const ImageDesc& desc);
    [[nodiscard]] Buffer buffer(std::string name, const BufferDesc& desc);
    [[nodiscard]] Image importImage(std::string name, const ImageDesc& desc, External external,
                                    Access importedAs = Access::None);
    [[nodiscard]] Buffer importBuffer(std::string name, const BufferDesc& desc, External external,
                                      Access importedAs = Access::None);
    /// The pair of a history image; the executor keeps the contents by name. `known` = it existed
    /// last frame with the same description (the caller asks the executor's HistoryBook).
    [[nodiscard]] HistoryImage history(std::string name, const ImageDesc& desc, bool known);

    ComputeNode compute(std::string name, const Shader& shader);
    RasterNode raster(std::string name, Extent extent);
    TransferNode transfer(std::string name);

    /// What the frame is for; all that leads to none of these is culled. Writes to imported and
    /// history images and buffers outlive the frame and count as outputs without being named here.
    void output(Image image);
    void output(Buffer buffer);
    /// Gives an image a public name, by which `--output-node` finds it. Does not keep it alive. A
    /// name used twice is the later image's.
    void publish(std::string name, Image image);

    [[nodiscard]] const ImageDesc& desc(Image image) const;
    [[nodiscard]] const BufferDesc& desc(Buffer buffer) const;
    [[nodiscard]] Image published(std::string_view name) const;  ///< invalid where there is none
    [[nodiscard]] std::vector<std::string> publishedNames() const;

    // What compile() reads.
    struct Output {
        uint32_t resource;
        uint32_t version;
    };
    struct Published {
        std::string name;
        Image image;
    };
    [[nodiscard]] const std::vector<ResourceInfo>& resources() const { return resources_; }
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Output>& outputs() const { return outputs_; }
    [[nodiscard]] const std::vector<Published>& publishedImages() const { return published_; }

 private:
    friend class NodeBuilder;
    uint32_t add(ResourceInfo info);
    uint32_t add(Node node);
    std::vector<ResourceInfo> resources_;
    std::vector<Node> nodes_;
    std::vector<Output> outputs_;
    std::vector<Published> published_;
};

}  // namespace lampyris::graph
