package org.robotui.ui;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Color;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageDataProvider;
import org.eclipse.swt.graphics.PaletteData;
import org.eclipse.swt.graphics.Path;
import org.robotui.ui.internal.IconOutline;

/** Draws icons. Display thread only. */
public final class Icons {
  /** The usual edge, pixels. */
  public static final int SIZE = 16;

  private static final float WEIGHT = 1.4f;

  private Icons() {}

  /**
   * Draws an icon in the foreground colour.
   *
   * @param gc where to draw; its line and antialias settings are changed
   * @param icon what to draw
   * @param x left edge
   * @param y top edge
   * @param size edge, pixels; 16 is usual
   */
  public static void paint(GC gc, Icon icon, int x, int y, int size) {
    float scale = size / (float) Icon.UNITS;
    Path path = IconOutline.path(gc.getDevice(), icon.outline(), x, y, scale);
    gc.setAntialias(SWT.ON);
    gc.setLineStyle(SWT.LINE_SOLID);
    gc.setLineCap(SWT.CAP_ROUND);
    gc.setLineJoin(SWT.JOIN_ROUND);
    gc.setLineAttributes(IconOutline.stroke(WEIGHT * scale));
    gc.drawPath(path);
    path.dispose();
  }

  /**
   * Makes an image of an icon, for menus and widgets of the platform. The caller disposes it.
   *
   * @param device the display
   * @param icon what to draw
   * @param color its colour
   * @return a transparent image of 16 by 16, sharp at every zoom
   */
  public static Image image(Device device, Icon icon, Color color) {
    return new Image(device, (ImageDataProvider) zoom -> pixels(device, icon, color, zoom));
  }

  private static ImageData pixels(Device device, Icon icon, Color color, int zoom) {
    int edge = SIZE * zoom / 100;
    Image drawn = new Image(device, new ImageData(edge, edge, 32, new PaletteData(0xff0000, 0xff00, 0xff)));
    GC gc = new GC(drawn);
    gc.setBackground(new Color(0, 0, 0));
    gc.fillRectangle(0, 0, edge, edge);
    gc.setForeground(new Color(255, 255, 255));
    paint(gc, icon, 0, 0, edge);
    gc.dispose();
    ImageData mask = drawn.getImageData(100);
    drawn.dispose();
    return tinted(mask, color);
  }

  private static ImageData tinted(ImageData mask, Color color) {
    ImageData result = new ImageData(mask.width, mask.height, 32, new PaletteData(0xff0000, 0xff00, 0xff));
    int pixel = color.getRed() << 16 | color.getGreen() << 8 | color.getBlue();
    for (int y = 0; y < mask.height; y++) {
      for (int x = 0; x < mask.width; x++) {
        result.setPixel(x, y, pixel);
        result.setAlpha(x, y, mask.palette.getRGB(mask.getPixel(x, y)).red);
      }
    }
    return result;
  }
}
