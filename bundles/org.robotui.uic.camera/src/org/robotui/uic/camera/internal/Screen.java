package org.robotui.uic.camera.internal;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;

/**
 * Holds the newest picture in the form in which the platform paints it. Making that form takes longer than painting it,
 * so the tick makes it before it is asked for. An image belongs to whoever holds it: the tick until the display takes
 * it, then the display.
 */
final class Screen {
  /** A picture in the platform's form. */
  private record Made(ImageData pixels, Image image) {
    void dispose() {
      image.dispose();
    }
  }

  private final Device device;
  private final AtomicReference<Optional<Made>> next = new AtomicReference<>(Optional.empty());
  private Optional<Made> shown = Optional.empty(); // display thread
  private ImageData asked; // display thread: what was shown is for this
  private volatile boolean disposed;

  Screen(Device device) {
    this.device = device;
  }

  /** Makes the image of a picture ready. On the tick, which knows nothing of the end of the display. */
  void prepare(ImageData pixels) {
    if (disposed || device.isDisposed()) {
      return;
    }
    try {
      next.getAndSet(Optional.of(new Made(pixels, new Image(device, pixels)))).ifPresent(Made::dispose);
    } catch (SWTException e) {
      next.getAndSet(Optional.empty()).ifPresent(Made::dispose); // the display ended just now, and its images with it
    }
    if (disposed) {
      next.getAndSet(Optional.empty()).ifPresent(Made::dispose);
    }
  }

  /**
   * The platform's image of a picture, or of a newer one of the same size that the tick has made ready meanwhile; owned
   * by this. Display thread.
   */
  Image image(ImageData pixels) {
    if (asked != pixels) {
      asked = pixels;
      Optional<Made> ready = next.get();
      while (ready.filter(r -> sameSize(r.pixels(), pixels)).isPresent()
          && !next.compareAndSet(ready, Optional.empty())) {
        ready = next.get();
      }
      show(pixels, ready.filter(r -> sameSize(r.pixels(), pixels)));
    }
    return shown.orElseThrow().image();
  }

  /**
   * What is ready is newer. Where it was shown already, or nothing is, the picture itself is made now where it is not
   * shown.
   */
  private void show(ImageData pixels, Optional<Made> ready) {
    if (ready.isPresent() || shown.filter(s -> s.pixels() == pixels).isEmpty()) {
      shown.ifPresent(Made::dispose);
      shown = ready.or(() -> Optional.of(new Made(pixels, new Image(device, pixels))));
    }
  }

  private static boolean sameSize(ImageData one, ImageData other) {
    return one.width == other.width && one.height == other.height;
  }

  /** The view is shown no more. Display thread. */
  void dispose() {
    disposed = true;
    next.getAndSet(Optional.empty()).ifPresent(Made::dispose);
    shown.ifPresent(Made::dispose);
    shown = Optional.empty();
    asked = null;
  }
}
