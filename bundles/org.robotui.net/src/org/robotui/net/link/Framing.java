package org.robotui.net.link;

import java.io.IOException;
import java.io.InputStream;

/**
 * How frames become bytes. Used by several threads at once.
 *
 * @param <F> a frame
 */
public interface Framing<F> {

  /**
   * Reads the next frame; blocks until all of it is there.
   *
   * @param in of a link
   * @return the frame
   * @throws IOException where the link ends, or the bytes are no frame
   */
  F read(InputStream in) throws IOException;

  /**
   * Writes a frame.
   *
   * @param frame to be sent
   * @return all of its bytes
   */
  byte[] bytes(F frame);
}
