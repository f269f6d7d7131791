package org.robotui.workbench.internal.display;

import java.io.IOException;
import java.nio.file.Path;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Shell;
import org.robotui.ui.PngFile;

/** Saves the picture of a window. Display thread only. */
public final class Screenshot {
  private Screenshot() {}

  /**
   * Saves a window as it is on the screen, without what the window manager draws around it.
   *
   * @param shell the window
   * @param file a PNG file; replaced where it exists
   * @throws IOException where it cannot be written
   */
  public static void save(Shell shell, Path file) throws IOException {
    shell.update();
    Rectangle area = shell.getClientArea();
    Rectangle place = shell.getDisplay().map(shell, null, area);
    Image image = new Image(shell.getDisplay(), area.width, area.height);
    GC gc = new GC(shell.getDisplay());
    gc.copyArea(image, place.x, place.y);
    gc.dispose();
    ImageData data = image.getImageData();
    image.dispose();
    PngFile.write(data, file);
  }
}
