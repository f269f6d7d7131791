package org.robotui.player.interfaces;

import java.util.List;
import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Cameras that find patches of colours. The interface {@code blobfinder}. */
public final class Blobfinder {

  /** Data: blobs. */
  public static final Kind.Data<Blobs> BLOBS = new Kind.Data<>("blobfinder", "blobs", Blobs.class);

  /** Request: set color by {@link Range}; the answer is empty. */
  public static final Kind.Request<Range, Empty> SET_COLOR =
      new Kind.Request<>("blobfinder", "set_color", Range.class, Empty.class);

  /** Request: set imager by {@link Imager}; the answer is empty. */
  public static final Kind.Request<Imager, Empty> SET_IMAGER =
      new Kind.Request<>("blobfinder", "set_imager", Imager.class, Empty.class);

  /** Request: get color with {@link Range}; answered by {@link Range}. */
  public static final Kind.Request<Range, Range> GET_COLOR =
      new Kind.Request<>("blobfinder", "get_color", Range.class, Range.class);

  private Blobfinder() {}

  /**
   * What is seen in one picture.
   *
   * @param width of the picture, pixels
   * @param height of the picture, pixels
   * @param blobs what was found
   */
  public record Blobs(long width, long height, List<Blob> blobs) {}

  /**
   * A patch of one colour.
   *
   * @param id which colour by its number
   * @param color 0xAARRGGBB, to draw it
   * @param area how many pixels it has, pixels
   * @param x its middle, from the left, pixels
   * @param y its middle, from the top, pixels
   * @param left of its frame, pixels
   * @param right of its frame, pixels
   * @param top of its frame, pixels
   * @param bottom of its frame, pixels
   * @param range how far it is, where the device knows, metres
   */
  public record Blob(long id, long color, long area, long x, long y, long left, long right, long top, long bottom,
      float range) {}

  /**
   * Which colours belong together, each part 0 to 255.
   *
   * @param channel the colour's number
   * @param redMin least red
   * @param redMax most red
   * @param greenMin least green
   * @param greenMax most green
   * @param blueMin least blue
   * @param blueMax most blue
   */
  public record Range(long channel, long redMin, long redMax, long greenMin, long greenMax, long blueMin,
      long blueMax) {}

  /**
   * How the camera sees; -1 leaves it as it is.
   *
   * @param brightness 0 to 255
   * @param contrast 0 to 255
   * @param colorMode 0 RGB, 1 RGB with white balance, 2 YCrCb, 3 YCrCb with white balance
   * @param autoGain 0 off, 1 on
   */
  public record Imager(int brightness, int contrast, int colorMode, int autoGain) {}
}
