package org.robotui.ui;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageDataProvider;
import org.eclipse.swt.graphics.PaletteData;
import org.robotui.ui.internal.SurfacePixels;

/**
 * An image whose pixels are replaced again and again: those of a camera, or of a scene that is turned. They are written
 * where the toolkit keeps them; it would otherwise convert them one by one, which takes longer than all the painting
 * (ADR 70). Belongs to one thread at a time.
 */
public final class LiveImage {
  private static final int DEPTH = 32;
  private static final int BYTES = 4;
  private static final int HUNDRED = 100;
  /** Blue, green, red, nothing: the order of pixels in memory. */
  private static final PaletteData ORDER = new PaletteData(0xff00, 0xff0000, 0xff000000);

  private final Device device;
  private final int width;
  private final int height;
  private final int zoom;
  private final Optional<SurfacePixels> pixels;
  private Image image;

  /**
   * A black one.
   *
   * @param device of the display
   * @param width pixels
   * @param height rows
   * @param zoom percent at which each pixel is a pixel of the screen
   */
  public LiveImage(Device device, int width, int height, int zoom) {
    this.device = device;
    this.width = width;
    this.height = height;
    this.zoom = zoom;
    image = made(new byte[BYTES * width * height]);
    pixels = SurfacePixels.find().filter(p -> p.has(image, width, height));
  }

  /**
   * Whether it can take pictures of this form.
   *
   * @param pixels of a row
   * @param rows how many
   * @param percent of the zoom
   * @return true where it has this form
   */
  public boolean fits(int pixels, int rows, int percent) {
    return width == pixels && height == rows && zoom == percent;
  }

  /**
   * Takes other pixels. Any thread, while the display thread does not have it.
   *
   * @param rgb row by row; red in bits 16 to 23, green in 8 to 15, blue in 0 to 7
   */
  public void set(int[] rgb) {
    pixels.ifPresentOrElse(p -> p.write(image, rgb, width * height), () -> replace(rgb));
  }

  private void replace(int[] rgb) {
    byte[] bytes = new byte[BYTES * width * height];
    ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().put(rgb, 0, width * height);
    Image old = image;
    image = made(bytes);
    old.dispose();
  }

  private Image made(byte[] bytes) {
    ImageData data = new ImageData(width, height, DEPTH, ORDER, BYTES, bytes);
    return zoom == HUNDRED ? new Image(device, data) : new Image(device, scaled(data));
  }

  /**
   * Pixels that are drawn as they are at this zoom, which the toolkit would otherwise enlarge; those of 100 % are asked
   * for and never drawn.
   */
  private ImageDataProvider scaled(ImageData data) {
    return wanted -> wanted == zoom ? data : new ImageData(width(), height(), DEPTH, ORDER);
  }

  /**
   * How wide it is on the screen.
   *
   * @return points
   */
  public int width() {
    return points(width);
  }

  /**
   * How high it is on the screen.
   *
   * @return points
   */
  public int height() {
    return points(height);
  }

  private int points(int count) {
    return Math.max(1, Math.round((float) count * HUNDRED / zoom));
  }

  /**
   * What to paint; not to be kept.
   *
   * @return the image as it is now. Display thread
   */
  public Image image() {
    return image;
  }

  /**
   * It was painted, or will be, and its pixels were or will be others. Display thread, before the first painting of new
   * pixels and after the last one.
   */
  public void changed() {
    pixels.filter(p -> !image.isDisposed()).ifPresent(p -> p.forget(image));
  }

  /** Frees it. */
  public void dispose() {
    image.dispose();
  }
}
