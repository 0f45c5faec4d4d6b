/// \file What lies over the picture: Dear ImGui's panels, drawn as a node of the graph. Open this
/// file first.
///
/// A frame: begin(), then any panels (see panels.h) or ImGui calls, then end(), and addNode() while
/// the graph is declared. Hidden, all of it does nothing and costs nothing.
#pragma once

#include <chrono>
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

    /// Adds the wall time up to its end to the frame's.
    class Counted {
     public:
        explicit Counted(double& milliseconds);
        ~Counted();
        Counted(const Counted&) = delete;
        Counted& operator=(const Counted&) = delete;

     private:
        double& milliseconds_;
        std::chrono::steady_clock::time_point begun_;
    };
    /// For what else the overlay does in a frame: marks, the looked-at image, what panels follow.
    /// Not around this class's own calls, which are counted by themselves.
    [[nodiscard]] Counted count();

    /// Wall time from begin() to end(), of addNode(), and of all that was count()ed, in the frame
    /// before the last begin(); 0 before there was one, and while hidden.
    [[nodiscard]] double cpuMilliseconds() const;

 private:
    struct State;
    explicit Overlay(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace lampyris::overlay
