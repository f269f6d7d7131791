package org.robotui.ui.layer;

import java.util.Optional;
import org.robotui.ui.ColorBar;
import org.robotui.ui.scene.Entity;

/**
 * One layer of a map. {@link #update} prepares it on the worker thread of the view, one call at a time; it may compute
 * for some milliseconds but must not wait: what takes longer (files, pictures) goes to
 * {@link LayerContext#background()}. What is painted is the last that was prepared. A layer that throws is switched
 * off, and its view says so.
 */
public interface DataLayer extends Entity {
  /**
   * Takes what came since the last tick and prepares what is painted from now on. Called at each tick, also when
   * nothing came, as frames move.
   *
   * @param tick what came, and where things are
   * @return whether something else is to be painted, and how the layer is
   */
  LayerResult update(LayerTick tick);

  /**
   * What the colours of what was prepared mean. Any thread.
   *
   * @return a bar that the view paints beside its layers; none where colours mean no numbers
   */
  default Optional<ColorBar> colors() {
    return Optional.empty();
  }
}
