package org.robotui.workbench.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robotui.api.host.Ruic;

/** Which RUIC a window shows. Display thread only. */
public final class WindowModel {
  private static final String PRODUCT = "RobotUI";

  private final String window;
  private final List<Runnable> fronts = new CopyOnWriteArrayList<>();
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private Optional<Ruic> selected = Optional.empty();
  private boolean operated;

  WindowModel(String window) {
    this.window = window;
  }

  /** The name of the window for core. */
  public String window() {
    return window;
  }

  /** What it shows. */
  public Optional<Ruic> selected() {
    return selected;
  }

  /** Whether it shows a certain RUIC. */
  public boolean shows(Ruic ruic) {
    return selected.filter(s -> s == ruic).isPresent();
  }

  /** What stands in the title of the window. */
  public String title() {
    return selected.map(ruic -> ruic.name() + " - " + PRODUCT).orElse(PRODUCT);
  }

  /** Has something run that brings the window before all others. */
  public void onFront(Runnable task) {
    fronts.add(task);
  }

  /** Brings the window before all others and gives it the keys. */
  public void front() {
    fronts.forEach(Runnable::run);
  }

  /** Whether it is for an operator: nothing but views and what stops robots, and no view can be moved or closed. */
  public boolean isOperated() {
    return operated;
  }

  /** Makes it one for an operator, or for everybody again. */
  public void operate(boolean now) {
    if (operated != now) {
      operated = now;
      listeners.forEach(Runnable::run);
    }
  }

  /** Has something run after each change of the selection, or of whom the window is for. */
  public Runnable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  void show(Optional<Ruic> next) {
    if (!next.equals(selected)) {
      selected = next;
      listeners.forEach(Runnable::run);
    }
  }
}
