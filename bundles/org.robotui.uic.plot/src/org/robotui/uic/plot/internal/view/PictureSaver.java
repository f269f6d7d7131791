package org.robotui.uic.plot.internal.view;

import java.nio.file.Path;
import java.time.ZoneId;
import java.util.Locale;
import java.util.Optional;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.Transform;
import org.eclipse.swt.widgets.Canvas;
import org.robotui.api.config.AtomicFile;
import org.robotui.ui.PngFile;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.uic.plot.internal.model.PlotScene;

/** Draws what is seen of a plot into a file, without what the pointer shows. Display thread. */
final class PictureSaver {
  /** Of pictures of pixels, which papers show larger than a screen does. */
  private static final int SCALE = 2;

  private final Theme theme;
  private final PlotPainter painter;
  private final Exporter exporter;

  /** Given also what painted the view last. */
  PictureSaver(Theme theme, PlotPainter painter, Exporter exporter) {
    this.theme = theme;
    this.painter = painter;
    this.exporter = exporter;
  }

  /** Has it written in the background: as PNG where the name ends so, else as SVG. */
  void save(Canvas canvas, PlotScene scene, PlotState state, Path file) {
    Rectangle area = canvas.getClientArea();
    if (file.toString().toLowerCase(Locale.ROOT).endsWith(".png")) {
      ImageData pixels = pixels(canvas, area, scene, state);
      exporter.picture(path -> PngFile.write(pixels, path), file.toString());
    } else {
      String svg = painter.svg(area, scene, state);
      exporter.picture(path -> AtomicFile.write(path, svg), file.toString());
    }
  }

  private ImageData pixels(Canvas canvas, Rectangle area, PlotScene scene, PlotState state) {
    Image image = new Image(canvas.getDisplay(), SCALE * area.width, SCALE * area.height);
    GC gc = new GC(image);
    Transform larger = new Transform(canvas.getDisplay());
    Optional<Point> pointer = state.pointer();
    try {
      larger.scale(SCALE, SCALE);
      gc.setTransform(larger);
      gc.setBackground(theme.color(Role.PANEL));
      gc.fillRectangle(area);
      state.pointer(Optional.empty());
      new PlotPainter(theme, ZoneId.systemDefault()).paint(gc, area, scene, state);
      return image.getImageData();
    } finally {
      state.pointer(pointer);
      larger.dispose();
      gc.dispose();
      image.dispose();
    }
  }
}
