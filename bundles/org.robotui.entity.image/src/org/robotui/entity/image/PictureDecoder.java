package org.robotui.entity.image;

import org.robotui.data.CompressedImage;
import org.robotui.data.Image;
import org.robotui.data.RawImage;
import org.robotui.entity.image.internal.CompressedPictures;
import org.robotui.entity.image.internal.RawPictures;

/** Decodes pictures. Safe for all threads; meant for a view's worker, never the display thread. */
public final class PictureDecoder {
  private static final int LONGEST_EDGE = 16_384;
  private static final long MOST_PIXELS = 64L << 20;

  private PictureDecoder() {}

  /**
   * Decodes a picture, raw or compressed (JPEG, PNG, and PNG depth with the header of ROS). Depth is shown as grey from the
   * nearest (dark) to the farthest (light) in the picture; what was not measured is black.
   *
   * @param image the picture
   * @return the decoded picture, or why it cannot be: nothing is thrown whatever the bytes are
   */
  public static Decoding decode(Image image) {
    return switch (image) {
      case RawImage raw -> fits(raw.width(), raw.height())
          ? RawPictures.decode(raw)
          : new Decoding.Undecodable(refusal(raw.width(), raw.height()));
      case CompressedImage compressed -> CompressedPictures.decode(compressed, PictureDecoder::fits, PictureDecoder::refusal);
    };
  }

  private static boolean fits(int width, int height) {
    return width > 0 && height > 0 && width <= LONGEST_EDGE && height <= LONGEST_EDGE && (long) width * height <= MOST_PIXELS;
  }

  private static String refusal(int width, int height) {
    return width <= 0 || height <= 0
        ? "the picture is empty (" + width + "\u00d7" + height + ")"
        : "the picture is too large (" + width + "\u00d7" + height + "); at most " + LONGEST_EDGE + " pixels an edge and "
            + (MOST_PIXELS >> 20) + " million in all are shown";
  }
}
