/// \file What lies over the picture: Dear ImGui's panels, drawn as a node of the graph. Open this
/// file first.
///
/// A frame: begin(), then any panels (see panels.h) or ImGui calls, then end(), and addNode() while
/// the graph is declared. Hidden, all of it does nothing and costs nothing.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/result.h"
#include "gpu/device.h"
#include "graph/frame.h"
#include "window/window.h"

namespace lampyris::overlay {

/// Where copied text goes to and comes from.
struct Clipboard {
    std::function<void(const std::string&)> set;
    std::function<std::string()> get;
};

class Overlay {
 public:
    /// The device must outlive it.
    static core::Result<Overlay> create(gpu::Device& device, Clipboard clipboard = {});
    Overlay(Overlay&&) noexcept;
    Overlay& operator=(Overlay&&) = delete;
    ~Overlay();

    [[nodiscard]] bool visible() const;
    void show(bool visible);

    /// Takes in what the user did since the last frame.
    /// \param windowSize  what the cursor's positions count in; the picture may be of another size
    void begin(const window::Input& input, graph::Extent windowSize, graph::Extent pictureSize,
               double seconds);
    /// No panels after this one.
    void end();
    /// Whether the mouse is over the panels, and not what lies under them.
    [[nodiscard]] bool wantsMouse() const;
    /// Whether keys go into a field; before begin(), as of the frame before.
    [[nodiscard]] bool typing() const;

    /// Declares the node `overlay`, which draws the panels over `shown`.
    /// \param picture  what panels show by pictureTexture(), see panel_node.h; may be invalid
    [[nodiscard]] graph::Image addNode(graph::Frame& frame, graph::Image shown,
                                       graph::Image picture = {});

    /// Wall time from begin() to end(), and of addNode(), in the last frame; 0 while hidden.
    [[nodiscard]] double cpuMilliseconds() const;

 private:
    struct State;
    explicit Overlay(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace lampyris::overlay
