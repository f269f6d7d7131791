package org.robotui.uic.scene3d.internal.view;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.graphics.Device;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Pattern;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.gl.render.Rendered;
import org.robotui.ui.LiveImage;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.render.Screen;

/**
 * The newest picture of a scene in the form in which the platform paints it. A shot belongs to whoever holds it: the
 * thread that hands pictures over until the display takes it, then the display. Images that are shown no more take the
 * next pictures.
 */
final class PicturePane implements Screen {
  /** One is painted, one waits, one is written. */
  private static final int SPARE = 2;

  private final Device device;
  private final AtomicReference<Optional<Shot>> next = new AtomicReference<>(Optional.empty());
  private final Deque<LiveImage> spare = new ArrayDeque<>();
  private Optional<Shot> shown = Optional.empty(); // display thread
  private volatile int zoom = 100;
  private volatile boolean disposed;

  PicturePane(Device device) {
    this.device = device;
  }

  /** Pictures are made for this zoom, in percent. */
  void zoom(int percent) {
    zoom = percent;
  }

  @Override
  public void take(Rendered.Picture picture, CameraPose from) {
    if (disposed || device.isDisposed()) {
      return;
    }
    try {
      LiveImage image = imageFor(picture);
      image.set(picture.rgb());
      put(Optional.of(new Shot(from, picture.figures(), picture.problems(), image)));
    } catch (SWTException e) {
      put(Optional.empty()); // the display ended just now, and its images with it
    }
    if (disposed) {
      put(Optional.empty());
      clear();
    }
  }

  private LiveImage imageFor(Rendered.Picture picture) {
    int percent = zoom;
    return spare().filter(i -> i.fits(picture.width(), picture.height(), percent))
        .orElseGet(() -> {
          clear();
          return new LiveImage(device, picture.width(), picture.height(), percent);
        });
  }

  private synchronized Optional<LiveImage> spare() {
    return Optional.ofNullable(spare.poll());
  }

  private void put(Optional<Shot> shot) {
    next.getAndSet(shot).ifPresent(old -> giveBack(old.image()));
  }

  private synchronized void giveBack(LiveImage image) {
    if (disposed || spare.size() == SPARE) {
      image.dispose();
    } else {
      spare.add(image);
    }
  }

  private synchronized void clear() {
    spare.forEach(LiveImage::dispose);
    spare.clear();
  }

  /** The newest, until the next call. Display thread. */
  Optional<Shot> newest() {
    next.getAndSet(Optional.empty()).ifPresent(newer -> {
      shown.ifPresent(this::release);
      newer.image().changed();
      shown = Optional.of(newer);
    });
    return shown;
  }

  private void release(Shot old) {
    old.image().changed();
    giveBack(old.image());
  }

  /**
   * As large as it is; where a window has just got another size, in its middle, until the next picture comes. An image
   * that is drawn is copied first, a pattern is not. Display thread.
   */
  static void paint(GC gc, Rectangle area, LiveImage image) {
    if (image.width() == area.width && image.height() == area.height && area.x == 0 && area.y == 0) {
      Pattern pattern = new Pattern(gc.getDevice(), image.image());
      gc.setBackgroundPattern(pattern);
      gc.fillRectangle(area);
      gc.setBackgroundPattern(null);
      pattern.dispose();
    } else {
      gc.drawImage(image.image(), area.x + (area.width - image.width()) / 2,
          area.y + (area.height - image.height()) / 2);
    }
  }

  /** The view is shown no more. Display thread. */
  void dispose() {
    disposed = true;
    put(Optional.empty());
    shown.ifPresent(this::release);
    shown = Optional.empty();
    clear();
  }
}
