/// \file The image that is looked at: channel, exposure, histogram, the value under the cursor.
#pragma once

#include "overlay/image_look.h"

namespace lampyris::overlay {

/// Draws a window while an image is chosen; closing it chooses none. Sets how it is looked at.
void drawImagePanel(ImageLook& look);

}  // namespace lampyris::overlay
