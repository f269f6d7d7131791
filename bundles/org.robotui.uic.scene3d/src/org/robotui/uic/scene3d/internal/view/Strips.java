package org.robotui.uic.scene3d.internal.view;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageDataProvider;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.Pattern;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.gl.render.Rendered;

/**
 * A picture in the form in which the platform paints it, in strips of some rows: the toolkit needs an array on the heap for each image that is
 * made, and arrays of megabytes, 25 a second, are garbage that collectors are bad at. Belongs to one thread at a time.
 */
final class Strips {
  private static final int DEPTH = 32;
  private static final int BYTES = 4;
  private static final int HUNDRED = 100;
  private static final int STRIP_BYTES = 1 << 18;
  /** A strip is a whole number of points at 100, 200, 300 and 400 %. */
  private static final int STEP = 12;
  /** Blue, green, red, nothing: the order of pixels in memory. */
  private static final PaletteData ORDER = new PaletteData(0xff00, 0xff0000, 0xff000000);

  private final int width;
  private final int height;
  private final int rows;
  private final List<Image> images;

  private Strips(int width, int height, int rows, List<Image> images) {
    this.width = width;
    this.height = height;
    this.rows = rows;
    this.images = images;
  }

  /** Copies a picture that was made for a zoom in percent. Any thread. */
  static Strips of(Device device, Rendered.Picture picture, int zoom) {
    int rows = Math.min(picture.height(), Math.max(1, STRIP_BYTES / (BYTES * picture.width() * STEP)) * STEP);
    byte[] bytes = new byte[BYTES * picture.width() * rows];
    List<Image> images = new ArrayList<>();
    for (int row = 0; row < picture.height(); row += rows) {
      copy(picture, row, Math.min(rows, picture.height() - row), bytes);
      ImageData pixels = new ImageData(picture.width(), rows, DEPTH, ORDER, BYTES, bytes);
      images.add(zoom == HUNDRED ? new Image(device, pixels) : new Image(device, scaled(pixels, zoom)));
    }
    return new Strips(points(picture.width(), zoom), points(picture.height(), zoom), points(rows, zoom), images);
  }

  private static int points(int pixels, int zoom) {
    return Math.max(1, Math.round((float) pixels * HUNDRED / zoom));
  }

  /** Pixels of a whole picture as the toolkit takes them. */
  static ImageData data(Rendered.Picture picture) {
    byte[] bytes = new byte[BYTES * picture.width() * picture.height()];
    copy(picture, 0, picture.height(), bytes);
    return new ImageData(picture.width(), picture.height(), DEPTH, ORDER, BYTES, bytes);
  }

  private static void copy(Rendered.Picture picture, int row, int rows, byte[] into) {
    ByteBuffer.wrap(into).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().put(picture.rgb(), row * picture.width(), rows * picture.width());
  }

  /** Pixels that are drawn as they are at this zoom, which the toolkit would otherwise enlarge; those of 100 % are asked for and never drawn. */
  private static ImageDataProvider scaled(ImageData pixels, int zoom) {
    return wanted -> wanted == zoom ? pixels : new ImageData(points(pixels.width, zoom), points(pixels.height, zoom), DEPTH, ORDER);
  }

  /** As it is where it fits; where a window has just got another size, as large as it was made and in the middle, until the next picture comes. Display thread. */
  void paint(GC gc, Rectangle area) {
    if (width == area.width && height == area.height && area.x == 0 && area.y == 0) {
      fill(gc);
    } else {
      center(gc, area);
    }
  }

  /**
   * A pattern begins anew every strip from the top, so that each strip lies where it belongs; for that the last one is as high as the others,
   * and not all of it is seen. Drawing an image would copy it first.
   */
  private void fill(GC gc) {
    for (int i = 0; i < images.size(); i++) {
      Pattern pattern = new Pattern(gc.getDevice(), images.get(i));
      gc.setBackgroundPattern(pattern);
      gc.fillRectangle(0, i * rows, width, Math.min(rows, height - i * rows));
      gc.setBackgroundPattern(null);
      pattern.dispose();
    }
  }

  private void center(GC gc, Rectangle area) {
    int left = area.x + (area.width - width) / 2;
    int top = area.y + (area.height - height) / 2;
    for (int i = 0; i < images.size(); i++) {
      int seen = Math.min(rows, height - i * rows);
      gc.drawImage(images.get(i), 0, 0, width, seen, left, top + i * rows, width, seen);
    }
  }

  void dispose() {
    images.forEach(Image::dispose);
  }
}
