package org.robotui.gl.internal.draw;

import java.nio.ByteBuffer;
import java.util.Optional;
import org.robotui.gl.shape.Texture;

/** Tells whether colours let through what lies behind. */
public final class Opacity {
  private static final byte OPAQUE = (byte) 255;

  private Opacity() {}

  static boolean translucent(Optional<ByteBuffer> rgba) {
    return rgba.isPresent() && translucent(rgba.get());
  }

  /**
   * Whether some pixels of a picture let through what lies behind.
   *
   * @param texture the picture
   * @return true where one does
   */
  public static boolean translucent(Texture texture) {
    return translucent(texture.rgba());
  }

  private static boolean translucent(ByteBuffer rgba) {
    for (int i = rgba.position() + 3; i < rgba.limit(); i += 4) {
      if (rgba.get(i) != OPAQUE) {
        return true;
      }
    }
    return false;
  }
}
