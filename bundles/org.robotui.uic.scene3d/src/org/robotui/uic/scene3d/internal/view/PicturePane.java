package org.robotui.uic.scene3d.internal.view;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageDataProvider;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.gl.render.Rendered;

/** The picture of a scene on the screen, pixel for pixel. Display thread. */
final class PicturePane {
  private static final int DEPTH = 32;
  private static final int BYTES = 4;
  private static final int HUNDRED = 100;
  /** Blue, green, red, nothing: the order of pixels in memory, so that they are copied and not converted. */
  private static final PaletteData ORDER = new PaletteData(0xff00, 0xff0000, 0xff000000);

  private Optional<Rendered.Picture> shown = Optional.empty();
  private Optional<Image> image = Optional.empty();
  private byte[] bytes = {};

  void paint(GC gc, Rectangle area, Rendered.Picture picture, int zoom) {
    if (shown.filter(s -> s == picture).isEmpty()) {
      take(gc.getDevice(), picture, zoom);
    }
    image.ifPresent(i -> draw(gc, area, i));
  }

  /** As it is where it fits; stretched for the moment in which a window has another size than its picture. */
  private static void draw(GC gc, Rectangle area, Image image) {
    Rectangle size = image.getBounds();
    if (size.width == area.width && size.height == area.height) {
      gc.drawImage(image, area.x, area.y);
    } else {
      gc.drawImage(image, 0, 0, size.width, size.height, area.x, area.y, area.width, area.height);
    }
  }

  /** Pixels as SWT takes them. */
  static ImageData data(Rendered.Picture picture, byte[] into) {
    ByteBuffer.wrap(into).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().put(picture.rgb(), 0, picture.width() * picture.height());
    return new ImageData(picture.width(), picture.height(), DEPTH, ORDER, BYTES, into);
  }

  private void take(Device device, Rendered.Picture picture, int zoom) {
    int size = picture.width() * picture.height() * BYTES;
    bytes = bytes.length == size ? bytes : new byte[size];
    dispose();
    ImageData pixels = data(picture, bytes);
    image = Optional.of(zoom == HUNDRED ? new Image(device, pixels) : new Image(device, scaled(pixels, zoom)));
    shown = Optional.of(picture);
  }

  /** Pixels that are drawn as they are at this zoom, which SWT would otherwise enlarge; those of 100 % are asked for and never drawn. */
  private static ImageDataProvider scaled(ImageData pixels, int zoom) {
    return wanted -> wanted == zoom ? pixels
        : new ImageData(Math.max(1, pixels.width * HUNDRED / zoom), Math.max(1, pixels.height * HUNDRED / zoom), DEPTH, ORDER);
  }

  void dispose() {
    image.ifPresent(Image::dispose);
    image = Optional.empty();
    shown = Optional.empty();
  }

  /** Room for the pixels of a picture. */
  static byte[] room(Rendered.Picture picture) {
    return new byte[picture.width() * picture.height() * BYTES];
  }
}
