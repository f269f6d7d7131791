package org.robotui.uic.camera.internal;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.eclipse.swt.SWT;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.ImageLoader;
import org.robotui.entity.image.Picture;

/** Saves pictures as PNG: ordered on the display thread, written by the tick. */
final class Saver {
  private static final long SHOWN_NANOS = 4_000_000_000L;

  private final AtomicReference<Optional<Order>> order = new AtomicReference<>(Optional.empty());
  private Optional<String> message = Optional.empty();
  private long since;

  /** Has a picture saved by the next tick. */
  void save(Picture picture, String file) {
    order.set(Optional.of(new Order(picture, file)));
  }

  /** Writes what was ordered, and says for a few seconds what became of it. */
  Optional<String> tick(long now) {
    order.getAndSet(Optional.empty()).ifPresent(o -> {
      message = Optional.of(write(o));
      since = now;
    });
    message = message.filter(m -> now - since < SHOWN_NANOS);
    return message;
  }

  private static String write(Order order) {
    try {
      ImageLoader loader = new ImageLoader();
      loader.data = new ImageData[] {order.picture.pixels()};
      loader.save(order.file, SWT.IMAGE_PNG);
      return "saved " + order.file;
    } catch (SWTException e) {
      return "cannot save " + order.file + ": " + e.getMessage();
    }
  }

  private record Order(Picture picture, String file) {}
}
