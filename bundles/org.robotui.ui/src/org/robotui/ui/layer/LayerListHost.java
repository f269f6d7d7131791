package org.robotui.ui.layer;

import java.util.List;
import java.util.function.Supplier;
import org.robotui.ui.display.DisplayKind;
import org.robotui.ui.display.DisplayList;
import org.robotui.ui.display.DisplayPane;
import org.robotui.ui.scene.Scene;
import org.robotui.ui.scene.SceneMover;

/**
 * What the list of layers needs of a view from above. Display thread.
 *
 * @param stack the layers
 * @param scene in which they are
 * @param refreshed shows what the user has changed
 * @param mover moves the view; asked for when it is there
 */
public record LayerListHost(LayerStack stack, Scene scene, Runnable refreshed, Supplier<SceneMover> mover)
    implements DisplayPane.Host {
  @Override
  public String noun() {
    return "layer";
  }

  @Override
  public DisplayList list() {
    return stack.list();
  }

  @Override
  public List<DisplayKind> kinds() {
    return stack.kinds();
  }

  @Override
  public void refresh() {
    refreshed.run();
  }

  @Override
  public void showAllOf(String id) {
    scene.find(id).flatMap(layer -> layer.entity().bounds()).ifPresent(box -> mover.get().fit(box));
  }
}
