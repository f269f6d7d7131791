package org.robotui.uic.scene3d.internal.view;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.eclipse.swt.SWTException;
import org.eclipse.swt.graphics.Device;
import org.robotui.gl.render.Rendered;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.studio.Screen;

/**
 * The newest picture of a scene in the form in which the platform paints it. Making that form takes longer than painting it, so it is made where the
 * picture comes. A shot belongs to whoever holds it: the thread that hands pictures over until the display takes it, then the display.
 */
final class PicturePane implements Screen {
  private final Device device;
  private final AtomicReference<Optional<Shot>> next = new AtomicReference<>(Optional.empty());
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
      put(Optional.of(new Shot(from, picture.figures(), picture.problems(), Strips.of(device, picture, zoom))));
    } catch (SWTException e) {
      put(Optional.empty()); // the display ended just now, and its images with it
    }
    if (disposed) {
      put(Optional.empty());
    }
  }

  private void put(Optional<Shot> shot) {
    next.getAndSet(shot).ifPresent(old -> old.strips().dispose());
  }

  /** The newest, until the next call. Display thread. */
  Optional<Shot> newest() {
    next.getAndSet(Optional.empty()).ifPresent(newer -> {
      shown.ifPresent(old -> old.strips().dispose());
      shown = Optional.of(newer);
    });
    return shown;
  }

  /** The view is shown no more. Display thread. */
  void dispose() {
    disposed = true;
    put(Optional.empty());
    shown.ifPresent(old -> old.strips().dispose());
    shown = Optional.empty();
  }
}
