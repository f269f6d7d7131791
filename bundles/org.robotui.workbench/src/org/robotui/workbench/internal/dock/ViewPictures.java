package org.robotui.workbench.internal.dock;

import java.io.IOException;
import java.util.Optional;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.robotui.workbench.internal.timeline.PictureSource;

/** Pictures of one view as it is in its window, also where other windows lie over it. */
public final class ViewPictures implements PictureSource {
  private final RuicSurface surface;
  private final SeenView view;
  private final Display display;

  /**
   * Of a view that is seen. Display thread.
   *
   * @param surface shows it
   * @param view which one
   */
  public ViewPictures(RuicSurface surface, SeenView view) {
    this.surface = surface;
    this.view = view;
    this.display = surface.getDisplay();
  }

  @Override
  public long ticks() {
    return surface.ruic().ticks(view.id());
  }

  @Override
  public ImageData picture() throws IOException {
    Optional<ImageData> taken;
    try {
      taken = display.syncCall(this::take);
    } catch (SWTException e) {
      taken = Optional.empty(); // the application ends
    }
    return taken.orElseThrow(() -> new IOException("the view is not seen any more"));
  }

  private Optional<ImageData> take() {
    Control control = view.control();
    if (surface.isDisposed() || control.isDisposed() || !control.isVisible()) {
      return Optional.empty();
    }
    surface.refresh(view.id());
    control.update();
    Point size = control.getSize();
    if (size.x < 1 || size.y < 1) {
      return Optional.empty();
    }
    Image image = new Image(display, size.x, size.y);
    GC gc = new GC(image);
    try {
      control.print(gc);
      return Optional.of(image.getImageData());
    } finally {
      gc.dispose();
      image.dispose();
    }
  }
}
