package org.robotui.uic.scene3d.internal.view;

import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.robotui.gl.shape.Handle;

/**
 * What keys do with the handle that was gripped last: an entry of its menu that ends with {@code (Enter)} or
 * {@code (Esc)} is chosen by that key. Display thread.
 */
final class HandleKeys {
  private final Consumer<Runnable> worker;
  private Optional<Handle> last = Optional.empty();

  HandleKeys(Consumer<Runnable> worker) {
    this.worker = worker;
  }

  void gripped(Handle handle) {
    last = Optional.of(handle);
  }

  /** True where the key was for that handle. */
  boolean key(int code) {
    return switch (code) {
      case SWT.CR, SWT.KEYPAD_CR -> choose("(Enter)");
      case SWT.ESC -> choose("(Esc)");
      default -> false;
    };
  }

  private boolean choose(String key) {
    Optional<Handle.Choice> choice =
        last.flatMap(handle -> handle.menu().stream().filter(c -> c.label().endsWith(key)).findFirst());
    choice.ifPresent(c -> {
      Handle handle = last.orElseThrow();
      worker.accept(() -> handle.choose(c.id()));
    });
    return choice.isPresent();
  }
}
