package org.robotui.uic.camera.internal;

import org.eclipse.swt.graphics.Point;

/**
 * Which part of a picture is seen: pure, and independent of the sizes of picture and window, so that it stays when
 * these change.
 *
 * @param mode how large it is without zoom
 * @param zoom beyond that, 1 for none
 * @param x what lies in the middle, as a share of the width
 * @param y what lies in the middle, as a share of the height
 */
record PictureView(ZoomMode mode, double zoom, double x, double y) {
  PictureView(ZoomMode mode) {
    this(mode, 1, 0.5, 0.5);
  }

  /** Whether it is as the mode says. */
  boolean untouched() {
    return zoom == 1;
  }

  /** Where the picture lies in a window. What is smaller than the window is in its middle, what is larger fills it. */
  Placement in(Stage stage) {
    double scale = scale(stage, zoom);
    double middleX = inside(x, stage.area().width / (stage.width() * scale));
    double middleY = inside(y, stage.area().height / (stage.height() * scale));
    return new Placement(stage.area().x + stage.area().width / 2.0 - middleX * stage.width() * scale,
        stage.area().y + stage.area().height / 2.0 - middleY * stage.height() * scale, scale);
  }

  /** Zooms so that what lies at a point of the window stays there. */
  PictureView zoomed(double factor, Point at, Stage stage) {
    Placement now = in(stage);
    double scale = scale(stage, zoom * factor);
    double pixelX = (at.x - now.left()) / now.scale();
    double pixelY = (at.y - now.top()) / now.scale();
    double midX = stage.area().x + stage.area().width / 2.0;
    double midY = stage.area().y + stage.area().height / 2.0;
    return new PictureView(mode, scale / stage.base(mode),
        (pixelX + (midX - at.x) / scale) / stage.width(), (pixelY + (midY - at.y) / scale) / stage.height());
  }

  /** Moves the picture with the hand. */
  PictureView moved(int dx, int dy, Stage stage) {
    Placement now = in(stage);
    double nextX = (stage.area().x + stage.area().width / 2.0 - dx - now.left()) / (now.scale() * stage.width());
    double nextY = (stage.area().y + stage.area().height / 2.0 - dy - now.top()) / (now.scale() * stage.height());
    return new PictureView(mode, zoom, inside(nextX, stage.area().width / (stage.width() * now.scale())),
        inside(nextY, stage.area().height / (stage.height() * now.scale())));
  }

  private double scale(Stage stage, double wanted) {
    return Math.clamp(stage.base(mode) * wanted, stage.least(), stage.most());
  }

  private static double inside(double middle, double visible) {
    return visible >= 1 ? 0.5 : Math.clamp(middle, visible / 2, 1 - visible / 2);
  }
}
