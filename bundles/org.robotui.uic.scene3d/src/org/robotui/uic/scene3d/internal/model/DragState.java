package org.robotui.uic.scene3d.internal.model;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Ray;

/**
 * A hand on a handle. Called on the display thread, acts on the worker; of many moves between two ticks the newest
 * counts.
 */
public final class DragState {
  private final Handle handle;
  private final Consumer<Runnable> worker;
  private final AtomicReference<Optional<Ray>> next = new AtomicReference<>(Optional.empty());
  private boolean moved;

  /** Grips. */
  public DragState(Handle handle, Ray ray, Vector3 place, Consumer<Runnable> worker) {
    this.handle = handle;
    this.worker = worker;
    worker.accept(() -> handle.press(ray, place));
  }

  /** The pointer moved. */
  public void drag(Ray ray) {
    moved = true;
    if (next.getAndSet(Optional.of(ray)).isEmpty()) {
      worker.accept(() -> next.getAndSet(Optional.empty()).ifPresent(handle::drag));
    }
  }

  /** The pointer let go. */
  public void release() {
    boolean clicked = !moved;
    worker.accept(() -> {
      next.getAndSet(Optional.empty()).ifPresent(handle::drag);
      handle.release(clicked);
    });
  }
}
