package org.robotui.ui.layer;

import java.util.concurrent.Executor;

/** What a view gives to a layer. Safe for all threads. */
public interface LayerContext {
  /**
   * Runs what may block; what it brings is taken with the next tick.
   *
   * @return takes tasks; interrupted at the end of the view
   */
  Executor background();
}
