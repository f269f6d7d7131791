package org.robotui.ui.scene;

import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageDataProvider;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.ImageFill;

/**
 * What is seen through a viewport, as pixels in this process: lines and text are painted faster there than at the
 * display's server. Display thread.
 */
final class SceneSheet {
  private static final int DEPTH = 32;
  private static final int HUNDRED = 100;
  private static final PaletteData ORDER = new PaletteData(0xff00, 0xff0000, 0xff000000);

  private final Viewport viewport;
  private final int zoom;
  private final Image image;

  /** A black one for screens of a zoom, percent. */
  SceneSheet(Device device, Viewport viewport, int zoom) {
    this.viewport = viewport;
    this.zoom = zoom;
    ImageDataProvider pixels = percent -> new ImageData(
        Math.ceilDiv(viewport.width() * percent, HUNDRED), Math.ceilDiv(viewport.height() * percent, HUNDRED), DEPTH,
        ORDER);
    image = new Image(device, pixels);
  }

  Viewport viewport() {
    return viewport;
  }

  boolean shows(Viewport wanted, int percent) {
    return viewport.equals(wanted) && zoom == percent;
  }

  GC open() {
    return new GC(image);
  }

  /** Paints it over all that there is. */
  void paint(GC gc) {
    Rectangle all = new Rectangle(0, 0, viewport.width(), viewport.height());
    ImageFill.draw(gc, image, all, all);
  }

  void dispose() {
    image.dispose();
  }
}
