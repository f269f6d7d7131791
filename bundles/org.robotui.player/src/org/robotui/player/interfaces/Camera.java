package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Cameras. The interface {@code camera}. */
public final class Camera {

  /** Data: image. */
  public static final Kind.Data<Image> IMAGE = new Kind.Data<>("camera", "image", Image.class);

  /** Request: get source; answered by {@link Source}. */
  public static final Kind.Request<Empty, Source> GET_SOURCE =
      new Kind.Request<>("camera", "get_source", Empty.class, Source.class);

  /** Request: set source by {@link Source}; the answer is empty. */
  public static final Kind.Request<Source, Empty> SET_SOURCE =
      new Kind.Request<>("camera", "set_source", Source.class, Empty.class);

  /** Request: get image; answered by {@link Image}. */
  public static final Kind.Request<Empty, Image> GET_IMAGE =
      new Kind.Request<>("camera", "get_image", Empty.class, Image.class);

  private Camera() {}

  /**
   * One picture, rows from the top.
   *
   * @param width of the picture, pixels
   * @param height of the picture, pixels
   * @param bits of one pixel: 8, 16, 24 or 32
   * @param format 1 grey of 8 bits, 2 grey of 16 bits, 4 RGB of 5, 6 and 5 bits, 5 RGB of 8 bits each
   * @param divisor a pixel's value divided by it is what it means; for depths
   * @param compression 0 none, 1 JPEG
   * @param data the pixels, or the compressed picture
   */
  public record Image(long width, long height, long bits, long format, long divisor, long compression, byte[] data) {}

  /**
   * Where the picture is from.
   *
   * @param norm NTSC, PAL, SECAM or UNKNOWN
   * @param source which input
   */
  public record Source(String norm, int source) {}
}
