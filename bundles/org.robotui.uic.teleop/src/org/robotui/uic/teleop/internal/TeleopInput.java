package org.robotui.uic.teleop.internal;

import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Event;

/** Mouse and keys on the way to the driver. Display thread. */
final class TeleopInput {
  private static final int SETTLE_MILLIS = 40;
  private static final Map<Integer, DriveKey> KEYS = Map.ofEntries(
      Map.entry((int) 'w', DriveKey.FORWARD), Map.entry(SWT.ARROW_UP, DriveKey.FORWARD),
      Map.entry((int) 's', DriveKey.BACK), Map.entry(SWT.ARROW_DOWN, DriveKey.BACK),
      Map.entry((int) 'a', DriveKey.LEFT), Map.entry(SWT.ARROW_LEFT, DriveKey.LEFT),
      Map.entry((int) 'd', DriveKey.RIGHT), Map.entry(SWT.ARROW_RIGHT, DriveKey.RIGHT),
      Map.entry((int) 'q', DriveKey.FORWARD_LEFT), Map.entry((int) 'e', DriveKey.FORWARD_RIGHT));
  private static final int MODIFIERS_OF_COMMANDS = SWT.CTRL | SWT.ALT | SWT.COMMAND;

  private final Canvas canvas;
  private final Driver driver;
  private final Supplier<Optional<Rectangle>> stick;
  private final Runnable changed;
  private boolean dragging;

  TeleopInput(Canvas canvas, Driver driver, Supplier<Optional<Rectangle>> stick, Runnable changed) {
    this.canvas = canvas;
    this.driver = driver;
    this.stick = stick;
    this.changed = changed;
  }

  void listen() {
    canvas.addListener(SWT.MouseDown, this::mouseDown);
    canvas.addListener(SWT.MouseMove, this::mouseMove);
    canvas.addListener(SWT.MouseUp, this::mouseUp);
    canvas.addListener(SWT.KeyDown, this::keyDown);
    canvas.addListener(SWT.KeyUp, this::keyUp);
    canvas.addListener(SWT.FocusOut, e -> lost());
    canvas.addListener(SWT.FocusIn, e -> changed.run());
    // Arrows and space drive here; only tab moves the focus on.
    canvas.addListener(SWT.Traverse,
        e -> e.doit = e.detail == SWT.TRAVERSE_TAB_NEXT || e.detail == SWT.TRAVERSE_TAB_PREVIOUS);
  }

  private void mouseDown(Event event) {
    canvas.forceFocus();
    if (event.button == 1) {
      dragging = stick.get().filter(disc -> disc.contains(event.x, event.y)).isPresent();
      drag(event);
    }
  }

  private void mouseMove(Event event) {
    // A press elsewhere may have swallowed the release: the button's own state decides.
    if (dragging && (event.stateMask & SWT.BUTTON1) == 0) {
      drop();
    }
    drag(event);
  }

  private void mouseUp(Event event) {
    if (event.button == 1 && dragging) {
      drop();
    }
  }

  private void drag(Event event) {
    if (dragging) {
      stick.get().ifPresent(disc -> driver.drag(at(disc, event), System.nanoTime()));
      dragging = driver.look(System.nanoTime()).held();
      changed.run();
    }
  }

  private void drop() {
    dragging = false;
    driver.dragEnd(System.nanoTime());
    changed.run();
  }

  private static Stick at(Rectangle disc, Event event) {
    double radius = disc.width / 2.0;
    return Stick.ofPointer((event.x - disc.x - radius) / radius, (event.y - disc.y - radius) / radius);
  }

  private void keyDown(Event event) {
    switch (event.keyCode) {
      case SWT.SHIFT -> driver.half(true);
      case ' ' -> driver.stop();
      case SWT.ESC -> driver.letGo();
      default -> drive(event);
    }
    changed.run();
  }

  private void drive(Event event) {
    if ((event.stateMask & MODIFIERS_OF_COMMANDS) == 0 && stick.get().isPresent()) {
      driver.half((event.stateMask & SWT.SHIFT) != 0);
      key(event).ifPresent(key -> driver.press(key, System.nanoTime()));
    }
  }

  private void keyUp(Event event) {
    if (event.keyCode == SWT.SHIFT) {
      driver.half(false);
    }
    key(event).ifPresent(key -> {
      driver.release(key, System.nanoTime());
      canvas.getDisplay().timerExec(SETTLE_MILLIS, this::settle);
    });
    changed.run();
  }

  private void settle() {
    driver.settle(System.nanoTime());
    changed.run();
  }

  private void lost() {
    dragging = false;
    driver.forget();
    changed.run();
  }

  private static Optional<DriveKey> key(Event event) {
    return Optional.ofNullable(KEYS.get(event.keyCode));
  }
}
