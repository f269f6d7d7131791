package org.robotui.workbench.internal.pane;

import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.jface.bindings.keys.KeySequence;
import org.eclipse.jface.bindings.keys.KeyStroke;
import org.eclipse.jface.bindings.keys.SWTKeySupport;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Listener;

/**
 * Listens for the next key with all its modifiers, which then does nothing else. The key that stops robots stops them
 * all the same: it is seen before. Display thread only.
 */
public final class KeyRecorder {
  private final Display display;
  private final Consumer<Boolean> silence;
  private final Listener filter = this::key;
  private Optional<Consumer<KeySequence>> taker = Optional.empty();
  private Runnable cancelled = () -> {};

  /**
   * Listens to nothing yet.
   *
   * @param display whose keys
   * @param silence has the platform run no commands by keys, while it is given true
   */
  public KeyRecorder(Display display, Consumer<Boolean> silence) {
    this.display = display;
    this.silence = silence;
  }

  /**
   * Listens for one key.
   *
   * @param wanted is given the key
   * @param refused runs where the user does not want any
   */
  public void begin(Consumer<KeySequence> wanted, Runnable refused) {
    end();
    taker = Optional.of(wanted);
    cancelled = refused;
    silence.accept(true);
    display.addFilter(SWT.KeyDown, filter);
    display.addFilter(SWT.Traverse, filter);
  }

  /** Listens no more. */
  public void end() {
    if (taker.isPresent()) {
      taker = Optional.empty();
      display.removeFilter(SWT.KeyDown, filter);
      display.removeFilter(SWT.Traverse, filter);
      silence.accept(false);
    }
  }

  private void key(Event event) {
    event.doit = false;
    if (event.type == SWT.Traverse || (event.keyCode & SWT.KEY_MASK) == 0) {
      return; // of a traversal the key itself follows; of a modifier what it is held for
    }
    KeyStroke stroke =
        SWTKeySupport.convertAcceleratorToKeyStroke(SWTKeySupport.convertEventToUnmodifiedAccelerator(event));
    if (event.keyCode == SWT.ESC && (event.stateMask & SWT.MODIFIER_MASK) == 0) {
      Runnable told = cancelled;
      end();
      told.run();
    } else if (stroke.isComplete()) {
      taker.ifPresent(told -> {
        end();
        told.accept(KeySequence.getInstance(stroke));
      });
    }
  }
}
