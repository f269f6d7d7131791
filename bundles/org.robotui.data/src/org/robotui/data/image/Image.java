package org.robotui.data.image;

import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;

/** A picture, raw or compressed. */
public sealed interface Image extends Data, InFrame permits RawImage, CompressedImage {
  /**
   * The optical frame: z forward, x right, y down (REP-103).
   *
   * @return the camera's frame
   */
  @Override
  FrameId frame();
}
