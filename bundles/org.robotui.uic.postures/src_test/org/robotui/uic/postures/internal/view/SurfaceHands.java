package org.robotui.uic.postures.internal.view;

import java.nio.file.Path;
import org.eclipse.swt.widgets.Control;

/** What a user does in the view, for tests. Display thread. */
public final class SurfaceHands {
  private final PosturesSurface surface;

  /** In one view. */
  public SurfaceHands(PosturesSurface surface) {
    this.surface = surface;
  }

  /** Where keys are pressed. */
  public Control list() {
    return surface.list().control();
  }

  /** Presses Store. */
  public void store() {
    surface.bar().store().press();
  }

  /** Presses Run, or Stop. */
  public void play() {
    surface.bar().play().press();
  }

  /** Opens a file. */
  public void open(Path file) {
    surface.files().open(file);
  }

  /** Saves to a file. */
  public void save(Path file) {
    surface.files().save(file);
  }

  /** What is said below. */
  public String words() {
    return surface.footer().words();
  }
}
