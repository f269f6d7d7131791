package org.robotui.entity.image;

import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.internal.CompressedPictures;
import org.robotui.entity.image.internal.Levels;
import org.robotui.entity.image.internal.Limits;
import org.robotui.entity.image.internal.RawPictures;

/**
 * Decodes the pictures of one camera, one after the other, and keeps from picture to picture what must not flicker: the
 * range of depth that the colours span. For one thread at a time; meant for a view's worker, never the display thread.
 */
public final class PictureDecoder {
  private final Levels levels = new Levels();

  /** For a camera of which nothing was seen yet. */
  public PictureDecoder() {
    // Ranges come with pictures.
  }

  /**
   * Decodes a picture: raw in any encoding of ROS, JPEG, PNG, and depth as compressed by ROS (PNG and RVL).
   *
   * @param image the picture
   * @param rendering how numbers become colours
   * @return the decoded picture, or why it cannot be: nothing is thrown whatever the bytes are
   */
  public Decoding decode(Image image, Rendering rendering) {
    try {
      return switch (image) {
        case RawImage raw -> Limits.refusal(raw.width(), raw.height())
            .<Decoding>map(Decoding.Undecodable::new)
            .orElseGet(() -> new Decoding.Decoded(RawPictures.decode(raw, rendering, levels)));
        case CompressedImage compressed -> CompressedPictures.decode(compressed, rendering, levels);
      };
    } catch (OutOfMemoryError e) {
      // A single large request that failed: what was there before is untouched.
      return new Decoding.Undecodable("the picture needs more memory than there is");
    }
  }
}
