package org.robotui.uic.topics.internal.view;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Icon;
import org.robotui.ui.ViewAction;
import org.robotui.uic.topics.internal.model.TopicsModel;

/** What the title line offers. Display thread. */
public final class TopicsActions {
  private final List<ViewAction> all;

  /** Over the model. */
  public TopicsActions(TopicsModel model) {
    all = List.of(
        new ViewAction("pause", "Pause the echo", Icon.PAUSE.id(), Optional.of(() -> model.look().wishes().paused()),
            () -> model.pause(!model.look().wishes().paused())),
        new ViewAction("refresh", "Refresh", Icon.RESTART.id(), Optional.empty(), model::refresh));
  }

  /** All actions, the same objects for each call. */
  public List<ViewAction> all() {
    return all;
  }
}
