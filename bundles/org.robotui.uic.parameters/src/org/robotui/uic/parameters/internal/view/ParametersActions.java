package org.robotui.uic.parameters.internal.view;

import java.util.List;
import java.util.Optional;
import org.robotui.ui.Icon;
import org.robotui.ui.ViewAction;
import org.robotui.uic.parameters.internal.model.ParametersModel;

/** What the title line offers. Display thread. */
public final class ParametersActions {
  private final List<ViewAction> all;

  /** Over the model. */
  public ParametersActions(ParametersModel model) {
    all = List.of(
        new ViewAction("undo", "Undo the last change (Ctrl+Z)", Icon.UNDO.id(), Optional.empty(), model::undo),
        new ViewAction("refresh", "Read all again (F5)", Icon.RESTART.id(), Optional.empty(), model::refresh));
  }

  /** All actions, the same objects for each call. */
  public List<ViewAction> all() {
    return all;
  }
}
