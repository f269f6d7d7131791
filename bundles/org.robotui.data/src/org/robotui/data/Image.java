package org.robotui.data;

/** A picture, raw or compressed. */
public sealed interface Image extends Data permits RawImage, CompressedImage {
  /**
   * The optical frame: z forward, x right, y down (REP-103).
   *
   * @return the camera's frame
   */
  FrameId frame();
}
