package org.robotui.api.replay;

import java.io.IOException;

/** A video that is being written, picture by picture. For one thread, which may block; not that of the display. */
public interface PictureVideo extends AutoCloseable {
  /**
   * Adds a picture. One of another size is brought to that of the video.
   *
   * @param bgr three bytes for each pixel, blue first, row by row from the top
   * @param width of the picture, pixels
   * @param height of the picture, pixels
   * @throws IOException where it cannot be written, such as onto a full disk; with a sentence for users
   */
  void add(byte[] bgr, int width, int height) throws IOException;

  /**
   * Ends the video, which is whole then.
   *
   * @throws IOException where it cannot be written; with a sentence for users
   * @throws InterruptedException where the thread was interrupted
   */
  void finish() throws IOException, InterruptedException;

  /** Gives up what was not finished. */
  @Override
  void close();
}
